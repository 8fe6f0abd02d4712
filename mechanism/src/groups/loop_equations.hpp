// Loop closures of a group at given numbers, and in general position.
#pragma once

#include <assur/loops/loop_equations.hpp>
#include <random>
#include <vector>

#include "groups/loops.hpp"
#include "groups/placed_links.hpp"

namespace assur::mechanism::groups {

using LoopEquations = loops::LoopEquations<loops::AnySizes>;

[[nodiscard]] LoopEquations loop_equations(const Loops& loops,
                                           const std::vector<JointFeatures<double>>& features);

/// The closures of a group in general position, with new random numbers on each call.
class GeneralEquations {
 public:
  explicit GeneralEquations(const Loops& loops) : loops_(loops), engine_(seed) {}

  [[nodiscard]] LoopEquations next();
  /// Closures that a configuration with random numbers satisfies.
  struct Closed {
    LoopEquations equations;
    loops::ComplexConfiguration<loops::AnySizes> at;
  };
  [[nodiscard]] Closed next_closed();
  /// A direction.
  [[nodiscard]] loops::Complex next_turn();

 private:
  static constexpr std::uint64_t seed = 20261128;
  [[nodiscard]] double next_length();

  const Loops& loops_;
  std::mt19937_64 engine_;
};

}  // namespace assur::mechanism::groups
