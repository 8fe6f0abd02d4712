// Random inputs, in doubles and in CLN's rational numbers.
#pragma once

#include <assur/model.hpp>
#include <assur/variables.hpp>
#include <complex>
#include <random>

#include "runtime/rational_scalar.hpp"

namespace assur::test {

inline Rational exact(double value) { return Rational::exactly(value); }
inline Direction<Rational> exact(const Direction<double>& value) {
  return {exact(value.cos), exact(value.sin)};
}

/// A length or an angle near `value`, for filling members by type.
class RandomInputs {
 public:
  explicit RandomInputs(unsigned seed) : engine_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  double length() { return between(-2.0, 2.0); }
  double angle() { return between(-3.14159, 3.14159); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }

  void fill(double& member) { member = length(); }
  void fill(Direction<double>& member) { member = direction_of(angle()); }
  void fill(Rational& member) { member = Rational(integer(-99, 99)) / Rational(integer(1, 40)); }
  /// A rational point of the unit circle.
  void fill(Direction<Rational>& member) {
    Rational t;
    fill(t);
    const Rational scale = Rational(1) / (Rational(1) + t * t);
    member = {(Rational(1) - t * t) * scale, Rational(2) * t * scale};
  }
  template <typename Variables>
  Variables variables() {
    Variables result;
    for_each_member(result, [this](auto& member, std::size_t) { this->fill(member); });
    return result;
  }
  template <typename Vector>
  Vector vector() {
    Vector result;
    for (Eigen::Index index = 0; index < result.size(); ++index) {
      fill(result(index));
    }
    return result;
  }

 private:
  std::mt19937 engine_;
};

/// The same variables in another scalar.
template <typename To, typename From, typename Convert>
To converted(const From& from, Convert convert) {
  To result;
  for_each_pair(result, from,
                [&convert](auto& target, const auto& source) { target = convert(source); });
  return result;
}

}  // namespace assur::test
