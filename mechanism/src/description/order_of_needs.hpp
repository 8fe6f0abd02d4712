// Order of evaluation of items that depend on one another, such as parameters in formulas.
#pragma once

#include <algorithm>
#include <assur/text/index.hpp>
#include <vector>

namespace assur::mechanism::description {

/// All indices below `count`, each after those on which it depends, as listed by `needs`. If some
/// depend on one another in a cycle, `refuse` is called with it and must throw: each depends on the
/// next, and the last on the first. A list of open indices replaces recursion, which a long chain
/// would exhaust.
template <typename Index, typename Needs, typename Refuse>
[[nodiscard]] std::vector<Index> order_of_needs(std::size_t count, const Needs& needs,
                                                const Refuse& refuse) {
  enum class Mark : unsigned char { untouched, open, known };
  text::Table<Index, Mark> marks(count, Mark::untouched);
  std::vector<Index> order;
  for (const Index first : marks.keys()) {
    std::vector<Index> open = {first};
    while (!open.empty()) {
      const Index last = open.back();
      if (marks[last] == Mark::known) {
        open.pop_back();
        continue;
      }
      const std::vector<Index> needed = needs(last);
      marks[last] = Mark::open;
      const auto next =
          std::ranges::find_if(needed, [&](Index index) { return marks[index] != Mark::known; });
      if (next == needed.end()) {
        marks[last] = Mark::known;
        order.push_back(last);
        open.pop_back();
      } else if (marks[*next] == Mark::open) {
        refuse(std::vector<Index>(std::ranges::find(open, *next), open.end()));
      } else {
        open.push_back(*next);
      }
    }
  }
  return order;
}

}  // namespace assur::mechanism::description
