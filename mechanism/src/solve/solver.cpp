#include "solver.hpp"

#include <utility>

#include "configuration_walk.hpp"

namespace assur::mechanism::solve {

MechanismSolver::MechanismSolver(const Values& values)
    : walk_(std::make_unique<ConfigurationWalk>(values)), others_(values) {}
MechanismSolver::~MechanismSolver() = default;

Answer MechanismSolver::solve(const SearchOptions& search, const Sought& sought, Solution& result) {
  return others_.settled(search, sought, walk_->walk(search, sought, result), result);
}

void MechanismSolver::count_from(std::vector<NearbyConfigurations> nearby) {
  others_.keep_own_choice(!nearby.empty());
  walk_->turns().count_from(std::move(nearby));
}

bool MechanismSolver::is_count_ambiguous() const { return walk_->turns().is_ambiguous(); }

bool MechanismSolver::is_count_in_doubt() const { return walk_->turns().is_in_doubt(); }

}  // namespace assur::mechanism::solve
