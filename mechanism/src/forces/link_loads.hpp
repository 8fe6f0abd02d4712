// Turns masses, gravity, loads, springs and dampers into wrenches on the links.
#pragma once

#include <assur/mechanism/forces.hpp>

#include "balance.hpp"
#include "moving_links.hpp"

namespace assur::mechanism::forces {

/// The wrenches on each link about its pivot, and on the ground about its origin.
struct LinkLoads {
  Table<LinkIndex, Wrench> applied;  ///< of gravity, loads, springs and dampers
  Table<LinkIndex, Wrench> inertia;  ///< -m a and -I alpha, at the centre of mass
  /// Units of the pulls that are not known, which `applied` lacks: two of each spring.
  std::vector<Reaction> unknown_pulls;
  std::string reason;  ///< why they are not known
};

/// The same wrenches, and their derivatives by the parameter that the links follow.
struct MovingLoads {
  LinkLoads values, derivatives;
};

/// The centre of mass of a link, in the frame of the ground.
struct MassCentre {
  LinkIndex link;
  double mass = 0, inertia = 0;
  Eigen::Vector2d arm;           ///< from the origin of the link's frame
  Eigen::Vector2d acceleration;  ///< with that of parameters that move it on its link
};

[[nodiscard]] std::vector<MassCentre> mass_centres(const Values& values,
                                                   const Configuration& configuration);

/// A damper at a joint whose rate is not known is NaN.
[[nodiscard]] MovingLoads moving_loads(const Mechanism& mechanism, const MovingLinks& links,
                                       const Balance& balance);
[[nodiscard]] LinkLoads link_loads(const Values& values, const Configuration& configuration,
                                   const Balance& balance);

}  // namespace assur::mechanism::forces
