// Turns a group with placed neighbours into the states of its links, by the generated model.
#pragma once

#include <assur/status.hpp>
#include <vector>

#include "scene/link_state.hpp"

namespace assur::generator {

/// What a generated model needs of a scene, in the order of the model's tables.
struct GroupProblem {
  std::vector<NormalForm<Dual>> links;       ///< of each link of the model
  std::vector<DimensionValue<Dual>> inputs;  ///< the model's inputs
  Eigen::VectorXd input_rates;
  Eigen::VectorXd input_second_rates;
  std::vector<double> guessed_angles;  ///< for each link of the model, of its normal frame
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
  double residual = 0;  ///< largest closure residual, in the scene's unit of length
};

/// Assembles, from the guess, the tetrad model of a number, with rates and gradients. The status is
/// `ok` or says why there is no state.
[[nodiscard]] Status solve_tetrad(int model, const GroupProblem& problem, GroupState& state);

/// Whether a degenerate tetrad model can be assembled: its angles are compatible.
[[nodiscard]] bool tetrad_is_compatible(int model, const GroupProblem& problem);

}  // namespace assur::generator
