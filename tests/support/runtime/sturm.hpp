// Exact counts of real roots: Sturm's theorem over CLN's rational numbers.
#pragma once

#include <algorithm>
#include <vector>

#include "runtime/exact.hpp"

namespace assur::test {

/// A polynomial with rational coefficients, by ascending power, without leading zeros.
using RationalPolynomial = std::vector<Rational>;

inline void trim(RationalPolynomial& p) {
  while (!p.empty() && p.back().is_zero()) {
    p.pop_back();
  }
}

inline RationalPolynomial product(const RationalPolynomial& a, const RationalPolynomial& b) {
  RationalPolynomial result(a.size() + b.size() - 1, Rational(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      result[i + j] = result[i + j] + a[i] * b[j];
    }
  }
  return result;
}

/// Remainder of the division of a by b.
inline RationalPolynomial remainder(RationalPolynomial a, const RationalPolynomial& b) {
  while (a.size() >= b.size() && !a.empty()) {
    const Rational factor = a.back() / b.back();
    for (std::size_t i = 0; i < b.size(); ++i) {
      const std::size_t place = a.size() - b.size() + i;
      a[place] = a[place] - factor * b[i];
    }
    a.pop_back();
    trim(a);
  }
  return a;
}

/// Distinct real roots on the whole line: sign changes of the Sturm chain at -infinity less those
/// at +infinity.
inline int real_root_count(RationalPolynomial p) {
  trim(p);
  std::vector<RationalPolynomial> chain = {p, {}};
  for (std::size_t i = 1; i < p.size(); ++i) {
    chain[1].push_back(p[i] * Rational(static_cast<int>(i)));
  }
  while (!chain.back().empty()) {
    RationalPolynomial next = remainder(chain[chain.size() - 2], chain.back());
    for (Rational& coefficient : next) {
      coefficient = -coefficient;
    }
    chain.push_back(std::move(next));
  }
  const auto changes = [&](bool at_minus_infinity) {
    int count = 0;
    int last = 0;
    for (const RationalPolynomial& member : chain) {
      if (member.empty()) {
        continue;
      }
      int sign = member.back().is_positive() ? 1 : -1;
      if (at_minus_infinity && member.size() % 2 == 0) {
        sign = -sign;
      }
      count += last != 0 && sign != last ? 1 : 0;
      last = sign;
    }
    return count;
  };
  return changes(true) - changes(false);
}

/// (1 + t^2)^n T with t = tan(x/2): cos kx and sin kx are the real and imaginary part of
/// (1 + i t)^2k (1 + t^2)^(n-k). A root at x = pi is a vanishing leading coefficient.
template <std::size_t Degree>
RationalPolynomial half_angle_polynomial(const TrigonometricPolynomial<Rational, Degree>& T) {
  RationalPolynomial sum(2 * Degree + 1, Rational(0));
  for (std::size_t k = 0; k <= Degree; ++k) {
    RationalPolynomial re = {Rational(1)};
    RationalPolynomial im = {Rational(0)};
    for (std::size_t factor = 0; factor < 2 * k; ++factor) {
      // (re + i im)(1 + i t)
      const RationalPolynomial t_re = product(re, {Rational(0), Rational(1)});
      const RationalPolynomial t_im = product(im, {Rational(0), Rational(1)});
      re.resize(t_re.size(), Rational(0));
      im.resize(t_im.size(), Rational(0));
      for (std::size_t i = 0; i < re.size(); ++i) {
        re[i] = re[i] - t_im[i];
        im[i] = im[i] + t_re[i];
      }
    }
    for (std::size_t factor = k; factor < Degree; ++factor) {
      re = product(re, {Rational(1), Rational(0), Rational(1)});
      im = product(im, {Rational(1), Rational(0), Rational(1)});
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] = sum[i] + T.cosine[k] * re[i] + (k == 0 ? Rational(0) : T.sine[k] * im[i]);
    }
  }
  return sum;
}

/// A model's final polynomial for exact dimensions and inputs: in the unknown if it is a
/// displacement, else in the tangent of half of it.
template <typename Model>
RationalPolynomial exact_final_polynomial(const typename Model::template Dimensions<double>& d,
                                          const typename Model::template Inputs<double>& u) {
  const auto convert = [](const auto& value) { return exact(value); };
  const auto exact_d = converted<typename Model::template Dimensions<Rational>>(d, convert);
  const auto exact_u = converted<typename Model::template Inputs<Rational>>(u, convert);
  if constexpr (Model::unknowns[static_cast<std::size_t>(Model::first_unknown)].is_angle) {
    TrigonometricPolynomial<Rational, Model::polynomial_degree> T;
    Model::position_polynomial(exact_d, exact_u, T);
    return half_angle_polynomial(T);
  } else {
    Vector<Rational, static_cast<int>(Model::polynomial_degree) + 1> T;
    Model::position_polynomial(exact_d, exact_u, T);
    return RationalPolynomial(T.begin(), T.end());
  }
}

/// Distinct real roots of that polynomial; if the leading coefficient vanishes, the angle pi counts
/// as one.
template <typename Model>
int exact_assembly_count(const typename Model::template Dimensions<double>& d,
                         const typename Model::template Inputs<double>& u) {
  const RationalPolynomial p = exact_final_polynomial<Model>(d, u);
  const bool is_angle = Model::unknowns[static_cast<std::size_t>(Model::first_unknown)].is_angle;
  return real_root_count(p) + (is_angle && p.back().is_zero() ? 1 : 0);
}

}  // namespace assur::test
