// Lists of names as text for messages, arguments and formulas.
#pragma once

#include <string>
#include <vector>

namespace assur::text {

/// The texts `text(item)` of all items, joined by the separator.
template <typename Items, typename Text>
[[nodiscard]] std::string joined(const Items& items, const std::string& separator,
                                 const Text& text) {
  std::string all;
  bool first = true;
  for (const auto& item : items) {
    all += (first ? "" : separator) + text(item);
    first = false;
  }
  return all;
}
[[nodiscard]] inline std::string joined(const std::vector<std::string>& items,
                                        const std::string& separator) {
  return joined(items, separator, [](const std::string& item) { return item; });
}

/// `A, B, C`.
[[nodiscard]] inline std::string listed(const std::vector<std::string>& names) {
  return joined(names, ", ");
}

/// `joint A`, or `joints A, B`: the names after the noun for them.
[[nodiscard]] inline std::string listed_as(const std::string& noun,
                                           const std::vector<std::string>& names) {
  return noun + (names.size() == 1 ? " " : "s ") + listed(names);
}

}  // namespace assur::text
