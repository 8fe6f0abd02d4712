// A group of any number of links in an emitted solver: real configurations from the complex ones,
// J^-1 and rates by LU.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <assur/assembly.hpp>
#include <assur/loops/real_configurations.hpp>
#include <assur/support/solved_by_lu.hpp>
#include <type_traits>

namespace assur::support {

/// The loop closures of a group at given inputs.
template <typename Model>
[[nodiscard]] auto loop_equations_of(const typename Model::template Inputs<double>& u) {
  using Of = typename Model::LoopSizes;
  const auto closures_at = [&u](Eigen::Index angle, Eigen::Index slide) {
    typename Model::template Configuration<double> q;
    for_each_member(q, [&](auto& member, std::size_t index) {
      const auto place = static_cast<Eigen::Index>(index);
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
        member = place == Of::angles + slide && slide >= 0 ? 1 : 0;
      } else {
        member = {place + 1 == angle ? 1.0 : 0.0, 0.0};
      }
    });
    Vector<double, Model::equation_count> f;
    Model::residual(typename Model::template Dimensions<double>(), u, q, f);
    typename Of::OfLoops closures(Of::loops);
    for (Eigen::Index loop = 0; loop < Of::loops; ++loop) {
      closures(loop) = {f(2 * loop), f(2 * loop + 1)};
    }
    return closures;
  };
  typename Of::template AtMost<int, Of::slides> slide_angles(Of::slides);
  std::copy(Model::slide_angles.begin(), Model::slide_angles.end(), slide_angles.data());
  return loops::loop_equations<Of>(Of::loops, Of::angles, slide_angles, closures_at);
}

/// The base of an emitted group that has `residual`, `jacobian` and right-hand sides.
template <typename Group>
struct LoopGroup {
  static constexpr int pivot_count = 1, core_pivot_count = 1;

  /// The one pivot is the reciprocal condition of J, with angles multiplied by the group's length.
  /// Rows are not scaled: in a group in one line all closures across the line vanish at once.
  template <typename Inputs, typename Configuration, typename Scalar>
  [[gnu::noinline]] static void degeneracies(const Inputs& u, const Configuration& q,
                                             Vector<Scalar, 1>& pivot, Vector<Scalar, 1>& size,
                                             Scalar& terms) {
    auto J = jacobian_at<Scalar>(u, q);
    J.leftCols(Group::LoopSizes::angles) /= Scalar(Group::own_length);
    pivot(0) = signed_reciprocal_condition(J);
    size(0) = Scalar(1);
    terms = Scalar(1);
  }

  template <typename Inputs, typename Configuration, typename Inverse>
  [[gnu::noinline]] static void inverse_jacobian(const Inputs& u, const Configuration& q,
                                                 Inverse& inverse) {
    inverse = jacobian_at<typename Inverse::Scalar>(u, q).partialPivLu().inverse();
  }

  /// dq/dt.
  template <typename Inputs, typename Configuration, typename InputRates, typename Rates>
  [[gnu::noinline]] static void velocity(const Inputs& u, const Configuration& q,
                                         const InputRates& u_rate, Rates& q_rate) {
    Rates rhs;
    Group::velocity_rhs(u, q, u_rate, rhs);
    q_rate = jacobian_at<typename Rates::Scalar>(u, q).partialPivLu().solve(rhs);
  }
  /// dq/dt and d2q/dt2.
  template <typename Inputs, typename Configuration, typename InputRates, typename Rates>
  [[gnu::noinline]] static void motion(const Inputs& u, const Configuration& q,
                                       const InputRates& u_rate, const InputRates& u_second_rate,
                                       Rates& q_rate, Rates& q_second_rate) {
    const auto lu = jacobian_at<typename Rates::Scalar>(u, q).partialPivLu();
    Rates rhs;
    Group::velocity_rhs(u, q, u_rate, rhs);
    q_rate = lu.solve(rhs);
    Group::acceleration_rhs(u, q, q_rate, u_rate, u_second_rate, rhs);
    q_second_rate = lu.solve(rhs);
  }
  /// Joint forces under loads on the links: J^T lambda = -Q gives those of the joints that close
  /// the loops.
  template <typename Inputs, typename Configuration, typename Loads, typename Forces>
  [[gnu::noinline]] static void forces(const Inputs& u, const Configuration& q, const Loads& loads,
                                       Forces& F) {
    using Scalar = typename Forces::Scalar;
    Vector<Scalar, Group::unknown_count> Q;
    Group::generalised_loads(u, q, loads, Q);
    const auto J = jacobian_at<Scalar>(u, q);
    const std::decay_t<decltype(J)> transposed = J.transpose();
    const Vector<Scalar, Group::equation_count> lambda = -transposed.partialPivLu().solve(Q);
    Group::forces_with_multipliers(u, q, loads, lambda, F);
  }

  /// All configurations of a group, from its complex ones. Not to be inlined.
  template <typename Model>
  [[gnu::noinline]] static void search(const typename Model::template Dimensions<double>& d,
                                       const typename Model::template Inputs<double>& u,
                                       const Displacement& displaced, Assemblies<Model>& result) {
    using Of = typename Model::LoopSizes;
    const loops::LoopEquations<Of> equations = loop_equations_of<Model>(u);
    if (!equations.is_finite() || !(equations.size() > 0)) {
      result.status = AssemblyStatus::not_finite;
      return;
    }
    const loops::RealConfigurations<Of> found =
        loops::real_configurations(equations, ways_of<Model>(), Model::max_configurations);
    const double unsure = unsure_jacobian<Model>(d, u, displaced);
    for (const loops::ComplexConfiguration<Of>& at : found.list) {
      auto& q = detail::entry(result.configurations, result.count);
      for_each_member(q, [&](auto& member, std::size_t index) {
        const auto place = static_cast<Eigen::Index>(index);
        if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
          member = at.s(place - Of::angles).real();
        } else {
          member = {at.theta(place + 1).real(), at.theta(place + 1).imag()};
        }
      });
      const Status status = detail::regularity_at<Model, double>(
                                detail::pivots_at<Model, double>(d, u, q), d, u, q, unsure)
                                .status;
      detail::entry(result.regularity, result.count++) =
          status == Status::ok ? Status::ok : Status::near_singular;
    }
    result.mobility = found.mobility;
    result.complete = found.complex_count == Model::max_configurations;
    if (result.count == 0 && result.mobility > 0) {
      result.status = AssemblyStatus::degenerate;
    }
  }

 private:
  /// The group's eliminations, or its starts if it has none.
  template <typename Model>
  [[nodiscard]] static constexpr const auto& ways_of() {
    if constexpr (Model::eliminations.empty()) {
      return Model::starts;
    } else {
      return Model::eliminations;
    }
  }
  template <typename Scalar, typename Inputs, typename Configuration>
  [[nodiscard]] static auto jacobian_at(const Inputs& u, const Configuration& q) {
    Matrix<Scalar, Group::equation_count, Group::unknown_count> J;
    Group::jacobian(u, q, J);
    // Unrolled loops over entries would take minutes to compile.
    return Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                         Group::equation_count, Group::unknown_count>(J);
  }
};

}  // namespace assur::support
