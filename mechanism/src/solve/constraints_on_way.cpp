#include "constraints_on_way.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace assur::mechanism::solve {

ConstraintsOnWay::ConstraintsOnWay(Values& values, const std::vector<RedundantJoint>& left_out,
                                   ParameterIndex parameter, double way_of_size, const Point& at)
    : values_(values),
      parameter_(parameter),
      column_(std::find(values.columns().begin(), values.columns().end(), parameter) -
              values.columns().begin()),
      way_of_size_(way_of_size),
      constraints_(values, left_out) {
  values_.set(parameter_, at.parameter);
  constraints_.measure(at.links);
}

void ConstraintsOnWay::read(const Point& point) const {
  values_.set(parameter_, point.parameter);
  constraints_.read();
}

Eigen::VectorXd ConstraintsOnWay::misses(const Point& point) const {
  read(point);
  return constraints_.misses(point.links);
}

Eigen::MatrixXd ConstraintsOnWay::jacobian(const Point& point) const {
  read(point);
  Eigen::MatrixXd result(row_count(), unknown_count() + 1);
  result.leftCols(unknown_count()) = constraints_.jacobian(point.links);
  AllConstraints::Links still;
  for (const Pose<double>& pose : point.links) {
    Frame frame;
    frame.pose = pose;
    frame.velocity.setZero();
    frame.acceleration.setZero();
    frame.follows.set_zero(std::ssize(values_.columns()), false);
    still.add(frame);
  }
  result.rightCols(1) = way_of_size_ * constraints_.first_rates(still).col(1 + column_);
  return result;
}

Eigen::MatrixXd ConstraintsOnWay::bends(const Point& point, const Step& v) const {
  const double width = std::cbrt(std::numeric_limits<double>::epsilon());
  const auto beside = [&](double by) {
    Point moved = point;
    move(by * v, moved);
    return jacobian(moved);
  };
  return (beside(width) - beside(-width)) / (2 * width);
}

void ConstraintsOnWay::move(const Step& step, Point& point) const {
  constraints_.move(step.head(unknown_count()), point.links);
  point.parameter += step(unknown_count()) * way_of_size_;
}

ConstraintsOnWay::Step ConstraintsOnWay::direction(const Table<LinkIndex, Frame>& links) const {
  Step result(unknown_count() + 1);
  result << way_of_size_ * constraints_.unknown_rates(links, column_), 1;
  return result;
}

}  // namespace assur::mechanism::solve
