// Traces of outputs and singular events over the sweep of a request, for a drawing.
#pragma once

#include <assur/mechanism/drawing.hpp>
#include <assur/mechanism/plan.hpp>

#include "draw/anchors.hpp"

namespace assur::mechanism::draw {

/// The paths of some configurations along the sweep.
struct SweepTraces {
  std::vector<Trace> traces;
  std::vector<Mark> marks;
  /// The ranges of joints, for each of the configurations in the given order.
  std::vector<Reaches> reaches;
};

/// Follows the branches through configurations of the mechanism at its own values, by their
/// numbers. If these values are not in the sweep, it is unknown which branch goes through which
/// configuration, and the traces of all branches have configuration 0. Without a sweep, and if
/// there are too many branches to follow, there are no traces.
[[nodiscard]] SweepTraces traces_of_sweep(const Mechanism& mechanism, const Request& request,
                                          const std::vector<int>& configurations);

/// The kind of a sweep's event, and the numbers of its branches, from `fold 1 2 on 3`.
[[nodiscard]] std::pair<std::string, std::vector<int>> parts_of_event(const std::string& event);

}  // namespace assur::mechanism::draw
