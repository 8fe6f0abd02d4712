// Bernstein form of a trigonometric polynomial on four charts, with error bounds.
//
// Error bounds. With (x, y) = (cos th/2, sin th/2), the polynomial T of order N is a form F of
// degree D = 2N in (x, y). Let u = epsilon/2, let S be the sum of |cosine[k]| + |sine[k]|, and let
// e be the error of the given coefficients.
//  1. A Bernstein coefficient is the symmetric multilinear form of F at D vectors of length at most
//     one, hence (Banach, 1938) at most the maximum of |F| on the unit circle, which is max |T|. So
//     an error e of every given coefficient changes no Bernstein coefficient, of a chart or of any
//     part of it, by more than (1 + sqrt(2) N) e.
//  2. A table entry is a weighted mean of at most four of the numbers 0, +-1 and +-sqrt(1/2), with
//     an error of at most 6u. The product with it adds u and meets at most four more roundings in
//     the sum, which makes 11u S together; 12u S covers higher orders.
//  3. When a chart is turned, the cosine and sine of k times the turn are within 10u, and the
//     product with the harmonic adds 3u; 14u S is used.
//  4. A cut takes D convex combinations mu p + lambda q one after another, each with an error of at
//     most 3u M, where M is the largest coefficient of the arc; 4D u M is used. M falls with the
//     width of the arc near a multiple root, so the bound does not pile up with depth. (A rounded
//     mu = 1 - lambda only changes the length of the dividing vector.)
#pragma once

#include <array>
#include <assur/model.hpp>
#include <cmath>
#include <limits>

namespace assur::numeric {

template <class Scalar>
inline Scalar magnitude(Scalar value) {
  using std::abs;
  return abs(value);
}

template <class Scalar>
inline bool negative(Scalar value) {
  return value < Scalar(0);
}

constexpr int binomial(std::size_t n, std::size_t k) {
  if (k > n) return 0;
  std::size_t value = 1;
  for (std::size_t i = 1; i <= k; ++i) value = value * (n - k + i) / i;
  return static_cast<int>(value);
}

/// The cosine and the sine of an angle, or the two coefficients of one frequency.
template <class Scalar>
struct Harmonic {
  Scalar cosine, sine;

  /// Returns the angle less `shift`, or, for coefficients, those of the function as seen from a
  /// chart centred at `shift`.
  [[nodiscard]] Harmonic less(Harmonic shift) const {
    return {cosine * shift.cosine + sine * shift.sine, sine * shift.cosine - cosine * shift.sine};
  }
  /// Returns the harmonic less a number of right angles, exactly.
  [[nodiscard]] Harmonic less_quarters(std::size_t quarters) const {
    switch (quarters % 4) {
      case 0:
        return *this;
      case 1:
        return {sine, -cosine};
      case 2:
        return {-cosine, -sine};
      default:
        return {-sine, cosine};
    }
  }
};

template <class Scalar, std::size_t N>
using Harmonics = std::array<Harmonic<Scalar>, N + 1>;

/// Linear maps from harmonics to the Bernstein coefficients on the arc [-pi/4, pi/4], and to the
/// coefficients of p(t) = (1 + t^2)^N T with t = tan(th/2).
template <class Scalar, std::size_t N>
struct ChartTables {
  static constexpr std::size_t degree = 2 * N;
  /// sqrt(1/2), to the digits of double-double.
  static constexpr Scalar half_root =
      constant<Scalar>(0x1.6a09e667f3bcdp-1, -0x1.bdd3413b26456p-55);
  using Polynomial = std::array<Scalar, degree + 1>;
  struct Map {
    std::array<Polynomial, N + 1> cosine{};
    std::array<Polynomial, N + 1> sine{};

    /// Returns the coefficients on the chart centred at chart * pi/2.
    [[nodiscard]] Polynomial apply(const Harmonics<Scalar, N>& harmonics, std::size_t chart) const {
      Polynomial image{};
      for (std::size_t k = 0; k <= N; ++k) {
        const Harmonic<Scalar> h = harmonics[k].less_quarters(k * chart);
        for (std::size_t i = 0; i <= degree; ++i) {
          image[i] += h.cosine * cosine[k][i] + h.sine * sine[k][i];
        }
      }
      return image;
    }
  };
  Map bernstein;
  Map power;

  // With z = x + i y, cos k th and sin k th are the real and imaginary parts of z^(N+k)
  // conj(z)^(N-k). Its symmetric form at 2N - i vectors of angle -pi/8 and i of angle pi/8 is the
  // mean over all choices of the N - k conjugates.
  constexpr ChartTables() {
    const auto cosine_of_eighths = [](std::size_t eighths) {
      constexpr std::array<int, 8> rational{1, 0, 0, 0, -1, 0, 0, 0};
      constexpr std::array<int, 8> irrational{0, 1, 0, -1, 0, -1, 0, 1};
      return Scalar(rational[eighths % 8]) + Scalar(irrational[eighths % 8]) * half_root;
    };
    for (std::size_t k = 0; k <= N; ++k) {
      const auto choices = Scalar(binomial(degree, N - k));
      for (std::size_t i = 0; i <= degree; ++i) {
        Scalar cosine(0);
        Scalar sine(0);
        for (std::size_t j = 0; j <= N - k; ++j) {
          const auto weight = Scalar(binomial(i, j) * binomial(degree - i, N - k - j));
          cosine += weight * cosine_of_eighths(32 + i - 2 * j - k);
          sine += weight * cosine_of_eighths(30 + i - 2 * j - k);
        }
        bernstein.cosine[k][i] = cosine / choices;
        bernstein.sine[k][i] = sine / choices;
        int coefficient =
            0;  // of t^i in (1 + i t)^2k (1 + t^2)^(N-k), without the i of the odd powers
        for (std::size_t j = 0; 2 * j <= i; ++j) {
          const int term = binomial(2 * k, i - 2 * j) * binomial(N - k, j);
          coefficient += (i - 2 * j) % 4 < 2 ? term : -term;
        }
        (i % 2 == 0 ? power.cosine : power.sine)[k][i] = Scalar(coefficient);
      }
    }
  }
};

template <class Scalar, std::size_t N>
inline constexpr ChartTables<Scalar, N> chart_tables;

template <class Scalar, std::size_t N>
inline Scalar transform_error(Scalar coefficient_error, Scalar sum) {
  const Scalar u = std::numeric_limits<Scalar>::epsilon() / Scalar(2);
  return coefficient_error * Scalar(1.0 + 1.4143 * static_cast<double>(N)) + Scalar(12) * u * sum;
}

template <class Scalar>
inline Scalar turn_error(Scalar sum) {
  return Scalar(7) * std::numeric_limits<Scalar>::epsilon() * sum;
}

template <class Scalar, std::size_t Size>
inline Scalar cut_error(const std::array<Scalar, Size>& b) {
  Scalar largest(0);
  for (const Scalar& x : b) largest = magnitude(x) > largest ? magnitude(x) : largest;
  return Scalar(2 * static_cast<int>(Size - 1)) * std::numeric_limits<Scalar>::epsilon() * largest;
}

/// Returns the largest number of sign variations that coefficients within `error` of b can have.
/// The signs of the first and the last are taken as known: they were certain when the arc was cut
/// there, though the error may have grown since.
template <class Scalar, std::size_t Size>
inline int count_variations(const std::array<Scalar, Size>& b, Scalar error) {
  int count = negative(b[Size - 1]) != negative(b[Size - 2]);
  bool uncertain = false;
  for (std::size_t i = 1; i + 1 < Size; ++i) {
    count += negative(b[i]) != negative(b[i - 1]);
    uncertain |= !(magnitude(b[i]) > error);
  }
  if (!uncertain) return count;
  // The most variations arise when every uncertain coefficient opposes the one before it.
  count = 0;
  bool last = negative(b[0]);
  for (std::size_t i = 1; i < Size; ++i) {
    const bool next = magnitude(b[i]) > error || i + 1 == Size ? negative(b[i]) : !last;
    count += next != last;
    last = next;
  }
  return count;
}

/// Computes, by de Casteljau's method, the Bernstein coefficients of the parts before and after the
/// fraction lambda. Taking in one coefficient after the other, instead of level by level, lets
/// compilers keep the triangle in registers.
template <class Scalar, std::size_t Size>
inline void cut_at(Scalar lambda, const std::array<Scalar, Size>& b,
                   std::array<Scalar, Size>& before, std::array<Scalar, Size>& after) {
  const Scalar mu = Scalar(1) - lambda;
  std::array<Scalar, Size> edge;
  for (std::size_t i = 0; i < Size; ++i) {
    Scalar x = b[i];
    for (std::size_t k = 0; k < i; ++k) {
      const Scalar next = mu * edge[k] + lambda * x;
      edge[k] = x;
      x = next;
    }
    before[i] = edge[i] = x;
  }
  for (std::size_t i = 0; i < Size; ++i) after[i] = edge[Size - 1 - i];
}

}  // namespace assur::numeric
