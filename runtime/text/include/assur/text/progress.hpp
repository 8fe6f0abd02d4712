// Callback for the progress of a long computation.
#pragma once

#include <cstdint>
#include <functional>

namespace assur::text {

/// Called with the number of steps done and the number of all steps. It may be empty.
using Progress = std::function<void(std::uint64_t done, std::uint64_t count)>;

}  // namespace assur::text
