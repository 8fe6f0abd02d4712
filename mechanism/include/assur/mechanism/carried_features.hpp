// Features of links in the frames of the links that carry them, in any scalar.
#pragma once

#include <algorithm>
#include <assur/mechanism/structure.hpp>
#include <assur/normal_form.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <tuple>
#include <utility>

namespace assur::mechanism {

/// The direction of a line along (dx, dy), which are not both zero. The vector is scaled first, so
/// that squaring neither overflows nor underflows.
template <typename Scalar>
[[nodiscard]] Direction<Scalar> unit_direction(const Scalar& dx, const Scalar& dy) {
  const double scale =
      std::ldexp(1.0, std::ilogb(std::max(std::abs(dx.value()), std::abs(dy.value()))));
  const Scalar x = dx / scale;
  const Scalar y = dy / scale;
  const Scalar length = sqrt(x * x + y * y);
  return {x / length, y / length};
}

/// A feature of a driven link in the frame of the link that carries it: turned or slid in the frame
/// of the driven joint. `near` and `far` are the joint's features on the two links.
template <typename Scalar>
[[nodiscard]] LinkFeature<Scalar> moved_feature(const LinkFeature<Scalar>& feature,
                                                const LinkFeature<Scalar>& near,
                                                const LinkFeature<Scalar>& far, bool slides,
                                                const Scalar& by) {
  const auto rotated = [](const Direction<Scalar>& turn, const Scalar& x, const Scalar& y) {
    return std::make_pair(Scalar(turn.cos * x - turn.sin * y), Scalar(turn.sin * x + turn.cos * y));
  };
  const Direction<Scalar> back = reversed(far.along);
  auto [x, y] = rotated(back, feature.x - far.x, feature.y - far.y);
  LinkFeature<Scalar> result = feature;
  if (slides) {
    x = x + by;
    result.along = turned(turned(feature.along, back), near.along);
  } else {
    const Direction<Scalar> turn{cos(by), sin(by)};
    std::tie(x, y) = rotated(turn, x, y);
    result.along = turned(turned(turned(feature.along, back), turn), near.along);
  }
  const auto [from_x, from_y] = rotated(near.along, x, y);
  result.x = near.x + from_x;
  result.y = near.y + from_y;
  return result;
}

/// A feature of a carried link in the frame of the link that carries it. `feature_of(feature,
/// is_line)` is a feature in its own link's frame, `position` the joint's coordinate by the
/// driver's law.
template <typename Scalar, typename FeatureOf>
[[nodiscard]] LinkFeature<Scalar> moved_feature(const LinkFeature<Scalar>& feature,
                                                const Structure& structure, const CarriedLink& link,
                                                const FeatureOf& feature_of,
                                                const Scalar& position) {
  const ElementaryJoint& joint = structure.linkage.joints[link.joint];
  return moved_feature(feature, feature_of(joint.on(link.from), joint.prismatic),
                       feature_of(joint.on(link.to), joint.prismatic), joint.prismatic,
                       joint.first == link.from ? position : Scalar(-position));
}

/// Transforms a feature that is given in `frame` into the outer frame, in which `frame` is given.
template <typename Scalar>
[[nodiscard]] LinkFeature<Scalar> placed_feature(const LinkFeature<Scalar>& feature,
                                                 const Pose<Scalar>& frame) {
  LinkFeature<Scalar> result = feature;
  const auto& [cosine, sine] = frame.direction;
  result.x = frame.x + cosine * feature.x - sine * feature.y;
  result.y = frame.y + sine * feature.x + cosine * feature.y;
  result.along = turned(feature.along, frame.direction);
  return result;
}

/// A joint's feature in the frame of a link that has it, or that carries the link that has it.
/// `feature_of(feature, is_line)` is a feature in its own link's frame, `carried(feature, link)`
/// one of a carried link in the frame of the link that carries it.
template <typename Scalar, typename FeatureOf, typename Carried>
[[nodiscard]] LinkFeature<Scalar> carried_feature(const Structure& structure,
                                                  const ElementaryJoint& at, LinkIndex link,
                                                  const FeatureOf& feature_of,
                                                  const Carried& carried) {
  LinkFeature<Scalar> result = feature_of(at.on(link), at.prismatic);
  for (LinkIndex holder = at.holder(link); holder != link;) {
    const CarriedLink& next = *structure.carried_link(holder);
    result = carried(result, next);
    holder = next.from;
  }
  return result;
}

}  // namespace assur::mechanism
