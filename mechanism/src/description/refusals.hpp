// Errors common to all descriptions of a mechanism, and the search for a part by name.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/text/index.hpp>
#include <assur/text/quoted.hpp>
#include <assur/text/suggestion.hpp>
#include <string>
#include <vector>

namespace assur::mechanism::description {

/// The error for a reference in `part` to a `what`, such as a link, that is not in `names`.
[[nodiscard]] inline MechanismError refusal_of_name(const std::string& part,
                                                    const std::string& what,
                                                    const std::string& name,
                                                    const std::vector<std::string>& names) {
  return {part, "no " + what + " named " + text::in_quotes(name) +
                    text::suggestion_or_choice(name, names)};
}

/// The index of the item with a name. Throws MechanismError if there is none.
template <typename Key, typename Item>
[[nodiscard]] Key part_named(const text::Table<Key, Item>& items, const std::string& name,
                             const std::string& what, const std::string& part) {
  const Key key = index_of(items, name);
  if (!key.exists()) {
    throw refusal_of_name(part, what, name, names_of(items));
  }
  return key;
}

/// The error for `part` if it reads the coordinate of a joint whose sense is not given;
/// `other_mend` follows the remedy.
[[nodiscard]] inline MechanismError refusal_of_measure(const std::string& part,
                                                       const std::string& joint,
                                                       const std::string& first,
                                                       const std::string& second,
                                                       const std::string& other_mend = "") {
  return {part, "the joint " + joint + " joins the moving links " + first + " and " + second +
                    R"(; say from which to which it is measured: "joints": {")" + joint +
                    R"(": {"type": "revolute", "links": [")" + first + R"(", ")" + second +
                    R"("]}})" + other_mend};
}

/// The error for the line `links.L.F`, whose `along` is [0, 0].
[[nodiscard]] inline MechanismError refusal_of_direction(const std::string& line) {
  return {line + ".along", "[0, 0] has no direction; at least one of the numbers must not be zero"};
}

}  // namespace assur::mechanism::description
