// Solution of a planned mechanism: all configurations, one of them, or the nearest.
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

/// Solves at given values. Throws OverConstrained if redundant constraints hold nowhere.
solve::Answer answered(const Values& values, const solve::SearchOptions& search,
                       const solve::Sought& sought, Solution& result) {
  const solve::Answer answer = solve::MechanismSolver(values).solve(search, sought, result);
  if (answer.refusal) {
    throw OverConstrained(*answer.refusal);
  }
  return answer;
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
  (void)choose::answered(values, {}, solve::SoughtAll{}, result);
}

double Plan::most_configurations() const { return solve::most_configurations(data_->structure); }

std::optional<Nearest> Plan::solve_nearest(const Values& values, Solution& result) const {
  expect_usable(values);
  solve::expect_reference(data_->request);
  return choose::answered(values, {}, solve::SoughtReference{}, result).nearest;
}

std::size_t Plan::solve_one(const Values& values, std::size_t number, Solution& result) const {
  expect_usable(values);
  if (number == 0) {
    throw MechanismError("", "there is no configuration 0; they are numbered from 1");
  }
  if (most_configurations() > most_listed) {
    return choose::answered(values, {}, solve::SoughtNumber{number}, result).passed;
  }
  solve(values, result);
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
    (void)solve::MechanismSolver(values).solve({.measures_gap = true}, solve::SoughtAll{}, result);
  } catch (const MechanismError& error) {  // a law has no value although all groups close
    return error.what();
  }
  return result.reason;
}

std::optional<NearestToLimits> Plan::nearest_to_limits(const Values& values) const {
  expect_usable(values);
  Solution result;
  (void)choose::answered(values, {.measures_gap = true}, solve::SoughtAll{}, result);
  return std::move(result.nearest_to_limits);
}

const Mechanism& Plan::mechanism() const { return data_->mechanism; }
const Request& Plan::request() const { return data_->request; }
const Structure& Plan::structure() const { return data_->structure; }

}  // namespace assur::mechanism
