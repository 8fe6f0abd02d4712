// Solution of a mechanism with another choice of redundant constraints left out.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>

#include "search_options.hpp"

namespace assur::mechanism::solve {

/// Every configuration of a mechanism is also one of the mechanism without some of its constraints.
/// If the remaining constraints leave a freedom for one choice of those left out, or hardly
/// determine the links, they may have regular configurations for another choice, which are then
/// listed.
class OtherConstraints {
 public:
  /// The values must outlive it.
  explicit OtherConstraints(const Values& values) : values_(values) {}

  /// Takes the answer and the `result` of a search with the mechanism's own choice of constraints
  /// to leave out. If rounding may have hidden configurations, or families do not persist under all
  /// constraints, `result` and the answer become those of the first choice without either defect.
  /// If there is no such choice, families that do not persist get mobility zero and a reason.
  [[nodiscard]] Answer settled(const SearchOptions& search, const Sought& sought, Answer own,
                               Solution& result) const;
  /// If set, answers stay unchanged, since other choices do not continue the counts of turns.
  void keep_own_choice(bool keeps) { keeps_own_choice_ = keeps; }

 private:
  const Values& values_;
  bool keeps_own_choice_ = false;
};

}  // namespace assur::mechanism::solve
