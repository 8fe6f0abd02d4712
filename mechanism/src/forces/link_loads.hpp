// Wrenches on the links due to masses, gravity, loads, springs and dampers.
#pragma once

#include <assur/mechanism/forces.hpp>

#include "balance.hpp"
#include "moving_links.hpp"

namespace assur::mechanism::forces {

/// The wrenches on each link about its pivot, and on the ground about its origin.
struct LinkLoads {
  Table<LinkIndex, Wrench> applied;  ///< of gravity, loads, springs and dampers
  Table<LinkIndex, Wrench> inertia;  ///< -m a and -I alpha, at the centre of mass
  /// Units of the unknown pulls, which `applied` lacks: two for each such spring.
  std::vector<Reaction> unknown_pulls;
  std::string reason;  ///< why they are unknown
};

/// The same wrenches, and their derivatives with respect to the links' parameter.
struct MovingLoads {
  LinkLoads values, derivatives;
};

/// The centre of mass of a link, in the frame of the ground.
struct MassCentre {
  LinkIndex link;
  double mass = 0, inertia = 0;
  Eigen::Vector2d arm;           ///< from the origin of the link's frame
  Eigen::Vector2d acceleration;  ///< including that of parameters that move it on its link
};

[[nodiscard]] std::vector<MassCentre> mass_centres(const Values& values,
                                                   const Configuration& configuration);

/// A damper at a joint with an unknown rate is NaN.
[[nodiscard]] MovingLoads moving_loads(const Mechanism& mechanism, const MovingLinks& links,
                                       const Balance& balance);
[[nodiscard]] LinkLoads link_loads(const Values& values, const Configuration& configuration,
                                   const Balance& balance);

}  // namespace assur::mechanism::forces
