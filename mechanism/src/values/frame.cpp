// Composition of frames, with rates and derivatives.
#include <assur/mechanism/frame.hpp>
#include <assur/support/rigid_motion.hpp>
#include <assur/variables.hpp>

namespace assur::mechanism::values {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The second derivatives of the coordinates along parameters i and j.
template <int Coordinates>
Eigen::Matrix<double, Coordinates, 1> mixed(const Derivatives<Coordinates>& follows, Eigen::Index i,
                                            Eigen::Index j) {
  Eigen::Matrix<double, Coordinates, 1> result;
  for (int row = 0; row < Coordinates; ++row) {
    result(row) = follows.second[static_cast<std::size_t>(row)](i, j);
  }
  return result;
}

/// The origin of a frame inside another frame, with all its derivatives.
class CarriedOrigin {
 public:
  CarriedOrigin(const Frame& frame, const Frame& inner)
      : frame_(frame), inner_(inner), arm_(turned_in({inner.pose.x, inner.pose.y})) {}

  [[nodiscard]] Vector2d position() const { return Vector2d(frame_.pose.x, frame_.pose.y) + arm_; }
  [[nodiscard]] Vector2d velocity() const {
    return support::carried<double>(frame_.velocity, arm_, turned_in(inner_.velocity.head<2>()));
  }
  [[nodiscard]] Vector2d acceleration() const {
    const Vector2d sliding = turned_in(inner_.velocity.head<2>());
    const double omega = frame_.velocity(2);
    return support::carried_twice<double>(frame_.acceleration, omega, omega, arm_, sliding, sliding,
                                          turned_in(inner_.acceleration.head<2>()));
  }

  /// Sets the first two coordinates of `result`, which has room for them.
  template <int Coordinates>
  void follow(Derivatives<Coordinates>& result) const {
    const Derivatives<3>& outer = frame_.follows;
    const Derivatives<3>& own = inner_.follows;
    const Eigen::Index count = outer.first.cols();
    // `carried`, along one parameter after the other: a sweep spends much of its time here, and
    // loops over plain numbers are fast at every level of optimisation.
    const auto& [cosine, sine] = frame_.pose.direction;
    const double* const x = outer.first.data();
    const double* const own_x = own.first.data();
    double* const result_x = result.first.data();
    for (Eigen::Index i = 0; i < count; ++i) {
      const double turn = x[i + 2 * count];
      const double along = own_x[i];
      const double across = own_x[i + count];
      result_x[i] = x[i] - arm_.y() * turn + cosine * along - sine * across;
      result_x[i + count] = x[i + count] + arm_.x() * turn + sine * along + cosine * across;
    }
    if (!outer.has_second()) {
      return;
    }
    for (Eigen::Index i = 0; i < count; ++i) {
      for (Eigen::Index j = 0; j <= i; ++j) {
        const Vector2d second = support::carried_twice<double>(
            mixed(outer, i, j), outer.first(2, i), outer.first(2, j), arm_,
            turned_in(own.first.template block<2, 1>(0, i)),
            turned_in(own.first.template block<2, 1>(0, j)), turned_in(mixed(own, i, j).head<2>()));
        for (int row = 0; row < 2; ++row) {
          Eigen::MatrixXd& target = result.second[static_cast<std::size_t>(row)];
          target(i, j) = target(j, i) = second(row);
        }
      }
    }
  }

 private:
  [[nodiscard]] Vector2d turned_in(const Vector2d& v) const {
    return support::rotated<double>(frame_.pose.direction, v);
  }

  const Frame& frame_;
  const Frame& inner_;
  Vector2d arm_;
};

template <int Coordinates>
void make_room(const Derivatives<3>& like, Derivatives<Coordinates>& result) {
  const Eigen::Index count = like.first.cols();
  result.first.resize(Coordinates, count);
  result.second.resize(like.has_second() ? std::size_t{Coordinates} : 0);
  for (Eigen::MatrixXd& matrix : result.second) {
    matrix.resize(count, count);
  }
}

/// A pose from `coordinate(value, row)`, a coordinate with its derivatives.
template <typename Coordinate>
Pose<Dual> pose_of(const Pose<double>& pose, const Coordinate& coordinate) {
  const auto& [cosine, sine] = pose.direction;
  const Dual angle = coordinate(0, 2);
  return {
      coordinate(pose.x, 0),
      coordinate(pose.y, 1),
      {Dual::chained(cosine, angle, -sine, -cosine), Dual::chained(sine, angle, cosine, -sine)}};
}

}  // namespace

}  // namespace assur::mechanism::values

namespace assur::mechanism {

template <int Coordinates>
void Derivatives<Coordinates>::set_zero(Eigen::Index parameters, bool with_second) {
  first.setZero(Coordinates, parameters);
  second.assign(with_second ? std::size_t{Coordinates} : 0,
                Eigen::MatrixXd::Zero(parameters, parameters));
}
template struct Derivatives<1>;
template struct Derivatives<2>;
template struct Derivatives<3>;

Frame Frame::at(const Pose<Dual>& pose) {
  Frame frame;
  frame.pose = {
      pose.x.value(), pose.y.value(), {pose.direction.cos.value(), pose.direction.sin.value()}};
  const Dual angle = angle_of(pose.direction);
  const std::array<const Dual*, 3> coordinates = {&pose.x, &pose.y, &angle};
  frame.follows.set_zero(pose.x.derivatives().size(), pose.x.has_hessian());
  for (std::size_t row = 0; row < coordinates.size(); ++row) {
    if (coordinates[row]->derivatives().size() > 0) {
      frame.follows.first.row(static_cast<Eigen::Index>(row)) =
          coordinates[row]->derivatives().transpose();
    }
    if (coordinates[row]->has_hessian() && frame.follows.has_second()) {
      frame.follows.second[row] = coordinates[row]->hessian();
    }
  }
  return frame;
}

void Frame::move(const Pose<Dual>& in_time) {
  const Dual angle = angle_of(in_time.direction);
  const std::array<const Dual*, 3> coordinates = {&in_time.x, &in_time.y, &angle};
  for (std::size_t row = 0; row < coordinates.size(); ++row) {
    const Dual& coordinate = *coordinates[row];
    const auto place = static_cast<Eigen::Index>(row);
    velocity(place) = coordinate.derivatives().size() > 0 ? coordinate.derivatives()(0) : 0;
    acceleration(place) = coordinate.has_hessian() ? coordinate.hessian()(0, 0) : 0;
  }
}

Pose<Dual> Frame::to_parameters() const {
  const auto coordinate = [this](double value, Eigen::Index row) {
    return Dual(
        value, follows.first.row(row).transpose(),
        follows.has_second() ? follows.second[static_cast<std::size_t>(row)] : Eigen::MatrixXd());
  };
  return values::pose_of(pose, coordinate);
}

Pose<Dual> Frame::in_time() const {
  const auto coordinate = [this](double value, Eigen::Index row) {
    return Dual(value, Eigen::VectorXd::Constant(1, velocity(row)),
                Eigen::MatrixXd::Constant(1, 1, acceleration(row)));
  };
  return values::pose_of(pose, coordinate);
}

Frame Frame::identity(Eigen::Index parameters, bool with_second) {
  Frame frame;
  frame.follows.set_zero(parameters, with_second);
  return frame;
}

void compose(const Frame& frame, const Frame& inner, Frame& result) {
  const values::CarriedOrigin origin(frame, inner);
  const Eigen::Vector2d position = origin.position();
  result.pose = {position.x(), position.y(), turned(frame.pose.direction, inner.pose.direction)};
  result.velocity << origin.velocity(), frame.velocity(2) + inner.velocity(2);
  result.acceleration << origin.acceleration(), frame.acceleration(2) + inner.acceleration(2);
  values::make_room(frame.follows, result.follows);
  origin.follow(result.follows);
  const Eigen::Index count = frame.follows.first.cols();
  for (Eigen::Index i = 2 * count; i < 3 * count; ++i) {
    result.follows.first.data()[i] = frame.follows.first.data()[i] + inner.follows.first.data()[i];
  }
  if (frame.follows.has_second()) {
    result.follows.second[2] = frame.follows.second[2] + inner.follows.second[2];
  }
}

Frame composed(const Frame& frame, const Frame& inner) {
  Frame result;
  compose(frame, inner, result);
  return result;
}

void carry(const Frame& frame, const Frame& inner, Point& result) {
  const values::CarriedOrigin origin(frame, inner);
  result.position = origin.position();
  result.velocity = origin.velocity();
  result.acceleration = origin.acceleration();
  values::make_room(frame.follows, result.follows);
  origin.follow(result.follows);
}

}  // namespace assur::mechanism
