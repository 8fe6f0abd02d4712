// Turns a number of things into what people say of them: `1 row`, `2 rows`, `2 entries`.
#pragma once

#include <cstdint>
#include <string>

namespace assur::text {

/// `1 entry`, `2 entries`, `0 rows`: for nouns whose plural ends with an s, and of those that end
/// with a y only such as have a consonant before it.
[[nodiscard]] inline std::string with_noun(std::uint64_t count, const std::string& noun) {
  const std::string number = std::to_string(count) + " ";
  if (count == 1) {
    return number + noun;
  }
  return number + (noun.ends_with('y') ? noun.substr(0, noun.size() - 1) + "ies" : noun + "s");
}

}  // namespace assur::text
