#include "branch_walk.hpp"

#include <algorithm>
#include <cmath>

#include "group_branches.hpp"
#include "models/series_functions.hpp"
#include "motion_terms.hpp"
#include "moving_laws.hpp"
#include "moving_shape.hpp"
#include "plan/plan_data.hpp"
#include "precision.hpp"
#include "relative_frames.hpp"

namespace assur::mechanism::solve {

namespace {

/// Walks depth first through the motions of the groups, as solving walks through configurations.
class BranchWalk {
 public:
  BranchWalk(const Values& values, const PlacedLinks& placed, const Configuration& configuration,
             const Motions& motions)
      : motions_(motions),
        settled_(motions.in_time && !values.plan().structure.reading.empty() ? std::optional(values)
                                                                             : std::nullopt),
        values_(settled_ ? *settled_ : values),
        structure_(values.plan().structure),
        placed_(placed),
        configuration_(configuration),
        links_(structure_.linkage.links.size()),
        carried_(structure_.carried.size()),
        has_relative_groups_(structure_.has_relative_groups()) {}

  std::vector<Configuration> run() {
    links_[structure_.linkage.ground] = models::at_rest({0, 0, {1, 0}});
    is_known_ = settled_ || std::ranges::all_of(motions_.drivers, is_finite);
    descend(0);
    return std::move(found_);
  }
  /// Whether what moves the groups was known on all branches.
  [[nodiscard]] bool is_known() const { return is_known_; }

 private:
  void move_carried_links(std::size_t groups_before) {
    auto reading = std::ranges::lower_bound(structure_.reading, groups_before, {},
                                            &ReadingDriver::groups_before);
    const auto settle_what_reads = [&](std::size_t links) {
      for (; settled_ && reading != structure_.reading.end() &&
             reading->groups_before == groups_before && reading->links_before <= links;
           ++reading) {
        settle(reading->driver);
      }
    };
    for (std::size_t place = 0; place < structure_.carried.size(); ++place) {
      settle_what_reads(place);
      if (structure_.carried[place].groups_before == groups_before) {
        move_carried_link(place);
      }
    }
    settle_what_reads(structure_.carried.size());
  }

  /// Evaluates the law of a driver that reads joints of links whose motions on this branch are
  /// known.
  void settle(DriverIndex driver) {
    const Mechanism& mechanism = values_.plan().mechanism;
    const auto coordinate = [&](JointIndex joint) {
      const DriverIndex other = mechanism.driver_of(joint);
      models::Series moving = other.exists() ? motions_.drivers[other] : moving_coordinate(joint);
      moving.c[0] = other.exists() ? values_.motion(other).position.value() : moving.c[0];
      return moving;
    };
    models::Series motion = moving_law(values_, driver, coordinate);
    motion.c[0] = 0;
    motions_.drivers[driver] = motion;
    is_known_ = is_known_ && is_finite(motion);
    settled_->settle(driver, [&](JointIndex joint) {
      const models::Series moving = coordinate(joint);
      return JointMotion{values_.constant(moving.value()), moving.rate(), moving.second_rate()};
    });
  }

  static bool is_finite(const models::Series& motion) {
    return std::isfinite(motion.c[1]) && std::isfinite(motion.c[2]);
  }
  void move_carried_link(std::size_t place) {
    const CarriedLink& link = structure_.carried[place];
    if (link.group.exists()) {
      links_[link.to] = composed(links_[link.from], carried_[place]);
      return;
    }
    const ElementaryJoint& joint = structure_.linkage.joints[link.joint];
    const models::Series& motion = motions_.drivers[link.driver];
    const models::Series moved = joint.first == link.from ? motion : -motion;
    // The joint's frame moves with the placed link, and the moved link turns or slides in it.
    const Pose<models::Series> base = composed(links_[link.from], place_of(joint.on(link.from)));
    const Pose<models::Series> step = joint.prismatic
                                          ? Pose<models::Series>{moved, 0, {1, 0}}
                                          : Pose<models::Series>{0, 0, turning({1, 0}, moved)};
    // Turning the link is not enough where its own feature moves on it, nor where the link that
    // carries it has been put elsewhere because a group is solved relative to it.
    links_[link.to] =
        has_relative_groups_ || (motions_.in_time && is_moving(values_.carried_frame(place)))
            ? composed(composed(composed(base, standing(link, joint)), step),
                       inverse(place_of(joint.on(link.to))))
            : composed(composed(base, step), seen_from(base, placed_.links[link.to].pose));
  }

  /// Puts the base of a group on the axes of the ground, with all that it carries, as solving does.
  void put_base(GroupIndex group) {
    if (structure_.groups[group].base.exists()) {
      links_[structure_.groups[group].base] = models::at_rest({0, 0, {1, 0}});
      for (const std::size_t place : structure_.carried_by_base(group)) {
        move_carried_link(place);
      }
    }
  }
  void keep_carried(GroupIndex group) {
    for (std::size_t place = 0; place < structure_.carried.size(); ++place) {
      if (structure_.carried[place].group == group) {
        carried_[place] = links_[structure_.carried[place].to];
      }
    }
  }

  /// A feature as it moves on its link.
  [[nodiscard]] LinkFeature<models::Series> own_feature(FeatureIndex index, bool is_line) const {
    if (motions_.in_time) {
      return moving_feature(values_, index, is_line);
    }
    const Pose<double>& pose = values_.frame(index).pose;
    return {is_line, pose.x, pose.y, {pose.direction.cos, pose.direction.sin}};
  }
  [[nodiscard]] Pose<models::Series> place_of(FeatureIndex index) const {
    const LinkFeature<models::Series> feature = own_feature(index, true);
    return {feature.x, feature.y, feature.along};
  }
  /// The coordinate of a joint without a driver between moving links.
  [[nodiscard]] models::Series moving_coordinate(JointIndex joint) const {
    const Mechanism& mechanism = values_.plan().mechanism;
    if (mechanism.joints()[joint].type == JointType::revolute) {
      return moving_angle(links_, configuration_, joint);
    }
    const auto placed = [&](FeatureIndex feature) {
      return composed(links_[mechanism.features()[feature].link], place_of(feature));
    };
    const SlideFeatures at = features_of_slide(mechanism, joint);
    const Pose<models::Series> line = placed(at.line);
    const Pose<models::Series> other = placed(at.other);
    return line.direction.cos * (other.x - line.x) + line.direction.sin * (other.y - line.y);
  }
  static bool is_moving(const Frame& frame) {
    return !frame.velocity.isZero(0) || !frame.acceleration.isZero(0);
  }
  /// The frame of the driven joint at t = 0.
  [[nodiscard]] Pose<models::Series> standing(const CarriedLink& link,
                                              const ElementaryJoint& joint) const {
    const double position = values_.motion(link.driver).position.value();
    const double by = joint.first == link.from ? position : -position;
    return models::at_rest(joint.prismatic ? Pose<double>{by, 0, {1, 0}}
                                           : Pose<double>{0, 0, {std::cos(by), std::sin(by)}});
  }

  /// A pose, at t = 0, as seen from a frame that moves.
  static Pose<models::Series> seen_from(const Pose<models::Series>& frame,
                                        const Pose<double>& pose) {
    const Direction<double> back{frame.direction.cos.value(), -frame.direction.sin.value()};
    const double x = pose.x - frame.x.value();
    const double y = pose.y - frame.y.value();
    return models::at_rest(
        {back.cos * x - back.sin * y, back.sin * x + back.cos * y, turned(pose.direction, back)});
  }

  void descend(std::size_t depth) {
    move_carried_links(depth);
    if (depth == structure_.groups.size()) {
      list();
      return;
    }
    const GroupIndex group(depth);
    const Values::GroupNumbers& numbers = values_.numbers_of(group);
    put_base(group);
    const std::optional<MovingShape> shape = shape_of(group, numbers);
    // The motion is not known where the features that move hardly define the frame of their link.
    is_known_ = is_known_ && shape && shape->is_known() &&
                precision_of_shape(numbers.firmness).second_rates_known;
    if (!is_known_) {
      return;
    }
    const models::FlatSeries u = inputs(numbers);
    const GroupModel& model = *structure_.groups[group].model;
    const std::vector<AcrossOnTheMove> across = across_axes(numbers, *shape);
    const PlacedGroup& here = placed_.groups[group];
    const MotionTerms terms = motion_terms(model, numbers, shape->speed, shape->d, u, here.q);
    // A displacement this large comes from a singular group, whose configuration has been settled
    // to rounding since. Behind other groups it is smaller, or these would have had no branches.
    const double displaced = here.displaced < two_digits_lost ? here.displaced : 0;
    for (const GroupBranch& branch :
         branches_through({model, shape->d, u, here.q, across, terms, displaced})) {
      for (std::size_t link = 0; link < numbers.links.size(); ++link) {
        links_[numbers.links[link]] = composed(branch.poses[link], shape->own[link]);
      }
      keep_carried(group);
      descend(depth + 1);
    }
  }

  [[nodiscard]] models::FlatSeries inputs(const Values::GroupNumbers& numbers) const {
    models::FlatSeries u;
    auto* to = u.data();
    for (const values::HeldJoint& joint : numbers.held) {
      const Pose<models::Series> place = composed(links_[joint.base], place_of(joint.feature));
      *to++ = place.x;
      *to++ = place.y;
      if (joint.prismatic) {
        *to++ = place.direction.cos;
        *to++ = place.direction.sin;
      }
    }
    return u;
  }

  [[nodiscard]] static std::vector<AcrossOnTheMove> across_axes(const Values::GroupNumbers& numbers,
                                                                const MovingShape& shape) {
    std::vector<AcrossOnTheMove> across;
    for (std::size_t place = 0; place < shape.across.size(); ++place) {
      const values::AcrossAxis& axis = numbers.across[place];
      models::Series moved = shape.across[place];
      moved.c[0] = 0;
      across.push_back({axis.dimension, axis.angle, moved});
    }
    return across;
  }

  /// The shape of a group on this branch: features that earlier groups and drivers carry move with
  /// these. Along a parameter that moves drivers alone, shapes do not change.
  [[nodiscard]] std::optional<MovingShape> shape_of(GroupIndex group,
                                                    const Values::GroupNumbers& numbers) const {
    if (motions_.in_time && numbers.d_rate.size() > 0) {
      return moving_shape(
          values_, group,
          {[this](FeatureIndex feature, bool is_line) { return own_feature(feature, is_line); },
           [this](const auto& feature, const CarriedLink& link) {
             return carried_feature(feature, link);
           }});
    }
    MovingShape shape;
    std::ranges::copy(numbers.d, shape.d.begin());
    for (const Frame& own : numbers.own) {
      shape.own.push_back(models::at_rest(own.pose));
    }
    return shape;
  }

  [[nodiscard]] LinkFeature<models::Series> carried_feature(
      const LinkFeature<models::Series>& feature, const CarriedLink& link) const {
    if (link.group.exists()) {
      return placed_feature(feature,
                            carried_[static_cast<std::size_t>(&link - structure_.carried.data())]);
    }
    return moved_feature(
        feature, structure_, link,
        [this](FeatureIndex of, bool is_line) { return own_feature(of, is_line); },
        values_.motion(link.driver).position.value() + motions_.drivers[link.driver]);
  }

  void list() {
    Configuration& result = found_.emplace_back(configuration_);
    result.rates_known = true;
    const Mechanism& mechanism = values_.plan().mechanism;
    for (const LinkIndex link : mechanism.links().keys()) {
      const Pose<models::Series>& pose = links_[link];
      result.links[link].velocity << pose.x.rate(), pose.y.rate(), turning_rate(pose.direction);
      result.links[link].acceleration << pose.x.second_rate(), pose.y.second_rate(),
          second_turning_rate(pose.direction);
    }
    for (const OutputIndex output : mechanism.outputs().keys()) {
      const FeatureIndex point = mechanism.outputs()[output].point;
      const Pose<models::Series> place =
          composed(links_[mechanism.features()[point].link], place_of(point));
      result.outputs[output].velocity << place.x.rate(), place.y.rate();
      result.outputs[output].acceleration << place.x.second_rate(), place.y.second_rate();
    }
    for (SlideState& slide : result.slides) {
      if (!mechanism.driver_of(slide.joint).exists()) {
        const models::Series moved = moving_coordinate(slide.joint);
        slide.velocity = moved.rate();
        slide.acceleration = moved.second_rate();
      }
    }
  }

  Motions motions_;
  std::optional<Values> settled_;  ///< where laws read links
  const Values& values_;           ///< one or the other
  const Structure& structure_;
  const PlacedLinks& placed_;
  const Configuration& configuration_;
  Table<LinkIndex, Pose<models::Series>> links_;
  std::vector<Pose<models::Series>> carried_;  ///< links of groups, in the frames of their bases
  bool has_relative_groups_;
  std::vector<Configuration> found_;
  bool is_known_ = true;
};

}  // namespace

std::optional<std::vector<Configuration>> motions_through(const Values& values,
                                                          const PlacedLinks& placed,
                                                          const Configuration& configuration,
                                                          const Motions& motions) {
  BranchWalk walk(values, placed, configuration, motions);
  std::vector<Configuration> found = walk.run();
  return walk.is_known() ? std::optional(std::move(found)) : std::nullopt;
}

}  // namespace assur::mechanism::solve
