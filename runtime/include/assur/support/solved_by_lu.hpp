// Regularity, inverse Jacobian and rates by LU of J, for closures of unknown structure.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <assur/detail/pivots.hpp>
#include <assur/model.hpp>
#include <cmath>

namespace assur::support {

/// The reciprocal condition number of a square matrix in the maximum norm, with the sign of the
/// determinant. Zero or NaN if the matrix has no inverse.
template <typename Square>
[[nodiscard]] typename Square::Scalar signed_reciprocal_condition(const Square& J) {
  using Scalar = typename Square::Scalar;
  const auto norm = [](const auto& matrix) {
    return Scalar(matrix.cwiseAbs().rowwise().sum().maxCoeff());
  };
  const auto lu = J.partialPivLu();
  const Scalar sign(lu.determinant() < Scalar(0) ? -1 : 1);
  return sign / (norm(J) * norm(lu.inverse().eval()));
}

/// The regularity of closures with the Jacobian J, all unknowns in one unit. Rounding moves the
/// configuration by eps over the reciprocal condition, which changes J by as much: derivatives lose
/// that factor twice. `unsure` is a further relative error of J.
template <typename Square>
[[nodiscard]] Regularity<typename Square::Scalar> regularity_by_lu(const Square& J,
                                                                   typename Square::Scalar unsure) {
  using Scalar = typename Square::Scalar;
  using std::abs;
  const Scalar firmness = abs(signed_reciprocal_condition(J));
  return detail::regularity_of(detail::Firmness<Scalar>{firmness, firmness, Scalar(1)},
                               derivative_rounding<Scalar>() + unsure);
}

/// The base of a struct with residual, jacobian and right-hand sides, `Model`, that adds the
/// regularity, the inverse Jacobian, sensitivities and rates. A model of a group computes these by
/// its own elimination. Eigen's LU of fixed size neither allocates nor throws.
template <typename Model>
struct SolvedByLu {
  static constexpr int pivot_count = 1;
  static constexpr int core_pivot_count = 1;
  static constexpr std::array<const char*, pivot_count> pivots = {{"a dead centre: det J = 0"}};

  /// The one pivot is the reciprocal condition of J with columns and rows scaled to a largest entry
  /// of one, since closures may have any units.
  template <typename Dimensions, typename Inputs, typename Configuration, typename Scalar>
  static void degeneracies(const Dimensions& d, const Inputs& u, const Configuration& q,
                           Vector<Scalar, pivot_count>& pivot, Vector<Scalar, pivot_count>& size,
                           Scalar& terms) {
    auto J = jacobian_at<Scalar>(d, u, q);
    for (Eigen::Index column = 0; column < J.cols(); ++column) {
      J.col(column) /= Scalar(J.col(column).cwiseAbs().maxCoeff());
    }
    for (Eigen::Index row = 0; row < J.rows(); ++row) {
      J.row(row) /= Scalar(J.row(row).cwiseAbs().maxCoeff());
    }
    pivot(0) = signed_reciprocal_condition(J);
    size(0) = Scalar(1);
    terms = Scalar(1);
  }

  template <typename Dimensions, typename Inputs, typename Configuration, typename Inverse>
  static void inverse_jacobian(const Dimensions& d, const Inputs& u, const Configuration& q,
                               Inverse& inverse) {
    inverse = factored<typename Inverse::Scalar>(d, u, q).inverse();
  }

  /// dq/dd and dq/du.
  template <typename Dimensions, typename Inputs, typename Configuration, typename ToDimensions,
            typename ToInputs>
  static void sensitivities(const Dimensions& d, const Inputs& u, const Configuration& q,
                            ToDimensions& to_dimensions, ToInputs& to_inputs) {
    using Scalar = typename ToDimensions::Scalar;
    solve_sensitivities(factored<Scalar>(d, u, q), d, u, q, to_dimensions, to_inputs);
  }

  /// dq/dt and d2q/dt2.
  template <typename Dimensions, typename Inputs, typename Configuration, typename InputRates,
            typename Rates>
  static void motion(const Dimensions& d, const Inputs& u, const Configuration& q,
                     const InputRates& u_rate, const InputRates& u_second_rate, Rates& velocity,
                     Rates& acceleration) {
    using Scalar = typename Rates::Scalar;
    solve_motion(factored<Scalar>(d, u, q), d, u, q, u_rate, u_second_rate, velocity, acceleration);
  }

  template <typename Dimensions, typename Inputs, typename Configuration, typename InputRates,
            typename ToDimensions, typename ToInputs, typename Rates>
  static void sensitivities_and_motion(const Dimensions& d, const Inputs& u, const Configuration& q,
                                       const InputRates& u_rate, const InputRates& u_second_rate,
                                       ToDimensions& to_dimensions, ToInputs& to_inputs,
                                       Rates& velocity, Rates& acceleration) {
    const auto lu = factored<typename Rates::Scalar>(d, u, q);
    solve_sensitivities(lu, d, u, q, to_dimensions, to_inputs);
    solve_motion(lu, d, u, q, u_rate, u_second_rate, velocity, acceleration);
  }

 private:
  template <typename Scalar, typename Dimensions, typename Inputs, typename Configuration>
  [[nodiscard]] static auto jacobian_at(const Dimensions& d, const Inputs& u,
                                        const Configuration& q) {
    static_assert(Model::equation_count == Model::unknown_count,
                  "only as many equations as unknowns can be solved");
    Matrix<Scalar, Model::equation_count, Model::unknown_count> J;
    Model::jacobian(d, u, q, J);
    return J;
  }

  template <typename Scalar, typename Dimensions, typename Inputs, typename Configuration>
  [[nodiscard]] static auto factored(const Dimensions& d, const Inputs& u, const Configuration& q) {
    return jacobian_at<Scalar>(d, u, q).partialPivLu();
  }

  template <typename Factors, typename Dimensions, typename Inputs, typename Configuration,
            typename ToDimensions, typename ToInputs>
  static void solve_sensitivities(const Factors& lu, const Dimensions& d, const Inputs& u,
                                  const Configuration& q, ToDimensions& to_dimensions,
                                  ToInputs& to_inputs) {
    if constexpr (Model::dimension_count > 0) {
      ToDimensions F_d;
      Model::dimension_jacobian(d, u, q, F_d);
      to_dimensions = -lu.solve(F_d);
    }
    if constexpr (Model::input_count > 0) {
      ToInputs F_u;
      Model::input_jacobian(d, u, q, F_u);
      to_inputs = -lu.solve(F_u);
    }
  }

  template <typename Factors, typename Dimensions, typename Inputs, typename Configuration,
            typename InputRates, typename Rates>
  static void solve_motion(const Factors& lu, const Dimensions& d, const Inputs& u,
                           const Configuration& q, const InputRates& u_rate,
                           const InputRates& u_second_rate, Rates& velocity, Rates& acceleration) {
    Rates rhs;
    Model::velocity_rhs(d, u, q, u_rate, rhs);
    velocity = lu.solve(rhs);
    Model::acceleration_rhs(d, u, q, velocity, u_rate, u_second_rate, rhs);
    acceleration = lu.solve(rhs);
  }
};

}  // namespace assur::support
