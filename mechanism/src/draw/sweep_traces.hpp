// Turns the sweep of a request into what a drawing shows of it.
#pragma once

#include <assur/mechanism/drawing.hpp>
#include <assur/mechanism/plan.hpp>

#include "draw/anchors.hpp"

namespace assur::mechanism::draw {

/// The paths of some configurations along the sweep.
struct SweepTraces {
  std::vector<Trace> traces;
  std::vector<Mark> marks;
  /// How far joints go, for each of the configurations in the order in which they were given.
  std::vector<Reaches> reaches;
};

/// Follows the branches that go through configurations of the mechanism at its own values, by their
/// numbers. Where these values are not in the sweep, it is not known which branch goes through
/// which configuration, and the traces of all branches have configuration 0. Without a sweep, and
/// where there are more branches than can be followed, there are no traces.
[[nodiscard]] SweepTraces traces_of_sweep(const Mechanism& mechanism, const Request& request,
                                          const std::vector<int>& configurations);

/// What an event of a sweep is, and the numbers of its branches: `fold 1 2 on 3`.
[[nodiscard]] std::pair<std::string, std::vector<int>> parts_of_event(const std::string& event);

}  // namespace assur::mechanism::draw
