// Truncated Taylor series of numbers along a motion.
#pragma once

#include <array>
#include <assur/model.hpp>
#include <cstddef>

namespace assur::mechanism::models {

/// The series c0 + c1 t + ... + c4 t^4, without higher orders. An unknown coefficient is NaN; so
/// are all that depend on it, which are of its order or higher.
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

/// The direction of a variable angle: `angle` is the turn from `start`, and zero at t = 0.
[[nodiscard]] Direction<Series> turning(const Direction<double>& start, const Series& angle);

/// The rates of a variable direction: with c^2 + s^2 = 1, omega = c s' - s c' and alpha = c s'' - s
/// c''.
[[nodiscard]] double turning_rate(const Direction<Series>& direction);
[[nodiscard]] double second_turning_rate(const Direction<Series>& direction);

/// Transforms `inner`, which is given in `frame`, into the frame in which `frame` moves.
[[nodiscard]] Pose<Series> composed(const Pose<Series>& frame, const Pose<Series>& inner);
/// A frame at rest.
[[nodiscard]] Pose<Series> at_rest(const Pose<double>& pose);

}  // namespace assur::mechanism::models
