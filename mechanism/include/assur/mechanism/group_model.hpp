// The groups and their kinematic models, as the generated headers list them or as they are derived.
#pragma once

#include <array>
#include <assur/loops/elimination.hpp>
#include <assur/loops/start.hpp>
#include <assur/model_tables.hpp>
#include <string>
#include <vector>

namespace assur::mechanism {

class ModelKernel;

/// An Assur group as a graph, the same for all its models.
struct GroupStructure {
  std::string name;  ///< `tetrad`
  int assur_class;
  std::vector<ModelJoint> joints;             ///< in the order of a kind's letters
  std::vector<std::vector<int>> link_joints;  ///< of each link, in the order of its word

  [[nodiscard]] std::size_t link_count() const { return link_joints.size(); }
};

/// A kinematic model of a group, as its generated header describes it, or as it is derived from its
/// graph.
struct GroupModel {
  const GroupStructure* group;
  int number;  ///< zero if it is derived
  bool rigid;
  int mobility;  ///< generic, where it can be assembled
  /// The number of configurations that a rigid model has in complex numbers, which is the most that
  /// it has in real ones; 0 for others.
  int max_configurations;
  std::vector<bool> prismatic;     ///< of each joint
  std::vector<std::string> kinds;  ///< the spellings of the kinds that it serves
  std::vector<ModelUnknown> unknowns;
  std::size_t dimension_count, input_count;
  std::vector<bool> dimension_is_angle, input_is_angle;
  const ModelKernel* kernel;  ///< its functions
  /// Of a derived model: the ways to all of its complex configurations, the smallest first.
  std::vector<loops::Elimination> eliminations;
  std::vector<loops::Start> starts;  ///< where there are none: the ways from other numbers
  std::vector<int> slide_angles;     ///< along which its displacements run, as in `LoopEquations`

  [[nodiscard]] bool is_derived() const { return number == 0; }
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

/// The largest group that is solved.
inline constexpr std::size_t most_links_of_group = 8;
/// The model of a group with these joints among some links, derived from its graph when it is asked
/// for first; it lasts as long as the process. Null where the group has no isolated configuration:
/// `obstacle` then tells why.
[[nodiscard]] const GroupModel* derived_model(int link_count, const std::vector<ModelJoint>& joints,
                                              std::string& obstacle);

/// A proof that no configuration of a group is missing: every solution of its equations in complex
/// numbers is enclosed in a ball in which Krawczyk's operator, rounded outward, is a contraction,
/// so that it holds exactly one; and in general position there are no more solutions than `of`.
struct GroupProof {
  int boxes = 0;         ///< disjoint balls that were found
  int of = 0;            ///< complex configurations that there are in general position
  double radius = 0;     ///< its ball's: radians, and parts of the size or of a longer displacement
  std::string obstacle;  ///< why this configuration is in no ball; empty where it is in one

  [[nodiscard]] bool is_complete() const { return obstacle.empty() && boxes == of; }
};

/// The two links that a joint joins.
struct JointPair {
  int first, second;
};
/// Assur's class of a group with these joints among the links 0 .. link_count - 1 and the rest
/// (`base_link`): the number of joints on its largest closed contour, where a link of three joints
/// or more, all inside the group, is a contour of its own; two if it has none.
[[nodiscard]] int assur_class_of(int link_count, const std::vector<JointPair>& joints);

}  // namespace assur::mechanism
