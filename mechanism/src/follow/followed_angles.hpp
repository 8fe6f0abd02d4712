// Angles between links that loads and springs read, continued along the branches of a sweep.
#pragma once

#include <assur/mechanism/sweep.hpp>
#include <functional>

namespace assur::mechanism::follow {

/// The function with each configuration's `followed` angles: between links whose joint no driver
/// moves, and at which a spring acts or which a load reads. From record to record of a branch an
/// angle moves by at most half a turn. Returns the function itself if there are none.
[[nodiscard]] std::function<void(const SweepRecord&)> with_followed_angles(
    const Mechanism& mechanism, std::function<void(const SweepRecord&)> record);

}  // namespace assur::mechanism::follow
