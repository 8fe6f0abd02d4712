// All constraints of a mechanism while one of its parameters goes on.
#pragma once

#include "all_constraints.hpp"

namespace assur::mechanism::solve {

/// A `local::System`. Its places are those of all links that move, and its way is the parameter's,
/// in parts of the way that moves the mechanism by its size. Laws must not read joints.
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

  /// The constraints of the plan's own mechanism, with some of those that it leaves out. Measures
  /// the mechanism where its links are at a point. `way_of_size` is how far the parameter goes
  /// meanwhile. The values are changed, and must outlive it.
  ConstraintsOnWay(Values& values, const std::vector<RedundantJoint>& left_out,
                   ParameterIndex parameter, double way_of_size, const Point& at);

  [[nodiscard]] int row_count() const { return constraints_.body().rows(); }
  [[nodiscard]] int unknown_count() const { return static_cast<int>(constraints_.unknowns()); }
  [[nodiscard]] Eigen::VectorXd misses(const Point& point) const;
  [[nodiscard]] Eigen::MatrixXd jacobian(const Point& point) const;
  [[nodiscard]] Eigen::MatrixXd bends(const Point& point, const Step& v) const;
  void move(const Step& step, Point& point) const;
  [[nodiscard]] double rounding() const { return constraints_.rounding(); }

  /// The direction in which links move, by their derivatives, with one unit along the way.
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
