// Drawing of a mechanism's configurations, with the traces of its sweep.
#include <algorithm>
#include <assur/mechanism/drawing.hpp>
#include <assur/mechanism/plan.hpp>

#include "draw/force_arrows.hpp"
#include "draw/sweep_traces.hpp"
#include "draw/symbols.hpp"

namespace assur::mechanism::draw {

namespace {

/// The configurations to draw, with their numbers.
struct Chosen {
  Solution solution;
  std::vector<std::pair<int, std::size_t>> drawn;  ///< numbers from 1, places in the solution
  std::size_t emphasised = 0;
  std::size_t left_out = 0;
};

[[noreturn]] void refuse(const Plan& plan, const Values& values, const Solution& solution) {
  const bool degenerate = solution.status == SolutionStatus::degenerate;
  throw MechanismError(
      "", std::string("there is nothing to draw: ") +
              (degenerate ? "degenerate: " + solution.reason + "; drive or hold what moves freely"
                          : "no-assembly: " + plan.obstacle(values)));
}

/// Throws MechanismError if there is nothing to draw.
Chosen chosen_of(const Plan& plan, const Values& values, const DrawingChoice& choice) {
  Chosen chosen;
  const bool alone = (choice.nearest || choice.configuration > 0) &&
                     plan.most_configurations() > Plan::most_listed;
  std::size_t passed = 0;
  if (choice.nearest && alone) {
    if (plan.solve_nearest(values, chosen.solution)) {
      chosen.drawn = {{0, 0}};
    }
  } else if (alone) {
    const auto number = static_cast<std::size_t>(choice.configuration);
    passed = plan.solve_one(values, number, chosen.solution);
    if (passed >= number) {
      chosen.drawn = {{choice.configuration, 0}};
    }
  } else {
    plan.solve(values, chosen.solution);
  }
  const std::size_t count = chosen.solution.configurations.size();
  if (count == 0) {
    if (chosen.solution.status == SolutionStatus::ok) {
      throw NoSuchConfiguration(static_cast<std::size_t>(choice.configuration), passed);
    }
    refuse(plan, values, chosen.solution);
  }
  if (alone) {
    return chosen;
  }
  if (choice.configuration > 0) {
    const auto place = static_cast<std::size_t>(choice.configuration) - 1;
    if (place >= count) {
      throw NoSuchConfiguration(place + 1, count);
    }
    chosen.drawn = {{choice.configuration, place}};
    return chosen;
  }
  const bool by_reference = choice.nearest || !plan.request().reference.empty();
  const std::size_t best = by_reference ? plan.nearest(values, chosen.solution)->configuration : 0;
  if (choice.nearest) {
    chosen.drawn = {{static_cast<int>(best) + 1, best}};
    return chosen;
  }
  for (std::size_t place = 0; place < count; ++place) {
    if (place == best || chosen.drawn.size() < most_drawn - (place < best ? 1 : 0)) {
      chosen.emphasised = place == best ? chosen.drawn.size() : chosen.emphasised;
      chosen.drawn.emplace_back(static_cast<int>(place) + 1, place);
    }
  }
  chosen.left_out = count - chosen.drawn.size();
  return chosen;
}

}  // namespace

}  // namespace assur::mechanism::draw

namespace assur::mechanism {

Drawing drawing_of(const Mechanism& mechanism, const Request& request,
                   const DrawingChoice& choice) {
  Request positions = request;
  positions.want = {true, false, false, false};
  positions.covariance.reset();
  Request wanted = positions;
  wanted.want.forces = wanted.want.velocity = wanted.want.acceleration = request.want.forces;
  const Plan plan(mechanism, wanted);
  const Values values = plan.values();
  const draw::Chosen chosen = draw::chosen_of(plan, values, choice);
  Drawing drawing;
  drawing.title = mechanism.name();
  drawing.unit = mechanism.unit();
  drawing.emphasised = chosen.emphasised;
  drawing.left_out = chosen.left_out;
  std::vector<int> numbers;
  for (const auto& [number, place] : chosen.drawn) {
    numbers.push_back(number);
  }
  draw::SweepTraces swept = draw::traces_of_sweep(mechanism, positions, numbers);
  if (request.sweep) {
    drawing.parameter = mechanism.parameters()[request.sweep->parameter].name;
  }
  drawing.traces = std::move(swept.traces);
  drawing.marks = std::move(swept.marks);

  const draw::FeatureFrames frames = draw::feature_frames(mechanism, values);
  std::vector<draw::LinkPoses> poses;
  for (std::size_t place = 0; place < numbers.size(); ++place) {
    const Configuration& configuration = chosen.solution.configurations[chosen.drawn[place].second];
    poses.push_back(draw::link_poses(mechanism, plan.mechanism(), configuration));
    draw::include_displacements(mechanism, plan.mechanism(), configuration, swept.reaches[place]);
  }
  const double size = draw::size_of(mechanism, frames, poses[chosen.emphasised]);
  draw::Symbols symbols = draw::symbols_of(
      {mechanism, frames, poses[chosen.emphasised], swept.reaches[chosen.emphasised], size});
  if (symbols.shapes.empty()) {
    throw MechanismError("",
                         "there is nothing to draw: the mechanism has no joints and no outputs");
  }
  drawing.shapes = std::move(symbols.shapes);
  for (std::size_t place = 0; place < numbers.size(); ++place) {
    Stance stance{numbers[place], {}};
    for (const draw::Anchor& anchor : symbols.points) {
      stance.points.push_back(
          position(anchor, mechanism, frames, poses[place], swept.reaches[place], size));
    }
    drawing.stances.push_back(std::move(stance));
  }
  if (wanted.want.forces && numbers.size() == 1) {
    const std::size_t place = chosen.drawn.front().second;
    draw::add_forces(plan, values, chosen.solution.configurations[place], size, drawing);
  }
  return drawing;
}

}  // namespace assur::mechanism
