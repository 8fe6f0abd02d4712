// Turns a scene into the poses of its links in one configuration.
#pragma once

#include <assur/mechanism/plan.hpp>

namespace assur::generator::emission::scene {

/// The poses of all links, blocks of pins in slots among them, in the scene's first configuration
/// at its own numbers. Throws MechanismError if there is none.
[[nodiscard]] mechanism::Table<mechanism::LinkIndex, Pose<double>> poses_of_links(
    const mechanism::Plan& plan, const mechanism::Values& values);

/// A pose in another one.
[[nodiscard]] Pose<double> seen_from(const Pose<double>& frame, const Pose<double>& pose);

}  // namespace assur::generator::emission::scene
