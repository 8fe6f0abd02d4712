// Tells whether a test runs its whole campaign, or the share of it that runs by default.
#pragma once

#include <cstdlib>

namespace assur::test {

/// `ctest -L long` sets the variable.
inline bool is_whole_campaign() { return std::getenv("ASSUR_WHOLE_CAMPAIGN") != nullptr; }

}  // namespace assur::test
