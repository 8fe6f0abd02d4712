// Turns what a long computation has done into calls of whoever waits for it.
#pragma once

#include <cstdint>
#include <functional>

namespace assur::text {

/// Called with how many of how many steps are done. It may be empty: nobody waits.
using Progress = std::function<void(std::uint64_t done, std::uint64_t count)>;

}  // namespace assur::text
