// Turns places of links into whether joints beyond those that determine them hold.
#pragma once

#include <assur/mechanism/frame.hpp>
#include <assur/mechanism/values.hpp>
#include <assur/status.hpp>

namespace assur::mechanism::solve {

/// Whether the redundant joints of a plan hold to rounding, or to the tolerance that the request
/// states, and whether their rates do where these are known.
[[nodiscard]] bool holds_redundantly(const Values& values, const Table<LinkIndex, Frame>& links,
                                     Status regularity, bool rates_known);

}  // namespace assur::mechanism::solve
