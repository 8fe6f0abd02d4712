#include "draw/film_details.hpp"

#include <assur/mechanism/forces.hpp>
#include <cmath>
#include <limits>

namespace assur::mechanism::draw {

namespace {

/// The place of a pin, on one of the links that it joins.
Eigen::Vector2d place_of(const ElementaryJoint& pin, LinkIndex link, const Values& values,
                         const Configuration& configuration) {
  const Pose<double>& own = values.frame(pin.on(link)).pose;
  const Pose<double>& pose = configuration.links[pin.holder(link)].pose;
  const auto& [c, s] = pose.direction;
  return {pose.x + c * own.x - s * own.y, pose.y + s * own.x + c * own.y};
}

}  // namespace

std::vector<PinnedDyad> dyads_of_pins(const Structure& structure) {
  std::vector<PinnedDyad> dyads;
  for (const FoundGroup& group : structure.groups) {
    const RoleAssignment& roles = group.assignments.front();
    if (roles.links.size() != 2 || roles.joints.size() != 3) {
      continue;
    }
    const LinkIndex first = roles.links[0];
    const LinkIndex second = roles.links[1];
    PinnedDyad dyad;
    bool is_pinned = true;
    for (const ElementaryJointIndex index : roles.joints) {
      const ElementaryJoint& joint = structure.linkage.joints[index];
      is_pinned =
          is_pinned && !joint.prismatic && joint.on_first.exists() && joint.on_second.exists();
      (joint.joins(first, second) ? dyad.inner
       : joint.touches(first)     ? dyad.one
                                  : dyad.other) = joint;
    }
    if (is_pinned) {
      dyads.push_back(dyad);
    }
  }
  return dyads;
}

double transmission_angle(const PinnedDyad& dyad, const Values& values,
                          const Configuration& configuration) {
  const auto on = [&](const ElementaryJoint& pin) {
    return place_of(pin, pin.first, values, configuration);
  };
  const Eigen::Vector2d inner = on(dyad.inner);
  const Eigen::Vector2d one = on(dyad.one) - inner;
  const Eigen::Vector2d other = on(dyad.other) - inner;
  return std::atan2(std::abs(one.x() * other.y() - one.y() * other.x()), one.dot(other));
}

namespace {

/// The joint of each driver.
std::vector<std::string> driven_joints(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const DriverIndex driver : described_drivers(mechanism)) {
    names.push_back(mechanism.joints()[mechanism.drivers()[driver].joint].name);
  }
  return names;
}

}  // namespace

FilmDetails::FilmDetails(const Plan& plan) : plan_(plan), dyads_(dyads_of_pins(plan.structure())) {
  for (const LinkIndex link : plan.mechanism().links().keys()) {
    if (link != plan.mechanism().ground() && plan.request().reported.has(link)) {
      links_.push_back(link);
    }
  }
}

void FilmDetails::name(Film& film) const {
  film.links.clear();
  for (const LinkIndex link : links_) {
    film.links.push_back(plan_.mechanism().links()[link].name);
  }
  film.transmissions.clear();
  for (const PinnedDyad& dyad : dyads_) {
    film.transmissions.push_back(dyad.inner.name);
  }
  if (plan_.request().want.forces) {
    film.efforts = driven_joints(plan_.mechanism());
    film.forces = forces_;
  }
}

DetailRow FilmDetails::row_of(const Values& values, const Configuration& configuration) {
  const Want& want = plan_.request().want;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  DetailRow row;
  for (const LinkIndex link : links_) {
    const Frame& frame = configuration.links[link];
    row.angles.insert(row.angles.end(),
                      {std::atan2(frame.pose.direction.sin, frame.pose.direction.cos),
                       want.velocity ? frame.velocity[2] : unknown,
                       want.acceleration ? frame.acceleration[2] : unknown});
  }
  for (const PinnedDyad& dyad : dyads_) {
    row.transmissions.push_back(transmission_angle(dyad, values, configuration));
  }
  if (want.forces) {
    row.forces = forces_in(values, configuration);
  }
  return row;
}

std::vector<double> FilmDetails::forces_in(const Values& values,
                                           const Configuration& configuration) {
  const Mechanism& mechanism = plan_.mechanism();
  const Forces forces = forces_of(values, configuration);
  std::vector<double> numbers;
  for (const DriverIndex driver : described_drivers(mechanism)) {
    numbers.push_back(forces.efforts[driver]);
  }
  forces_.clear();
  for (const JointForce& force : forces.joints) {
    const JointIndex joint = index_of(mechanism.joints(), force.joint);
    if (joint.exists() && !plan_.request().reported.has(joint)) {
      continue;
    }
    const std::size_t first = force.on.size() > 2 ? 0 : force.on.size() - 1;
    for (std::size_t place = first; place < force.on.size(); ++place) {
      const auto& [link, vector] = force.on[place];
      numbers.insert(numbers.end(), {vector.x(), vector.y()});
      forces_.push_back({force.joint, mechanism.links()[link].name});
    }
  }
  return numbers;
}

}  // namespace assur::mechanism::draw
