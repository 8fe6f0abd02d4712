// One line that lists the nonzero counts of faults.
#pragma once

#include <ostream>
#include <utility>

namespace assur::test {

using NamedCount = std::pair<const char*, int>;

template <typename NamedCounts>
std::ostream& print_counts(std::ostream& out, const NamedCounts& counts) {
  const char* separator = "";
  for (const auto& [name, number] : counts) {
    if (number != 0) {
      out << separator << number << ' ' << name;
      separator = ", ";
    }
  }
  return out;
}

}  // namespace assur::test
