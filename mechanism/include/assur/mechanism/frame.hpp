// Frames and points in nested frames, with rates in time and derivatives by the parameters.
#pragma once

#include <Eigen/Core>
#include <assur/directions.hpp>
#include <assur/mechanism/dual.hpp>
#include <assur/model.hpp>
#include <vector>

namespace assur::mechanism {

/// One row per coordinate, one column per parameter; operations on all parameters run along rows.
template <int Coordinates>
using ParameterRows = Eigen::Matrix<double, Coordinates, Eigen::Dynamic, Eigen::RowMajor>;

/// The derivatives of some coordinates with respect to the parameters: first ones and, if carried,
/// a symmetric matrix of second derivatives for each coordinate.
template <int Coordinates>
struct Derivatives {
  ParameterRows<Coordinates> first;
  std::vector<Eigen::MatrixXd> second;  ///< of each coordinate; empty where not carried

  [[nodiscard]] bool has_second() const { return !second.empty(); }
  /// Sets all derivatives to zero, for a number of parameters.
  void set_zero(Eigen::Index parameters, bool with_second);
};

/// A frame in another: its pose (x, y, theta), the rates [vx, vy, omega] and [ax, ay, alpha] of its
/// origin, and the derivatives of the pose with respect to the parameters.
struct Frame {
  Pose<double> pose;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  Derivatives<3> follows;

  /// A frame at rest in the outer frame, with a pose.
  [[nodiscard]] static Frame at(const Pose<Dual>& pose);
  /// Sets the rates from a pose that is a function of time (its first and second derivative).
  void move(const Pose<Dual>& in_time);
  /// The pose with its derivatives by the parameters, and as a function of time.
  [[nodiscard]] Pose<Dual> to_parameters() const;
  [[nodiscard]] Pose<Dual> in_time() const;
  /// The frame that coincides with the outer frame.
  [[nodiscard]] static Frame identity(Eigen::Index parameters, bool with_second);
};

/// A point in a frame, with the same rates and derivatives.
struct Point {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
  Eigen::Vector2d acceleration = Eigen::Vector2d::Zero();
  Derivatives<2> follows;
};

/// Transforms `inner`, which is given in `frame`, into the frame in which `frame` is given.
/// `result` may not be one of the two.
void compose(const Frame& frame, const Frame& inner, Frame& result);
/// Does the same and returns the result.
[[nodiscard]] Frame composed(const Frame& frame, const Frame& inner);

/// Finds the origin of `inner`, in the frame in which `frame` is given.
void carry(const Frame& frame, const Frame& inner, Point& result);

/// The pose of the outer frame relative to a frame.
template <typename Scalar>
[[nodiscard]] Pose<Scalar> inverse(const Pose<Scalar>& pose) {
  return {-(pose.direction.cos * pose.x) - pose.direction.sin * pose.y,
          pose.direction.sin * pose.x - pose.direction.cos * pose.y, reversed(pose.direction)};
}

}  // namespace assur::mechanism
