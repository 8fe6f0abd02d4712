#include "shown_branches.hpp"

#include <algorithm>

namespace assur::mechanism::follow {

std::vector<int> untold(std::vector<int> branches, const std::vector<StepRow>& rows,
                        std::span<const BranchEvent> events) {
  std::erase_if(branches, [&](int branch) {
    const auto has = [branch](const std::vector<int>& numbers) {
      return std::ranges::find(numbers, branch) != numbers.end();
    };
    return std::ranges::any_of(
               rows,
               [&](const StepRow& row) { return row.branch == branch && row.state->path_known; }) ||
           std::ranges::any_of(events, [&](const BranchEvent& event) {
             return has(event.ended) || has(event.begun) || event.through == branch;
           });
  });
  return branches;
}

std::set<int> left_unresolved(std::span<const BranchEvent> events) {
  std::set<int> branches;
  for (const BranchEvent& event : events) {
    if (event.kind == EventKind::unresolved) {
      branches.insert(event.ended.begin(), event.ended.end());
      branches.insert(event.begun.begin(), event.begun.end());
    }
  }
  return branches;
}

void ShownBranches::note(const StepRow& row) {
  if (!row.state->is_consistent && row.state->regularity == Status::ok) {
    foreign_.insert(row.branch);
  }
  if (is_told(*row.state) && row.branch > 0) {
    told_.insert(row.branch);
  }
}

bool ShownBranches::keeps_own(BranchEvent& event) const {
  if (!has_foreign_ || (event.ended.empty() && event.begun.empty())) {
    return true;
  }
  const auto has_no_row = [this](int branch) { return !has_row(branch); };
  std::erase_if(event.ended, has_no_row);
  std::erase_if(event.begun, has_no_row);
  event.through = has_no_row(event.through) ? 0 : event.through;
  const std::size_t befallen =
      event.ended.size() + event.begun.size() + (event.through > 0 ? 1U : 0U);
  return befallen >= (event.kind == EventKind::crossing ? 2U : 1U);
}

void ShownBranches::renumber(BranchEvent& event) {
  event.through = shown(event.through);
  for (std::vector<int>* list : {&event.ended, &event.begun}) {
    std::ranges::transform(*list, list->begin(), [this](int branch) { return shown(branch); });
    std::ranges::sort(*list);
  }
}

int ShownBranches::shown(int branch) {
  const auto place = static_cast<std::size_t>(branch);
  numbers_.resize(std::max(numbers_.size(), place + 1), 0);
  if (branch > 0 && numbers_[place] == 0) {
    numbers_[place] = ++last_shown_;
  }
  return numbers_[place];
}

std::vector<int> ShownBranches::in_order() const {
  std::vector<int> branches(static_cast<std::size_t>(last_shown_), 0);
  for (std::size_t branch = 0; branch < numbers_.size(); ++branch) {
    if (numbers_[branch] > 0) {
      branches[static_cast<std::size_t>(numbers_[branch]) - 1] = static_cast<int>(branch);
    }
  }
  return branches;
}

}  // namespace assur::mechanism::follow
