#include <algorithm>
#include <assur/directions.hpp>
#include <assur/mechanism/held_pairs.hpp>
#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <assur/text/quoted.hpp>
#include <assur/text/suggestion.hpp>
#include <cmath>

#include "plan/plan_data.hpp"
#include "plan/reported_part.hpp"
#include "redundant_plan.hpp"
#include "reference.hpp"
#include "search_bounds.hpp"
#include "solver.hpp"

namespace assur::mechanism::solve {

namespace {

/// Throws MechanismError where a reported part does not exist, is listed twice, or is a joint that
/// does not slide.
void expect_reported(const Mechanism& mechanism, const Reported& reported) {
  const auto expect = [](const auto& list, const auto& parts, const std::string& part) {
    if (!list) {
      return;
    }
    for (auto key = list->begin(); key != list->end(); ++key) {
      if (!key->exists() || key->place() >= parts.size()) {
        throw MechanismError(part, "the mechanism has no such part");
      }
      if (std::find(list->begin(), key, *key) != key) {
        throw MechanismError(part, text::in_quotes(parts[*key].name) + " occurs twice");
      }
    }
  };
  expect(reported.links, mechanism.links(), "report.links");
  expect(reported.joints, mechanism.joints(), "report.joints");
  if (!reported.joints) {
    return;
  }
  for (const JointIndex joint : *reported.joints) {
    const Joint& at = mechanism.joints()[joint];
    if (at.type == JointType::revolute) {
      throw MechanismError("report.joints", "the joint " + text::in_quotes(at.name) +
                                                " is revolute and has no displacement; report " +
                                                "prismatic joints, pins in slots, or links");
    }
  }
}

/// The largest number of parameters: in any plan, with derivatives, and with second derivatives.
constexpr std::size_t most_parameters = 20000;
constexpr std::size_t most_with_sensitivities = 2000;
constexpr std::size_t most_with_covariance = 200;

void expect_few_parameters(const Mechanism& mechanism, const Request& request) {
  const std::size_t count = mechanism.parameters().size();
  const auto expect = [count](bool counts, std::size_t most, const std::string& mend) {
    if (counts && count > most) {
      throw MechanismError("parameters", "there are " + std::to_string(count) +
                                             ", and no more than " + std::to_string(most) +
                                             " can be used" + mend);
    }
  };
  const bool derives = request.want.sensitivity;
  expect(true, most_parameters, "");
  expect(derives, most_with_sensitivities,
         " where each has sensitivities; leave 'sensitivity' out of 'want'");
  expect(derives && request.covariance, most_with_covariance,
         " with a covariance; leave that out, or 'sensitivity' out of 'want'");
}

/// Throws MechanismError where a request names what the mechanism does not have.
void expect_usable(const Mechanism& mechanism, const Request& request) {
  const auto expect_parameter = [&](ParameterIndex parameter, const std::string& part) {
    if (!parameter.exists() || parameter.place() >= mechanism.parameters().size()) {
      throw MechanismError(part, "the mechanism has no parameter of this index");
    }
  };
  const auto expect_number = [&](NumberIndex number, const std::string& part) {
    if (!number.exists() || number.place() >= mechanism.numbers().size()) {
      throw MechanismError(part, "the mechanism has no number of this index");
    }
  };
  expect_reported(mechanism, request.reported);
  for (const ReferenceAngle& angle : request.reference) {
    if (!angle.link.exists() || angle.link.place() >= mechanism.links().size()) {
      throw MechanismError("reference", "the mechanism has no such link");
    }
    if (angle.link == mechanism.ground()) {
      throw MechanismError("reference.ground",
                           "the ground stands still in all configurations; name a moving link");
    }
    expect_number(angle.theta, "reference");
  }
  if (request.sweep) {
    expect_parameter(request.sweep->parameter, "sweep.parameter");
    expect_number(request.sweep->from, "sweep.from");
    expect_number(request.sweep->to, "sweep.to");
    if (request.sweep->count < 1) {
      throw MechanismError("sweep.count", "expected a whole number from 1 on");
    }
  }
  if (request.covariance) {
    const std::vector<ParameterIndex>& named = request.covariance->parameters;
    for (std::size_t place = 0; place < named.size(); ++place) {
      expect_parameter(named[place], "covariance.parameters");
      if (std::find(named.begin(), named.begin() + static_cast<std::ptrdiff_t>(place),
                    named[place]) != named.begin() + static_cast<std::ptrdiff_t>(place)) {
        throw MechanismError("covariance.parameters", "a parameter occurs twice");
      }
    }
    const auto& matrix = request.covariance->matrix;
    const auto expect_each = [&named](std::size_t count) {
      if (count != named.size()) {
        throw MechanismError("covariance.matrix",
                             "expected a row and a column for each of the parameters");
      }
    };
    expect_each(matrix.size());
    for (const std::vector<NumberIndex>& row : matrix) {
      expect_each(row.size());
      for (const NumberIndex entry : row) {
        expect_number(entry, "covariance.matrix");
      }
    }
  }
  if (request.redundancy_tolerance.exists()) {
    expect_number(request.redundancy_tolerance, "redundancy.tolerance");
  }
  for (const ParameterIndex parameter : request.variable) {
    expect_parameter(parameter, "variable");
  }
}

std::shared_ptr<const PlanData> planned(const Mechanism& mechanism, const Request& request) {
  expect_usable(mechanism, request);
  expect_few_parameters(mechanism, request);
  std::optional<Structure> found;
  try {
    found = structure_of(mechanism);
  } catch (const OverConstrained& excess) {
    return planned_with_redundancy(mechanism, request, excess);
  }
  Structure& structure = *found;
  if (request.reported.everything()) {
    return planned_whole(mechanism, request, std::move(structure));
  }
  const plan::ReportedPart part = plan::reported_part(mechanism, structure, request);
  return planned_whole(part.mechanism, part.request, structure_of(part.mechanism));
}

/// Finds an item by its name; the message of the error says what a program asked for.
template <typename Key, typename Part, typename Item>
const Item& item_named(const Table<Key, Part>& parts, const Table<Key, Item>& items,
                       const std::string& name, const std::string& what) {
  const Key key = index_of(parts, name);
  if (!key.exists()) {
    throw MechanismError("", "no " + what + " named " + text::in_quotes(name) +
                                 text::suggestion_or_choice(name, names_of(parts)));
  }
  return items[key];
}

}  // namespace

}  // namespace assur::mechanism::solve

namespace assur::mechanism {

Plan::Plan(const Mechanism& mechanism, const Request& request)
    : data_(solve::planned(mechanism, request)) {}

Plan::Plan(const Scene& scene) {
  try {
    data_ = solve::planned(scene.mechanism, scene.request);
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
  solve::MechanismSolver(values).solve({}, result);
}

double Plan::most_configurations() const { return solve::most_configurations(data_->structure); }

std::optional<Nearest> Plan::solve_nearest(const Values& values, Solution& result) const {
  expect_usable(values);
  solve::expect_reference(data_->request);
  return solve::MechanismSolver(values).solve_nearest(result);
}

std::size_t Plan::solve_one(const Values& values, std::size_t number, Solution& result) const {
  expect_usable(values);
  if (number == 0) {
    throw MechanismError("", "there is no configuration 0; they are numbered from 1");
  }
  solve::MechanismSolver solver(values);
  if (most_configurations() > most_listed) {
    return solver.solve_one(number, result);
  }
  solver.solve({}, result);
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
  solve::MechanismSolver(values).solve({.measures_gap = true}, result);
  return std::move(result.nearest_to_limits);
}

const Mechanism& Plan::mechanism() const { return data_->mechanism; }
const Request& Plan::request() const { return data_->request; }
const Structure& Plan::structure() const { return data_->structure; }

const Frame& Configuration::link(const std::string& name) const {
  expect_solved();
  return solve::item_named(plan->mechanism.links(), links, name, "link");
}

void Configuration::expect_solved() const {
  if (plan == nullptr) {
    throw MechanismError("", "the configuration is empty: it comes from no solution");
  }
}

const Point& Configuration::output(const std::string& name) const {
  expect_solved();
  return solve::item_named(plan->mechanism.outputs(), outputs, name, "output");
}

}  // namespace assur::mechanism
