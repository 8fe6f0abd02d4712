// Turns configurations near a singular one, with weights, into the configuration there.
#pragma once

#include "snapshot.hpp"

namespace assur::mechanism::follow {

/// Where a singular event happens. Its rates and gradients are not numbers.
struct EventLocation {
  double parameter;
  Configuration configuration;
  double uncertainty = 0;  ///< of the parameter, by rounding
};

/// A configuration of a mechanism with nothing known.
[[nodiscard]] Configuration unknown_configuration(const Plan& plan);

/// Weights of the values at `nodes` in the interpolating polynomial's value at zero.
[[nodiscard]] Eigen::VectorXd weights_at_zero(const Eigen::VectorXd& nodes);

/// The weighted sum of configurations; rates and gradients stay unknown.
class Blend {
 public:
  explicit Blend(const Plan& plan);

  void add(const Configuration& configuration, double weight);
  [[nodiscard]] Configuration result() const;

 private:
  Configuration sum_;
};

/// The point of a set that is nearest to a place; none of an empty set.
[[nodiscard]] PointIndex nearest(const Snapshot& set, const Eigen::VectorXd& place);

}  // namespace assur::mechanism::follow
