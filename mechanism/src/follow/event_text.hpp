// Turns an event into the words of its row.
#pragma once

#include <string>

#include "branch_tracker.hpp"

namespace assur::mechanism::follow {

/// As the page on sweeps lists them.
[[nodiscard]] std::string event_text(const BranchEvent& event);

}  // namespace assur::mechanism::follow
