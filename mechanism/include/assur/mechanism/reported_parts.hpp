// Turns a configuration into what is reported of it: reported parts, and known numbers.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <vector>

namespace assur::mechanism {

/// The configuration with NaN in place of rates and derivatives that are not known. Those of links
/// that drivers place are always known. In the result, `rates_known` and `derivatives_known` hold.
[[nodiscard]] Configuration without_unknown(const Plan& plan, Configuration configuration);

/// The links that are reported, in the mechanism's order.
[[nodiscard]] std::vector<LinkIndex> reported_links(const Plan& plan, bool with_ground);

/// The prismatic joints and pins in slots that are reported, in the mechanism's order. The slot
/// that stands in for a redundant joint is not among them: it belongs to the solver only.
[[nodiscard]] std::vector<JointIndex> reported_slides(const Plan& plan);
/// Their states in a configuration, in its order.
[[nodiscard]] std::vector<const SlideState*> reported_slides(const Plan& plan,
                                                             const Configuration& configuration);

}  // namespace assur::mechanism
