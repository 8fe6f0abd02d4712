// The final polynomial of a group, with a bound on its rounding errors.
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
  typename numeric::PartOf<Scalar>::Type error = 0;
};

/// The final polynomial of a model whose first unknown is an angle, evaluated in `Work`, which is
/// double or DoubleDouble, or float or DoubleFloat for variables in float. Except in DoubleDouble
/// the error includes the rounding of the variables and the displacement `displaced` of the
/// neighbours. It is NaN or infinite if a coefficient is.
template <typename Model, typename Work, typename Scalar = double>
[[nodiscard]] PositionPolynomial<Work, Model::polynomial_degree> position_polynomial(
    const typename Model::template Dimensions<Scalar>& d,
    const typename Model::template Inputs<Scalar>& u, Scalar displaced = 0) {
  constexpr bool counts_rounding = !std::is_same_v<Work, numeric::DoubleDouble>;
  using Certified = numeric::Bounded<Work>;
  constexpr std::size_t degree = Model::polynomial_degree;
  TrigonometricPolynomial<Certified, degree> bounded;
  using Dimensions = typename Model::template Dimensions<Certified>;
  using Inputs = typename Model::template Inputs<Certified>;
  if constexpr (counts_rounding) {
    const Scalar of_inputs = rounding_of_inputs(u, displaced);
    constexpr Scalar of_dimensions = rounding_of_one<Scalar>;
    Model::position_polynomial(rounded<Dimensions>(d, of_dimensions, of_dimensions),
                               rounded<Inputs>(u, of_inputs, of_inputs), bounded);
  } else {
    (void)displaced;
    Model::position_polynomial(scaled_to<Dimensions>(d, 1), scaled_to<Inputs>(u, 1), bounded);
  }
  PositionPolynomial<Work, degree> result;
  for (std::size_t k = 0; k <= degree; ++k) {
    result.value.cosine[k] = bounded.cosine[k].value;
    result.value.sine[k] = bounded.sine[k].value;
    result.error = (std::max)(
        {result.error, bounded.cosine[k].certain_bound(), bounded.sine[k].certain_bound()});
  }
  if constexpr (counts_rounding) {
    result.error += rounding_of_numbers<Model, Scalar>() + numeric::lost_in_underflow<Scalar>;
  }
  return result;
}

}  // namespace assur::support
