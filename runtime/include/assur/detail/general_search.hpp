// Turns a group in general position into its configurations, or tells that it may not be in one.
#pragma once

#include <algorithm>
#include <assur/assemblies.hpp>
#include <assur/detail/closure_geometry.hpp>
#include <assur/detail/completion.hpp>
#include <assur/detail/index.hpp>
#include <assur/detail/members.hpp>
#include <assur/detail/polish.hpp>
#include <assur/kinematics.hpp>
#include <assur/numeric/bounded.hpp>
#include <assur/numeric/trigonometric_roots.hpp>
#include <assur/support/position_polynomial.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>

namespace assur::detail {

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
  /// Rounding has `displaced` the inputs by so much as counts for the list, and by so much that
  /// they are `off` as counts for verdicts.
  GeneralSearch(const Dimensions& d, const Inputs& u, double displaced, double off,
                Assemblies<Model>& result)
      : d_(d), u_(u), displaced_(displaced), off_(off), result_(result) {}

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
    const double longest = (std::max)(1.0, longest_length(u_));
    // The Jacobian is as unsure as the places are; a length of one is among those of the group.
    const double unsure = (std::max)(off_, std::numeric_limits<double>::epsilon() * longest);
    for (std::size_t root = 0; root < roots.root_count; ++root) {
      if (!accept({roots.roots[root].cosine, roots.roots[root].sine}, longest, unsure)) {
        return false;
      }
    }
    return !has_twins<Model>(result_);
  }

 private:
  /// Completes the configuration at a simple root, where one second value fits, polishes it on the
  /// loop equations if need be and lists it; false if it does not close.
  [[nodiscard]] bool accept(const Direction<double>& first, double longest, double unsure) {
    if (result_.count == Model::max_configurations) {
      return false;
    }
    Configuration& q = entry(result_.configurations, result_.count);
    Status& regularity = entry(result_.regularity, result_.count);
    regularity = Status::no_convergence;
    first_of<Model>(q) = first;
    if (complete_simple<Model, double>(d_, u_, q)) {
      const bool settled = closes<Model, double>(d_, u_, q, longest * longest) &&
                           is_regular<Model, double>(d_, u_, q, unsure);
      regularity = settled ? Status::ok : polish<Model>(d_, u_, q, unsure, loose_margin);
    }
    if (regularity == Status::no_convergence) {
      first_of<Model>(q) = first;
      if (complete<Model>(d_, u_, q)) {
        regularity = polish<Model>(d_, u_, q, unsure, loose_margin);
      }
    }
    result_.count += is_solvable(regularity) ? 1 : 0;
    return is_solvable(regularity);
  }

  const Dimensions& d_;
  const Inputs& u_;
  double displaced_;
  double off_;
  Assemblies<Model>& result_;
};

}  // namespace assur::detail
