#include "emission/scene/force_statements.hpp"

#include <algorithm>
#include <assur/mechanism/error.hpp>
#include <assur/mechanism/forces.hpp>
#include <assur/text/identifiers.hpp>
#include <functional>
#include <map>

#include "emission/scene/carried_links.hpp"
#include "emission/scene/force_order.hpp"
#include "emission/scene/link_loads.hpp"
#include "emission/scene/specialised_numbers.hpp"
#include "emission/scene/state_members.hpp"
#include "emission/scene/told_joints.hpp"

namespace assur::generator::emission::scene {

namespace {

using mechanism::FeatureIndex;
using mechanism::JointIndex;
using mechanism::LinkIndex;

/// The force of an elementary joint, as expressions.
struct Reaction {
  LinkIndex on;           ///< the link on which it acts; the opposite one acts on the other
  cpp::Expression force;  ///< without the effort of a driver
  /// The couple on that link, with the force at a point; empty for a pin.
  std::function<cpp::Expression(const cpp::Expression&)> couple_about;
};

cpp::Expression place_word(std::size_t place) { return cpp::word(place); }

/// Writes the function step by step: loads, then groups and drivers from the far ends to the
/// ground, then the members of the state.
class ForceStatements {
 public:
  explicit ForceStatements(const SolverScene& solver)
      : solver_(solver), body_(solver.body()), loads_(solver, body_) {}

  [[nodiscard]] cpp::Block run() {
    loads_.add_all();
    add_ground();
    for (const ForceStep& step : force_order(solver_.mechanism(), solver_.plan.structure())) {
      step.cut != nullptr ? cut(*step.cut) : solve(step.group);
    }
    for (const JointIndex joint : solver_.mechanism().joints().keys()) {
      if (solver_.tells_force(joint)) {
        tell(joint);
      }
    }
    return behind_joints_read(solver_, body_);
  }

 private:
  [[nodiscard]] cpp::Expression state(const std::string& part) const {
    return cpp::variable("state").member(part);
  }
  [[nodiscard]] LinkIndex link_of(FeatureIndex feature) const {
    return solver_.mechanism().features()[feature].link;
  }
  [[nodiscard]] const std::vector<FeatureIndex>& between(JointIndex joint) const {
    return solver_.mechanism().joints()[joint].between;
  }

  void add_ground() {
    std::vector<LinkIndex> links = {solver_.linkage().ground};
    for (const LinkIndex link : solver_.mechanism().links().keys()) {
      if (!solver_.is_ground(link)) {
        links.push_back(link);
      }
    }
    add_ground_resultant(loads_.together(links), body_);
  }

  void solve(mechanism::GroupIndex group) {
    const mechanism::GroupGeometry<SceneNumber>& geometry = solver_.numbers.group(group);
    const LinkIndex base = solver_.group(group).base;
    const std::string number = std::to_string(group.place() + 1);
    const std::string of = solver_.group_struct(group) + ", Scalar";
    const cpp::Expression held = body_.local("held_" + number);
    const cpp::Expression forces = body_.local("forces_" + number);
    body_.add(cpp::declared("support::HeldJoints<" + of + ", order, parameter_count>", held));
    body_.add(cpp::called(cpp::call("hold", {cpp::variable("placed"), held})));
    if (base.exists()) {
      const cpp::Name type = "support::GroupForces<" + of + ", true>";
      body_.add(cpp::declared(
          "auto", forces,
          cpp::call(type, {solver_.placed(base)->member("pose").member("direction")})));
    } else {
      body_.add(cpp::declared("support::GroupForces<" + of + ">", forces));
    }
    std::vector<cpp::Expression> origins;
    for (std::size_t place = 0; place < geometry.links.size(); ++place) {
      const LinkIndex link = geometry.roles->links[place];
      const Pose<SceneNumber>& frame = geometry.links[place].frame;
      origins.push_back(
          loads_.place("origin_of_" + solver_.link_name(link), link, frame.x, frame.y));
      body_.add(cpp::called(forces.member("load").at(
          {place_word(place), origins.back(),
           loads_.together(links_carried_by(solver_.plan.structure(), link))})));
    }
    const cpp::Expression solved = cpp::variable("placed").member(solver_.members.solved[group]);
    body_.add(cpp::called(forces.member("solve").at({held, solved})));
    const auto& joints = solver_.group(group).model->group->joints;
    for (std::size_t joint = 0; joint < joints.size(); ++joint) {
      const auto second = static_cast<std::size_t>(joints[joint].second);
      act(forces, joint, geometry.roles->joints[joint], geometry.roles->links[second],
          origins[second]);
    }
  }

  /// Adds the force of a group's joint to the loads of its links. `second` is the joint's second
  /// link in the model.
  void act(const cpp::Expression& forces, std::size_t joint, mechanism::ElementaryJointIndex index,
           LinkIndex second, const cpp::Expression& origin) {
    const mechanism::ElementaryJoint& at = solver_.joint(index);
    const LinkIndex on = at.holder(second);
    const cpp::Expression number = place_word(joint);
    const cpp::Expression place =
        at.prismatic ? origin : loads_.place(at.on_first.exists() ? at.on_first : at.on_second);
    body_.add(cpp::called(
        forces.member(at.prismatic ? "slide" : "turn")
            .at({number, place, loads_.on(on), loads_.on(at.holder(at.other(second)))})));
    Reaction reaction{on, forces.member("force").at({number}), {}};
    if (at.prismatic) {
      reaction.couple_about = [=](const cpp::Expression& about) {
        return forces.member("couple_about").at({number, origin, about});
      };
    }
    reactions_[index] = reaction;
  }

  /// Finds the effort of a driver, and the force in the bearing of its joint.
  void cut(const mechanism::CarriedLink& link) {
    const mechanism::ElementaryJoint& at = solver_.joint(link.joint);
    const std::string& member = solver_.members.drivers[link.driver];
    const std::vector<FeatureIndex>& features = between(at.joint);
    const bool slot =
        solver_.mechanism().joints()[at.joint].type == mechanism::JointType::pin_in_slot;
    const FeatureIndex through = slot && is_line(features[1]) ? features[0] : features[1];
    const cpp::Expression across = body_.local("across_" + at.name);
    body_.add(cpp::declared(
        "const support::ForceAndMoment<Scalar>", across,
        cpp::call("support::balance",
                  {loads_.place(through), loads_.on(link.to), loads_.on(link.from)})));
    const double sense = at.first == link.from ? 1 : -1;
    const cpp::Expression effort = body_.local("effort_" + at.name);
    Reaction reaction{link.to, across.member("force"), {}};
    cpp::Expression part = across.member("moment");
    if (at.prismatic) {
      const cpp::Expression line =
          loads_.direction(at.on_first.exists() ? at.on_first : at.on_second);
      part = cpp::call("support::part_along", {line, across.member("force")});
      reaction.force = cpp::call("support::part_across", {line, across.member("force")});
      reaction.couple_about = [across](const cpp::Expression&) { return across.member("moment"); };
    }
    reactions_[link.joint] = reaction;
    if (solver_.mechanism().holds_idle(link.driver)) {
      return;
    }
    body_.add(cpp::declared("const Scalar", effort, with_sense(sense, part)));
    body_.add(cpp::assigned(state("efforts").member(member), effort));
    pass_on(link.driver, effort);
  }

  /// A driver whose law reads joints also loads these joints.
  void pass_on(mechanism::DriverIndex driver, const cpp::Expression& effort) {
    const mechanism::NumberIndex law = solver_.mechanism().drivers()[driver].position;
    const std::vector<JointIndex> read = solver_.mechanism().numbers()[law].formula.joints();
    for (const JointIndex joint : read) {
      const cpp::Expression slope = body_.number(solver_.numbers.slope(driver, joint));
      if (slope.is_number(0)) {
        continue;
      }
      const cpp::Expression passed = body_.local("passed_on_to_" + solver_.members.joints[joint]);
      body_.add(
          cpp::declared("const Scalar", passed, cpp::negative(cpp::product({effort, slope}))));
      loads_.push(between(joint), passed);
    }
  }

  [[nodiscard]] bool is_line(FeatureIndex feature) const {
    return solver_.mechanism().features()[feature].is_line;
  }
  /// The force of an elementary joint on one of its links.
  [[nodiscard]] static cpp::Expression force_on(const Reaction& reaction, LinkIndex link) {
    return reaction.on == link ? reaction.force : opposite(reaction.force);
  }
  [[nodiscard]] std::vector<mechanism::ElementaryJointIndex> elementary_of(JointIndex joint) const {
    std::vector<mechanism::ElementaryJointIndex> list;
    for (const mechanism::ElementaryJointIndex index : solver_.linkage().joints.keys()) {
      if (solver_.joint(index).joint == joint) {
        list.push_back(index);
      }
    }
    return list;
  }

  /// Fills the member for the force in a joint.
  void tell(JointIndex index) {
    const mechanism::Joint& joint = solver_.mechanism().joints()[index];
    const cpp::Expression target = state("forces").member(solver_.members.joints[index]);
    const LinkIndex second = link_of(joint.between[1]);
    if (joint.between.size() > 2) {
      tell_pin(index, target);
    } else if (joint.type == mechanism::JointType::pin_in_slot) {
      tell_slot(index, second, target);
    } else {
      const mechanism::ElementaryJointIndex only = elementary_of(index).front();
      const Reaction& reaction = reactions_.at(only);
      const cpp::Expression force = force_on(reaction, second);
      if (joint.type == mechanism::JointType::revolute) {
        body_.add(cpp::assigned(target, force));
        return;
      }
      const cpp::Expression couple = reaction.couple_about(loads_.place(joint.between[1]));
      body_.add(cpp::assigned(
          target,
          cpp::braces("", {force, reaction.on == second ? couple : cpp::negative(couple)})));
    }
  }

  void tell_pin(JointIndex index, const cpp::Expression& target) {
    const auto members = solver_.pin_members(index);
    for (std::size_t place = 0; place < members.size(); ++place) {
      const LinkIndex link = link_of(between(index)[place]);
      std::vector<cpp::Expression> forces;
      for (const mechanism::ElementaryJointIndex one : elementary_of(index)) {
        const mechanism::ElementaryJoint& at = solver_.joint(one);
        if (at.holder_first == link || at.holder_second == link) {
          forces.push_back(force_on(reactions_.at(one), link));
        }
      }
      body_.add(cpp::assigned(target.member(members[place]),
                              cpp::call("support::total", std::move(forces))));
    }
  }

  /// A slot acts on its pin through a massless block: across the line, if no driver pushes the
  /// block along it.
  void tell_slot(JointIndex index, LinkIndex second, const cpp::Expression& target) {
    const FeatureIndex line = between(index)[is_line(between(index)[0]) ? 0 : 1];
    for (const mechanism::ElementaryJointIndex one : elementary_of(index)) {
      const mechanism::ElementaryJoint& at = solver_.joint(one);
      if (at.prismatic == solver_.mechanism().driver_of(index).exists()) {
        const Reaction& reaction = reactions_.at(one);
        // The reaction of the pin acts on the pin's link or on the block, that of the slide on the
        // line's link or on the block.
        const LinkIndex outside = at.prismatic ? link_of(line) : link_of(pin_of(index));
        const bool acts_on_outside = reaction.on == outside;
        const bool tells_outside = second == outside;
        body_.add(cpp::assigned(
            target, acts_on_outside == tells_outside ? reaction.force : opposite(reaction.force)));
      }
    }
  }
  [[nodiscard]] FeatureIndex pin_of(JointIndex index) const {
    return between(index)[is_line(between(index)[0]) ? 1 : 0];
  }

  const SolverScene& solver_;
  FunctionBody body_;
  LinkLoads loads_;
  std::map<mechanism::ElementaryJointIndex, Reaction> reactions_;
};

}  // namespace

cpp::Block force_statements(const SolverScene& solver) {
  return solver.gives_forces_by_groups() ? ForceStatements(solver).run() : cpp::Block{};
}

void show_force_members(const SolverScene& solver, cpp::View& view) {
  const bool wanted = solver.plan.request().want.forces;
  const auto& described = solver.mechanism();
  cpp::View::List efforts;
  cpp::View::List joints;
  const std::vector<mechanism::DriverIndex> drivers = mechanism::described_drivers(described);
  for (const mechanism::DriverIndex driver : drivers) {
    cpp::View entry("member", solver.members.drivers[driver]);
    entry.set("comma", efforts.size() + 1 < drivers.size() ? ", " : "");
    efforts.push_back(entry);
  }
  for (const ToldJoint& joint : wanted ? told_joints(solver) : std::vector<ToldJoint>{}) {
    cpp::View entry("member", joint.member);
    entry.set("name", cpp::comment_text(joint.name));
    entry.set("is_pin", joint.is_pin());
    entry.set("is_slide", !joint.is_pin() && joint.has_moment);
    entry.set("is_vector", !joint.is_pin() && !joint.has_moment);
    entry.set("on", cpp::comment_text(solver.link_name(joint.links.back())));
    cpp::View::List links = member_list(joint.link_members);
    for (cpp::View& link : links) {
      link.set("joint", joint.member);
    }
    entry.set("links", std::move(links));
    joints.push_back(entry);
  }
  for (std::size_t place = 0; place < joints.size(); ++place) {
    joints[place].set("comma", place + 1 < joints.size() ? ", " : "");
  }
  view.set("has_forces", wanted);
  view.set("has_efforts", wanted && !efforts.empty());
  view.set("efforts", efforts);
  view.set("has_joint_forces", !joints.empty());
  view.set("joint_forces", joints);
}

}  // namespace assur::generator::emission::scene
