// Coefficients of the equations of motion of an emitted solver, from masses and loads.
#pragma once

#include <assur/model.hpp>
#include <assur/numeric/entries.hpp>
#include <assur/support/link_forces.hpp>
#include <assur/support/rigid_motion.hpp>
#include <tuple>

namespace assur::support {

/// A vector of numbers.
template <typename Scalar, typename... Numbers>
[[nodiscard]] Vector<Scalar, static_cast<int>(sizeof...(Numbers))> vector_of(
    const Numbers&... numbers) {
  Vector<Scalar, static_cast<int>(sizeof...(Numbers))> result;
  int place = 0;
  ((result(place++) = numbers), ...);
  return result;
}

/// M phi'' + bias = load + effort for the coordinates phi of the free drivers.
template <typename Scalar, int Coordinates>
struct Dynamics {
  Matrix<Scalar, Coordinates, Coordinates> mass_matrix;
  Vector<Scalar, Coordinates> bias, load;
  [[nodiscard]] auto members() { return std::tie(mass_matrix, bias, load); }
};

/// With h the first derivatives of a mass centre by the coordinates, k those of its link's angle,
/// and a0, alpha0 the accelerations without those of the coordinates:
///     M = sum m h h + I k k,  bias = sum m h a0 + I k alpha0,  load = sum f h + M k.
template <typename Scalar, int Coordinates>
class EquationsOfMotion {
  using PerCoordinate = Vector<Scalar, Coordinates>;
  using OfFrame = Matrix<Scalar, 3, Coordinates>;

 public:
  /// `accelerations` are those of the coordinates.
  explicit EquationsOfMotion(const PerCoordinate& accelerations) : accelerations_(accelerations) {
    numeric::fill(result_.mass_matrix, Scalar(0));
    numeric::fill(result_.bias, Scalar(0));
    numeric::fill(result_.load, Scalar(0));
  }

  /// Adds a mass at a point of a link; `of_frame` holds the derivatives of the link's frame.
  template <typename Frame, typename Point>
  void add_mass(const OfFrame& of_frame, const Frame& frame, const Point& centre,
                const Scalar& mass) {
    const Scalar arm_x = centre.x - frame.pose.x;
    const Scalar arm_y = centre.y - frame.pose.y;
    PerCoordinate h_x, h_y;
    for (int i = 0; i < Coordinates; ++i) {
      h_x(i) = of_frame(0, i) - of_frame(2, i) * arm_y;
      h_y(i) = of_frame(1, i) + of_frame(2, i) * arm_x;
    }
    add(h_x, centre.rates(0, 1), mass);
    add(h_y, centre.rates(1, 1), mass);
  }
  /// Adds the moment of inertia of a link about its mass centre.
  template <typename Frame>
  void add_inertia(const OfFrame& of_frame, const Frame& frame, const Scalar& inertia) {
    PerCoordinate k;
    for (int i = 0; i < Coordinates; ++i) {
      k(i) = of_frame(2, i);
    }
    add(k, frame.rates(2, 1), inertia);
  }
  /// Adds the applied load of a link, about the origin of its frame.
  void add_load(const OfFrame& of_frame, const LinkLoad<Scalar>& applied) {
    for (int i = 0; i < Coordinates; ++i) {
      result_.load(i) +=
          applied.x * of_frame(0, i) + applied.y * of_frame(1, i) + applied.moment * of_frame(2, i);
    }
  }

  [[nodiscard]] const Dynamics<Scalar, Coordinates>& coefficients() const { return result_; }

 private:
  /// Adds the inertia of one coordinate of a body, by its derivatives and its acceleration.
  void add(const PerCoordinate& slopes, const Scalar& acceleration, const Scalar& inertia) {
    Scalar at_rest = acceleration;
    for (int i = 0; i < Coordinates; ++i) {
      at_rest -= slopes(i) * accelerations_(i);
    }
    for (int i = 0; i < Coordinates; ++i) {
      const Scalar momentum = inertia * slopes(i);
      for (int j = 0; j < Coordinates; ++j) {
        result_.mass_matrix(i, j) += momentum * slopes(j);
      }
      result_.bias(i) += momentum * at_rest;
    }
  }

  PerCoordinate accelerations_;
  Dynamics<Scalar, Coordinates> result_;
};

}  // namespace assur::support
