// Singular events that explain why branches do not simply continue across an interval.
#pragma once

#include <optional>
#include <vector>

#include "branch_matching.hpp"
#include "event_location.hpp"
#include "snapshot_solver.hpp"

namespace assur::mechanism::follow {

/// The kinds of events at one value of the swept parameter.
enum class EventKind : unsigned char {
  fold,        ///< two configurations meet, and none remains beyond
  birth,       ///< a fold seen from its other side
  crossing,    ///< two branches pass through one another
  escape,      ///< a displacement becomes infinite
  arrival,     ///< an escape seen from its other side
  degenerate,  ///< infinitely many configurations, or inconsistent ones
  unresolved   ///< closer together than double precision can resolve
};

/// An event between two neighbouring sets, with the configurations of both that it involves.
struct SingularEvent {
  EventKind kind;
  double parameter;
  std::vector<PointIndex> left;   ///< configurations of the left set that it involves
  std::vector<PointIndex> right;  ///< configurations of the right set that begin there
  PointIndex through;  ///< one of the left set that passes through a fold or birth, if any
  Configuration configuration;
  double uncertainty = 0;  ///< of the parameter, by rounding
};

/// The events that may explain an interval.
enum class Explaining : unsigned char {
  crossings,   ///< only crossings, since the interval is long
  any_event,   ///< the interval is short
  all_that_is  ///< the interval cannot be halved, so that folds may be located from far away
};

/// The events between two sets, in the order of the sweep. Returns nothing if the interval is too
/// long for each event to be recognised and located separately. Matches that prove to be a fold and
/// a birth at one place are removed.
[[nodiscard]] std::optional<std::vector<SingularEvent>> explain(SnapshotSolver& solver,
                                                                const SnapshotPointer& left,
                                                                const SnapshotPointer& right,
                                                                BranchMatching& matching,
                                                                Explaining by);

/// The folds and births at the end of the sweep's range: `near` is a set inside the range, and
/// `end` the parameter value, at which no set can be matched.
[[nodiscard]] std::vector<SingularEvent> folds_at_end(SnapshotSolver& solver,
                                                      const SnapshotPointer& near, double end);

}  // namespace assur::mechanism::follow
