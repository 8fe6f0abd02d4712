// Reads the connectors, links and ratios of a `.linkage2` file, XML of the program Linkage.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "foreign/foreign_mechanism.hpp"

namespace assur::mechanism::foreign {

/// A pin, or a point of a link.
struct LinkageConnector {
  int id = 0;
  std::string name;
  double x = 0, y = 0;
  bool moves = true;       ///< not part of a drawing or a measurement
  bool is_anchor = false;  ///< on the ground, as inputs are
  bool is_input = false, is_drawing = false, is_moved_by_hand = false;
  double turns_per_minute = 0;               ///< clockwise
  double limit_angle = 0, start_offset = 0;  ///< degrees; with a limit the input oscillates
  double slide_radius = 0;
  std::vector<int> slide_limits;       ///< none, or two connectors between which this one slides
  std::optional<int> link, connector;  ///< the link or connector to which it is fastened
};

/// A rigid body, an actuator or a gear.
struct LinkageLink {
  int id = 0;
  std::string name;
  std::vector<int> connectors, fastened;
  bool is_actuator = false, is_gear = false, is_moved_by_hand = false;
  double stroke = 0, cycles_per_minute = 0, start_offset = 0;
  std::optional<int> link, connector;  ///< the link or connector to which it is fastened
};

/// A pair of gears, or of wheels with a chain.
struct LinkageRatio {
  bool is_chain = false;
  std::vector<int> links;
  std::vector<double> sizes;
};

/// The links of a file without measurements and the drawing layer, and all connectors.
struct LinkageFile {
  std::string unit;  ///< the unit in which the program shows lengths: `mm`
  std::vector<LinkageConnector> connectors;
  std::vector<LinkageLink> links;
  std::vector<LinkageRatio> ratios;
};

/// Adds remarks on all other contents of the file to `mechanism`. Throws MechanismError for a text
/// that is not such a file.
[[nodiscard]] LinkageFile read_linkage(const std::string& text, ForeignMechanism& mechanism);

}  // namespace assur::mechanism::foreign
