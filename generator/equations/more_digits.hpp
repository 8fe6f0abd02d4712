// Turns the evaluation of roots into one by more decimal digits.
#pragma once

#include <ginac/ginac.h>

namespace assur::generator::equations {

/// The digits that exact numbers are compared by where roots make them decimals.
inline constexpr int decimal_digits = 60;

/// Raises the number of digits of evaluation to that for as long as it lives.
class MoreDigits {
 public:
  MoreDigits() : before_(GiNaC::Digits) { GiNaC::Digits = decimal_digits; }
  ~MoreDigits() { GiNaC::Digits = before_; }
  MoreDigits(const MoreDigits&) = delete;
  MoreDigits& operator=(const MoreDigits&) = delete;

 private:
  long before_;
};

}  // namespace assur::generator::equations
