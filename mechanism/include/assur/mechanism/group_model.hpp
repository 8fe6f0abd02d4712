// Turns the tables of the generated headers into one list of groups and their kinematic models.
#pragma once

#include <array>
#include <assur/model_tables.hpp>
#include <string>
#include <vector>

namespace assur::mechanism {

struct ModelKernel;

/// An Assur group as a graph, the same for all its models.
struct GroupStructure {
  std::string name;  ///< `tetrad`
  int assur_class;
  std::vector<ModelJoint> joints;             ///< in the order of a kind's letters
  std::vector<std::vector<int>> link_joints;  ///< of each link, in the order of its word

  [[nodiscard]] std::size_t link_count() const { return link_joints.size(); }
};

/// A kinematic model of a group, as its generated header describes it.
struct GroupModel {
  const GroupStructure* group;
  int number;
  bool rigid;
  int mobility;                    ///< generic, where it can be assembled
  int max_configurations;          ///< the most that a rigid model has; 0 for others
  std::vector<bool> prismatic;     ///< of each joint
  std::vector<std::string> kinds;  ///< the spellings of the kinds that it serves
  std::vector<ModelUnknown> unknowns;
  std::size_t dimension_count, input_count;
  std::vector<bool> dimension_is_angle, input_is_angle;
  const ModelKernel* kernel;  ///< its functions
};

/// The models of one group.
struct GroupModels {
  GroupStructure structure;
  std::vector<GroupModel> models;

  /// The model that serves the kind with these prismatic joints, and how the kind is spelled.
  struct Served {
    const GroupModel* model;
    std::string kind;
  };
  [[nodiscard]] Served serving(const std::vector<bool>& prismatic) const;
};

/// Every group that was generated: dyad, triad, tetrad.
[[nodiscard]] const std::vector<GroupModels>& known_groups();

/// The two links that a joint joins.
struct JointPair {
  int first, second;
};
/// Assur's class of a group with these joints among the links 0 .. link_count - 1 and the rest
/// (`base_link`): the number of joints on its largest closed contour, where a link of three joints
/// or more, all inside the group, is a contour of its own; two if it has none.
[[nodiscard]] int assur_class_of(int link_count, const std::vector<JointPair>& joints);

}  // namespace assur::mechanism
