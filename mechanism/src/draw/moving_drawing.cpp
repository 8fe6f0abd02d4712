// Moving drawing of one branch of a film.
#include <algorithm>
#include <assur/mechanism/drawing.hpp>
#include <cmath>

#include "draw/film.hpp"

namespace assur::mechanism::draw {

namespace {

constexpr double seconds_of_sweep = 4;
/// The most moments; points move along straight lines between them.
constexpr std::size_t most_moments = 72;
constexpr std::size_t most_numbers = 40'000'000;
constexpr std::size_t numbers_of_output = 6;

Eigen::Vector2d pair_at(const std::vector<double>& numbers, std::size_t place) {
  return {numbers[place], numbers[place + 1]};
}

const FilmedBranch& branch_of(const Film& film, int number) {
  for (const FilmedBranch& branch : film.branches) {
    if (branch.number == number) {
      return branch;
    }
  }
  throw NoSuchConfiguration(static_cast<std::size_t>(number), film.branches.size() + film.left_out,
                            "branch");
}

/// The steps of the branch's first stretch, from its first step to the one after its last.
std::pair<std::size_t, std::size_t> stretch_of(const FilmedBranch& branch, std::size_t width,
                                               std::size_t count) {
  const auto is_there = [&](std::size_t step) { return !std::isnan(branch.points[width * step]); };
  std::size_t first = 0;
  while (first < count && !is_there(first)) {
    ++first;
  }
  std::size_t end = first;
  while (end < count && is_there(end)) {
    ++end;
  }
  return {first, end};
}

}  // namespace

}  // namespace assur::mechanism::draw

namespace assur::mechanism {

Drawing moving_drawing_of(const Mechanism& mechanism, const Request& request, int branch) {
  using namespace draw;
  if (!request.sweep || request.sweep->count < 2) {
    throw MechanismError("sweep", "a moving picture needs a sweep of at least two steps");
  }
  Request still = request;  // a moving picture does not show spreads
  still.want.sensitivity = false;
  Film film = film_of(mechanism, still, {most_numbers, branch, false, std::nullopt});
  const FilmedBranch& filmed = branch_of(film, branch > 0 ? branch : film.chosen);
  Drawing drawing;
  drawing.title = mechanism.name();
  drawing.unit = mechanism.unit();
  drawing.parameter = mechanism.parameters()[request.sweep->parameter].name;
  drawing.shapes = std::move(film.shapes);
  drawing.seconds = seconds_of_sweep;

  const std::size_t width = 2 * film.points;
  const auto [first, end] = stretch_of(filmed, width, static_cast<std::size_t>(film.count));
  for (std::size_t output = 0; output < mechanism.outputs().size(); ++output) {
    Trace trace{filmed.number, mechanism.outputs()[OutputIndex(output)].name, {}};
    const std::size_t columns = numbers_of_output * mechanism.outputs().size();
    for (std::size_t step = first; step < end; ++step) {
      trace.points.push_back(pair_at(filmed.outputs, columns * step + numbers_of_output * output));
    }
    drawing.traces.push_back(std::move(trace));
  }
  const std::size_t stride = (end - first - 1) / most_moments + 1;
  for (std::size_t step = first; step < end;
       step += step + stride < end || step + 1 == end ? stride : end - 1 - step) {
    Stance stance{filmed.number, {}};
    for (std::size_t point = 0; point < film.points; ++point) {
      stance.points.push_back(pair_at(filmed.points, width * step + 2 * point));
    }
    drawing.motion.push_back(std::move(stance));
  }
  drawing.stances.push_back(drawing.motion.front());
  const bool is_whole = first == 0 && end == static_cast<std::size_t>(film.count);
  const bool is_closed = is_whole && filmed.next == filmed.number;
  if (!is_closed) {
    const std::vector<Stance> there = drawing.motion;
    drawing.motion.insert(drawing.motion.end(), there.rbegin() + 1, there.rend());
    drawing.seconds *= 2;
  }
  return drawing;
}

}  // namespace assur::mechanism
