// Turns a group's dimensions and inputs into its final polynomial with a bound of its rounding.
#pragma once

#include <algorithm>
#include <assur/model.hpp>
#include <assur/numeric/bounded.hpp>
#include <assur/support/scale.hpp>
#include <cstddef>
#include <type_traits>

namespace assur::support {

/// A trigonometric polynomial and the largest absolute error of a coefficient.
template <typename Scalar, std::size_t Degree>
struct PositionPolynomial {
  TrigonometricPolynomial<Scalar, Degree> value;
  double error = 0;
};

/// The final polynomial of a model whose first unknown is an angle, evaluated in `Work`, double or
/// DoubleDouble. In double the error counts what rounding may have changed of the variables, among
/// neighbours that it has `displaced`. It is NaN or infinite where a coefficient is.
template <typename Model, typename Work>
[[nodiscard]] PositionPolynomial<Work, Model::polynomial_degree> position_polynomial(
    const typename Model::template Dimensions<double>& d,
    const typename Model::template Inputs<double>& u, double displaced = 0) {
  using Certified = numeric::Bounded<Work>;
  constexpr std::size_t degree = Model::polynomial_degree;
  TrigonometricPolynomial<Certified, degree> bounded;
  using Dimensions = typename Model::template Dimensions<Certified>;
  using Inputs = typename Model::template Inputs<Certified>;
  if constexpr (std::is_same_v<Work, double>) {
    const double of_inputs = rounding_of_inputs(u, displaced);
    Model::position_polynomial(rounded<Dimensions>(d, rounding_of_one, rounding_of_one),
                               rounded<Inputs>(u, of_inputs, of_inputs), bounded);
  } else {
    (void)displaced;
    Model::position_polynomial(scaled_to<Dimensions>(d, 1.0), scaled_to<Inputs>(u, 1.0), bounded);
  }
  PositionPolynomial<Work, degree> result;
  for (std::size_t k = 0; k <= degree; ++k) {
    result.value.cosine[k] = bounded.cosine[k].value;
    result.value.sine[k] = bounded.sine[k].value;
    result.error = (std::max)(
        {result.error, bounded.cosine[k].certain_bound(), bounded.sine[k].certain_bound()});
  }
  if constexpr (std::is_same_v<Work, double>) {
    result.error += rounding_of_numbers<Model>();
  }
  return result;
}

}  // namespace assur::support
