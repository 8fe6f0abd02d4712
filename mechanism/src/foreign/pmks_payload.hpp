// Reads the numbers and names in the text after the question mark of a PMKS+ link.
#pragma once

#include <string>
#include <vector>

#include "foreign/foreign_mechanism.hpp"

namespace assur::mechanism::foreign {

/// A pin, or a slider in a slot of the ground or of a link.
struct PmksJoint {
  bool slides = false, is_input = false, is_grounded = false;
  bool is_welded = false;  ///< of a slider: the part in the slot does not turn in it
  bool is_traced = false;
  std::string id, name;
  double x = 0, y = 0;
  double angle = 0;                     ///< of a slot in the ground, in radians
  std::string carrier, slot_a, slot_b;  ///< a slot in a link, along two of its joints
  double speed = 0;  ///< counter-clockwise turns per minute, or length per second; 0 if none
  double mass = 0;   ///< of the block of a slider
};

/// A rigid body, or the block between a pin and a slider at one place.
struct PmksLink {
  bool is_root = true;  ///< false for a part that is welded into another link
  bool is_block = false;
  std::string id, name;
  double mass = 0, inertia = 0, x = 0, y = 0;
  std::vector<std::string> joints, parts;
};

/// A force from its start toward its end.
struct PmksForce {
  bool is_local = false, points_out = true;
  std::string id, link, name;
  double start_x = 0, start_y = 0, end_x = 0, end_y = 0, magnitude = 0;
};

struct PmksPayload {
  bool is_clockwise = false, wants_forces = false, has_gravity = true;
  double slide_speed = 0;  ///< length per second; 0 if it is not given
  double turns_per_minute = 0;
  int length_unit = -1;  ///< 0 inch, 1 centimetre, 2 metre
  std::vector<PmksJoint> joints;
  std::vector<PmksLink> links;
  std::vector<PmksForce> forces;
};

/// Adds remarks on all other contents to `mechanism`. Throws MechanismError for a text that is not
/// such a payload, or damaged.
[[nodiscard]] PmksPayload read_pmks(const std::string& payload, ForeignMechanism& mechanism);

/// The part of a link after the question mark, with its percent signs decoded; a payload itself is
/// unchanged. Empty for a text that is neither.
[[nodiscard]] std::string pmks_payload_of(const std::string& text);

}  // namespace assur::mechanism::foreign
