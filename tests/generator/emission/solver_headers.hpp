// Precompiled header for emitted solvers and the programs around them: their common includes, and
// calls of some solvers, whose template instances other solvers share.
#pragma once

#include <array>
#include <assur/scenes/before_eight_links.hpp>
#include <assur/scenes/before_excavator_arm.hpp>
#include <assur/scenes/before_three_cranks.hpp>
#include <assur/support/all_constraints.hpp>
#include <assur/support/derivative_digits.hpp>
#include <assur/support/discriminant.hpp>
#include <assur/support/flat_branch.hpp>
#include <assur/support/nearest.hpp>
#include <assur/support/redundant.hpp>
#include <assur/support/scale.hpp>
#include <assur/support/scene_track.hpp>
#include <assur/support/solved_by_lu.hpp>
#include <cstdio>
#include <cstring>
#include <limits>

namespace assur::scenes {

template <typename Solver>
void call_solver() {
  const typename Solver::template Drivers<double> drivers;
  std::array<typename Solver::template State<double>, Solver::max_configurations> states;
  auto branch = Solver::branch(drivers, Solver::solve(drivers, states).count);
  static_cast<void>(Solver::track(drivers, branch, states[0]));
}

inline void call_solvers_that_are_compiled_before() {
  call_solver<BeforeEightLinks>();
  call_solver<BeforeExcavatorArm>();
  call_solver<BeforeThreeCranks>();
}

}  // namespace assur::scenes
