// Turns a name that does not exist into the nearest one that does.
#pragma once

#include <string>
#include <vector>

namespace assur::text {

/// ` (did you mean 'crank'?)` for the candidate within an edit distance of two and of half the
/// longer name, in which the case of letters does not count; or nothing.
[[nodiscard]] std::string suggestion(const std::string& name,
                                     const std::vector<std::string>& candidates);

/// The same; where none is near and the candidates are few, ` (choose from A, B, C)`.
[[nodiscard]] std::string suggestion_or_choice(const std::string& name,
                                               const std::vector<std::string>& candidates);

}  // namespace assur::text
