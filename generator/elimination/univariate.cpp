#include "elimination/univariate.hpp"

#include <algorithm>
#include <cstdlib>

namespace assur::generator::elimination {

ComplexExpression operator+(const ComplexExpression& a, const ComplexExpression& b) {
  return {(a.re + b.re).expand(), (a.im + b.im).expand()};
}
ComplexExpression operator-(const ComplexExpression& a, const ComplexExpression& b) {
  return {(a.re - b.re).expand(), (a.im - b.im).expand()};
}
ComplexExpression operator*(const ComplexExpression& a, const ComplexExpression& b) {
  return {(a.re * b.re - a.im * b.im).expand(), (a.re * b.im + a.im * b.re).expand()};
}
ComplexExpression conjugate(const ComplexExpression& a) { return {a.re, -a.im}; }

void Univariate::add(int power, const ComplexExpression& coefficient) {
  const ComplexExpression sum = at(power) + coefficient;
  if (sum.is_zero()) {
    coefficients_.erase(power);
  } else {
    coefficients_[power] = sum;
  }
}

ComplexExpression Univariate::at(int power) const {
  const auto found = coefficients_.find(power);
  return found == coefficients_.end() ? ComplexExpression{0, 0} : found->second;
}

int Univariate::degree() const {
  return coefficients_.empty()
             ? -1
             : std::max(coefficients_.rbegin()->first, std::abs(coefficients_.begin()->first));
}

Univariate Univariate::circle_conjugate() const {
  Univariate result;
  for (const auto& [power, coefficient] : coefficients_) {
    result.add(-power, conjugate(coefficient));
  }
  return result;
}

Univariate Univariate::named(const std::string& name, const std::string& meaning,
                             equations::Vocabulary& vocabulary) const {
  Univariate result;
  for (const auto& [power, coefficient] : coefficients_) {
    const std::string place = name + (power < 0 ? "_m" : "_") + std::to_string(std::abs(power));
    const std::string what = meaning + ", power " + std::to_string(power);
    result.add(power, {vocabulary.name(place + "_re", coefficient.re, what + ", real part"),
                       vocabulary.name(place + "_im", coefficient.im, what + ", imaginary part")});
  }
  return result;
}

Univariate operator+(const Univariate& a, const Univariate& b) {
  Univariate sum = a;
  for (const auto& [power, coefficient] : b.coefficients()) {
    sum.add(power, coefficient);
  }
  return sum;
}

Univariate operator-(const Univariate& a, const Univariate& b) {
  Univariate difference = a;
  for (const auto& [power, coefficient] : b.coefficients()) {
    difference.add(power, ComplexExpression{0, 0} - coefficient);
  }
  return difference;
}

Univariate operator*(const Univariate& a, const Univariate& b) {
  Univariate product;
  for (const auto& [a_power, a_coefficient] : a.coefficients()) {
    for (const auto& [b_power, b_coefficient] : b.coefficients()) {
      product.add(a_power + b_power, a_coefficient * b_coefficient);
    }
  }
  return product;
}

Univariate operator*(const ComplexExpression& factor, const Univariate& a) {
  Univariate product;
  for (const auto& [power, coefficient] : a.coefficients()) {
    product.add(power, factor * coefficient);
  }
  return product;
}

}  // namespace assur::generator::elimination
