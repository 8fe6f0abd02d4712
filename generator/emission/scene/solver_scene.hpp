// The data of a scene from which the text of its solver is made: values, order and names.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <string>
#include <vector>

#include "emission/scene/function_body.hpp"
#include "emission/scene/scene_numbers.hpp"
#include "emission/scene/specialised_group.hpp"
#include "structure/kind.hpp"

namespace assur::generator::emission::scene {

/// The names of the solver's members for the items of the scene.
struct SceneMembers {
  mechanism::Table<mechanism::LinkIndex, std::string> links;
  mechanism::Table<mechanism::JointIndex, std::string> joints;
  mechanism::Table<mechanism::DriverIndex, std::string> drivers;
  mechanism::Table<mechanism::OutputIndex, std::string> outputs;
  /// The frames of links whose groups are solved relative to a moving link; empty for others.
  mechanism::Table<mechanism::LinkIndex, std::string> relative;
  /// The configurations of groups, if they are kept.
  mechanism::Table<mechanism::GroupIndex, std::string> solved;
};

/// A parameter that is an argument of the solver, and its member.
struct VariableParameter {
  mechanism::ParameterIndex index;
  std::string member;
};

/// A scene with all data for its solver.
struct SolverScene {
  /// Throws MechanismError for a scene that cannot be decomposed into known groups, and for
  /// variable parameters that cannot be arguments.
  explicit SolverScene(const mechanism::Scene& described);

  mechanism::Plan plan;
  mechanism::Values values;
  std::vector<VariableParameter> variable;
  ModelledParameters parameters;
  SceneMembers members;
  SceneNumbers numbers;
  /// The needed parts of the frames of links, including blocks of pins in slots.
  mechanism::Table<mechanism::LinkIndex, FrameNeed> needs;
  int derivative_order;   ///< highest order of the wanted time derivatives: 0, 1 or 2
  std::string file;       ///< without directories
  std::string structure;  ///< the name of the solver's struct

  [[nodiscard]] const mechanism::Mechanism& mechanism() const { return plan.mechanism(); }
  [[nodiscard]] const mechanism::Linkage& linkage() const { return plan.structure().linkage; }
  [[nodiscard]] const mechanism::FoundGroup& group(mechanism::GroupIndex index) const {
    return plan.structure().groups[index];
  }
  [[nodiscard]] const mechanism::ElementaryJoint& joint(
      mechanism::ElementaryJointIndex index) const {
    return linkage().joints[index];
  }
  /// The joint of the scene in the role of a group's joint.
  [[nodiscard]] const mechanism::ElementaryJoint& played_joint(mechanism::GroupIndex group,
                                                               int joint) const;
  [[nodiscard]] const std::string& link_name(mechanism::LinkIndex link) const {
    return linkage().links[link];
  }
  [[nodiscard]] bool is_ground(mechanism::LinkIndex link) const { return link == linkage().ground; }
  /// Whether a driver's position is an argument of the solver: its law reads no other joint.
  [[nodiscard]] bool is_argument(mechanism::DriverIndex driver) const {
    const mechanism::NumberIndex law = mechanism().drivers()[driver].position;
    return mechanism().numbers()[law].formula.joints().empty();
  }
  /// Whether other groups are held or shaped by a group's links.
  [[nodiscard]] bool holds_groups(mechanism::GroupIndex group) const;
  /// The struct of a group.
  [[nodiscard]] std::string group_struct(mechanism::GroupIndex group) const {
    return structure + "Group" + std::to_string(group.place() + 1);
  }
  /// Whether tolerances are modelled.
  [[nodiscard]] bool has_tolerances() const {
    return parameters.count() > 0 && !values.spread().tolerances.isZero(0.0);
  }
  [[nodiscard]] bool reports(mechanism::LinkIndex link) const {
    return wants_motion() && !is_ground(link) && plan.request().reported.has(link);
  }
  [[nodiscard]] bool reports(mechanism::JointIndex slide) const {
    return wants_motion() && plan.request().reported.has(slide) && !plan.is_stand_in(slide);
  }
  /// Whether the force in a joint is reported.
  [[nodiscard]] bool tells_force(mechanism::JointIndex joint) const {
    return plan.request().reported.has(joint) && !plan.is_stand_in(joint);
  }
  /// Whether derivatives with respect to the coordinates of drivers are wanted, or needed.
  [[nodiscard]] bool wants_coordinates() const {
    const mechanism::Want& want = plan.request().want;
    return want.coefficients || want.dynamics;
  }
  /// Whether the configurations of groups are kept besides their links.
  [[nodiscard]] bool keeps_groups() const {
    return plan.request().want.forces || wants_coordinates();
  }
  /// Whether forces follow group by group. Redundant constraints share loads among all links.
  [[nodiscard]] bool gives_forces_by_groups() const {
    return plan.request().want.forces && plan.redundant().empty();
  }
  /// The members for the links at a pin of several, in the order of the joint's `between`.
  [[nodiscard]] std::vector<std::string> pin_members(mechanism::JointIndex pin) const;
  /// Whether any result of links and slides, which have no sensitivities, is wanted.
  [[nodiscard]] bool wants_motion() const {
    const mechanism::Want& want = plan.request().want;
    return want.position || want.velocity || want.acceleration;
  }
  /// `placed.crank`, or empty for the ground, whose frame is the fixed one.
  [[nodiscard]] std::optional<cpp::Expression> placed(mechanism::LinkIndex link) const {
    return is_ground(link) ? std::nullopt
                           : std::optional(cpp::variable("placed").member(members.links[link]));
  }
  /// The body of a function of the solver, without statements.
  [[nodiscard]] FunctionBody body() const { return {parameters, numbers, derivative_order}; }
  /// The frame in which a group places one of its links: `placed.crank`, or `placed.rod_on_crank`.
  [[nodiscard]] cpp::Expression placed_by_group(mechanism::LinkIndex link) const {
    const auto& names = members.relative[link].empty() ? members.links : members.relative;
    return cpp::variable("placed").member(names[link]);
  }
  [[nodiscard]] const std::string& slide_member(const mechanism::ElementaryJoint& at) const {
    return members.joints[at.joint];
  }
};

/// Throws MechanismError for a mechanism whose configurations cannot be listed by an emitted
/// solver.
void expect_listable(const mechanism::Plan& plan);

/// The model of a group as the generator derives it.
[[nodiscard]] const structure::Model& symbolic_model(const mechanism::FoundGroup& group);

}  // namespace assur::generator::emission::scene
