// Suggestions of existing names similar to a misspelt one.
#pragma once

#include <string>
#include <vector>

namespace assur::text {

/// ` (did you mean 'crank'?)` for the nearest candidate within an edit distance of two and of half
/// the longer name, ignoring case; otherwise empty.
[[nodiscard]] std::string suggestion(const std::string& name,
                                     const std::vector<std::string>& candidates);

/// The same; if none is near and the candidates are few, ` (choose from A, B, C)`.
[[nodiscard]] std::string suggestion_or_choice(const std::string& name,
                                               const std::vector<std::string>& candidates);

}  // namespace assur::text
