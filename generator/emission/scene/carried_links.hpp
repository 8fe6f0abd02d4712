// Statements that place links carried by others and find the joint coordinates that laws read.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// The name of a feature's frame: `B_on_crank`.
[[nodiscard]] std::string feature_name(const SolverScene& solver, const std::string& feature,
                                       mechanism::LinkIndex link);
/// A joint's feature as a frame of the link: a line along its x-axis, a point in the link's axes.
[[nodiscard]] Pose<SceneNumber> feature_frame(const SolverScene& solver,
                                              const mechanism::ElementaryJoint& at,
                                              mechanism::LinkIndex link);
/// The pose of a feature; a point has the direction of its link.
[[nodiscard]] cpp::Expression pose_of(const SolverScene& solver, mechanism::FeatureIndex index,
                                      const FunctionBody& body);
/// The expression, or its negative.
[[nodiscard]] cpp::Expression with_sense(double sense, const cpp::Expression& expression);
[[nodiscard]] cpp::Expression placed_slide(const std::string& member);
/// The displacement of a slide along its line, from the placed links.
[[nodiscard]] cpp::Expression displacement(const SolverScene& solver, mechanism::JointIndex slide,
                                           FunctionBody& body);
/// The displacement of the second of two features along the line that one of them is.
[[nodiscard]] cpp::Expression displacement(const SolverScene& solver,
                                           const std::vector<mechanism::FeatureIndex>& between,
                                           FunctionBody& body);
/// Sets a slide, with its rates if they are wanted, as placed links have it.
void add_measured_slide(const SolverScene& solver, mechanism::JointIndex slide, FunctionBody& body);

/// Declares the coordinates of the joints that a driver's law reads and that groups place, if
/// `is_read` holds for their names.
void add_joints_read(const SolverScene& solver, mechanism::DriverIndex driver, FunctionBody& body,
                     const std::function<bool(const std::string&)>& is_read);
/// Declares the coordinates of all joints that groups place and whose names are read.
void add_joints_read(const SolverScene& solver, FunctionBody& body,
                     const std::function<bool(const std::string&)>& is_read);
/// The statements of a function that runs after all links are placed, preceded by the coordinates
/// of joints that they read.
[[nodiscard]] cpp::Block behind_joints_read(const SolverScene& solver, FunctionBody& body);
/// The position to which a driver moves its joint.
[[nodiscard]] cpp::Expression driver_position(const SolverScene& solver,
                                              mechanism::DriverIndex driver,
                                              const FunctionBody& body);
/// Places a link that another one carries. A slide that moves with it is added to `slides`.
void add_carried_link(const SolverScene& solver, const mechanism::CarriedLink& link,
                      FunctionBody& body, std::vector<std::string>& slides);

}  // namespace assur::generator::emission::scene
