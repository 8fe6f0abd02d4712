#include "program/coefficient.hpp"

#include <sstream>
#include <utility>

namespace assur::generator::program {

Coefficient::Coefficient(GiNaC::numeric value, GiNaC::ex origin)
    : value_(std::move(value)), origin_(std::move(origin)) {
  // A coefficient of zero, one or minus one is written without names.
  if (is_zero() || !scales()) {
    origin_ = value_;
  }
}

std::string Coefficient::text() const {
  // Nearly all coefficients are small integers, which a stream prints more slowly.
  if (value_.is_integer() && GiNaC::abs(value_) < 1000) {
    return std::to_string(value_.to_int());
  }
  std::ostringstream digits;
  digits << value_;
  return digits.str();
}

Coefficient& Coefficient::operator+=(const Coefficient& other) {
  return *this = {value_ + other.value_, origin_ + other.origin_};
}

Coefficient& Coefficient::operator*=(const Coefficient& other) {
  if (!other.scales()) {
    return other.is_negative() ? *this = -*this : *this;
  }
  return *this = {value_ * other.value_, origin_ * other.origin_};
}

Coefficient& Coefficient::operator/=(const Coefficient& other) {
  if (!other.scales()) {
    return *this *= other;
  }
  return *this = {value_ / other.value_, origin_ / other.origin_};
}

}  // namespace assur::generator::program
