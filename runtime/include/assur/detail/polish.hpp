// Turns a configuration that nearly closes into one that closes to a few roundings.
#pragma once

#include <algorithm>
#include <assur/assemblies.hpp>
#include <assur/detail/closure_geometry.hpp>
#include <assur/detail/index.hpp>
#include <assur/detail/numbers.hpp>
#include <assur/detail/pivots.hpp>
#include <assur/kinematics.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace assur::detail {

/// Whether the closures hold as they are to a few roundings, where the square of the longest of the
/// given lengths is so much.
template <typename Model, typename Scalar>
[[nodiscard]] auto closes(const typename Model::template Dimensions<Scalar>& d,
                          const typename Model::template Inputs<Scalar>& u,
                          const typename Model::template Configuration<Scalar>& q, double square) {
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  constexpr double farthest = farthest_configuration * farthest_configuration;
  Vector<Scalar, Model::equation_count> f;
  Model::residual(d, u, q, f);
  Scalar miss(0);
  for (int index = 0; index < Model::equation_count; ++index) {
    miss = miss + f(index) * f(index);
  }
  const auto lengths = square_of_lengths<Scalar>(q);
  return (miss <= (Scalar(square) + lengths) * Scalar(rounding * rounding)) &
         (lengths < Scalar(farthest * square));
}

/// Whether a configuration is regular, where what tells it is `unsure` by so much beforehand.
template <typename Model, typename Scalar>
[[nodiscard]] bool is_regular(const typename Model::template Dimensions<Scalar>& d,
                              const typename Model::template Inputs<Scalar>& u,
                              const typename Model::template Configuration<Scalar>& q,
                              double unsure) {
  return is_regular<Model>(pivots_at<Model, Scalar>(d, u, q),
                           derivative_rounding<double>() + unsure);
}

/// What polishing leaves of the closures where the longest number among them is so long.
[[nodiscard]] inline double polished_rounding(double longest) {
  return 18 * std::numeric_limits<double>::epsilon() * longest;
}

/// A small step without trigonometric functions.
template <typename Model>
void nudge(typename Model::template Configuration<double>& q,
           const Vector<double, Model::unknown_count>& step) {
  for_each_member(q, [&step](auto& member, std::size_t index) {
    const double by = step(static_cast<Eigen::Index>(index));
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
      member += by;
    } else {
      member =
          normalised(Direction<double>{member.cos - by * member.sin, member.sin + by * member.cos});
    }
  });
}

/// A root that is certainly simple may yet leave another unknown loose, which then may move freely,
/// as a link between parallel slides does. Its pivot is of rounding, and the margin of rounding's
/// square.
inline constexpr double loose_margin =
    1e5 * std::numeric_limits<double>::epsilon() * std::numeric_limits<double>::epsilon();

/// Newton's steps as long as they lessen a residual above rounding. The longest length is near
/// one; where a displacement is longer, its rounding ends the steps. `no_convergence` if the
/// closures do not hold then, or if the configuration is not finite; `singular` if its margin is
/// below `least_margin`; else whether it is regular, where the Jacobian is `unsure` by so much
/// beforehand.
template <typename Model>
[[nodiscard, gnu::noinline]] Status polish(const typename Model::template Dimensions<double>& d,
                                           const typename Model::template Inputs<double>& u,
                                           typename Model::template Configuration<double>& q,
                                           double unsure, double least_margin) {
  if (!is_finite(q)) {
    return Status::no_convergence;
  }
  constexpr int steps = 3;
  Vector<double, Model::equation_count> f;
  Model::residual(d, u, q, f);
  double miss = f.cwiseAbs().maxCoeff();
  const InverseJacobian<Model, double> jacobian(d, u, q, unsure);
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  for (int step = 0; step < steps && miss > rounding && jacobian.solvable(); ++step) {
    auto next = q;
    nudge<Model>(next, jacobian.solve(Vector<double, Model::equation_count>(-f)));
    Model::residual(d, u, next, f);
    const double next_miss = f.cwiseAbs().maxCoeff();
    if (!(next_miss < miss)) {
      break;
    }
    q = next;
    miss = next_miss;
  }
  const double longest = longest_length(q);
  if (!(longest < farthest_configuration) ||
      (miss > polished_rounding(1) &&
       !(miss <= polished_rounding((std::max)(longest, longest_length(u)))))) {
    return Status::no_convergence;
  }
  if (!(jacobian.margin() >= least_margin)) {
    return Status::singular;
  }
  return jacobian.status() == Status::ok ? Status::ok : Status::near_singular;
}

/// Two roots that polish to one configuration: one of them was completed wrongly.
template <typename Model>
[[nodiscard]] bool has_twins(const Assemblies<Model>& found) {
  for (int index = 1; index < found.count; ++index) {
    for (int other = 0; other < index; ++other) {
      const double largest =
          farthest_apart(&entry(found.configurations, index), &entry(found.configurations, other),
                         SortsOf<typename Model::template Configuration<double>>::count);
      if (largest < 1e-7) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace assur::detail
