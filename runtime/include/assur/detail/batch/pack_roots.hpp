// Roots of several polynomials at once in isolating arcs.
#pragma once

#include <array>
#include <assur/model.hpp>
#include <assur/numeric/pack.hpp>
#include <assur/numeric/trigonometric_charts.hpp>
#include <cstddef>
#include <limits>

namespace assur::detail::batch {

/// The points where the control polygons of arcs from -1 to 1 cross zero once: first guesses of the
/// roots.
template <typename Pack, std::size_t Size>
[[nodiscard]] Pack crossing_of(const std::array<Pack, Size>& bernstein) {
  const auto is_negative = bernstein[0] < Pack(0);
  Pack before = bernstein[0];
  Pack after = bernstein[Size - 1];
  Pack place(0);
  for (std::size_t i = 1; i + 1 < Size; ++i) {
    const auto differs = (bernstein[i] < Pack(0)) != is_negative;
    before = select(differs, before, bernstein[i]);
    place = place + select(differs, Pack(0), Pack(1));
  }
  for (std::size_t i = Size - 2; i > 0; --i) {
    const auto differs = (bernstein[i] < Pack(0)) != is_negative;
    after = select(differs, bernstein[i], after);
  }
  const Pack guess = (place + before / (before - after)) * Pack(2.0 / (Size - 1)) - Pack(1);
  return select(abs(guess) < Pack(1), guess, Pack(0));
}

/// The table that turns Bernstein coefficients on an arc into coefficients of the powers of m,
/// which is -1 at one end and 1 at the other: entry [i][j] is the coefficient of m^j in B_i.
template <std::size_t Degree>
inline constexpr auto powers_of_bernstein = [] {
  std::array<std::array<double, Degree + 1>, Degree + 1> table{};
  double scale = 1;
  for (std::size_t i = 0; i < Degree; ++i) {
    scale /= 2;
  }
  for (std::size_t i = 0; i <= Degree; ++i) {
    for (std::size_t j = 0; j <= Degree; ++j) {
      int sum = 0;  // of m^j in (1 + m)^i (1 - m)^(Degree - i)
      for (std::size_t k = 0; k <= j; ++k) {
        const int term = numeric::binomial(i, j - k) * numeric::binomial(Degree - i, k);
        sum += k % 2 == 0 ? term : -term;
      }
      table[i][j] = scale * numeric::binomial(Degree, i) * sum;
    }
  }
  return table;
}();

/// Computes the coefficients of the powers of m: exchanging the ends of an arc keeps those of even
/// powers and changes the sign of those of odd powers.
template <typename Pack, std::size_t Size>
void put_powers(const std::array<Pack, Size>& bernstein, std::array<Pack, Size>& power) {
  constexpr const auto& table = powers_of_bernstein<Size - 1>;
  constexpr std::size_t half = Size / 2;
  for (std::size_t j = 0; j < Size; ++j) {
    power[j] = j % 2 == 0 ? bernstein[half] * Pack(table[half][j]) : Pack(0);
  }
  for (std::size_t i = 0; i < half; ++i) {
    const Pack sum = bernstein[i] + bernstein[Size - 1 - i];
    const Pack difference = bernstein[i] - bernstein[Size - 1 - i];
    for (std::size_t j = 0; j < Size; ++j) {
      power[j] += (j % 2 == 0 ? sum : difference) * Pack(table[i][j]);
    }
  }
}

/// The brackets of several polynomials with one root each between -1 and 1, as `numeric::Bracket`
/// for one.
template <typename Pack, std::size_t Size>
class PackBracket {
  using Truth = decltype(Pack() < Pack());
  using Scalar = typename numeric::PartOf<Pack>::Type;

 public:
  /// Below `noise`, the value of a polynomial is due to rounding. Roots are sought in the `wanted`
  /// lanes.
  PackBracket(const std::array<Pack, Size>& bernstein, const Pack& noise, const Truth& wanted)
      : root_(crossing_of(bernstein)),
        noise_(noise),
        negative_left_(bernstein[0] < Pack(0)),
        open_(wanted) {
    put_powers(bernstein, power_);
  }

  /// Whether roots remain to be found.
  [[nodiscard]] bool is_open() const { return open_.any(); }
  [[nodiscard]] const Truth& open() const { return open_; }
  [[nodiscard]] const Pack& roots() const { return root_; }

  /// One step, to be repeated with 0, 1, ..., as in `numeric::improve`.
  [[gnu::always_inline]] void improve(int step) {
    constexpr Scalar u = std::numeric_limits<Scalar>::epsilon() / 2;
    // The first two steps of Horner's rule, without products of zero.
    Pack bend = power_[Size - 1];
    Pack slope = bend * root_ + power_[Size - 2];
    Pack value = slope * root_ + power_[Size - 3];
    slope = bend * root_ + slope;
    for (std::size_t i = Size - 3; i-- > 0;) {
      bend = bend * root_ + slope;
      slope = slope * root_ + value;
      value = value * root_ + power_[i];
    }
    const Pack square = slope * slope;
    Pack by;
    if (step < 3) {
      by = value * slope / (square - value * bend);
    } else {
      const Pack inside = square - Pack(4) * value * bend;
      const Pack reach = sqrt(select(inside > Pack(0), inside, Pack(0)));
      by = (value + value) / (slope + select(negative_left_, reach, -reach));
    }
    const Truth on_right = (value < Pack(0)) != negative_left_;
    left_ = select(on_right, left_, root_);
    right_ = select(on_right, root_, right_);
    const Pack next = root_ - by;
    const Truth follows = open_ & (left_ <= next) & (next <= right_);
    if (step < 2) {
      root_ = select(follows, next, (left_ + right_) * Pack(0.5));
      return;
    }
    const Truth exact =
        Pack(512) * abs(by) * (by * by) * (square + bend * bend) <= Pack(u) * square;
    const Truth lost = abs(value) <= noise_;
    const Truth falls = (slope > Pack(0)) != negative_left_;
    const Truth ends = open_ & (exact | lost) & !falls;
    // Later every second step bisects, so that the bracket closes in any case.
    const bool may_follow = step < 8 || step % 2 == 0;
    open_ = open_ & !ends;
    root_ = select(may_follow ? follows : follows & ends, next,
                   select(open_, (left_ + right_) * Pack(0.5), root_));
  }

 private:
  std::array<Pack, Size> power_;
  Pack left_ = Pack(-1), right_ = Pack(1), root_;
  Pack noise_;
  Truth negative_left_, open_;
};

/// The directions of roots t = tan((x - centre)/2) on charts whose centres have the given
/// directions.
template <typename Pack>
[[nodiscard]] Direction<Pack> direction_on_chart(const Pack& t, const Direction<Pack>& centre) {
  const Pack square = t * t;
  const Pack inverse = Pack(1) / (Pack(1) + square);
  const Pack cosine = (Pack(1) - square) * inverse;
  const Pack sine = (t + t) * inverse;
  return {cosine * centre.cos - sine * centre.sin, sine * centre.cos + cosine * centre.sin};
}

}  // namespace assur::detail::batch
