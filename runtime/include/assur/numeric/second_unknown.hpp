// The second unknown of a model from its two reduced equations, once the first is known.
#pragma once

#include <algorithm>
#include <array>
#include <assur/model.hpp>
#include <assur/numeric/double_double.hpp>
#include <assur/numeric/order.hpp>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace assur::numeric {

template <typename Scalar>
[[nodiscard]] typename PartOf<Scalar>::Type size_of(const Scalar& value) {
  return std::abs(static_cast<typename PartOf<Scalar>::Type>(value));
}
/// The scalar of the residual of an unknown's value.
template <typename Unknown>
struct MissOf {
  using Type = typename PartOf<Unknown>::Type;
};
template <typename Scalar>
struct MissOf<Direction<Scalar>> {
  using Type = typename PartOf<Scalar>::Type;
};

/// Values of the second unknown that satisfy one of the equations, with their residuals in both,
/// relative to the size of the coefficients. Both equations hold at an assembly.
template <typename Unknown>
struct SecondCandidates {
  struct Candidate {
    Unknown value{};
    typename MissOf<Unknown>::Type miss = 0;
  };
  std::array<Candidate, 4> list;
  std::size_t count = 0;
};

/// a cos z + b sin z + c, relative to the size of its coefficients.
template <typename Scalar>
[[nodiscard]] typename PartOf<Scalar>::Type relative_miss(const Matrix<Scalar, 2, 3>& e, int row,
                                                          const Direction<Scalar>& z) {
  const Scalar value = e.coeff(row, 0) * z.cos + e.coeff(row, 1) * z.sin + e.coeff(row, 2);
  const auto scale = size_of(e.coeff(row, 0)) + size_of(e.coeff(row, 1)) + size_of(e.coeff(row, 2));
  return scale > 0 ? size_of(value) / scale : 0;
}

/// a z^2 + b z + c, relative to the size of its terms.
template <typename Scalar>
[[nodiscard]] typename PartOf<Scalar>::Type relative_miss(const Matrix<Scalar, 2, 3>& e, int row,
                                                          const Scalar& z) {
  const Scalar square = e.coeff(row, 0) * z * z;
  const Scalar linear = e.coeff(row, 1) * z;
  const auto scale = size_of(square) + size_of(linear) + size_of(e.coeff(row, 2));
  return scale > 0 ? size_of(square + linear + e.coeff(row, 2)) / scale : 0;
}

template <typename Scalar, typename Unknown>
void add_candidate(const Matrix<Scalar, 2, 3>& e, const Unknown& z,
                   SecondCandidates<Unknown>& candidates) {
  const auto miss = relative_miss(e, 0, z) + relative_miss(e, 1, z);
  if (std::isfinite(miss)) {
    candidates.list[candidates.count++] = {z, miss};
  }
}

/// a cos z + b sin z + c = 0: the foot of the perpendicular from the origin on the line, and from
/// there to both sides. A line that misses the circle by rounding counts as touching it.
template <typename Scalar>
void solve_row(const Matrix<Scalar, 2, 3>& e, int row,
               SecondCandidates<Direction<Scalar>>& candidates) {
  using std::sqrt;
  const Scalar& a = e.coeff(row, 0);
  const Scalar& b = e.coeff(row, 1);
  const Scalar& c = e.coeff(row, 2);
  const Scalar square = a * a + b * b;
  if (!(square > Scalar(0))) {
    return;
  }
  const Scalar inside = square - c * c;
  const Scalar root = inside > Scalar(0) ? Scalar(sqrt(inside)) : Scalar(0);
  for (const int side : {1, -1}) {
    const Scalar reach = Scalar(side) * root;
    Direction<Scalar> z{(-(a * c) - b * reach) / square, (-(b * c) + a * reach) / square};
    const Scalar norm = sqrt(z.cos * z.cos + z.sin * z.sin);
    if (norm > Scalar(0)) {
      z = {z.cos / norm, z.sin / norm};
      add_candidate(e, z, candidates);
    }
  }
}

/// a z^2 + b z + c = 0 by the formula that does not cancel.
template <typename Scalar>
void solve_row(const Matrix<Scalar, 2, 3>& e, int row, SecondCandidates<Scalar>& candidates) {
  using std::sqrt;
  const Scalar& a = e.coeff(row, 0);
  const Scalar& b = e.coeff(row, 1);
  const Scalar& c = e.coeff(row, 2);
  const Scalar inside = b * b - Scalar(4) * a * c;
  const Scalar root = inside > Scalar(0) ? Scalar(sqrt(inside)) : Scalar(0);
  const Scalar q = b > Scalar(0) ? -(b + root) / Scalar(2) : -(b - root) / Scalar(2);
  if (!(a == Scalar(0))) {
    add_candidate(e, Scalar(q / a), candidates);
  }
  if (!(q == Scalar(0))) {
    add_candidate(e, Scalar(c / q), candidates);
  }
}

/// How well a row determines an angle: the square of the sine of the angle between its line and the
/// circle.
template <typename Scalar>
[[nodiscard]] typename PartOf<Scalar>::Type sharpness(const Matrix<Scalar, 2, 3>& e, int row) {
  using Part = typename PartOf<Scalar>::Type;
  const auto a = static_cast<Part>(e.coeff(row, 0));
  const auto b = static_cast<Part>(e.coeff(row, 1));
  const auto c = static_cast<Part>(e.coeff(row, 2));
  const Part square = a * a + b * b;
  return square > 0 ? (square - c * c) / square : -1;
}

/// All candidates, by ascending residual. If one row alone determines an angle well, the other only
/// chooses between its two values.
template <typename Unknown, typename Scalar>
[[nodiscard]] SecondCandidates<Unknown> second_candidates(const Matrix<Scalar, 2, 3>& e) {
  SecondCandidates<Unknown> candidates;
  if constexpr (std::is_same_v<Unknown, Direction<Scalar>>) {
    const auto first = sharpness(e, 0);
    const auto second = sharpness(e, 1);
    solve_row(e, first > second ? 0 : 1, candidates);
    if ((std::max)(first, second) < static_cast<decltype(first)>(1e-3)) {
      solve_row(e, first > second ? 1 : 0, candidates);
    }
  } else {
    solve_row(e, 0, candidates);
    solve_row(e, 1, candidates);
  }
  auto& list = candidates.list;
  insertion_sort(
      candidates.count,
      [&list](std::size_t one, std::size_t other) { return list[one].miss < list[other].miss; },
      [&list](std::size_t one, std::size_t other) { std::swap(list[one], list[other]); });
  return candidates;
}

/// The common root of both equations, which are linear in the cosine and the sine, or in the
/// displacement and its square. NaN if they do not determine it.
template <typename Unknown, typename Scalar>
[[nodiscard]] Unknown common_root(const Matrix<Scalar, 2, 3>& e) {
  const Scalar determinant = e(0, 0) * e(1, 1) - e(0, 1) * e(1, 0);
  const Scalar second = e(0, 2) * e(1, 0) - e(0, 0) * e(1, 2);
  if constexpr (std::is_same_v<Unknown, Direction<Scalar>>) {
    const Scalar inverse = Scalar(1) / determinant;
    return {(e(0, 1) * e(1, 2) - e(0, 2) * e(1, 1)) * inverse, second * inverse};
  } else {
    const auto first_has_no_square = e(0, 0) == Scalar(0);
    const auto second_has_no_square = e(1, 0) == Scalar(0);
    if (static_cast<bool>(first_has_no_square & second_has_no_square)) {
      return -(e(0, 1) * e(0, 2) + e(1, 1) * e(1, 2)) / (e(0, 1) * e(0, 1) + e(1, 1) * e(1, 1));
    }
    return second / determinant;
  }
}

}  // namespace assur::numeric
