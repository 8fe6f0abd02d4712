// Turns a group with placed neighbours into the states of its links, by the generated model.
#pragma once

#include <assur/assembly.hpp>
#include <vector>

#include "scene/link_state.hpp"
#include "structure/kind.hpp"

namespace assur::generator {

/// What a generated model needs of a scene, in the order of the model's tables.
struct GroupProblem {
  std::vector<NormalForm<Dual>> links;       ///< of each link of the model
  std::vector<DimensionValue<Dual>> inputs;  ///< the model's inputs
  Eigen::VectorXd input_rates;
  Eigen::VectorXd input_second_rates;
  double displaced = 0;  ///< how far rounding may have moved the neighbours
};

/// A slide of the group: the displacement between the feet on its two links.
struct SlideState {
  int joint;  ///< of the model
  Dual displacement;
  double velocity;
  double acceleration;
};

/// One assembly configuration: the normal frames of the model's links, and its slides.
struct GroupState {
  std::vector<LinkState> frames;
  std::vector<SlideState> slides;
  Status regularity = Status::ok;
  double residual = 0;   ///< largest closure residual, in the scene's unit of length
  double displaced = 0;  ///< how far rounding may have moved neighbours and links
};

/// Every assembly configuration of a group.
struct GroupSolution {
  AssemblyStatus status = AssemblyStatus::ok;
  int mobility = 0;   ///< of a degenerate group where it was found assembled
  int undecided = 0;  ///< nearly multiple roots that may hide two configurations, or none
  std::vector<GroupState> states;
};

/// Assembles a group of a model, with rates and gradients.
[[nodiscard]] GroupSolution solve_group(const Model& model, const GroupProblem& problem);

/// What a model is before any numbers: whether it is rigid, and its generic mobility.
struct ModelVerdict {
  bool rigid;
  int mobility;
};
[[nodiscard]] ModelVerdict verdict_of(const Model& model);

/// Whether a group of a degenerate model can be assembled: its angles are compatible.
[[nodiscard]] bool is_compatible(const Model& model, const GroupProblem& problem);

}  // namespace assur::generator
