// Poses of a scene's links in its first configuration.
#pragma once

#include <assur/mechanism/plan.hpp>

namespace assur::generator::emission::scene {

/// The poses of all links in the scene's first configuration at its own numbers; those of blocks,
/// which have no features, are default poses. Throws MechanismError if there is no configuration.
[[nodiscard]] mechanism::Table<mechanism::LinkIndex, Pose<double>> poses_of_links(
    const mechanism::Plan& plan, const mechanism::Values& values);

/// A pose relative to a frame.
[[nodiscard]] Pose<double> seen_from(const Pose<double>& frame, const Pose<double>& pose);

}  // namespace assur::generator::emission::scene
