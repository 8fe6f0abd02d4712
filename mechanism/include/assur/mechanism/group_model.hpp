// Assur groups and their kinematic models, from the generated headers or derived from a graph.
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

/// A kinematic model of a group, as its generated header describes it, or as derived from the
/// group's graph.
struct GroupModel {
  const GroupStructure* group;
  int number;  ///< zero if it is derived
  bool rigid;
  int mobility;  ///< generic, where it can be assembled
  /// The number of configurations of a rigid model in complex numbers, which bounds that of real
  /// ones; 0 for others.
  int max_configurations;
  std::vector<bool> prismatic;     ///< of each joint
  std::vector<std::string> kinds;  ///< the spellings of the kinds that it covers
  std::vector<ModelUnknown> unknowns;
  std::size_t dimension_count, input_count;
  std::vector<bool> dimension_is_angle, input_is_angle;
  const ModelKernel* kernel;  ///< its functions
  /// For a derived model: the eliminations that find all its complex configurations, smallest
  /// first.
  std::vector<loops::Elimination> eliminations;
  std::vector<loops::Start> starts;  ///< if there are none: the start systems of homotopies
  std::vector<int> slide_angles;     ///< along which its displacements run, as in `LoopEquations`

  [[nodiscard]] bool is_derived() const { return number == 0; }
};

/// The models of one group.
struct GroupModels {
  GroupStructure structure;
  std::vector<GroupModel> models;

  /// The model that covers the kind with these prismatic joints, and the spelling of the kind.
  struct Served {
    const GroupModel* model;
    std::string kind;
  };
  [[nodiscard]] Served serving(const std::vector<bool>& prismatic) const;
};

/// Every generated group: dyad, triad, tetrad.
[[nodiscard]] const std::vector<GroupModels>& known_groups();

/// The most links of a group that can be solved.
inline constexpr std::size_t most_links_of_group = 8;
/// The model of a group with these joints among some links, derived from its graph on the first
/// call; it lasts as long as the process. Null if the group has no isolated configuration, for the
/// reason in `obstacle`.
[[nodiscard]] const GroupModel* derived_model(int link_count, const std::vector<ModelJoint>& joints,
                                              std::string& obstacle);

/// A proof that no configuration of a group is missing: every solution of its equations in complex
/// numbers is enclosed in a ball in which Krawczyk's operator, rounded outward, is a contraction,
/// so that the ball contains exactly one; and in general position there are no more solutions than
/// `of`.
struct GroupProof {
  int boxes = 0;         ///< number of disjoint balls
  int of = 0;            ///< number of complex configurations in general position
  double radius = 0;     ///< of its ball, in radians and parts of the size or a longer displacement
  std::string obstacle;  ///< why this configuration is in no ball; empty if it is in one

  [[nodiscard]] bool is_complete() const { return obstacle.empty() && boxes == of; }
};

/// The two links that a joint joins.
struct JointPair {
  int first, second;
};
/// Assur's class of a group with these joints among the links 0 .. link_count - 1 and the rest
/// (`base_link`): the number of joints on its largest closed contour; two if it has none. A link of
/// three joints or more, all inside the group, is a contour of its own.
[[nodiscard]] int assur_class_of(int link_count, const std::vector<JointPair>& joints);

}  // namespace assur::mechanism
