// Results of sweeps: the rows of branches, and events.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "given.hpp"
#include "plan.hpp"
#include "rows.hpp"

namespace assur::python {

/// Rows of one branch, or events, in the order of the sweep.
struct SweptRows : RowsView {
  SharedPlan planned;
  std::vector<std::int32_t> step, configuration;
  std::vector<double> parameter;
  std::vector<std::string> event;
};

struct Branch : SweptRows {
  int number = 0;
  std::optional<int> circuit;
  std::optional<double> ends_at;
};

struct Events : SweptRows {};

struct SweptScene {
  std::map<int, std::shared_ptr<Branch>> branches;
  std::shared_ptr<Branch> unassigned;
  std::shared_ptr<Events> events;
  std::string parameter;
};

/// The same through items, which are consecutive sets of values: the parameter is the index of the
/// item.
[[nodiscard]] SweptScene swept_through_items(const SharedPlan& planned, const Given& given);

}  // namespace assur::python
