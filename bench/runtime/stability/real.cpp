// Arithmetic in 50 decimal digits by Boost.Multiprecision.
#include "stability/real.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <new>
#include <type_traits>

namespace assur::stability {

/// 50 decimal digits, without expression templates.
using Number = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                             boost::multiprecision::et_off>;

struct Real::Access {
  static const Number& in(const Real& real) {
    return *std::launder(reinterpret_cast<const Number*>(real.storage_.data()));
  }
  static void put(Real& real, const Number& number) {
    static_assert(sizeof(Number) <= sizeof real.storage_ && alignof(Number) <= alignof(Real));
    static_assert(std::is_trivially_destructible_v<Number>);
    new (real.storage_.data()) Number(number);
  }
  static Real made_of(const Number& number) {
    Real real;
    put(real, number);
    return real;
  }
};

Real::Real() { Access::put(*this, Number()); }
Real::Real(int value) { Access::put(*this, Number(value)); }
Real::Real(std::ptrdiff_t value) { Access::put(*this, Number(value)); }
Real::Real(double value) { Access::put(*this, Number(value)); }
Real::Real(const std::string& digits) { Access::put(*this, Number(digits)); }
Real::Real(const Real& other) { Access::put(*this, Access::in(other)); }
Real& Real::operator=(const Real& other) {
  if (this != &other) {
    Access::put(*this, Access::in(other));
  }
  return *this;
}

Real::operator int() const { return static_cast<int>(Access::in(*this)); }
Real::operator double() const { return static_cast<double>(Access::in(*this)); }
Real::operator long double() const { return static_cast<long double>(Access::in(*this)); }

Real operator+(const Real& a, const Real& b) {
  return Real::Access::made_of(Real::Access::in(a) + Real::Access::in(b));
}
Real operator-(const Real& a, const Real& b) {
  return Real::Access::made_of(Real::Access::in(a)-Real::Access::in(b));
}
Real operator*(const Real& a, const Real& b) {
  return Real::Access::made_of(Real::Access::in(a)*Real::Access::in(b));
}
Real operator/(const Real& a, const Real& b) {
  return Real::Access::made_of(Real::Access::in(a) / Real::Access::in(b));
}
Real operator-(const Real& a) { return Real::Access::made_of(-Real::Access::in(a)); }
bool operator==(const Real& a, const Real& b) { return Real::Access::in(a) == Real::Access::in(b); }
bool operator<(const Real& a, const Real& b) { return Real::Access::in(a) < Real::Access::in(b); }
bool operator<=(const Real& a, const Real& b) { return Real::Access::in(a) <= Real::Access::in(b); }

Real abs(const Real& a) { return Real::Access::made_of(abs(Real::Access::in(a))); }
Real sqrt(const Real& a) { return Real::Access::made_of(sqrt(Real::Access::in(a))); }
Real sin(const Real& a) { return Real::Access::made_of(sin(Real::Access::in(a))); }
Real cos(const Real& a) { return Real::Access::made_of(cos(Real::Access::in(a))); }
bool isfinite(const Real& a) { return boost::multiprecision::isfinite(Real::Access::in(a)); }

Real Real::epsilon() { return Access::made_of(std::numeric_limits<Number>::epsilon()); }

}  // namespace assur::stability
