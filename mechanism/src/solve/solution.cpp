// Look-up of the parts of a configuration by name.
#include <assur/mechanism/error.hpp>
#include <assur/mechanism/solution.hpp>
#include <assur/text/quoted.hpp>
#include <assur/text/suggestion.hpp>

#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

namespace {

/// Finds an item by its name; the error's message names the missing item.
template <typename Key, typename Part, typename Item>
const Item& item_named(const Table<Key, Part>& parts, const Table<Key, Item>& items,
                       const std::string& name, const std::string& what) {
  const Key key = index_of(parts, name);
  if (!key.exists()) {
    throw MechanismError("", "no " + what + " named " + text::in_quotes(name) +
                                 text::suggestion_or_choice(name, names_of(parts)));
  }
  return items[key];
}

}  // namespace

}  // namespace assur::mechanism::solve

namespace assur::mechanism {

const Frame& Configuration::link(const std::string& name) const {
  expect_solved();
  return solve::item_named(plan->mechanism.links(), links, name, "link");
}

void Configuration::expect_solved() const {
  if (plan == nullptr) {
    throw MechanismError("", "the configuration is empty: it comes from no solution");
  }
}

const Point& Configuration::output(const std::string& name) const {
  expect_solved();
  return solve::item_named(plan->mechanism.outputs(), outputs, name, "output");
}

}  // namespace assur::mechanism
