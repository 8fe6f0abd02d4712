// Polynomials in one unknown with symbolic coefficients: Laurent polynomials in exp(i x) for an
// angle x, ordinary ones for a displacement.
#pragma once

#include <map>

#include "equations/vocabulary.hpp"

namespace assur::generator::elimination {

/// A complex number whose parts are real expressions.
struct ComplexExpression {
  GiNaC::ex re;
  GiNaC::ex im;

  [[nodiscard]] bool is_zero() const { return re.is_zero() && im.is_zero(); }
};

[[nodiscard]] ComplexExpression operator+(const ComplexExpression& a, const ComplexExpression& b);
[[nodiscard]] ComplexExpression operator-(const ComplexExpression& a, const ComplexExpression& b);
[[nodiscard]] ComplexExpression operator*(const ComplexExpression& a, const ComplexExpression& b);
[[nodiscard]] ComplexExpression conjugate(const ComplexExpression& a);

/// sum of coefficient[k] w^k. With w = exp(i x) for an angle x, negative powers occur and a real
/// function has coefficient[-k] = conjugate(coefficient[k]); with w = x for a displacement, all
/// coefficients are real.
class Univariate {
 public:
  void add(int power, const ComplexExpression& coefficient);
  [[nodiscard]] const std::map<int, ComplexExpression>& coefficients() const {
    return coefficients_;
  }
  [[nodiscard]] ComplexExpression at(int power) const;
  /// Largest power with a nonzero coefficient; -1 for the zero polynomial.
  [[nodiscard]] int degree() const;
  [[nodiscard]] bool is_zero() const { return coefficients_.empty(); }
  /// The conjugate on the unit circle: coefficient[-k] of the result is conj(coefficient[k]).
  [[nodiscard]] Univariate circle_conjugate() const;
  /// The polynomial with every coefficient named `<name>_<power>` in the vocabulary.
  [[nodiscard]] Univariate named(const std::string& name, const std::string& meaning,
                                 equations::Vocabulary& vocabulary) const;

 private:
  std::map<int, ComplexExpression> coefficients_;
};

[[nodiscard]] Univariate operator+(const Univariate& a, const Univariate& b);
[[nodiscard]] Univariate operator-(const Univariate& a, const Univariate& b);
[[nodiscard]] Univariate operator*(const Univariate& a, const Univariate& b);
[[nodiscard]] Univariate operator*(const ComplexExpression& factor, const Univariate& a);

}  // namespace assur::generator::elimination
