// Links of a group at given angles and displacements, in any scalar.
#pragma once

#include <assur/directions.hpp>
#include <assur/model.hpp>
#include <assur/normal_form.hpp>
#include <vector>

#include "groups/loops.hpp"

namespace assur::mechanism::groups {

/// The features of a joint in the frames of its two links: a point, or a line through it. The
/// base's frame is fixed.
template <typename Scalar>
struct JointFeatures {
  LinkFeature<Scalar> on_first, on_second;
};

template <typename Scalar>
struct PlacedLinks {
  std::vector<Pose<Scalar>> poses;  ///< of the links
  std::vector<Scalar> closures;     ///< x and y of each loop
};

/// The place of a feature on a link.
template <typename Scalar>
[[nodiscard]] Pose<Scalar> feature_place(const Pose<Scalar>& link,
                                         const LinkFeature<Scalar>& feature) {
  const Direction<Scalar>& by = link.direction;
  return {link.x + feature.x * by.cos - feature.y * by.sin,
          link.y + feature.y * by.cos + feature.x * by.sin,
          feature.line ? turned(by, feature.along) : by};
}

/// Places the links of a group with these angles (without the base's) and displacements, each by
/// the joint through which it is reached. The closures are the gaps at the joints that close the
/// loops.
template <typename Scalar>
[[nodiscard]] PlacedLinks<Scalar> place_links(const Loops& loops,
                                              const std::vector<JointFeatures<Scalar>>& features,
                                              const std::vector<Direction<Scalar>>& angles,
                                              const std::vector<Scalar>& displacements) {
  const auto at = [](int index) { return static_cast<std::size_t>(index); };
  const Pose<Scalar> base{Scalar(0), Scalar(0), {Scalar(1), Scalar(0)}};
  PlacedLinks<Scalar> result{std::vector<Pose<Scalar>>(at(loops.link_count), base), {}};
  const auto pose_of = [&](int link) -> const Pose<Scalar>& {
    return link == base_link ? base : result.poses[at(link)];
  };
  const auto feature_on = [&](int joint, int link) -> const LinkFeature<Scalar>& {
    return loops.joints[at(joint)].first == link ? features[at(joint)].on_first
                                                 : features[at(joint)].on_second;
  };
  for (std::size_t angle = 0; angle < angles.size(); ++angle) {
    result.poses[at(loops.free_turned[angle])].direction = angles[angle];
  }
  for (const auto& [link, joint] : loops.turned) {
    const int from = loops.other(joint, link);
    result.poses[at(link)].direction =
        turned(turned(pose_of(from).direction, feature_on(joint, from).along),
               reversed(feature_on(joint, link).along));
  }
  // The vector from the first link's feature to the second one's, by the displacement.
  const auto slid = [&](int joint, int from) {
    const Pose<Scalar> end = feature_place(pose_of(from), feature_on(joint, from));
    if (loops.slide[at(joint)] < 0) {
      return end;
    }
    const Scalar& s = displacements[at(loops.slide[at(joint)])];
    const Scalar by = loops.joints[at(joint)].first == from ? s : Scalar(-s);
    return Pose<Scalar>{end.x + by * end.direction.cos, end.y + by * end.direction.sin,
                        end.direction};
  };
  for (const auto& [link, joint] : loops.placed) {
    const Pose<Scalar> there = slid(joint, loops.other(joint, link));
    Pose<Scalar>& pose = result.poses[at(link)];
    const Pose<Scalar> end = feature_place(pose, feature_on(joint, link));
    pose.x = there.x - end.x;
    pose.y = there.y - end.y;
  }
  for (const int joint : loops.closing) {
    const ModelJoint& ends = loops.joints[at(joint)];
    const Pose<Scalar> there = slid(joint, ends.first);
    const Pose<Scalar> end = feature_place(pose_of(ends.second), feature_on(joint, ends.second));
    result.closures.push_back(there.x - end.x);
    result.closures.push_back(there.y - end.y);
  }
  return result;
}

}  // namespace assur::mechanism::groups
