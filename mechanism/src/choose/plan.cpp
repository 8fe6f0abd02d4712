#include <algorithm>
#include <assur/directions.hpp>
#include <assur/mechanism/held_pairs.hpp>
#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <cmath>

#include "chosen_plan.hpp"
#include "plan/plan_data.hpp"
#include "solve/reference.hpp"
#include "solve/search_bounds.hpp"
#include "solve/solver.hpp"

namespace assur::mechanism::choose {

namespace {

/// Throws OverConstrained where the last search found that redundant constraints do not hold.
void expect_no_refusal(const solve::MechanismSolver& solver) {
  if (solver.refusal()) {
    throw OverConstrained(*solver.refusal());
  }
}

}  // namespace

}  // namespace assur::mechanism::choose

namespace assur::mechanism {

Plan::Plan(const Mechanism& mechanism, const Request& request)
    : data_(choose::chosen_plan(mechanism, request)) {}

Plan::Plan(const Scene& scene) {
  try {
    data_ = choose::chosen_plan(scene.mechanism, scene.request);
  } catch (const MechanismError& error) {
    throw InputError(scene.file + ": " + error.what());
  }
}

Values Plan::values(const std::vector<std::pair<std::string, double>>& replaced) const {
  std::vector<std::pair<ParameterIndex, double>> indexed;
  indexed.reserve(replaced.size());
  for (const auto& [name, value] : replaced) {
    indexed.emplace_back(data_->mechanism.parameter_named(name, ""), value);
  }
  return {data_, indexed};
}

bool Plan::has_rates(NumberIndex number) const {
  return std::ranges::any_of(
      data_->mechanism.numbers()[number].formula.parameters(),
      [this](ParameterIndex parameter) { return data_->evaluation.moves[parameter]; });
}

void Plan::expect_usable(const Values& values) const {
  if (&values.plan() != data_.get()) {
    throw MechanismError("", "the values belong to another plan");
  }
  if (!values.usable()) {
    throw MechanismError("", "the values cannot be used: the last one that was set was refused");
  }
}

Solution Plan::solve(const Values& values) const {
  Solution result;
  solve(values, result);
  return result;
}

void Plan::solve(const Values& values, Solution& result) const {
  expect_usable(values);
  solve::MechanismSolver solver(values);
  solver.solve({}, result);
  choose::expect_no_refusal(solver);
}

double Plan::most_configurations() const { return solve::most_configurations(data_->structure); }

std::optional<Nearest> Plan::solve_nearest(const Values& values, Solution& result) const {
  expect_usable(values);
  solve::expect_reference(data_->request);
  solve::MechanismSolver solver(values);
  std::optional<Nearest> found = solver.solve_nearest(result);
  choose::expect_no_refusal(solver);
  return found;
}

std::size_t Plan::solve_one(const Values& values, std::size_t number, Solution& result) const {
  expect_usable(values);
  if (number == 0) {
    throw MechanismError("", "there is no configuration 0; they are numbered from 1");
  }
  solve::MechanismSolver solver(values);
  if (most_configurations() > most_listed) {
    const std::size_t passed = solver.solve_one(number, result);
    choose::expect_no_refusal(solver);
    return passed;
  }
  solver.solve({}, result);
  choose::expect_no_refusal(solver);
  std::vector<Configuration>& all = result.configurations;
  const std::size_t passed = std::min(number, all.size());
  if (passed == number) {
    std::swap(all.front(), all[number - 1]);
  }
  all.resize(passed == number ? 1 : 0);
  return passed;
}

const std::vector<RedundantJoint>& Plan::redundant() const { return data_->redundant; }

bool Plan::is_stand_in(JointIndex joint) const {
  return mechanism::is_stand_in(mechanism().joints()[joint], data_->redundant);
}

std::optional<Nearest> Plan::nearest(const Values& values, const Solution& solution) const {
  expect_usable(values);
  solve::expect_reference(data_->request);
  const auto distance = [&](const Configuration& configuration) {
    double square = 0;
    for (const ReferenceAngle& angle : data_->request.reference) {
      const double difference =
          solve::difference_from(values, configuration.links[angle.link], angle);
      square += difference * difference;
    }
    return std::sqrt(square);
  };
  std::optional<Nearest> found;
  for (std::size_t place = 0; place < solution.configurations.size(); ++place) {
    const double away = distance(solution.configurations[place]);
    if (!found || away < found->distance) {
      found = Nearest{place, away, found ? std::optional(found->distance) : std::nullopt};
    } else if (!found->runner_up || away < *found->runner_up) {
      found->runner_up = away;
    }
  }
  return found;
}

std::string Plan::obstacle(const Values& values) const {
  expect_usable(values);
  Solution result;
  try {
    solve::MechanismSolver(values).solve({.measures_gap = true}, result);
  } catch (const MechanismError& error) {  // a law has no value where everything else closes
    return error.what();
  }
  return result.reason;
}

std::optional<NearestToLimits> Plan::nearest_to_limits(const Values& values) const {
  expect_usable(values);
  Solution result;
  solve::MechanismSolver solver(values);
  solver.solve({.measures_gap = true}, result);
  choose::expect_no_refusal(solver);
  return std::move(result.nearest_to_limits);
}

const Mechanism& Plan::mechanism() const { return data_->mechanism; }
const Request& Plan::request() const { return data_->request; }
const Structure& Plan::structure() const { return data_->structure; }

}  // namespace assur::mechanism
