// Discriminants of final polynomials of first and second degree.
#pragma once

#include <assur/model.hpp>

namespace assur::support {

/// The discriminant, whose sign determines the number of real roots, and the leading coefficient of
/// a polynomial in a displacement, by which the formula divides (that of a trigonometric one is no
/// less than its discriminant).
template <typename Scalar>
struct Discriminants {
  Scalar discriminant{};
  Scalar leading{};
};

/// The discriminant of T = c0 + c1 cos x + s1 sin x: c1^2 + s1^2 - c0^2.
template <typename Scalar>
[[nodiscard]] Discriminants<Scalar> discriminants_of(const TrigonometricPolynomial<Scalar, 1>& T) {
  const Scalar leading = T.cosine[1] * T.cosine[1] + T.sine[1] * T.sine[1];
  return {leading - T.cosine[0] * T.cosine[0], leading};
}
/// The discriminant of T = a + b x, which has one root if its leading coefficient is not zero.
template <typename Scalar>
[[nodiscard]] Discriminants<Scalar> discriminants_of(const Vector<Scalar, 2>& T) {
  return {T(1) * T(1), T(1)};
}
/// The discriminant of T = a + b x + c x^2: b^2 - 4 a c.
template <typename Scalar>
[[nodiscard]] Discriminants<Scalar> discriminants_of(const Vector<Scalar, 3>& T) {
  return {T(1) * T(1) - Scalar(4) * T(2) * T(0), T(2)};
}

/// The longest length for which the error bounds of a specialised group hold, in the unit of its
/// numeric dimensions. Those of a model hold for a longest length of one.
inline constexpr double most_length_of_numbers = 8;
/// The highest degree in the lengths of a discriminant with known error bounds.
inline constexpr int highest_discriminant_degree = 7;

}  // namespace assur::support
