#include "followable_set.hpp"

#include <algorithm>
#include <cmath>

namespace assur::mechanism::follow {

namespace {

/// The first distance from the step, as a part of the sweep.
constexpr double beside = 1e-5;
/// At the farthest distance the mechanism has moved by this part of its size, even if that is
/// beyond the next steps or the end of a short sweep: the range in which a change point spoils sets
/// does not depend on the steps.
constexpr double farthest_beside = 0.25;

}  // namespace

SnapshotPointer nearest_followable_set(SnapshotSolver& solver, const SnapshotPointer& followed,
                                       const StepSide& of) {
  const Snapshot& set = *of.set;
  const double value = set.parameter;
  const double range = solver.to() - solver.from();
  const double sense = range < 0 ? -1 : 1;
  const int last = solver.sweep().count - 1;
  const double width = std::abs(range) / std::max(1, last);
  const bool is_at_end = of.side < 0 ? of.step == 0 : of.step == last;
  const bool is_degenerate = set.is_degenerate();
  const bool may_go_far =
      !(is_at_end && is_degenerate) && (of.side > 0 || of.step == 0 || followed != nullptr);
  const double nearby = is_at_end ? 0 : width / 2;
  const Snapshot& moving = set.count() == 0 && followed != nullptr ? *followed : set;
  const double farthest =
      may_go_far ? std::max(nearby, farthest_beside * solver.way_of_size(moving)) : nearby;
  double distance = std::min(beside * std::abs(range), width / 8);
  for (; distance > 0 && distance < farthest; distance *= 4) {
    const double place = value + sense * of.side * distance;
    if (followed != nullptr && (place - followed->parameter) * sense <= 0) {
      break;
    }
    SnapshotPointer found = solver.at(place);
    if (found->separable) {
      return found;
    }
    if (found->is_degenerate() && distance >= nearby) {
      break;
    }
  }
  return nullptr;
}

}  // namespace assur::mechanism::follow
