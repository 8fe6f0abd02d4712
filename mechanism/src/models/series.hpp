// Turns formulas into formulas for the Taylor coefficients of what moves.
#pragma once

#include <array>
#include <assur/model.hpp>
#include <cstddef>

namespace assur::mechanism::models {

/// c0 + c1 t + ... + c4 t^4, and what is of higher order cut off. A coefficient that is not known
/// is NaN, and makes those that depend on it NaN, which are of its order and above.
struct Series {
  static constexpr std::size_t order = 4;
  std::array<double, order + 1> c{};

  Series() = default;
  Series(double constant) : c{constant} {}  // NOLINT(google-explicit-constructor): as numbers do
  Series(int constant) : c{static_cast<double>(constant)} {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] double value() const { return c[0]; }
  [[nodiscard]] double rate() const { return c[1]; }
  [[nodiscard]] double second_rate() const { return 2 * c[2]; }
};

[[nodiscard]] Series operator+(const Series& a, const Series& b);
[[nodiscard]] Series operator-(const Series& a, const Series& b);
[[nodiscard]] Series operator-(const Series& a);
[[nodiscard]] Series operator*(const Series& a, const Series& b);

/// The direction of an angle that moves: `angle` is how far it has turned from `start`, and zero at
/// t = 0.
[[nodiscard]] Direction<Series> turning(const Direction<double>& start, const Series& angle);

/// The rates of a direction that moves: with c^2 + s^2 = 1, omega = c s' - s c' and
/// alpha = c s'' - s c''.
[[nodiscard]] double turning_rate(const Direction<Series>& direction);
[[nodiscard]] double second_turning_rate(const Direction<Series>& direction);

/// The frame `inner`, which is given in `frame`, in the frame in which that one moves.
[[nodiscard]] Pose<Series> composed(const Pose<Series>& frame, const Pose<Series>& inner);
/// A frame at rest.
[[nodiscard]] Pose<Series> at_rest(const Pose<double>& pose);
/// A number that moves with a rate and a second rate; where these are zero it is at rest, and
/// elsewhere what is of higher order is not known.
[[nodiscard]] Series moving(double value, double rate, double second_rate);

}  // namespace assur::mechanism::models
