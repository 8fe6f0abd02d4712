// Counts with their nouns for messages: `1 row`, `2 rows`, `2 entries`.
#pragma once

#include <cstdint>
#include <string>

namespace assur::text {

/// `1 entry`, `2 entries`, `0 rows`: for nouns with a plural in -s; a final y must follow a
/// consonant.
[[nodiscard]] inline std::string with_noun(std::uint64_t count, const std::string& noun) {
  const std::string number = std::to_string(count) + " ";
  if (count == 1) {
    return number + noun;
  }
  return number + (noun.ends_with('y') ? noun.substr(0, noun.size() - 1) + "ies" : noun + "s");
}

}  // namespace assur::text
