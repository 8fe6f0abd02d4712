// Points of a drawing on features of links.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>

namespace assur::mechanism::draw {

/// The range of a joint's coordinate: its lowest and highest displacement.
struct Reach {
  double lowest = 0, highest = 0;

  void include(double displacement) {
    lowest = std::min(lowest, displacement);
    highest = std::max(highest, displacement);
  }
};
using Reaches = Table<JointIndex, std::optional<Reach>>;

/// The position of a point along its line, from the feature's `through`.
enum class Offset : unsigned char {
  none,
  first_end,   ///< before the lowest place of the sliding part, by a margin
  second_end,  ///< behind the highest, by a margin
  ahead,       ///< at a short distance, to show a direction
  mouth        ///< of a tube: just short of the rod's eye of the shortest cylinder
};

/// A point of the drawing, as a place on a feature of a link.
struct Anchor {
  FeatureIndex feature;
  Offset offset = Offset::none;
  JointIndex joint = {};  ///< the joint whose displacements define the offset
  double sense = 1;       ///< -1 where they count against the line
};

/// The features of a mechanism in the frames of their links, at one set of values; a line runs
/// along its x-axis.
using FeatureFrames = Table<FeatureIndex, Pose<double>>;
[[nodiscard]] FeatureFrames feature_frames(const Mechanism& mechanism, const Values& values);

/// The poses of a mechanism's links in a configuration of its planned part; nothing for links
/// outside that part.
using LinkPoses = Table<LinkIndex, std::optional<Pose<double>>>;
[[nodiscard]] LinkPoses link_poses(const Mechanism& mechanism, const Mechanism& planned,
                                   const Configuration& configuration);

/// Includes the displacements of a configuration of the planned part in the joints' ranges.
void include_displacements(const Mechanism& mechanism, const Mechanism& planned,
                           const Configuration& configuration, Reaches& reaches);

/// The place of an anchor in the frame of the ground; margins are parts of the mechanism's `size`.
[[nodiscard]] Eigen::Vector2d position(const Anchor& anchor, const Mechanism& mechanism,
                                       const FeatureFrames& frames, const LinkPoses& poses,
                                       const Reaches& reaches, double size);

/// The diagonal of the box around the points of a configuration's links; one if they are all in one
/// place.
[[nodiscard]] double size_of(const Mechanism& mechanism, const FeatureFrames& frames,
                             const LinkPoses& poses);

}  // namespace assur::mechanism::draw
