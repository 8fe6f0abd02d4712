// Whether a test runs its whole campaign, or only the share that runs by default.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <vector>

namespace assur::test {

/// `ctest -L long` sets the variable.
inline bool is_whole_campaign() { return std::getenv("ASSUR_WHOLE_CAMPAIGN") != nullptr; }

/// Every value of a whole campaign; by default one in `stride`, the first of them included.
template <typename Value>
std::vector<Value> share_of(const std::vector<Value>& values, std::size_t stride) {
  std::vector<Value> share;
  for (std::size_t index = 0; index < values.size(); index += is_whole_campaign() ? 1 : stride) {
    share.push_back(values[index]);
  }
  return share;
}

}  // namespace assur::test
