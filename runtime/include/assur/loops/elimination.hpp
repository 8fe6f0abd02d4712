// Tables for the elimination of a group's loop closures down to one unknown, in complex numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace assur::loops {

/// A set of angles, by the bits of their numbers.
using AngleSet = std::uint32_t;

[[nodiscard]] constexpr AngleSet bit(std::ptrdiff_t angle) { return AngleSet(1) << angle; }
[[nodiscard]] constexpr bool holds(AngleSet set, std::ptrdiff_t angle) {
  return (set & bit(angle)) != 0;
}

/// The elimination of a group's equations down to one unknown: all angles are measured relative to
/// one of them, the ground, and another one, x = exp(i angle), is hidden in the coefficients. With
/// t_c = 1 / theta_c, every set K of the other angles gives one equation: of the 2l loops and
/// conjugates, linear in theta_c, t_c and the displacements, all theta_c with c outside K, all t_c
/// with c in K and all displacements are eliminated, and the remaining equation is multiplied by
/// the product t_K:
///   sum_{c in K} [theta_c] t_{K - c} + sum_{c outside K} [t_c] t_{K + c} + [1] t_K = 0.
/// The equations are linear in the products of the columns, with polynomials in x as coefficients.
/// Wampler, Solving the kinematics of planar mechanisms by Dixon determinant and a complex-plane
/// formulation, Journal of Mechanical Design 123 (2001); slides as in docs/method/groups.md.
struct Elimination {
  /// In place of a hidden angle if slides fix all angles: the equations are then linear.
  static constexpr int none = -1;

  int ground;
  int hidden;
  int size;                  ///< number of equations, and of products
  int degree;                ///< of the polynomials in x, each row starting at x^0
  const AngleSet* sets;      ///< of the equations, one per row
  const AngleSet* products;  ///< one per column, in ascending order
  const int* lowest_powers;  ///< of x, in each row

  [[nodiscard]] int eigenvalues() const { return size * degree; }
  /// The column of a product; `size` if there is none.
  [[nodiscard]] int column_of(AngleSet product) const {
    const AngleSet* const end = products + size;
    const AngleSet* const found = std::lower_bound(products, end, product);
    return static_cast<int>(found != end && *found == product ? found - products : size);
  }
};

}  // namespace assur::loops
