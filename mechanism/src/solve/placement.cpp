#include "placement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "limits.hpp"
#include "plan/plan_data.hpp"
#include "search_bounds.hpp"

namespace assur::mechanism::solve {

namespace {

bool slides_on(const Structure& structure, const CarriedLink& link) {
  return link.joint.exists() && structure.linkage.joints[link.joint].prismatic;
}

bool is_of(const FoundGroup& group, LinkIndex link) {
  return std::ranges::find(group.links, link) != group.links.end();
}

}  // namespace

Placement::Placement(const Values& values)
    : plan_(values.shared_plan()),
      structure_(plan_->structure),
      given_(values),
      settled_(structure_.reading.empty() && !structure_.has_relative_groups()
                   ? std::nullopt
                   : std::optional(values)),
      values_(settled_ ? *settled_ : given_),
      chosen_(structure_.groups.size(), 0) {
  const auto parameters = static_cast<Eigen::Index>(values.columns().size());
  placed_.links.resize(structure_.linkage.links.size());
  placed_.links[structure_.linkage.ground] = Frame::identity(parameters, values.second_order());
  placed_.displaced.assign(structure_.linkage.links.size(), {});
  placed_.groups.resize(structure_.groups.size());
  if (plan_->request.sweep) {
    placed_.determinants.resize(structure_.groups.size());
  }
  std::size_t slides = 0;
  for (const CarriedLink& link : structure_.carried) {
    driven_slide_.push_back(slides);
    slides += slides_on(structure_, link) ? 1 : 0;
  }
  solvers_.reserve(structure_.groups.size());
  for (const GroupIndex group : structure_.groups.keys()) {
    solvers_.add(GroupSolver(values_, group));
    carried_by_base_.add(structure_.carried_by_base(group));
    first_slide_.add(slides);
    for (const ModelUnknown& unknown : structure_.groups[group].model->unknowns) {
      slides += unknown.is_angle ? 0 : 1;
    }
  }
  placed_.slides.resize(slides);
}

void Placement::begin() {
  if (settled_) {
    *settled_ = given_;
  }
  placed_.regularity = Status::ok;
  placed_.derivatives_known = true;
  placed_.path_known = true;
  placed_.rates_known = true;
  placed_.is_crossing = true;
  placed_.residual = 0;
  countings_.assign(structure_.reading.size(), {});
  listed_ = {};
  is_continued_.resize(nearby_.size());
  for (std::size_t set = 0; set < nearby_.size(); ++set) {
    is_continued_[set].assign(nearby_[set].configurations->size(), false);
  }
  steps_ = 0;
}

bool Placement::move_carried_links(std::size_t groups, Table<LinkIndex, bool>* unplaced) {
  placed_groups_ = groups;
  const auto is_missing = [unplaced](LinkIndex link) {
    return unplaced != nullptr && (*unplaced)[link];
  };
  const auto is_unread = [&](const ReadingDriver& one) {
    return std::ranges::any_of(one.reads, is_missing);
  };
  auto reading =
      std::ranges::lower_bound(structure_.reading, groups, {}, &ReadingDriver::groups_before);
  const auto settle_what_reads = [&](std::size_t links) {
    for (; reading != structure_.reading.end() && reading->groups_before == groups &&
           reading->links_before <= links;
         ++reading) {
      if (!is_unread(*reading) && !settle(*reading)) {
        return false;
      }
    }
    return true;
  };
  for (std::size_t place = 0; place < structure_.carried.size(); ++place) {
    if (!settle_what_reads(place)) {
      return false;
    }
    const CarriedLink& link = structure_.carried[place];
    if (link.groups_before == groups) {
      const bool reads_nothing = std::ranges::any_of(
          structure_.reading,
          [&](const ReadingDriver& one) { return one.driver == link.driver && is_unread(one); });
      if (is_missing(link.from) || reads_nothing) {
        (*unplaced)[link.to] = true;
      } else {
        place_carried_link(place);
      }
    }
  }
  return settle_what_reads(structure_.carried.size());
}

JointMotion Placement::counted_coordinate(JointIndex joint, Counting& counting) {
  JointMotion motion = coordinate_of(values_, placed_.links, placed_.slides, joint);
  if (plan_->mechanism.joints()[joint].type == JointType::revolute) {
    const std::optional<double> turns = turns_of(joint, motion.position.value(), counting);
    counting.doubts.begins = counting.doubts.begins || !turns;
    motion.position = motion.position + values_.constant(2 * std::numbers::pi * turns.value_or(0));
    const double angle = motion.position.value();
    const auto known = std::ranges::find(placed_.counted, joint, &CountedAngle::joint);
    if (known == placed_.counted.end()) {
      placed_.counted.push_back({joint, angle});
    } else {
      known->angle = angle;
    }
  }
  return motion;
}

/// Whether the groups that are placed so far have loop Jacobians of the signs that they have in a
/// configuration nearby. Along a branch, signs change in singular configurations only.
bool Placement::has_signs_of(const NearbyConfigurations& nearby, const Configuration& there) const {
  for (GroupIndex group(0); group.place() < placed_groups_; group = GroupIndex(group.place() + 1)) {
    if (values_.group(group).roles == (*nearby.roles)[group] &&
        there.determinants[group] * placed_.determinants[group] < 0) {
      return false;
    }
  }
  return true;
}

/// The whole turns to add to an angle, from the configuration nearby that the joint's links, and
/// all links of groups placed before, continue best; nothing if the joint's links continue none: a
/// configuration that continues no branch, such as the mirror image of one, has a count of its own.
/// Where a change of sign shows that branches have met, the continuation leads straight on; a step
/// across such a place is too wide to tell whether branches meet there or miss one another.
std::optional<double> Placement::turns_of(JointIndex joint, double angle, Counting& counting) {
  constexpr double clearly = 4;
  constexpr double indistinct = 1e-6;  // where branches meet, rounding moves links by less
  counts_.clear();
  for (std::size_t set = 0; set < nearby_.size(); ++set) {
    const NearbyConfigurations& nearby = nearby_[set];
    for (std::size_t place = 0; place < nearby.configurations->size(); ++place) {
      const Configuration& there = (*nearby.configurations)[place];
      const auto counted = std::ranges::find(there.counted, joint, &CountedAngle::joint);
      if (counted == there.counted.end()) {
        continue;
      }
      Continuation continuation;
      for (const FeatureIndex feature : plan_->mechanism.joints()[joint].between) {
        const LinkIndex link = plan_->mechanism.features()[feature].link;
        continuation.add(nearby, there, link, placed_.links[link].pose.direction);
      }
      if (std::min(continuation.error, continuation.away) < continuation.reach) {
        counting.continued.emplace_back(set, place);
        counts_.push_back({continuation.error + error_of_groups(nearby, there),
                           std::round((counted->angle - angle) / (2 * std::numbers::pi)),
                           has_signs_of(nearby, there)});
      }
    }
  }
  if (counts_.empty()) {
    return std::nullopt;
  }
  const Count best = *std::ranges::min_element(counts_, {}, &Count::error);
  CountDoubts& doubts = counting.doubts;
  doubts.leads_across = doubts.leads_across || !best.has_signs;
  for (const Count& other : counts_) {
    doubts.is_ambiguous = doubts.is_ambiguous || (other.turns != best.turns &&
                                                  other.error <= indistinct + clearly * best.error);
  }
  return best.turns;
}

double Placement::error_of_groups(const NearbyConfigurations& nearby,
                                  const Configuration& there) const {
  Continuation continuation;
  for (GroupIndex group(0); group.place() < placed_groups_; group = GroupIndex(group.place() + 1)) {
    for (const LinkIndex link : structure_.groups[group].links) {
      if (link.place() < there.links.size()) {
        continuation.add(nearby, there, link, placed_.links[link].pose.direction);
      }
    }
  }
  return continuation.error;
}

void Placement::note_listed() {
  for (const auto& [doubts, continued] : countings_) {
    note_doubts(doubts);
    listed_.begins = listed_.begins || doubts.begins;
    for (const auto& [set, place] : continued) {
      is_continued_[set][place] = true;
    }
  }
}

void Placement::note_doubts(const CountDoubts& doubts) {
  listed_.is_ambiguous = listed_.is_ambiguous || doubts.is_ambiguous;
  listed_.leads_across = listed_.leads_across || doubts.leads_across;
}

bool Placement::is_count_in_doubt() const {
  if (listed_.is_ambiguous || listed_.leads_across || (listed_.begins && !nearby_.empty())) {
    return true;
  }
  for (std::size_t set = 0; set < nearby_.size(); ++set) {
    const std::vector<bool>& is_continued = is_continued_[set];
    if (nearby_[set].go_on && std::ranges::find(is_continued, false) != is_continued.end()) {
      return true;
    }
  }
  return false;
}

bool Placement::settle(const ReadingDriver& reading) {
  Counting& counting = countings_[static_cast<std::size_t>(&reading - structure_.reading.data())];
  counting = {};
  try {
    settled_->settle(reading.driver,
                     [&](JointIndex joint) { return counted_coordinate(joint, counting); });
  } catch (const MechanismError& error) {
    // If turns were counted otherwise, the law might have a value, and the configuration be listed.
    note_doubts(counting.doubts);
    flaw_ = error.what();
    return false;
  }
  if (!values_.motion(reading.driver).is_known()) {
    placed_.regularity = Status::near_singular;
    placed_.derivatives_known = placed_.path_known = placed_.rates_known = false;
  }
  return true;
}

void Placement::place_carried_link(std::size_t place) {
  const CarriedLink& link = structure_.carried[place];
  if (link.group.exists()) {
    const Frame& there = values_.carried_frame(place);
    compose(placed_.links[link.from], there, placed_.links[link.to]);
    placed_.displaced[link.to] = placed_.displaced[link.from].carries(
        there.pose.x, there.pose.y, values_.carried_rounding(place));
    return;
  }
  const JointMotion& motion = values_.motion(link.driver);
  const ElementaryJoint& at = structure_.linkage.joints[link.joint];
  set_motion(motion, at.prismatic, at.first == link.from ? 1.0 : -1.0);
  compose(placed_.links[link.from], values_.frame(at.on(link.from)), joint_);
  compose(joint_, motion_, moved_);
  compose(moved_, values_.carried_frame(place), placed_.links[link.to]);
  const Pose<double>& near = values_.frame(at.on(link.from)).pose;
  const Pose<double>& back = values_.carried_frame(place).pose;
  const double position = motion.position.value();
  placed_.displaced[link.to] = placed_.displaced[link.from]
                                   .carries(near.x, near.y, values_.rounding(at.on(link.from)))
                                   .carries(0, 0,
                                            at.prismatic ? support::Displacement::of_slide(position)
                                                         : support::Displacement::of_turn(position))
                                   .carries(back.x, back.y, values_.rounding(at.on(link.to)));
  if (at.prismatic) {
    set_slide(motion, at.joint, placed_.slides[driven_slide_[place]]);
  }
}

void Placement::hold(GroupIndex group) {
  if (const LinkIndex base = structure_.groups[group].base; base.exists()) {
    placed_.links[base] = placed_.links[structure_.linkage.ground];
    placed_.displaced[base] = {};
    for (const std::size_t place : carried_by_base_[group]) {
      place_carried_link(place);
    }
  }
  solvers_[group].hold(placed_);
}

/// Sets the moved frame in the joint's frame: turned about its origin, or slid along its x-axis.
void Placement::set_motion(const JointMotion& motion, bool prismatic, double sense) {
  const Dual& position = motion.position;
  const Eigen::Index moved = prismatic ? 0 : 2;
  const double by = sense * position.value();
  motion_.pose =
      prismatic ? Pose<double>{by, 0, {1, 0}} : Pose<double>{0, 0, {std::cos(by), std::sin(by)}};
  motion_.velocity(moved) = sense * motion.velocity;
  motion_.acceleration(moved) = sense * motion.acceleration;
  motion_.velocity(2 - moved) = motion_.acceleration(2 - moved) = 0;
  motion_.follows.set_zero(position.derivatives().size(), values_.second_order());
  motion_.follows.first.row(moved) = sense * position.derivatives().transpose();
  if (values_.second_order()) {
    motion_.follows.second[static_cast<std::size_t>(moved)] = sense * position.hessian();
  }
}

void Placement::set_slide(const JointMotion& motion, JointIndex joint, SlideState& slide) const {
  slide.joint = joint;
  slide.displacement = motion.position.value();
  slide.velocity = motion.velocity;
  slide.acceleration = motion.acceleration;
  slide.follows.first = motion.position.derivatives().transpose();
  if (values_.second_order()) {
    slide.follows.second = {motion.position.hessian()};
  }
}

bool Placement::can_be_solved(GroupIndex group, const Table<LinkIndex, bool>& unplaced) const {
  const auto is_any_unplaced = [&](const std::vector<LinkIndex>& links) {
    return std::ranges::any_of(links, [&](LinkIndex link) { return unplaced[link]; });
  };
  // A carried link is loose where the group that places it is unplaced, or its law reads an
  // unplaced link.
  const auto is_loose = [&](const CarriedLink& link) {
    return link.group.exists()
               ? is_any_unplaced(structure_.groups[link.group].links)
               : std::ranges::any_of(structure_.reading, [&](const ReadingDriver& reading) {
                   return link.driver == reading.driver && is_any_unplaced(reading.reads);
                 });
  };
  const auto shapes_it = [&](const CarriedLink& link) {
    return link.group != group && is_of(structure_.groups[group], link.to) && is_loose(link);
  };
  return std::ranges::none_of(structure_.carried, shapes_it) &&
         std::ranges::none_of(
             carried_by_base_[group],
             [&](std::size_t place) { return is_loose(structure_.carried[place]); }) &&
         !is_any_unplaced(structure_.groups[group].links) && solvers_[group].has_normal_form() &&
         !values_.numbers_of(group).is_held_by(unplaced);
}

const models::GroupAssemblies& Placement::assemble(GroupIndex group) {
  if (++steps_ > most_steps) {
    refuse_search(structure_, "to find them, more than " + std::to_string(most_steps) +
                                  " groups would have to be solved");
  }
  return solvers_[group].assemble();
}

void Placement::stand(GroupIndex group, std::size_t index) {
  if (structure_.groups[group].base.exists()) {
    place(group, index);
  } else {
    solvers_[group].stand(index, placed_.links);
  }
}

void Placement::place(GroupIndex group, std::size_t index) {
  solvers_[group].place(index, first_slide_[group], placed_);
  if (structure_.groups[group].base.exists()) {
    settled_->settle(group, placed_.links, placed_.displaced);
  }
  placed_.groups[group] = {solvers_[group].configuration(index), solvers_[group].displaced(),
                           placed_.rates_known};
  chosen_[group] = index;
  if (plan_->request.sweep) {
    placed_.determinants[group] = solvers_[group].determinant();
  }
}

}  // namespace assur::mechanism::solve
