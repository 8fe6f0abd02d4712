// Turns a configuration into what is told of it: reported parts, and numbers that are known.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <vector>

namespace assur::mechanism {

/// A configuration with NaN in place of the rates and the derivatives that are not known: those of
/// links that drivers place are. Both flags are then true.
[[nodiscard]] Configuration without_unknown(const Plan& plan, Configuration configuration);

/// The links that are reported, in the mechanism's order.
[[nodiscard]] std::vector<LinkIndex> reported_links(const Plan& plan, bool with_ground);

/// The prismatic joints and pins in slots that are reported, in the mechanism's order. A joint that
/// holds where the others do is not one of them: its slot belongs to the solver only.
[[nodiscard]] std::vector<JointIndex> reported_slides(const Plan& plan);
/// Their states in a configuration, in its order.
[[nodiscard]] std::vector<const SlideState*> reported_slides(const Plan& plan,
                                                             const Configuration& configuration);

}  // namespace assur::mechanism
