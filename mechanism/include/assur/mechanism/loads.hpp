// Loads on the links of a mechanism: masses, gravity, forces, couples, springs and dampers.
#pragma once

#include <array>
#include <assur/mechanism/part_indices.hpp>
#include <string>
#include <vector>

namespace assur::mechanism {

/// A place on a link: a point of it, or coordinates in its frame.
struct PlaceOnLink {
  LinkIndex link;
  NumberIndex x, y;  ///< do not exist for the origin of the link's frame
};

/// The mass of a link, and its moment of inertia about the centre of mass. Neither is negative;
/// both count as constant in time.
struct Mass {
  PlaceOnLink at;
  NumberIndex mass, inertia;  ///< an inertia that does not exist is zero
};

/// A force at a point of a link, or a couple on a link.
struct Load {
  std::string name;
  PlaceOnLink at;
  NumberIndex force_x, force_y;  ///< do not exist for a couple
  LinkIndex frame;               ///< the frame of the force; the ground's if it does not exist
  NumberIndex moment;            ///< does not exist for a force
};

/// A straight spring with a damper between points of two links, or one that acts along the
/// coordinate of a joint of two links. Numbers that do not exist are zero.
struct Spring {
  std::string name;
  bool at_joint = false;
  std::array<FeatureIndex, 2> between;  ///< two points, or the features of the joint
  NumberIndex stiffness, rest, damping;
};

/// All loads of a mechanism.
struct Loading {
  std::vector<Mass> masses;  ///< at most one for each link
  std::array<NumberIndex, 2> gravity;
  std::vector<Load> loads;
  std::vector<Spring> springs;
};

}  // namespace assur::mechanism
