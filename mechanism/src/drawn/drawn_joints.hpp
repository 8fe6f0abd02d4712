// Explicit joints of a drawing, added to a mechanism with the features that they need.
#pragma once

#include <assur/mechanism/drawn_mechanism.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drawn/link_places.hpp"

namespace assur::mechanism::drawn {

/// The link and the point of an end `link.point` of a joint; the index of a link or a point that is
/// not drawn does not exist.
struct DrawnEnd {
  DrawnLinkIndex link;
  DrawnPointIndex point;
};

/// An explicit joint with its names resolved.
struct ResolvedJoint {
  const DrawnJoint* joint;
  std::vector<DrawnLinkIndex> links;  ///< of `links`
  std::vector<DrawnEnd> ends;         ///< of `between`
  DrawnPointIndex at;                 ///< of a pin
  std::optional<DrawnLine> line;      ///< of a slot or slide
  std::optional<Formula> coordinate;  ///< as drawn; nothing if the drawing does not determine it
};

/// Finds links and points of a drawing by their names. Throws MechanismError for others.
struct DrawnNames {
  std::function<DrawnLinkIndex(const std::string& name, const std::string& part)> link;
  std::function<DrawnEnd(const std::string& name)> end;
  std::function<DrawnPointIndex(const std::string& name, const std::string& part)> point;
  std::function<bool(const std::string& name)> has_point;
};

/// Resolves the names of a joint, and finds its coordinate as drawn, without any decision by
/// numbers.
[[nodiscard]] ResolvedJoint resolved(const DrawnJoint& joint, const DrawnParts& parts,
                                     const Mechanism& mechanism, const DrawnNames& names);

/// The distance of a joint's pin from its slot as drawn; zero for other joints.
[[nodiscard]] double gap_of(const ResolvedJoint& joint, const DrawnParts& parts,
                            const LinkPlaces& places);

/// Adds the lines that a joint needs, and the joint. Its points must already be features of the
/// links. `places` may be null for a joint without a line.
void add_resolved(const ResolvedJoint& joint, const DrawnParts& parts, const LinkPlaces* places,
                  Mechanism& mechanism);

}  // namespace assur::mechanism::drawn
