// The task of sweeping a scene: Jansen's leg over a turn of its crank.
#include <benchmark/benchmark.h>

#include <array>
#include <assur/mechanism/scene_file.hpp>
#include <assur/mechanism/sweep.hpp>
#include <assur/scenes/jansen_leg.hpp>
#include <memory>
#include <vector>

#include "precise.hpp"
#include "scenes/crank_angles.hpp"
#include "tasks.hpp"

namespace assur::speed {

namespace {

using Solver = scenes::JansenLeg;
using Foot = std::array<double, 2>;

/// A point in 60 digits.
struct PrecisePoint {
  Precise x, y;
};

/// The third corner of a triangle on the side from P to Q, at distances p and q from these, to the
/// left (+1) or right (-1) of it; none where the circles do not meet.
std::optional<PrecisePoint> corner(const PrecisePoint& P, const PrecisePoint& Q, const Precise& p,
                                   const Precise& q, int side) {
  const Precise dx = Q.x - P.x;
  const Precise dy = Q.y - P.y;
  const Precise square = dx * dx + dy * dy;
  const Precise along = (p * p - q * q + square) / (2 * square);
  const Precise height = p * p / square - along * along;
  if (height < 0) {
    return std::nullopt;
  }
  const Precise across = side * Precise(sqrt(height));
  return PrecisePoint{P.x + along * dx - across * dy, P.y + along * dy + across * dx};
}

/// The foot in every configuration of the leg, by its triangles alone; they are drawn in
/// docs/guide/scenes.md.
std::vector<PrecisePoint> feet(double crank) {
  const auto length = [](double value) { return precise(value); };
  const Precise b = length(41.5);
  const Precise c = length(39.3);
  const Precise d = length(40.1);
  const Precise e = length(55.8);
  const Direction<Precise> turn = direction_of<Precise>(precise(crank));
  const PrecisePoint B{length(-38), length(-7.8)};
  const PrecisePoint M{length(15) * turn.cos, length(15) * turn.sin};
  std::vector<PrecisePoint> result;
  for (int code = 0; code < 8; ++code) {
    const auto side = [code](int bit) { return (code >> bit & 1) != 0 ? 1 : -1; };
    const auto T = corner(M, B, length(50), b, side(0));
    const auto U = corner(M, B, length(61.9), c, side(1));
    const auto W = T ? corner(B, *T, d, e, 1) : std::nullopt;
    const auto V = W && U ? corner(*W, *U, length(39.4), length(36.7), side(2)) : std::nullopt;
    const auto foot = V ? corner(*U, *V, length(49), length(65.7), 1) : std::nullopt;
    if (foot) {
      result.push_back(*foot);
    }
  }
  return result;
}

/// Largest distance of a foot from the nearest exact one, relative to its distance from the crank's
/// axis; infinite where their numbers differ.
double error_of(const std::vector<Foot>& found, const std::vector<PrecisePoint>& truth) {
  double largest = found.size() == truth.size() ? 0.0 : std::numeric_limits<double>::infinity();
  for (const Foot& foot : found) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const PrecisePoint& exact : truth) {
      const double off = std::hypot(cln::double_approx(precise(foot[0]) - exact.x),
                                    cln::double_approx(precise(foot[1]) - exact.y));
      nearest = std::min(
          nearest, off / std::hypot(cln::double_approx(exact.x), cln::double_approx(exact.y)));
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

/// Sweeps the scene with the library over a part of the angles.
template <typename Use>
void sweep_by_library(const mechanism::Scene& scene, const CrankAngles& angles, std::size_t first,
                      std::size_t last, const Use& use) {
  mechanism::Mechanism leg = scene.mechanism;
  mechanism::Request request = scene.request;
  request.sweep->from = leg.add_number(angles[first], "from");
  request.sweep->to = leg.add_number(angles[last - 1], "to");
  request.sweep->count = static_cast<int>(last - first);
  mechanism::sweep(mechanism::Plan(leg, request),
                   {[&](const mechanism::SweepRecord& record) {
                      if (record.event.empty()) {
                        use(first + static_cast<std::size_t>(record.step),
                            record.state->outputs[mechanism::OutputIndex(0)].position);
                      }
                    },
                    [](double, const mechanism::Solution&) {}, [](int) {}});
}

template <typename Use>
void sweep_emitted(const CrankAngles& angles, std::size_t first, std::size_t last, const Use& use) {
  Solver::Drivers<double> drivers;
  std::array<Solver::State<double>, Solver::max_configurations> states;
  for (std::size_t index = first; index < last; ++index) {
    drivers.A.position = angles[index];
    const Solver::Solution solution = Solver::solve(drivers, states);
    for (std::size_t place = 0; place < static_cast<std::size_t>(solution.count); ++place) {
      use(index, states[place].outputs.foot.position);
    }
  }
}

/// The entry of a method that sweeps a part of the angles and hands over every foot.
template <typename SweepPart>
Entry entry_of(const std::string& task, const std::string& method, const CrankAngles& angles,
               const std::vector<std::vector<PrecisePoint>>& truth, const SweepPart& sweep_part) {
  Entry entry;
  entry.row.task = task;
  entry.row.method = method;
  std::vector<std::vector<Foot>> found(angles.size());
  sweep_part(0, angles.size(), [&](std::size_t index, const Eigen::Vector2d& foot) {
    found[index].push_back({foot.x(), foot.y()});
  });
  ErrorTally tally;
  for (std::size_t index = 0; index < angles.size(); ++index) {
    tally.add(error_of(found[index], truth[index]));
  }
  tally.write_to(entry.row);
  entry.run = [sweep_part](std::size_t first, std::size_t last) {
    sweep_part(first, last, [](std::size_t, const Eigen::Vector2d& foot) {
      double x = foot.x();
      benchmark::DoNotOptimize(x);
    });
  };
  return entry;
}

}  // namespace

std::vector<Task> sweep_tasks(const TaskSizes& sizes) {
  const CrankAngles angles(2 * sizes.inputs);
  std::vector<std::vector<PrecisePoint>> truth;
  for (std::size_t index = 0; index < angles.size(); ++index) {
    truth.push_back(feet(angles[index]));
  }
  const auto scene = std::make_shared<const mechanism::Scene>(
      mechanism::read_scene(ASSUR_EXAMPLES "/jansen_leg.json"));
  Task task{"sweep of a scene", angles.size(), {}};
  task.entries.push_back(
      entry_of(task.name, "assur solve", angles, truth,
               [scene, angles](std::size_t first, std::size_t last, const auto& use) {
                 sweep_by_library(*scene, angles, first, last, use);
               }));
  task.entries.push_back(entry_of(task.name, "emitted", angles, truth,
                                  [angles](std::size_t first, std::size_t last, const auto& use) {
                                    sweep_emitted(angles, first, last, use);
                                  }));
  return {task};
}

}  // namespace assur::speed
