// All constraints of a mechanism as functions of one of its parameters.
#pragma once

#include "all_constraints.hpp"

namespace assur::mechanism::solve {

/// A `local::System` whose places are those of all moving links and whose way is the parameter's,
/// in units of the change that moves the mechanism by its size. Laws must not read joints.
class ConstraintsOnWay {
 public:
  using Scalar = double;
  static constexpr int rows = Eigen::Dynamic;
  static constexpr int unknowns = Eigen::Dynamic;
  struct Point {
    AllConstraints::Poses links;
    double parameter = 0;
  };
  using Step = Eigen::VectorXd;

  /// The constraints of the plan's own mechanism, with some of those that the plan leaves out. The
  /// mechanism is measured at the links' poses at a point. `way_of_size` is the change of the
  /// parameter that moves it by its size. The values are changed, and must outlive the object.
  ConstraintsOnWay(Values& values, const std::vector<RedundantJoint>& left_out,
                   ParameterIndex parameter, double way_of_size, const Point& at);

  [[nodiscard]] int row_count() const { return constraints_.body().rows(); }
  [[nodiscard]] int unknown_count() const { return static_cast<int>(constraints_.unknowns()); }
  [[nodiscard]] Eigen::VectorXd misses(const Point& point) const;
  [[nodiscard]] Eigen::MatrixXd jacobian(const Point& point) const;
  [[nodiscard]] Eigen::MatrixXd bends(const Point& point, const Step& v) const;
  void move(const Step& step, Point& point) const;
  [[nodiscard]] double rounding() const { return constraints_.rounding(); }

  /// The links' direction of motion per unit of way, from their derivatives.
  [[nodiscard]] Step direction(const Table<LinkIndex, Frame>& links) const;

 private:
  void read(const Point& point) const;

  Values& values_;
  ParameterIndex parameter_;
  Eigen::Index column_;  ///< of the derivatives with respect to the parameter
  double way_of_size_;
  mutable AllConstraints constraints_;
};

}  // namespace assur::mechanism::solve
