// CLN's real numbers of 60 digits as a scalar of generated code, for reference values.
#pragma once

#include <cln/float.h>
#include <cln/lfloat.h>

#include <assur/variables.hpp>

#include "runtime/cln_scalars.hpp"

namespace assur::speed {

/// Integers are exact; arithmetic with a float of 60 digits gives such a float.
using Precise = cln::cl_R;

/// The value of a float, a double or a long double.
template <typename Scalar>
[[nodiscard]] Precise precise(Scalar value) {
  static const cln::float_format_t format = cln::float_format(60);
  const auto head = static_cast<double>(value);
  const auto rest = static_cast<double>(value - static_cast<Scalar>(head));
  return cln::cl_float(cln::rational(cln::cl_F(head)) + cln::rational(cln::cl_F(rest)), format);
}

/// The value rounded once; for long double in two parts, which together have more digits than it.
template <typename Scalar>
[[nodiscard]] Scalar rounded(const Precise& value) {
  const double head = cln::double_approx(value);
  if constexpr (sizeof(Scalar) <= sizeof(double)) {
    return static_cast<Scalar>(head);
  } else {
    const Precise rest = value - cln::rational(cln::cl_F(head));
    return static_cast<Scalar>(head) + static_cast<Scalar>(cln::double_approx(rest));
  }
}

namespace precise_detail {

template <typename Scalar>
void assign(Precise& to, const Scalar& from) {
  to = precise(from);
}
template <typename Scalar>
void assign(Scalar& to, const Precise& from) {
  to = rounded<Scalar>(from);
}
template <typename To, typename From>
void assign(Direction<To>& to, const Direction<From>& from) {
  assign(to.cos, from.cos);
  assign(to.sin, from.sin);
}

}  // namespace precise_detail

/// Converts a model's variables to or from 60 digits.
template <typename To, typename From>
[[nodiscard]] To in_scalar(const From& from) {
  To result;
  std::apply(
      [&](const auto&... source) {
        std::apply([&](auto&... target) { (precise_detail::assign(target, source), ...); },
                   result.members());
      },
      from.members());
  return result;
}

/// J of the loop closures at a configuration, factored.
template <typename Model>
class PreciseJacobian {
  static constexpr int size = Model::unknown_count;

 public:
  PreciseJacobian(const typename Model::template Dimensions<Precise>& d,
                  const typename Model::template Inputs<Precise>& u,
                  const typename Model::template Configuration<Precise>& q) {
    Model::jacobian(d, u, q, matrix_);
  }

  /// X with J X = rhs, by Gaussian elimination with partial pivoting.
  template <int Columns>
  [[nodiscard]] Matrix<Precise, size, Columns> solve(Matrix<Precise, size, Columns> rhs) const {
    Matrix<Precise, size, size> J = matrix_;
    for (int column = 0; column < size; ++column) {
      int pivot = column;
      for (int row = column + 1; row < size; ++row) {
        pivot = abs(J(row, column)) > abs(J(pivot, column)) ? row : pivot;
      }
      J.row(column).swap(J.row(pivot));
      rhs.row(column).swap(rhs.row(pivot));
      for (int row = column + 1; row < size; ++row) {
        const Precise factor = J(row, column) / J(column, column);
        J.row(row) -= factor * J.row(column);
        rhs.row(row) -= factor * rhs.row(column);
      }
    }
    for (int row = size - 1; row >= 0; --row) {
      for (int other = row + 1; other < size; ++other) {
        rhs.row(row) -= J(row, other) * rhs.row(other);
      }
      rhs.row(row) /= J(row, row);
    }
    return rhs;
  }
  [[nodiscard]] const Matrix<Precise, size, size>& matrix() const { return matrix_; }

 private:
  Matrix<Precise, size, size> matrix_;
};

/// Newton's iteration from a configuration near by. False if it does not converge to 50 digits.
template <typename Model>
[[nodiscard]] bool assemble(const typename Model::template Dimensions<Precise>& d,
                            const typename Model::template Inputs<Precise>& u,
                            typename Model::template Configuration<Precise>& q) {
  const Precise tolerance = cln::cl_float(cln::expt(cln::cl_RA(10), -50), cln::float_format(60));
  for (int iteration = 0; iteration < 40; ++iteration) {
    Vector<Precise, Model::equation_count> f;
    Model::residual(d, u, q, f);
    const PreciseJacobian<Model> jacobian(d, u, q);
    const Vector<Precise, Model::unknown_count> step =
        jacobian.template solve<1>(Vector<Precise, Model::equation_count>(-f));
    advance(q, step);
    Precise largest(0);
    for (int index = 0; index < Model::unknown_count; ++index) {
      largest = abs(step(index)) > largest ? abs(step(index)) : largest;
    }
    if (largest < tolerance) {
      return true;
    }
    if (largest > 1) {
      return false;
    }
  }
  return false;
}

}  // namespace assur::speed
