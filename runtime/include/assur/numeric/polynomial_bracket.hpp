// Root of a polynomial in an isolating bracket.
#pragma once

#include <array>
#include <cmath>
#include <limits>

namespace assur::numeric {

/// An interval that holds exactly one root.
template <class Scalar>
struct Bracket {
  std::size_t chart;
  bool negative_left;  ///< the sign of the polynomial at the left end
  Scalar left, right, t;
  bool done = false;
};

/// Makes one step towards the root, to be repeated with iteration = 0, 1, ... until it is done.
/// `power` holds ascending coefficients; below `noise`, the value of the polynomial is due to
/// rounding. Three steps of Halley's method nearly always suffice. Close roots need more steps,
/// which take the zero of the local parabola on its rising or falling side, according to the
/// bracket.
template <class Scalar, std::size_t Size>
inline void improve(Bracket<Scalar>& b, const std::array<Scalar, Size>& power, Scalar noise,
                    int iteration) {
  using std::abs;
  using std::sqrt;
  Scalar value(0);  // p
  Scalar slope(0);  // p'
  Scalar bend(0);   // p''/2
  for (std::size_t i = Size; i-- > 0;) {
    bend = bend * b.t + slope;
    slope = slope * b.t + value;
    value = value * b.t + power[i];
  }
  const Scalar square = slope * slope;
  Scalar step(0);
  if (iteration < 3) {
    step = value * slope / (square - value * bend);
  } else {
    const Scalar inside = square - Scalar(4) * value * bend;
    const Scalar root = sqrt(inside > Scalar(0) ? inside : Scalar(0));
    step = (value + value) / (b.negative_left ? slope + root : slope - root);
  }
  const bool on_left = (value < Scalar(0)) == b.negative_left;
  b.left = on_left ? b.t : b.left;
  b.right = on_left ? b.right : b.t;
  const Scalar next = b.t - step;
  const bool inside = next >= b.left && next <= b.right;
  // Done if the remaining error, about step^3 ((p''/2p')^2 + p'''/6p'), is below the effect of
  // rounding p, u / p', or if p itself is. The slope distinguishes the root from a neighbour just
  // outside the bracket.
  const Scalar u = std::numeric_limits<Scalar>::epsilon() / Scalar(2);
  const bool exact = Scalar(512) * abs(step) * step * step * (square + bend * bend) <= u * square;
  const bool lost = abs(value) <= noise;
  b.done = iteration > 1 && (exact | lost) && (slope > Scalar(0)) == b.negative_left;
  // Later every second step bisects, so that the bracket closes in any case.
  const bool follow = inside && (b.done || iteration < 8 || iteration % 2 == 0);
  b.t = follow ? next : b.done ? b.t : (b.left + b.right) / Scalar(2);
}

}  // namespace assur::numeric
