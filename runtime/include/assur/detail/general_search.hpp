// Configurations of a group in general position; groups that may not be in general position are
// reported.
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

/// The search for the configurations of a group whose longest length is near one. It works in the
/// precision of the scalar; `Work`, the scalar of the polynomial and its roots, may have more
/// digits. The list is certain if every root of the final polynomial is certainly simple, for any
/// rounding of dimensions and inputs, and completes to a configuration that closes: a simple root
/// belongs to at most one configuration.
template <typename Model, typename Scalar, typename Work>
class GeneralSearch {
  using Dimensions = typename Model::template Dimensions<Scalar>;
  using Inputs = typename Model::template Inputs<Scalar>;
  using Configuration = typename Model::template Configuration<Scalar>;

 public:
  /// `displaced` bounds the displacement of the inputs by rounding for the certainty of the list,
  /// `off` for the verdicts on regularity. In float `displaced` is used for both.
  GeneralSearch(const Dimensions& d, const Inputs& u, Scalar displaced, Scalar off,
                Assemblies<Model, Scalar>& result)
      : d_(d),
        u_(u),
        displaced_(displaced),
        off_(std::is_same_v<Scalar, float> ? displaced : off),
        result_(result) {}

  /// False if the list is not certain.
  [[nodiscard]] bool run() {
    static_assert(is_angle<Model>(Model::first_unknown),
                  "a polynomial in a displacement is of second degree at most");
    const auto polynomial = support::position_polynomial<Model, Work, Scalar>(d_, u_, displaced_);
    const auto roots = numeric::trigonometric_roots<Work, Model::polynomial_degree>(
        polynomial.value, Work(polynomial.error));
    if constexpr (std::is_same_v<Scalar, double>) {
      if (roots.status == numeric::RootStatus::invalid) {
        result_.status = AssemblyStatus::not_finite;
        return true;
      }
    }
    if (roots.status != numeric::RootStatus::certified) {
      return false;
    }
    const Scalar longest = (std::max)(Scalar(1), longest_length(u_));
    // The Jacobian has the relative error of the coordinates; the group's length is near one.
    const Scalar unsure = (std::max)(off_, std::numeric_limits<Scalar>::epsilon() * longest);
    for (std::size_t root = 0; root < roots.root_count; ++root) {
      if (!accept({Scalar(roots.roots[root].cosine), Scalar(roots.roots[root].sine)}, longest,
                  unsure)) {
        return false;
      }
    }
    return !has_twins<Model, Scalar>(result_);
  }

 private:
  /// Completes the configuration at a simple root, polishes it on the loop equations if need be and
  /// lists it; false if it does not close.
  [[nodiscard]] bool accept(const Direction<Scalar>& first, Scalar longest, Scalar unsure) {
    if (result_.count == Model::max_configurations) {
      return false;
    }
    Configuration& q = entry(result_.configurations, result_.count);
    Status& regularity = entry(result_.regularity, result_.count);
    regularity = Status::no_convergence;
    first_of<Model>(q) = first;
    if (complete_simple<Model, Scalar>(d_, u_, q)) {
      const bool settled = closes<Model, Scalar>(d_, u_, q, longest * longest) &&
                           is_regular<Model, Scalar>(d_, u_, q, unsure);
      regularity =
          settled ? Status::ok : polish<Model, Scalar>(d_, u_, q, unsure, loose_margin<Scalar>);
    }
    if (regularity == Status::no_convergence) {
      first_of<Model>(q) = first;
      if (complete<Model, Scalar>(d_, u_, q)) {
        regularity = polish<Model, Scalar>(d_, u_, q, unsure, loose_margin<Scalar>);
      }
    }
    result_.count += is_solvable(regularity) ? 1 : 0;
    return is_solvable(regularity);
  }

  const Dimensions& d_;
  const Inputs& u_;
  Scalar displaced_;
  Scalar off_;
  Assemblies<Model, Scalar>& result_;
};

}  // namespace assur::detail
