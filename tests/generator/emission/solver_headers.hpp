// Precompiled header for emitted solvers and the programs around them: their common includes, and a
// call of a solver.
#pragma once

#include <array>
#include <assur/scenes/compiled_before.hpp>
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

inline void call_solver_that_is_compiled_before() {
  using Solver = CompiledBefore;
  const Solver::Drivers<double> drivers;
  std::array<Solver::State<double>, Solver::max_configurations> states;
  Solver::Branch branch = Solver::branch(drivers, Solver::solve(drivers, states).count);
  static_cast<void>(Solver::track(drivers, branch, states[0]));
}

}  // namespace assur::scenes
