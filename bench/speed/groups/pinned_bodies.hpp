// The links of the six-link group `three_pairs` as pinned rigid bodies, for Newton's method.
#pragma once

#include <Eigen/LU>
#include <array>
#include <complex>

namespace assur::speed {

/// Six bodies with coordinates x, y and angle each, in the frames of the scene: the origin at the
/// first point of a link, the x-axis towards its second one. Loops do not enter.
template <typename Scalar>
class PinnedBodies {
 public:
  using Coordinates = Eigen::Matrix<Scalar, 18, 1>;

  explicit PinnedBodies(Scalar crank) {
    places_[B] = places_[A] + std::polar(length_of(A, B), crank);
  }

  /// Newton's method with steps of at most one radian or one unit of length; returns whether it
  /// converged.
  [[nodiscard]] bool assemble(Coordinates& q) const {
    constexpr int most_steps = 60;
    for (int step = 0; step < most_steps; ++step) {
      Coordinates f;
      Jacobian jacobian = Jacobian::Zero();
      put_gaps(q, f, jacobian);
      const Coordinates by = Eigen::PartialPivLU<Jacobian>(jacobian).solve(-f);
      if (!by.allFinite()) {
        return false;
      }
      const Scalar longest = by.cwiseAbs().maxCoeff();
      q += by / std::max(Scalar(1), longest);
      if (longest < Scalar(1e-11)) {
        return true;
      }
    }
    return false;
  }

  using Complex = std::complex<Scalar>;
  /// A bar between two of the first three bodies. With the bodies' directions z it closes where |b
  /// + g z_first - f z_second| is its length.
  struct Bar {
    int first, second;
    Complex b, g, f;
    Scalar length;
  };
  [[nodiscard]] std::array<Bar, 3> bars() const {
    std::array<Bar, 3> result;
    for (std::size_t bar = 0; bar < 3; ++bar) {
      const auto [from, to] = axes[3 + bar];
      const auto [first, second] = ends[bar];
      result[bar] = {first,
                     second,
                     pin_of(first) - pin_of(second),
                     arm_of(first, from),
                     arm_of(second, to),
                     length_of(from, to)};
    }
    return result;
  }
  /// The coordinates of all bodies for given directions of the first three.
  [[nodiscard]] Coordinates standing(const std::array<Complex, 3>& z) const {
    Coordinates q;
    const auto put = [&q](int body, const Complex& at, const Complex& direction) {
      q.template segment<3>(3 * body) << at.real(), at.imag(), std::arg(direction);
    };
    for (int body = 0; body < 3; ++body) {
      put(body, pin_of(body), z[static_cast<std::size_t>(body)]);
    }
    int bar = 3;
    for (const Bar& one : bars()) {
      const Complex from = pin_of(one.first) + one.g * z[static_cast<std::size_t>(one.first)];
      const Complex to = pin_of(one.second) + one.f * z[static_cast<std::size_t>(one.second)];
      put(bar++, from, to - from);
    }
    return q;
  }

 private:
  using Jacobian = Eigen::Matrix<Scalar, 18, 18>;
  enum Place { A, B, D, F, P, Q, R, S, T, U };
  static constexpr int base = -1;
  struct Joint {
    Place place;
    std::array<int, 2> bodies;
  };
  /// The bodies one, two, three, bar_a, bar_b and bar_c.
  static constexpr std::array<std::array<Place, 2>, 6> axes = {
      {{B, P}, {D, R}, {F, T}, {P, R}, {Q, T}, {S, U}}};
  /// The bodies at the ends of each bar.
  static constexpr std::array<std::array<int, 2>, 3> ends = {{{0, 1}, {0, 2}, {1, 2}}};
  static constexpr std::array<Joint, 9> joints = {{{B, {base, 0}},
                                                   {D, {base, 1}},
                                                   {F, {base, 2}},
                                                   {P, {0, 3}},
                                                   {R, {1, 3}},
                                                   {Q, {0, 4}},
                                                   {T, {2, 4}},
                                                   {S, {1, 5}},
                                                   {U, {2, 5}}}};
  /// The points as drawn in the scene.
  static constexpr std::array<std::array<double, 2>, 10> drawn = {{{-2, 0},
                                                                   {-1, 1},
                                                                   {4, 0.5},
                                                                   {7, 0},
                                                                   {0, 3},
                                                                   {-0.5, 5},
                                                                   {3.2, 2.9},
                                                                   {4.6, 3.1},
                                                                   {6, 5.5},
                                                                   {7.4, 3.3}}};

  [[nodiscard]] static Complex drawn_at(Place place) {
    return {Scalar(drawn[place][0]), Scalar(drawn[place][1])};
  }
  [[nodiscard]] static Scalar length_of(Place from, Place to) {
    return std::abs(drawn_at(to) - drawn_at(from));
  }
  [[nodiscard]] static std::array<Complex, 10> all_drawn() {
    std::array<Complex, 10> result;
    for (std::size_t place = 0; place < result.size(); ++place) {
      result[place] = drawn_at(static_cast<Place>(place));
    }
    return result;
  }

  /// The pin that joins one of the first three bodies to the crank or the ground.
  [[nodiscard]] Complex pin_of(int body) const {
    return places_[axes[static_cast<std::size_t>(body)][0]];
  }
  /// A point of a body in its frame.
  [[nodiscard]] static Complex arm_of(int body, Place place) {
    const auto [origin, end] = axes[static_cast<std::size_t>(body)];
    const Complex axis = (drawn_at(end) - drawn_at(origin)) / length_of(origin, end);
    return (drawn_at(place) - drawn_at(origin)) / axis;
  }
  [[nodiscard]] static std::array<std::array<Complex, 2>, 9> all_arms() {
    std::array<std::array<Complex, 2>, 9> result;
    for (std::size_t joint = 0; joint < joints.size(); ++joint) {
      for (std::size_t side = 0; side < 2; ++side) {
        const int body = joints[joint].bodies[side];
        result[joint][side] = body == base ? Complex(0) : arm_of(body, joints[joint].place);
      }
    }
    return result;
  }

  void put_gaps(const Coordinates& q, Coordinates& f, Jacobian& jacobian) const {
    static const std::array<std::array<Complex, 2>, 9> arms = all_arms();
    for (std::size_t joint = 0; joint < joints.size(); ++joint) {
      const auto row = 2 * static_cast<Eigen::Index>(joint);
      Complex gap = 0;
      for (std::size_t side = 0; side < 2; ++side) {
        const Scalar sign = side == 0 ? Scalar(1) : Scalar(-1);
        const int body = joints[joint].bodies[side];
        if (body == base) {
          gap += sign * places_[joints[joint].place];
          continue;
        }
        const Eigen::Index first = 3 * body;
        const Complex arm = std::polar(Scalar(1), q(first + 2)) * arms[joint][side];
        gap += sign * (Complex(q(first), q(first + 1)) + arm);
        jacobian(row, first) = jacobian(row + 1, first + 1) = sign;
        jacobian(row, first + 2) = -sign * arm.imag();
        jacobian(row + 1, first + 2) = sign * arm.real();
      }
      f(row) = gap.real();
      f(row + 1) = gap.imag();
    }
  }

  std::array<Complex, 10> places_ = all_drawn();
};

}  // namespace assur::speed
