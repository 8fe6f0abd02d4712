// Turns a name that does not exist into the nearest one that does.
#pragma once

#include <string>
#include <vector>

namespace assur::text {

/// ` (did you mean 'crank'?)` for the candidate within an edit distance of two, in which the
/// case of letters does not count; or nothing.
[[nodiscard]] std::string suggestion(const std::string& name,
                                     const std::vector<std::string>& candidates);

}  // namespace assur::text
