// Exact derivatives up to the third of functions templated on their scalar.
#pragma once

#include <assur/variables.hpp>
#include <tuple>
#include <utility>

namespace assur::test {

/// c0 + c1 t + c2 t^2 + c3 t^3, truncated. Over rational numbers every coefficient is exact.
template <typename Number>
struct Taylor {
  Number c0{0};
  Number c1{0};
  Number c2{0};
  Number c3{0};

  Taylor() = default;
  Taylor(int value) : c0(value) {}  // NOLINT(google-explicit-constructor): as numbers convert
  Taylor(Number value, Number first, Number second, Number third)
      : c0(std::move(value)), c1(std::move(first)), c2(std::move(second)), c3(std::move(third)) {}

  friend Taylor operator+(const Taylor& a, const Taylor& b) {
    return {a.c0 + b.c0, a.c1 + b.c1, a.c2 + b.c2, a.c3 + b.c3};
  }
  friend Taylor operator-(const Taylor& a, const Taylor& b) {
    return {a.c0 - b.c0, a.c1 - b.c1, a.c2 - b.c2, a.c3 - b.c3};
  }
  friend Taylor operator-(const Taylor& a) { return {-a.c0, -a.c1, -a.c2, -a.c3}; }
  friend Taylor operator*(const Taylor& a, const Taylor& b) {
    return {a.c0 * b.c0, a.c0 * b.c1 + a.c1 * b.c0, a.c0 * b.c2 + a.c1 * b.c1 + a.c2 * b.c0,
            a.c0 * b.c3 + a.c1 * b.c2 + a.c2 * b.c1 + a.c3 * b.c0};
  }
};

/// A length l + v t + a t^2/2 + j t^3/6.
template <typename Number>
Taylor<Number> moving(const Number& value, const Number& rate, const Number& second_rate,
                      const Number& third_rate) {
  return {value, rate, second_rate / Number(2), third_rate / Number(6)};
}

/// An angle theta + w t + a t^2/2 + j t^3/6; with c and s at t = 0,
///   cos''' = -s j - 3 c w a + s w^3,  sin''' = c j - 3 s w a - c w^3.
template <typename Number>
Direction<Taylor<Number>> moving(const Direction<Number>& angle, const Number& rate,
                                 const Number& second_rate, const Number& third_rate) {
  const Number& c = angle.cos;
  const Number& s = angle.sin;
  const Number square = rate * rate;
  const Number mixed = Number(3) * rate * second_rate;
  const Number turning = third_rate - square * rate;
  return {{c, -(s * rate), -(s * second_rate + c * square) / Number(2),
           -(s * turning + c * mixed) / Number(6)},
          {s, c * rate, (c * second_rate - s * square) / Number(2),
           (c * turning - s * mixed) / Number(6)}};
}

/// First, second and third rates, indexed as a model's vectors are. Made of rational numbers they
/// start at zero.
template <typename Vector>
struct Rates {
  Vector first, second, third;
};

/// The variables of a model on the move.
template <typename Moving, typename Variables, typename Vector>
Moving all_moving(const Variables& at, const Rates<Vector>& rates) {
  Moving result;
  Eigen::Index index = 0;
  for_each_pair(result, at, [&](auto& to, const auto& from) {
    to = moving(from, rates.first(index), rates.second(index), rates.third(index));
    ++index;
  });
  return result;
}

}  // namespace assur::test
