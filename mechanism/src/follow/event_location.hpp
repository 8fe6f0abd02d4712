// Interpolation of a singular configuration from weighted configurations near it.
#pragma once

#include <assur/mechanism/plan.hpp>

#include "snapshot.hpp"

namespace assur::mechanism::follow {

/// Where a singular event happens. The rates and derivatives of the configuration are NaN.
struct EventLocation {
  double parameter;
  Configuration configuration;
  double uncertainty = 0;  ///< of the parameter, by rounding
};

/// A configuration of the plan's mechanism in which all numbers are NaN.
[[nodiscard]] Configuration unknown_configuration(const Plan& plan);

/// The weights of the values at `nodes` in the value at zero of the interpolating polynomial.
[[nodiscard]] Eigen::VectorXd weights_at_zero(const Eigen::VectorXd& nodes);

/// The weighted sum of configurations; rates and derivatives stay NaN.
class Blend {
 public:
  explicit Blend(const Plan& plan);

  void add(const Configuration& configuration, double weight);
  [[nodiscard]] Configuration result() const;

 private:
  Configuration sum_;
};

/// The point of a set that is nearest to a place; an index that does not exist if the set is empty.
[[nodiscard]] PointIndex nearest(const Snapshot& set, const Eigen::VectorXd& place);

}  // namespace assur::mechanism::follow
