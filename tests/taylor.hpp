// Turns a function templated on its scalar into its first and second derivative, exactly.
#pragma once

#include <assur/variables.hpp>
#include <tuple>

namespace assur::test {

/// c0 + c1 t + c2 t^2, truncated. Over rational numbers every coefficient is exact.
template <typename Number>
struct Taylor {
  Number c0{0};
  Number c1{0};
  Number c2{0};

  Taylor() = default;
  Taylor(int value) : c0(value) {}  // NOLINT(google-explicit-constructor): as numbers convert
  Taylor(Number value, Number first, Number second) : c0(value), c1(first), c2(second) {}

  friend Taylor operator+(const Taylor& a, const Taylor& b) {
    return {a.c0 + b.c0, a.c1 + b.c1, a.c2 + b.c2};
  }
  friend Taylor operator-(const Taylor& a, const Taylor& b) {
    return {a.c0 - b.c0, a.c1 - b.c1, a.c2 - b.c2};
  }
  friend Taylor operator-(const Taylor& a) { return {-a.c0, -a.c1, -a.c2}; }
  friend Taylor operator*(const Taylor& a, const Taylor& b) {
    return {a.c0 * b.c0, a.c0 * b.c1 + a.c1 * b.c0, a.c0 * b.c2 + a.c1 * b.c1 + a.c2 * b.c0};
  }
};

/// A length that moves at a rate and a second rate.
template <typename Number>
Taylor<Number> moving(const Number& value, const Number& rate, const Number& second_rate) {
  return {value, rate, second_rate / Number(2)};
}

/// An angle that turns: theta = theta0 + w t + a t^2/2 has cos theta = c - s w t
/// - (s a + c w^2) t^2/2, and sin theta = s + c w t + (c a - s w^2) t^2/2.
template <typename Number>
Direction<Taylor<Number>> moving(const Direction<Number>& angle, const Number& rate,
                                 const Number& second_rate) {
  const Number& c = angle.cos;
  const Number& s = angle.sin;
  const Number square = rate * rate;
  return {{c, -(s * rate), -(s * second_rate + c * square) / Number(2)},
          {s, c * rate, (c * second_rate - s * square) / Number(2)}};
}

/// The variables of a model on the move. Rates are indexed as the model's vectors are.
template <typename Moving, typename Variables, typename Rates>
Moving all_moving(const Variables& at, const Rates& rates, const Rates& second_rates) {
  Moving result;
  std::apply(
      [&](const auto&... from) {
        std::apply(
            [&](auto&... to) {
              Eigen::Index index = 0;
              ((to = moving(from, rates(index), second_rates(index)), ++index), ...);
            },
            result.members());
      },
      at.members());
  return result;
}

}  // namespace assur::test
