// Tables of a model's structure: variables, links, joints and kinds.
#pragma once

#include <array>
#include <cstddef>

namespace assur {

/// A dimension or an input of a model as its vectors and matrices index it.
struct ModelVariable {
  const char* name;
  bool is_angle;  ///< radians; otherwise a length
};

/// An unknown of a model: the angle of a link, or the displacement of a prismatic joint.
struct ModelUnknown {
  const char* name;
  bool is_angle;
  int owner;  ///< index of the link whose angle it is, or of the joint that slides
};

/// Stands for the base, to which external joints attach, in place of a link index.
inline constexpr int base_link = -1;

/// A joint of a model: the links it joins (`first` may be the base) and its type.
struct ModelJoint {
  char name;
  int first;
  int second;
  bool prismatic;
};

/// A link of a model by its joints; a binary link has -1 in the third place.
struct ModelLink {
  const char* name;
  std::array<int, 3> joints;
};

/// A kind, and the joint of the model that corresponds to each of its joints.
template <int Joints>
struct KindRoles {
  const char* kind;
  std::array<int, static_cast<std::size_t>(Joints)> role;
};

}  // namespace assur
