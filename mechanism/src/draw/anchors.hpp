// Turns features of links into the points of a drawing.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>

namespace assur::mechanism::draw {

/// Where the coordinates of joints have been: the lowest and the highest displacement of each.
struct Reach {
  double lowest = 0, highest = 0;

  void include(double displacement) {
    lowest = std::min(lowest, displacement);
    highest = std::max(highest, displacement);
  }
};
using Reaches = Table<JointIndex, std::optional<Reach>>;

/// How far along its line a point stands from the feature's `through`.
enum class Offset : unsigned char {
  none,
  first_end,   ///< the lowest place of what slides along the line, and a margin before it
  second_end,  ///< the highest, and a margin behind it
  ahead,       ///< a short way, which shows a direction
  mouth        ///< of a tube: just short of the rod's eye where the cylinder is shortest
};

/// A point of the drawing, as a place on a feature of a link.
struct Anchor {
  FeatureIndex feature;
  Offset offset = Offset::none;
  JointIndex joint = {};  ///< the joint whose displacements define the offset
  double sense = 1;       ///< -1 where they count against the line
};

/// The features of a mechanism in the frames of their links, at one set of values: a line along
/// its x-axis.
using FeatureFrames = Table<FeatureIndex, Pose<double>>;
[[nodiscard]] FeatureFrames feature_frames(const Mechanism& mechanism, const Values& values);

/// The poses of a mechanism's links in a configuration of its planned part; nothing for links
/// outside that part.
using LinkPoses = Table<LinkIndex, std::optional<Pose<double>>>;
[[nodiscard]] LinkPoses link_poses(const Mechanism& mechanism, const Mechanism& planned,
                                   const Configuration& configuration);

/// Includes the displacements of a configuration of the planned part in the joints' reaches.
void include_displacements(const Mechanism& mechanism, const Mechanism& planned,
                           const Configuration& configuration, Reaches& reaches);

/// The place of an anchor in the frame of the ground; margins are parts of the mechanism's `size`.
[[nodiscard]] Eigen::Vector2d position(const Anchor& anchor, const Mechanism& mechanism,
                                       const FeatureFrames& frames, const LinkPoses& poses,
                                       const Reaches& reaches, double size);

/// The diagonal of the box about the points of a configuration's links; one where they are in one
/// place.
[[nodiscard]] double size_of(const Mechanism& mechanism, const FeatureFrames& frames,
                             const LinkPoses& poses);

}  // namespace assur::mechanism::draw
