#include "models/series_functions.hpp"

#include <algorithm>
#include <assur/directions.hpp>
#include <cmath>
#include <limits>

namespace assur::mechanism::models {

namespace {

/// f0 + f1 (a - a0) + f2 (a - a0)^2 + ..., from the Taylor coefficients of a function at a0.
Series taylor(const std::array<double, Series::order + 1>& f, const Series& a) {
  Series step = a;
  step.c[0] = 0;
  Series result = f.back();
  for (std::size_t k = Series::order; k-- > 0;) {
    result = result * step + Series(f[k]);
  }
  return result;
}

/// The derivative with respect to t, without its last coefficient, which is unknown.
Series rate_of(const Series& a) {
  Series rate;
  for (std::size_t k = 0; k < Series::order; ++k) {
    rate.c[k] = static_cast<double>(k + 1) * a.c[k + 1];
  }
  return rate;
}

/// The series with an initial value and a rate.
Series integral(double start, const Series& rate) {
  Series result(start);
  for (std::size_t k = 1; k <= Series::order; ++k) {
    result.c[k] = rate.c[k - 1] / static_cast<double>(k);
  }
  return result;
}

}  // namespace

Series pow(const Series& base, double exponent) {
  // The base is divided by its value, so that its powers remain in range in any unit.
  const double unit = base.value() == 0 ? 1 : base.value();
  Series part = base;
  for (double& coefficient : part.c) {
    coefficient /= unit;
  }
  std::array<double, Series::order + 1> f{};
  double factor = 1;  // exponent over k
  for (std::size_t k = 0; k < f.size(); ++k) {
    const double left = exponent - static_cast<double>(k);
    f[k] = factor == 0 ? 0 : factor * std::pow(part.value(), left);
    factor *= left / static_cast<double>(k + 1);
  }
  Series power = taylor(f, part);
  const double scale = std::pow(unit, exponent);
  for (double& coefficient : power.c) {
    coefficient *= scale;
  }
  return power;
}

Series operator/(const Series& a, const Series& b) { return a * pow(b, -1); }
Series sqrt(const Series& a) { return pow(a, 0.5); }

Series exp(const Series& a) {
  const double e = std::exp(a.value());
  return taylor({e, e, e / 2, e / 6, e / 24}, a);
}
Series log(const Series& a) { return integral(std::log(a.value()), rate_of(a) / a); }
Series pow(const Series& base, const Series& exponent) {
  if (std::all_of(exponent.c.begin() + 1, exponent.c.end(), [](double c) { return c == 0; })) {
    return pow(base, exponent.value());
  }
  if (base.value() > 0) {
    return exp(exponent * log(base));
  }
  Series result;
  result.c.fill(std::numeric_limits<double>::quiet_NaN());
  result.c[0] = std::pow(base.value(), exponent.value());
  return result;
}

Series sin(const Series& a) {
  const double s = std::sin(a.value());
  const double c = std::cos(a.value());
  return taylor({s, c, -s / 2, -c / 6, s / 24}, a);
}
Series cos(const Series& a) {
  const double s = std::sin(a.value());
  const double c = std::cos(a.value());
  return taylor({c, -s, -c / 2, s / 6, c / 24}, a);
}
Series tan(const Series& a) { return sin(a) / cos(a); }

Series asin(const Series& a) {
  return integral(std::asin(a.value()), rate_of(a) / sqrt(Series(1) - a * a));
}
Series acos(const Series& a) {
  return integral(std::acos(a.value()), -rate_of(a) / sqrt(Series(1) - a * a));
}
Series atan(const Series& a) {
  return integral(std::atan(a.value()), rate_of(a) / (Series(1) + a * a));
}
Series abs(const Series& a) { return a.value() < 0 ? -a : a; }
Series min(const Series& a, const Series& b) { return b.value() < a.value() ? b : a; }
Series max(const Series& a, const Series& b) { return a.value() < b.value() ? b : a; }

Series atan2(const Series& y, const Series& x) {
  return integral(std::atan2(y.value(), x.value()),
                  (x * rate_of(y) - y * rate_of(x)) / (x * x + y * y));
}

}  // namespace assur::mechanism::models
