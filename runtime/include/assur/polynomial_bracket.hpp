// Turns a bracket that holds one root of a polynomial into that root, for trigonometric_roots.hpp.
#pragma once

#include <array>
#include <cmath>
#include <limits>

namespace assur::detail {

template <class Scalar>
struct Bracket {  // holds exactly one root
  std::size_t chart;
  bool negative_left;  // the sign of the polynomial at the left end
  Scalar left, right, t;
  bool done = false;
};

// One step, to be repeated with iteration = 0, 1, ... until done. `power` holds ascending
// coefficients. Three steps of Halley's method nearly always do; roots close to each other need
// more, and then the next zero of the local parabola is taken, on its rising or falling side as the
// bracket tells: it cannot step to the neighbour.
template <class Scalar, std::size_t Size>
inline void improve(Bracket<Scalar>& b, const std::array<Scalar, Size>& power, int iteration) {
  using std::abs;
  using std::sqrt;
  Scalar value(0), slope(0), bend(0);  // p, p', p''/2
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
  // Past a few steps every other one bisects: the bracket closes whatever the others do.
  const bool accept = next >= b.left && next <= b.right && (iteration < 8 || iteration % 2 == 0);
  b.t = accept ? next : (b.left + b.right) / Scalar(2);
  // The error left is about step^3 ((p''/2p')^2 + p'''/6p'): below the effect of rounding p, u /
  // p', from here on.
  const Scalar u = std::numeric_limits<Scalar>::epsilon() / Scalar(2);
  b.done = accept && iteration > 1 &&
           Scalar(512) * abs(step) * step * step * (square + bend * bend) <= u * square;
}

}  // namespace assur::detail
