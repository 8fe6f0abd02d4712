#include "draw/anchors.hpp"

#include <cmath>

namespace assur::mechanism::draw {

namespace {

/// Margins relative to the mechanism's size.
constexpr double margin = 0.05;
constexpr double step_ahead = 0.02;
/// The length of the tube, relative to the shortest cylinder.
constexpr double tube_part = 0.88;

Eigen::Vector2d carried(const Pose<double>& pose, const Eigen::Vector2d& point) {
  const auto& [c, s] = pose.direction;
  return {pose.x + c * point.x() - s * point.y(), pose.y + s * point.x() + c * point.y()};
}

double offset_of(const Anchor& anchor, const Reaches& reaches, double size) {
  if (anchor.offset == Offset::none) {
    return 0;
  }
  if (anchor.offset == Offset::ahead) {
    return step_ahead * size;
  }
  const Reach reach = reaches[anchor.joint].value_or(Reach());
  if (anchor.offset == Offset::mouth) {
    return anchor.sense * tube_part * (reach.lowest > 0 ? reach.lowest : reach.highest);
  }
  const bool low = (anchor.offset == Offset::first_end) == (anchor.sense > 0);
  const double end = anchor.sense * (low ? reach.lowest : reach.highest);
  return end + (anchor.offset == Offset::first_end ? -margin : margin) * size;
}

}  // namespace

FeatureFrames feature_frames(const Mechanism& mechanism, const Values& values) {
  FeatureFrames frames;
  for (const Feature& feature : mechanism.features()) {
    Pose<double> frame{values.value_of(feature.x), values.value_of(feature.y), {}};
    if (feature.is_line) {
      const double x = values.value_of(feature.along_x);
      const double y = values.value_of(feature.along_y);
      const double length = std::hypot(x, y);
      frame.direction = {x / length, y / length};
    }
    frames.add(frame);
  }
  return frames;
}

LinkPoses link_poses(const Mechanism& mechanism, const Mechanism& planned,
                     const Configuration& configuration) {
  LinkPoses poses(mechanism.links().size());
  for (const LinkIndex link : mechanism.links().keys()) {
    const LinkIndex own = index_of(planned.links(), mechanism.links()[link].name);
    if (own.exists()) {
      poses[link] = configuration.links[own].pose;
    }
  }
  return poses;
}

void include_displacements(const Mechanism& mechanism, const Mechanism& planned,
                           const Configuration& configuration, Reaches& reaches) {
  for (const SlideState& slide : configuration.slides) {
    const JointIndex joint = index_of(mechanism.joints(), planned.joints()[slide.joint].name);
    if (joint.exists()) {
      std::optional<Reach>& reach = reaches[joint];
      reach = reach.value_or(Reach{slide.displacement, slide.displacement});
      reach->include(slide.displacement);
    }
  }
}

Eigen::Vector2d position(const Anchor& anchor, const Mechanism& mechanism,
                         const FeatureFrames& frames, const LinkPoses& poses,
                         const Reaches& reaches, double size) {
  const double along = offset_of(anchor, reaches, size);
  const Eigen::Vector2d local = carried(frames[anchor.feature], {along, 0});
  return carried(*poses[mechanism.features()[anchor.feature].link], local);
}

double size_of(const Mechanism& mechanism, const FeatureFrames& frames, const LinkPoses& poses) {
  Eigen::Vector2d lowest = Eigen::Vector2d::Constant(INFINITY);
  Eigen::Vector2d highest = -lowest;
  for (const FeatureIndex feature : mechanism.features().keys()) {
    if (poses[mechanism.features()[feature].link] && !mechanism.features()[feature].is_line) {
      const Eigen::Vector2d at = position(Anchor{feature}, mechanism, frames, poses, {}, 0);
      lowest = lowest.cwiseMin(at);
      highest = highest.cwiseMax(at);
    }
  }
  const double size = (highest - lowest).norm();
  return size > 0 && std::isfinite(size) ? size : 1;
}

}  // namespace assur::mechanism::draw
