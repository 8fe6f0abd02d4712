// Raises the number of decimal digits in numeric evaluation.
#pragma once

#include <ginac/ginac.h>

namespace assur::generator::equations {

/// The number of digits for comparing values that are decimals because of roots.
inline constexpr int decimal_digits = 60;

/// Raises the number of digits of evaluation during its lifetime.
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
