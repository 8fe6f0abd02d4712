#include "solved_scene.hpp"

#include "errors.hpp"

namespace assur::python {

namespace {

std::shared_ptr<const Rows> rates_of(const PlannedScene& planned,
                                     const mechanism::Configuration& configuration,
                                     const mechanism::Spread& spread) {
  if (configuration.branches.empty()) {
    return nullptr;
  }
  const auto rows = std::make_shared<Rows>(planned.plan, planned.layout_of_rates);
  for (const mechanism::Configuration& branch : configuration.branches) {
    rows->add_without_forces(branch, spread);
  }
  return rows;
}

}  // namespace

SolvedScene::SolvedScene(SharedPlan of, Replaced replaced_values, Asked what, std::size_t number)
    : planned(std::move(of)),
      replaced(std::move(replaced_values)),
      asked(what),
      asked_number(number) {
  rows = in_scene(planned->scene->file, [&] {
    return planned->spare.with(planned->plan, replaced, [&](const mechanism::Values& values) {
      solve(values);
      return rows_of(values);
    });
  });
}

void SolvedScene::solve(const mechanism::Values& values) {
  const mechanism::Plan& plan = planned->plan;
  if (asked == Asked::all) {
    plan.solve(values, solution);
  } else if (asked == Asked::nearest) {
    nearest = plan.solve_nearest(values, solution);
  } else {
    const std::size_t passed = plan.solve_one(values, asked_number, solution);
    if (passed < asked_number && solution.status != mechanism::SolutionStatus::degenerate) {
      throw mechanism::NoSuchConfiguration(asked_number, passed);
    }
  }
}

std::shared_ptr<const Rows> SolvedScene::rows_of(const mechanism::Values& values) {
  const auto made = std::make_shared<Rows>(planned->plan, planned->layout);
  made->reserve(solution.configurations.size());
  branches.reserve(solution.configurations.size());
  for (const mechanism::Configuration& configuration : solution.configurations) {
    made->add(configuration, values);
    branches.push_back(rates_of(*planned, configuration, values.spread()));
  }
  return made;
}

mechanism::Report SolvedScene::report(const mechanism::Values& values) const {
  return {planned->plan,
          values,
          solution,
          planned->scene->file,
          static_cast<int>(asked_number),
          nearest,
          asked != Asked::all};
}

std::optional<std::size_t> SolvedScene::number_of(std::size_t at) const {
  switch (asked) {
    case Asked::all:
      return at + 1;
    case Asked::numbered:
      return asked_number;
    case Asked::nearest:
      break;
  }
  return std::nullopt;
}

std::size_t SolvedScene::number_in_all(std::size_t at) const {
  if (const std::optional<std::size_t> number = number_of(at)) {
    return *number;
  }
  return in_scene(planned->scene->file, [&] {
    const mechanism::Values given = values();
    return planned->plan.nearest(given, planned->plan.solve(given))->configuration + 1;
  });
}

}  // namespace assur::python
