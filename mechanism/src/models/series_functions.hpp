// Taylor series of the functions that drivers' laws may contain.
#pragma once

#include "models/series.hpp"

namespace assur::mechanism::models {

[[nodiscard]] Series operator/(const Series& a, const Series& b);
[[nodiscard]] Series pow(const Series& base, double exponent);
/// If the exponent varies and the base is not positive, all coefficients except the value are
/// unknown, NaN.
[[nodiscard]] Series pow(const Series& base, const Series& exponent);
[[nodiscard]] Series sqrt(const Series& a);
[[nodiscard]] Series exp(const Series& a);
[[nodiscard]] Series log(const Series& a);
[[nodiscard]] Series sin(const Series& a);
[[nodiscard]] Series cos(const Series& a);
[[nodiscard]] Series tan(const Series& a);
[[nodiscard]] Series asin(const Series& a);
[[nodiscard]] Series acos(const Series& a);
[[nodiscard]] Series atan(const Series& a);
[[nodiscard]] Series atan2(const Series& y, const Series& x);
/// At a corner the series are those of the side of positive arguments of abs, and of the first
/// argument of min and max.
[[nodiscard]] Series abs(const Series& a);
[[nodiscard]] Series min(const Series& a, const Series& b);
[[nodiscard]] Series max(const Series& a, const Series& b);

/// Series are compared by their values, as numbers with derivatives are.
[[nodiscard]] inline bool operator==(const Series& a, const Series& b) {
  return a.value() == b.value();
}
[[nodiscard]] inline bool operator>(const Series& a, const Series& b) {
  return a.value() > b.value();
}
/// Whether the number also represents other values, as a formula with variable parameters does.
[[nodiscard]] inline bool may_change(const Series&) { return false; }

}  // namespace assur::mechanism::models
