// Kinds of a group and their kinematic models, the orbits under its symmetries.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "structure/group.hpp"

namespace assur::generator::structure {

enum class JointType : unsigned char { revolute, prismatic };

/// A kind: one joint type for each joint, in the order of the group's spelling.
using Kind = JointTable<JointType>;

/// `RPR-RRR`: R or P for each joint in the order and with the separators of the group's spelling.
[[nodiscard]] std::string spell(const Group& group, const Kind& kind);
/// The kind that a text spells; empty if there is none.
[[nodiscard]] std::optional<Kind> parse_kind(const Group& group, const std::string& text);
/// All 2^joints kinds, the last joint varying fastest, R before P.
[[nodiscard]] std::vector<Kind> all_kinds(const Group& group);

/// The map of a kind onto its model: joint j of the kind plays the model's joint `role[j]`.
struct Relabelling {
  Kind kind;
  JointTable<JointIndex> role;
};

/// A kinematic model: one orbit of the kinds under the automorphisms of the group.
struct Model {
  const Group* group;
  int number;                        ///< zero for a model of a group without a name
  Kind representative;               ///< the kind for which the equations are derived
  std::vector<Relabelling> members;  ///< every kind of the orbit, the representative first

  [[nodiscard]] bool slides(JointIndex joint) const {
    return representative[joint] == JointType::prismatic;
  }
  [[nodiscard]] bool is_numbered() const { return number != 0; }
  /// `tetrad model 2 (RPR-RRR)`, for messages.
  [[nodiscard]] std::string title() const;
};

/// The models of a group, in the order of their numbers. The tetrad's are numbered by the paper's
/// Table 2: an orbit takes the number of the row that prints most of its kinds.
[[nodiscard]] const std::vector<Model>& models_of(const Group& group);

/// The model to which a kind belongs.
[[nodiscard]] const Model& model_of(const Group& group, const Kind& kind);

}  // namespace assur::generator::structure
