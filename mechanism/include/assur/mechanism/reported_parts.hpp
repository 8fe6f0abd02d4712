// Reported parts of a configuration, and its known numbers.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <vector>

namespace assur::mechanism {

/// A copy of the configuration in which all derivatives are NaN, except those of links that drivers
/// place. In the copy, `derivatives_known` is true.
[[nodiscard]] Configuration without_derivatives(const Plan& plan, Configuration configuration);

/// The links that are reported, in the mechanism's order.
[[nodiscard]] std::vector<LinkIndex> reported_links(const Plan& plan, bool with_ground);

/// The reported prismatic joints and pins in slots, in the mechanism's order. A slot that replaces
/// a redundant joint is not among them: only the solver uses it.
[[nodiscard]] std::vector<JointIndex> reported_slides(const Plan& plan);
/// Their states in a configuration, in its order.
[[nodiscard]] std::vector<const SlideState*> reported_slides(const Plan& plan,
                                                             const Configuration& configuration);

}  // namespace assur::mechanism
