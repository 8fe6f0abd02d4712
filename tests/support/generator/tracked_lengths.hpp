// Tracks of emitted solvers of a four-bar and a slider-crank past change points and gaps, checked
// by formulas. For inclusion in a program of C++17 that includes both solvers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

namespace assur::test {

constexpr double pi = 3.141592653589793;

/// The distance of a mechanism from its change points along a path of its crank.
struct Margin {
  double least = std::numeric_limits<double>::infinity();  ///< in parts of the lengths
  int change_points = 0;                                   ///< that the way passes
  bool ends_on_one = false;  ///< or begins on one, up to what `track` takes for one

  /// Branches meet at an angle of the crank where the margin vanishes.
  void look(double angle, long double margin, double from, double to) {
    constexpr double beside = 1e-2;  // in float velocities are unknown there
    least = std::min(least, static_cast<double>(margin));
    if (std::abs(margin) < rounding) {
      ends_on_one |= std::min(std::abs(angle - from), std::abs(angle - to)) < beside;
      change_points += std::min(from, to) < angle && angle < std::max(from, to) ? 1 : 0;
    }
  }
  static constexpr double rounding = 1e-15;  ///< openings in double are five times as large
};

/// A four-bar with crank a, coupler b, rocker c and frame d.
struct FourBarLengths {
  using Solver = assur::scenes::FourBar;
  double a = 0, b = 0, c = 0, d = 0;

  /// The distance of the angle at the rocker's pin from stretched and from folded along a path of
  /// the crank, relative to the lengths: the distance r of B and D lies between |b - c| and b + c.
  /// It is extreme at the ends, and where the crank is in line with the frame.
  [[nodiscard]] Margin margin(double from, double to) const {
    Margin result;
    const auto look = [&](double angle) {
      const long double r = std::hypot(a * std::cos(static_cast<long double>(angle)) - d,
                                       a * std::sin(static_cast<long double>(angle)));
      const long double margin = std::min<long double>(
          b + static_cast<long double>(c) - r, r - std::abs(b - static_cast<long double>(c)));
      result.look(angle, margin / (a + b + c + d), from, to);
    };
    look(from);
    look(to);
    for (double in_line = pi * std::ceil(std::min(from, to) / pi); in_line <= std::max(from, to);
         in_line += pi) {
      look(in_line);
    }
    return result;
  }
  /// The rocker's pin is on the left of the line from B to D.
  template <typename State>
  [[nodiscard]] bool is_left(const State& state, double angle) const {
    const double x = a * std::cos(angle);
    const double y = a * std::sin(angle);
    const auto& C = state.outputs.C.position;
    return (d - x) * (static_cast<double>(C.y()) - y) > -y * (static_cast<double>(C.x()) - x);
  }
  template <typename Parameters>
  void give(Parameters& parameters) const {
    using Scalar = std::decay_t<decltype(parameters.a)>;
    parameters.a = static_cast<Scalar>(a);
    parameters.b = static_cast<Scalar>(b);
    parameters.c = static_cast<Scalar>(c);
    parameters.d = static_cast<Scalar>(d);
  }
  template <typename Scalar>
  [[nodiscard]] FourBarLengths rounded() const {
    const auto round = [](double length) {
      return static_cast<double>(static_cast<Scalar>(length));
    };
    return {round(a), round(b), round(c), round(d)};
  }
  static constexpr double first_in_line = 0;  ///< an angle of the crank at which branches may meet
};

/// A slider-crank with crank r, rod l, and its slide at the height e.
struct SliderLengths {
  using Solver = assur::scenes::SliderCrank;
  double r = 0, l = 0, e = 0;

  [[nodiscard]] Margin margin(double from, double to) const {
    Margin result;
    const auto look = [&](double angle) {
      const long double height = r * std::sin(static_cast<long double>(angle)) - e;
      result.look(angle, (l - std::abs(height)) / (r + l), from, to);
    };
    look(from);
    look(to);
    for (double upright = pi * (std::ceil(std::min(from, to) / pi - 0.5) + 0.5);
         upright <= std::max(from, to); upright += pi) {
      look(upright);
    }
    return result;
  }
  template <typename State>
  [[nodiscard]] bool is_left(const State& state, double angle) const {
    return static_cast<double>(state.outputs.C.position.x()) < r * std::cos(angle);
  }
  template <typename Parameters>
  void give(Parameters& parameters) const {
    using Scalar = std::decay_t<decltype(parameters.r)>;
    parameters.r = static_cast<Scalar>(r);
    parameters.l = static_cast<Scalar>(l);
    parameters.e = static_cast<Scalar>(e);
  }
  template <typename Scalar>
  [[nodiscard]] SliderLengths rounded() const {
    const auto round = [](double length) {
      return static_cast<double>(static_cast<Scalar>(length));
    };
    return {round(r), round(l), round(e)};
  }
  static constexpr double first_in_line = pi / 2;
};

/// Draws lengths on a lattice with special sums, opened by nothing or by 1e-13 to 0.1, and tracks.
class TrackedLengths {
 public:
  explicit TrackedLengths(unsigned seed) : random_(seed) {}

  template <typename Scalar>
  void follow(int mechanisms) {
    for (int index = 0; index < mechanisms; ++index) {
      follow_each<Scalar>(four_bar(index).template rounded<Scalar>());
      follow_each<Scalar>(slider(index).template rounded<Scalar>());
    }
  }
  /// Prints how many tracks reached their end, did so through a change point, stopped, stopped
  /// though branches keep apart by more than 1e-3, stopped at a change point, and were wrong.
  void print() const {
    std::printf("%d %d %d %d %d %d\n", reached_, passed_, stopped_, stopped_early_,
                stopped_at_change_points_, wrong_);
  }

 private:
  [[nodiscard]] double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  [[nodiscard]] int length() { return 1 + static_cast<int>(random_() % 5); }
  [[nodiscard]] double opening() {
    const double size = std::pow(10, between(-13, -1));
    const auto choice = random_() % 4;
    return choice == 0 ? 0 : choice == 1 ? -size : size;
  }
  [[nodiscard]] FourBarLengths four_bar(int index) {
    double a = length();
    double b = length();
    double c = length();
    double d = length();
    switch (index % 6) {
      case 0:
        d = std::max(b + c - a, 1.0);
        break;
      case 1:
        b = d;
        c = a;
        break;  // a parallelogram
      case 2:
        a = d;
        b = c;
        break;  // a kite
      case 3:
        b = std::max(a + d - c, 1.0);
        break;
      case 4:
        d = a + std::abs(b - c);
        break;
      default:
        break;
    }
    return {a, b, c, d + opening()};
  }
  [[nodiscard]] SliderLengths slider(int index) {
    const double r = length();
    const double e = index % 3 == 0 ? 0 : index % 3 == 1 ? -1 : length() - 3;
    return {r, std::max(r - e, 1.0) + opening(), e};
  }

  template <typename Scalar, typename Lengths>
  void follow_each(const Lengths& lengths) {
    using Solver = typename Lengths::Solver;
    using State = typename Solver::template State<Scalar>;
    const double way = (random_() % 2 == 0 ? 1 : -1) * std::pow(10, between(-2, -0.5));
    const double in_line = Lengths::first_in_line + pi * static_cast<double>(random_() % 3);
    // Passing, beginning beside, ending at, and anywhere.
    const double begins[] = {in_line - way * between(0, 1), in_line - way / 2,
                             in_line - way * std::pow(10, between(-9, 0)), in_line - way,
                             between(-4, 4)};
    const auto from = static_cast<Scalar>(begins[random_() % 5]);
    const auto to = static_cast<Scalar>(static_cast<double>(from) + way);
    typename Solver::template Drivers<Scalar> drivers;
    typename Solver::template Parameters<Scalar> parameters;
    lengths.give(parameters);
    drivers.A.position = from;
    std::array<State, Solver::max_configurations> states;
    const auto found = Solver::solve(drivers, parameters, states);
    const Margin margin = lengths.margin(from, to);
    const bool is_through = std::abs(margin.least) < Margin::rounding && margin.change_points > 0 &&
                            !margin.ends_on_one;
    for (int index = 0; index < found.count; ++index) {
      drivers.A.position = from;
      auto branch = Solver::branch(drivers, parameters, index);
      drivers.A.position = to;
      State state;
      const auto track = Solver::track(drivers, parameters, branch, state);
      if (!assur::is_solvable(track.status)) {
        ++stopped_;
        stopped_early_ += margin.least > 1e-3 ? 1 : 0;
        stopped_at_change_points_ += is_through && assur::is_solvable(branch.status) ? 1 : 0;
        continue;
      }
      ++reached_;
      passed_ += is_through ? 1 : 0;
      const State& start = states[static_cast<std::size_t>(index)];
      // If the margin stays positive a branch keeps to its side; at a change point it changes to
      // the other.
      const bool changes_side = lengths.is_left(start, from) != lengths.is_left(state, to);
      const bool is_open = margin.least < -Margin::rounding;
      const bool is_right =
          !is_open && (margin.ends_on_one || changes_side == (margin.change_points % 2 == 1));
      // Openings that are no more than a few roundings of a length count as none.
      constexpr double few_roundings =
          8 * static_cast<double>(std::numeric_limits<Scalar>::epsilon());
      wrong_ += is_right || (std::abs(margin.least) < few_roundings && margin.least != 0) ? 0 : 1;
    }
  }

  std::mt19937_64 random_;
  int reached_ = 0, passed_ = 0, stopped_ = 0, stopped_early_ = 0, stopped_at_change_points_ = 0,
      wrong_ = 0;
};

}  // namespace assur::test
