// Turns the declaration of a matrix into its size, as far as it says one.
#pragma once

#include <optional>

#include "audit/code/tokens.hpp"

namespace assur::generator::audit::code {

struct DeclaredShape {
  std::optional<std::size_t> rows;
  std::optional<std::size_t> columns;
};

/// Reads the shape of `Eigen::Matrix3d`, `Matrix<S, 2, 3>`, `std::array<std::array<double, 3>, 2>`.
[[nodiscard]] DeclaredShape shape_of_type(Tokens type);
/// Reads the shape from `[2][3]` or `(2, 3)`, with which the tokens begin.
[[nodiscard]] DeclaredShape leading_shape(Tokens tokens);

}  // namespace assur::generator::audit::code
