// Turns the explicit joints of a drawing into features of links and joints of a mechanism.
#pragma once

#include <assur/mechanism/drawn_mechanism.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drawn/link_places.hpp"

namespace assur::mechanism::drawn {

/// The link and the point of an end `link.point` of a joint; an index that does not exist stands
/// for a link or a point that is not drawn.
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
  std::optional<Formula> coordinate;  ///< as drawn; nothing if the drawing does not tell it
};

/// Finds links and points of a drawing by their names. Throws MechanismError for others.
struct DrawnNames {
  std::function<DrawnLinkIndex(const std::string& name, const std::string& part)> link;
  std::function<DrawnEnd(const std::string& name)> end;
  std::function<DrawnPointIndex(const std::string& name, const std::string& part)> point;
  std::function<bool(const std::string& name)> has_point;
};

/// Resolves the names of a joint, and finds its coordinate as drawn. No number decides here.
[[nodiscard]] ResolvedJoint resolved(const DrawnJoint& joint, const DrawnParts& parts,
                                     const Mechanism& mechanism, const DrawnNames& names);

/// How far the pin of a joint is drawn beside its slot; zero for other joints.
[[nodiscard]] double gap_of(const ResolvedJoint& joint, const DrawnParts& parts,
                            const LinkPlaces& places);

/// Adds the lines that a joint needs, and the joint. Its points are features of the links already.
/// `places` may be null where the joint has no line.
void add_resolved(const ResolvedJoint& joint, const DrawnParts& parts, const LinkPlaces* places,
                  Mechanism& mechanism);

}  // namespace assur::mechanism::drawn
