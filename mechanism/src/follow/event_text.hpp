// Words for the events of a sweep.
#pragma once

#include <string>

#include "branch_tracker.hpp"

namespace assur::mechanism::follow {

/// The words of an event, such as `fold 1 2`, as docs/guide/sweeps.md lists them.
[[nodiscard]] std::string event_text(const BranchEvent& event);

}  // namespace assur::mechanism::follow
