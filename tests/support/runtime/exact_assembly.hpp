// Random assembled configurations in rational numbers: arbitrary angles, then the lengths for them.
#pragma once

#include <array>

#include "runtime/exact.hpp"

namespace assur::test {

/// A model's variables in one scalar.
template <typename Model, typename Scalar>
struct Assembly {
  typename Model::template Dimensions<Scalar> d;
  typename Model::template Inputs<Scalar> u;
  typename Model::template Configuration<Scalar> q;
};

inline void add_to_length(Rational& length, const Rational& change) { length = length + change; }
inline void add_to_length(Direction<Rational>& /*angle*/, const Rational& /*change*/) {}

/// Changes as many lengths as there are equations until the loops close: the equations are linear
/// in dimensions and inputs that are lengths; the inputs are changed before the dimensions. Returns
/// false if these lengths are too few.
template <typename Model>
[[nodiscard]] bool close_loops(Assembly<Model, Rational>& at) {
  constexpr int rows = Model::equation_count;
  constexpr int dimensions = Model::dimension_count;
  constexpr int columns = dimensions + Model::input_count;
  Vector<Rational, rows> f;
  Matrix<Rational, rows, dimensions> f_d;
  Matrix<Rational, rows, Model::input_count> f_u;
  Model::residual(at.d, at.u, at.q, f);
  Model::dimension_jacobian(at.d, at.u, at.q, f_d);
  Model::input_jacobian(at.d, at.u, at.q, f_u);
  Matrix<Rational, rows, columns> system;
  for (int column = 0; column < columns; ++column) {
    const auto slot = static_cast<std::size_t>(column);
    const bool is_angle = column < dimensions ? Model::dimensions[slot].is_angle
                                              : Model::inputs[slot - dimensions].is_angle;
    for (int row = 0; row < rows; ++row) {
      const Rational entry = column < dimensions ? f_d(row, column) : f_u(row, column - dimensions);
      system(row, column) = is_angle ? Rational(0) : entry;
    }
  }
  Vector<Rational, columns> change;
  std::array<int, rows> pivots{};
  for (int row = 0; row < rows; ++row) {
    int pivot = columns - 1;
    while (pivot >= 0 && system(row, pivot) == 0) {
      --pivot;
    }
    if (pivot < 0) {
      return false;
    }
    pivots[static_cast<std::size_t>(row)] = pivot;
    for (int other = 0; other < rows; ++other) {
      if (other != row) {
        const Rational factor = system(other, pivot) / system(row, pivot);
        for (int column = 0; column < columns; ++column) {
          system(other, column) = system(other, column) - factor * system(row, column);
        }
        f(other) = f(other) - factor * f(row);
      }
    }
  }
  // Each row is left with its pivot and with columns that do not change.
  for (int row = 0; row < rows; ++row) {
    const int pivot = pivots[static_cast<std::size_t>(row)];
    change(pivot) = -f(row) / system(row, pivot);
  }
  int column = 0;
  const auto apply = [&](auto&... member) { (add_to_length(member, change(column++)), ...); };
  std::apply(apply, at.d.members());
  std::apply(apply, at.u.members());
  return true;
}

/// The same assembly in floating point, rounded.
template <typename Scalar, typename Model>
[[nodiscard]] Assembly<Model, Scalar> rounded(const Assembly<Model, Rational>& at) {
  struct Rounding {
    Scalar operator()(const Rational& value) const { return Scalar(value.rounded()); }
    Direction<Scalar> operator()(const Direction<Rational>& value) const {
      return {(*this)(value.cos), (*this)(value.sin)};
    }
  };
  return {converted<typename Model::template Dimensions<Scalar>>(at.d, Rounding()),
          converted<typename Model::template Inputs<Scalar>>(at.u, Rounding()),
          converted<typename Model::template Configuration<Scalar>>(at.q, Rounding())};
}

}  // namespace assur::test
