// Turns the steps that a long computation has done into calls of a function of its caller.
#pragma once

#include <cstdint>
#include <functional>

namespace assur::text {

/// Called with the number of steps that are done, and that of all steps. It may be empty.
using Progress = std::function<void(std::uint64_t done, std::uint64_t count)>;

}  // namespace assur::text
