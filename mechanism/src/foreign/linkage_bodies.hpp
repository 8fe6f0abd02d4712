// Rigid bodies of a file of the program Linkage, and the slots in which they slide.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "foreign/foreign_mechanism.hpp"
#include "foreign/linkage_file.hpp"

namespace assur::mechanism::foreign {

/// A mechanism without drives, and its file without the elements that the program itself ignores.
struct LinkageBodies {
  ForeignMechanism mechanism;
  LinkageFile file;
  /// The link of each Link of the file; for an actuator those of its two connectors.
  std::vector<std::array<ForeignLinkIndex, 2>> links;
  std::map<int, std::size_t> connector_of_id, link_of_id;  ///< their indices in the file

  /// Null if the file has no connector of that number.
  [[nodiscard]] const LinkageConnector* connector(int id) const;
  [[nodiscard]] ForeignPointIndex point(int id) const;
};

/// Throws MechanismError for a text that is not a file of Linkage.
[[nodiscard]] LinkageBodies linkage_bodies(const std::string& text);

}  // namespace assur::mechanism::foreign
