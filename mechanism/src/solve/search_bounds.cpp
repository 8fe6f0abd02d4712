#include "search_bounds.hpp"

#include <algorithm>
#include <array>
#include <assur/mechanism/mechanism.hpp>
#include <assur/mechanism/plan.hpp>
#include <cstdio>

#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

namespace {

std::string whole_number(double number) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), number < 1e15 ? "%.0f" : "%.3g", number);
  return text.data();
}

}  // namespace

double most_configurations(const Structure& structure) {
  double product = 1;
  for (const FoundGroup& group : structure.groups) {
    product *= std::max(1, group.model->max_configurations);
  }
  return product;
}

void refuse_search(const Structure& structure, const std::string& what) {
  throw MechanismError("", "there may be " + whole_number(most_configurations(structure)) +
                               " configurations, and " + what +
                               "; give joints limits, or ask for one configuration only: the "
                               "nearest to a reference of more links, or one with a low number");
}

void expect_room(const Values& values, std::size_t listed) {
  const Structure& structure = values.plan().structure;
  const double parameters = 1 + static_cast<double>(values.columns().size());
  const double numbers = static_cast<double>(structure.linkage.links.size()) *
                         (12 + 3 * parameters * (values.second_order() ? parameters : 1));
  if (listed == Plan::most_listed || static_cast<double>(listed) * numbers > most_numbers) {
    refuse_search(structure, "no more than " + std::to_string(listed) + " can be listed");
  }
}

}  // namespace assur::mechanism::solve
