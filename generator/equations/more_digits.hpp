// Turns the evaluation of roots into one with more decimal digits.
#pragma once

#include <ginac/ginac.h>

namespace assur::generator::equations {

/// The number of digits with which values are compared where roots make them decimals.
inline constexpr int decimal_digits = 60;

/// Raises the number of digits of evaluation for as long as it lives.
class MoreDigits {
 public:
  explicit MoreDigits(int digits = decimal_digits) : before_(GiNaC::Digits) {
    GiNaC::Digits = digits;
  }
  ~MoreDigits() { GiNaC::Digits = before_; }
  MoreDigits(const MoreDigits&) = delete;
  MoreDigits& operator=(const MoreDigits&) = delete;

 private:
  long before_;
};

}  // namespace assur::generator::equations
