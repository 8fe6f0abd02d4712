// Turns a group in general position into its configurations, or tells that it may not be in one.
#pragma once

#include <algorithm>
#include <assur/assemblies.hpp>
#include <assur/detail/closure_geometry.hpp>
#include <assur/detail/index.hpp>
#include <assur/detail/members.hpp>
#include <assur/kinematics.hpp>
#include <assur/numeric/bounded.hpp>
#include <assur/numeric/second_unknown.hpp>
#include <assur/numeric/trigonometric_roots.hpp>
#include <assur/support/position_polynomial.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>

namespace assur::detail {

/// What polishing leaves of the closures where the longest number among them is so long.
[[nodiscard]] inline double polished_rounding(double longest) {
  return 16 * std::numeric_limits<double>::epsilon() * longest;
}

/// The search in double precision, of a group whose longest length is near one. It vouches for its
/// list where every root of the final polynomial is certainly simple, however dimensions and inputs
/// were rounded, and completes to a configuration that closes: a simple root belongs to one
/// configuration at most.
template <typename Model>
class GeneralSearch {
  using Dimensions = typename Model::template Dimensions<double>;
  using Inputs = typename Model::template Inputs<double>;
  using Configuration = typename Model::template Configuration<double>;

 public:
  GeneralSearch(const Dimensions& d, const Inputs& u, double displaced, Assemblies<Model>& result)
      : d_(d), u_(u), displaced_(displaced), result_(result) {}

  /// False if it cannot vouch for its list.
  [[nodiscard]] bool run() {
    static_assert(is_angle<Model>(Model::first_unknown),
                  "a polynomial in a displacement is of second degree at most");
    const auto polynomial = support::position_polynomial<Model, double>(d_, u_, displaced_);
    const auto roots = numeric::trigonometric_roots<double, Model::polynomial_degree>(
        polynomial.value, polynomial.error);
    if (roots.status == numeric::RootStatus::invalid) {
      result_.status = AssemblyStatus::not_finite;
      return true;
    }
    if (roots.status != numeric::RootStatus::certified) {
      return false;
    }
    for (std::size_t root = 0; root < roots.root_count; ++root) {
      Configuration q;
      first_of(q) = {roots.roots[root].cosine, roots.roots[root].sine};
      if (!accept(q)) {
        return false;
      }
    }
    return !has_twins();
  }

 private:
  /// Completes the configuration at a simple root, where one second value fits, polishes it on the
  /// loop equations and lists it; false if it does not close.
  [[nodiscard]] bool accept(Configuration& q) {
    if constexpr (Model::second_unknown >= 0) {
      auto& second = std::get<size(Model::second_unknown)>(q.members());
      Matrix<double, 2, 3> e;
      Model::second_equations(d_, u_, q, e);
      const auto candidates = numeric::second_candidates<std::decay_t<decltype(second)>>(e);
      if (candidates.count == 0) {
        return false;
      }
      second = candidates.list[0].value;
    }
    Model::complete(d_, u_, q);
    bool fits = true;
    for_each_member(q, [&fits](auto& member, std::size_t) {
      if constexpr (!std::is_same_v<std::decay_t<decltype(member)>, double>) {
        // Between ends that coincide a bar has no direction, whatever its length.
        const double square = member.cos * member.cos + member.sin * member.sin;
        fits = fits && std::abs(square - 1) < 0.1;
        member = normalised(member);
      }
    });
    if (!fits || !is_finite(q) || result_.count == Model::max_configurations) {
      return false;
    }
    const Status regularity = polish(q);
    if (regularity == Status::no_convergence) {
      return false;
    }
    entry(result_.configurations, result_.count) = q;
    entry(result_.regularity, result_.count) = regularity;
    ++result_.count;
    return true;
  }

  [[nodiscard]] static auto& first_of(Configuration& q) {
    return std::get<size(Model::first_unknown)>(q.members());
  }

  /// Newton's steps as long as they lessen a residual above rounding. The longest length is near
  /// one; where a displacement is longer, its rounding ends the steps. `no_convergence` if the
  /// closures do not hold then.
  [[nodiscard]] Status polish(Configuration& q) const {
    constexpr int steps = 3;
    Vector<double, Model::equation_count> f;
    Model::residual(d_, u_, q, f);
    double miss = f.cwiseAbs().maxCoeff();
    const InverseJacobian<Model, double> jacobian(d_, u_, q);
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    for (int step = 0; step < steps && miss > rounding && jacobian.solvable(); ++step) {
      Configuration next = q;
      nudge(next, jacobian.solve(Vector<double, Model::equation_count>(-f)));
      Model::residual(d_, u_, next, f);
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
         !(miss <= polished_rounding(std::max(longest, longest_length(u_)))))) {
      return Status::no_convergence;
    }
    return jacobian.status() == Status::ok ? Status::ok : Status::near_singular;
  }

  /// A small step without trigonometric functions.
  static void nudge(Configuration& q, const Vector<double, Model::unknown_count>& step) {
    for_each_member(q, [&step](auto& member, std::size_t index) {
      const double by = step(static_cast<Eigen::Index>(index));
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
        member += by;
      } else {
        member = normalised(
            Direction<double>{member.cos - by * member.sin, member.sin + by * member.cos});
      }
    });
  }

  /// Two roots that polish to one configuration: one of them was completed wrongly.
  [[nodiscard]] bool has_twins() const {
    for (int index = 1; index < result_.count; ++index) {
      for (int other = 0; other < index; ++other) {
        double largest = 0;
        for_each_pair(
            entry(result_.configurations, index), entry(result_.configurations, other),
            [&largest](const auto& a, const auto& b) { largest = std::max(largest, apart(a, b)); });
        if (largest < 1e-7) {
          return true;
        }
      }
    }
    return false;
  }

  const Dimensions& d_;
  const Inputs& u_;
  double displaced_;
  Assemblies<Model>& result_;
};

}  // namespace assur::detail
