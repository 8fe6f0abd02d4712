#include "placement.hpp"

#include <algorithm>
#include <cmath>

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
      chosen_(structure_.groups.size(), 0),
      turns_(values_, placed_),
      all_placed_(structure_.linkage.links.size(), false) {
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

void Placement::begin(bool forgets_unknown_rates) {
  if (settled_) {
    *settled_ = given_;
  }
  placed_.regularity = Status::ok;
  placed_.derivatives_known = true;
  placed_.path_known = true;
  placed_.rates_known = true;
  placed_.forgets_unknown_rates = forgets_unknown_rates;
  placed_.is_crossing = true;
  placed_.residual = 0;
  turns_.begin();
  steps_ = 0;
}

bool Placement::move_carried_links(std::size_t groups) {
  return move_carried_links(groups, all_placed_);
}

bool Placement::move_carried_links(std::size_t groups, Table<LinkIndex, bool>& unplaced) {
  placed_groups_ = groups;
  const auto is_missing = [&unplaced](LinkIndex link) { return unplaced[link]; };
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
        unplaced[link.to] = true;
      } else {
        place_carried_link(place);
      }
    }
  }
  return settle_what_reads(structure_.carried.size());
}

bool Placement::settle(const ReadingDriver& reading) {
  turns_.begin_law(static_cast<std::size_t>(&reading - structure_.reading.data()), placed_groups_);
  try {
    settled_->settle(reading.driver, [&](JointIndex joint) { return turns_.coordinate(joint); });
  } catch (const MechanismError& error) {
    turns_.lose_law();
    flaw_ = error.what();
    return false;
  }
  const JointMotion& motion = values_.motion(reading.driver);
  if (!motion.is_known()) {
    placed_.regularity = Status::near_singular;
    placed_.rates_known = false;
  }
  if (!motion.has_known_derivatives()) {
    placed_.derivatives_known = placed_.path_known = false;
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
  // A carried link is loose if the group that places it is unplaced, or if its law reads an
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
