// Velocities and accelerations by special Assur points, as published by Quintero, Calle, Diaz and
// Henao: a vector diagram for each point, then one system of lengths.
#pragma once

#include <Eigen/LU>
#include <assur/detail/index.hpp>
#include <assur/kinematics.hpp>
#include <assur/model.hpp>
#include <assur/status.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <limits>

namespace assur {

/// The special points of a configuration and the resulting system of lengths.
///
/// A closure link is reached from two sides, i = 1 and 2. At the special point S of the link, where
/// the lines n_i . S = c_i of both sides cross, all unknowns move the point along the unit normal
/// n_i of the side's line, by signed lengths L:
///   velocity of S = known_i + (sum over k of L(i, k) dq_k/dt) n_i,  i = 1, 2.
/// Equating the sides gives both sums; the sums of all closure links are the system L q' = sums.
///
/// With N = [n_1, -n_2] of each loop the loop Jacobian is J = N L, det N = -(n_1 x n_2). So the
/// method fails where the lines are parallel, however regular the group is.
template <typename Model, typename Scalar>
class SpecialPointSystem {
  static_assert(Model::has_special_points,
                "this header holds no special points: assur emit --model N --with special-points "
                "writes those of a model for which they are defined");

 public:
  static constexpr int points = Model::closure_link_count;
  static constexpr int sides = 2 * points;
  static constexpr int size = Model::unknown_count;
  static_assert(sides == size, "there are two equations per closure link");

  /// status(): ok, near_singular (the rates may keep fewer than six digits), singular,
  /// point_at_infinity (|n_1 x n_2| <= 4 epsilon, or a side has no line, or the point is so far
  /// that no digit would hold) or not_finite.
  ///
  /// The bound. With columns scaled as those of J, L and the sums are of the size of S, the group's
  /// size over |n_1 x n_2|, and rounded in proportion. N turns that into a backward error of J, and
  /// with L^-1 = J^-1 N the forward error is of the order epsilon condition(L), where about
  ///   condition(L) <= 2 condition(J) / |n_1 x n_2|.
  /// In tests it is below 64 epsilon condition(L) times the largest term of the sums that give the
  /// rates; where that exceeds 1e-6 the status is near_singular.
  SpecialPointSystem(const typename Model::template Dimensions<Scalar>& d,
                     const typename Model::template Inputs<Scalar>& u,
                     const typename Model::template Configuration<Scalar>& q) {
    if (!is_finite(d) || !is_finite(u) || !is_finite(q)) {
      status_ = Status::not_finite;
      return;
    }
    status_ = cross_lines(d, u, q);
    if (status_ == Status::ok) {
      Model::special_point_lengths(d, u, q, points_, normals_, lengths_);
      status_ = factor();
    }
  }

  [[nodiscard]] Status status() const { return status_; }
  /// Whether L has an inverse, certified despite rounding.
  [[nodiscard]] bool solvable() const { return is_solvable(status_); }

  /// Whether the points are determined, even if the rates are not.
  [[nodiscard]] bool has_points() const { return solvable() || status_ == Status::singular; }
  /// The special points, one row per closure link, from the origin of its link's frame.
  [[nodiscard]] const Matrix<Scalar, points, 2>& places() const { return points_; }
  /// The unit normals of the lines, one row per side.
  [[nodiscard]] const Matrix<Scalar, sides, 2>& normals() const { return normals_; }
  /// L, one row per side.
  [[nodiscard]] const Matrix<Scalar, sides, size>& lengths() const { return lengths_; }
  /// The smallest |n_1 x n_2|, the sine of the angle between the lines of a point.
  [[nodiscard]] Scalar smallest_sine() const { return smallest_sine_; }

  /// Reciprocal of condition(L) in the 1-norm, columns scaled as those of J; zero if unknown.
  [[nodiscard]] Scalar reciprocal_condition() const { return reciprocal_condition_; }

  /// The vector diagram: sums a_i of each point with known_1 + a_1 n_1 = known_2 + a_2 n_2; NaN if
  /// the points are not determined.
  [[nodiscard]] Vector<Scalar, sides> sums(const Matrix<Scalar, sides, 2>& known) const {
    Vector<Scalar, sides> result;
    if (!has_points()) {
      result.setConstant(std::numeric_limits<Scalar>::quiet_NaN());
      return result;
    }
    for (int first = 0; first < sides; first += 2) {
      const int second = first + 1;
      const Scalar x = known(second, 0) - known(first, 0);
      const Scalar y = known(second, 1) - known(first, 1);
      const Scalar determinant = cross(first);
      result(first) = (x * normals_(second, 1) - y * normals_(second, 0)) / determinant;
      result(second) = (x * normals_(first, 1) - y * normals_(first, 0)) / determinant;
    }
    return result;
  }
  /// q' with L q' = sums; NaN unless solvable().
  [[nodiscard]] Vector<Scalar, size> solve(const Vector<Scalar, sides>& sums) const {
    if (!solvable()) {
      return Vector<Scalar, size>::Constant(std::numeric_limits<Scalar>::quiet_NaN());
    }
    return column_scale_.asDiagonal() * factors_.solve(sums);
  }

 private:
  /// n_1 x n_2 of the point whose first side is given.
  [[nodiscard]] Scalar cross(int first) const {
    return normals_(first, 0) * normals_(first + 1, 1) -
           normals_(first, 1) * normals_(first + 1, 0);
  }

  [[nodiscard]] Status cross_lines(const typename Model::template Dimensions<Scalar>& d,
                                   const typename Model::template Inputs<Scalar>& u,
                                   const typename Model::template Configuration<Scalar>& q) {
    using std::abs;
    Matrix<Scalar, sides, 3> lines;
    Model::special_point_lines(d, u, q, lines);
    Vector<Scalar, sides> offsets;
    for (int side = 0; side < sides; ++side) {
      const Scalar length = lines.row(side).template head<2>().stableNorm();
      normals_.row(side) = lines.row(side).template head<2>() / length;
      offsets(side) = lines(side, 2) / length;
    }
    smallest_sine_ = Scalar(1);
    for (int point = 0; point < points; ++point) {
      const int first = 2 * point;
      const int second = first + 1;
      const Scalar sine = cross(first);
      smallest_sine_ = abs(sine) < smallest_sine_ ? abs(sine) : smallest_sine_;
      if (!(abs(sine) > Scalar(4) * std::numeric_limits<Scalar>::epsilon())) {  // or NaN
        return Status::point_at_infinity;
      }
      points_(point, 0) =
          (offsets(first) * normals_(second, 1) - offsets(second) * normals_(first, 1)) / sine;
      points_(point, 1) =
          (offsets(second) * normals_(first, 0) - offsets(first) * normals_(second, 0)) / sine;
    }
    return Status::ok;
  }

  /// Largest entry of each column of J = N L.
  [[nodiscard]] Vector<Scalar, size> jacobian_columns() const {
    Vector<Scalar, size> largest = Vector<Scalar, size>::Zero();
    for (int first = 0; first < sides; first += 2) {
      for (int axis = 0; axis < 2; ++axis) {
        const Vector<Scalar, size> row =
            normals_(first, axis) * lengths_.row(first).transpose() -
            normals_(first + 1, axis) * lengths_.row(first + 1).transpose();
        largest = largest.cwiseMax(row.cwiseAbs());
      }
    }
    return largest;
  }

  [[nodiscard]] Status factor() {
    column_scale_ = jacobian_columns();
    column_scale_ = column_scale_.cwiseInverse();
    if (!column_scale_.allFinite()) {
      return Status::singular;
    }
    const Matrix<Scalar, size, size> scaled = lengths_ * column_scale_.asDiagonal();
    factors_.compute(scaled);
    const Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
    reciprocal_condition_ = factors_.rcond();
    if (reciprocal_condition_ > epsilon) {
      return reciprocal_condition_ < Scalar(64e6) * epsilon ? Status::near_singular : Status::ok;
    }
    // A regular group whose point is far, or a singular one.
    return reciprocal_condition_ > epsilon * smallest_sine_ ? Status::point_at_infinity
                                                            : Status::singular;
  }

  Status status_ = Status::singular;
  Scalar smallest_sine_ = Scalar(0);
  Scalar reciprocal_condition_ = Scalar(0);
  Matrix<Scalar, points, 2> points_;
  Matrix<Scalar, sides, 2> normals_;
  Matrix<Scalar, sides, size> lengths_;
  Vector<Scalar, size> column_scale_;
  Eigen::PartialPivLU<Matrix<Scalar, size, size>> factors_;
};

/// The special points in the fixed frame, one row per closure link in the order of the links. The
/// result is set if the status is ok, near_singular or singular.
template <typename Model, typename Scalar>
[[nodiscard]] Status special_points(const typename Model::template Dimensions<Scalar>& d,
                                    const typename Model::template Inputs<Scalar>& u,
                                    const typename Model::template Configuration<Scalar>& q,
                                    Matrix<Scalar, Model::closure_link_count, 2>& points) {
  const SpecialPointSystem<Model, Scalar> system(d, u, q);
  if (system.has_points()) {
    Poses<Scalar, Model::link_count> poses;
    Model::link_poses(d, u, q, poses);
    for (int point = 0; point < Model::closure_link_count; ++point) {
      const Pose<Scalar>& frame = detail::entry(poses, detail::entry(Model::closure_links, point));
      points(point, 0) = frame.x + system.places()(point, 0);
      points(point, 1) = frame.y + system.places()(point, 1);
    }
  }
  return system.status();
}

/// The rates of `motion`, by special points instead of the Jacobian. The result is set if the
/// status is ok or near_singular.
template <typename Model, typename Scalar>
[[nodiscard]] Status special_point_motion(const typename Model::template Dimensions<Scalar>& d,
                                          const typename Model::template Inputs<Scalar>& u,
                                          const typename Model::template Configuration<Scalar>& q,
                                          const Vector<Scalar, Model::input_count>& u_rate,
                                          const Vector<Scalar, Model::input_count>& u_second_rate,
                                          Motion<Model, Scalar>& result) {
  if (!is_finite(u_rate) || !is_finite(u_second_rate)) {
    return Status::not_finite;
  }
  const SpecialPointSystem<Model, Scalar> system(d, u, q);
  if (system.solvable()) {
    Matrix<Scalar, 2 * Model::closure_link_count, 2> known;
    Model::special_point_velocities(d, u, q, system.places(), u_rate, known);
    result.velocity = system.solve(system.sums(known));
    Model::special_point_accelerations(d, u, q, system.places(), result.velocity, u_rate,
                                       u_second_rate, known);
    result.acceleration = system.solve(system.sums(known));
  }
  return system.status();
}

}  // namespace assur
