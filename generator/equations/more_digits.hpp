// Turns the evaluation of roots into one with more decimal digits.
#pragma once

#include <ginac/ginac.h>

namespace assur::generator::equations {

/// The number of digits with which values are compared where roots make them decimals.
inline constexpr int decimal_digits = 60;

/// Raises the number of digits of evaluation to `decimal_digits` for as long as it lives.
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
