// The solution of a mechanism with other redundant constraints left out, where its own choice of
// these does not determine the configurations.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>

#include "search.hpp"

namespace assur::mechanism::solve {

/// Every configuration of a mechanism is one of the mechanism without some of its constraints,
/// whichever these are. If the rest moves freely for one choice of the constraints left out, or
/// hardly determines where links stand, it may have regular configurations for another choice, and
/// these are listed.
class OtherConstraints {
 public:
  /// The values must outlive it.
  explicit OtherConstraints(const Values& values) : values_(values) {}

  /// Takes the answer and the `result` of a search for the mechanism's own choice of constraints to
  /// leave out. Where rounding may have kept it from all configurations, or it has families that do
  /// not remain under all constraints, `result` becomes that of the first choice without either,
  /// and so does the answer. If there is no such choice, families that do not remain get mobility
  /// zero and a reason.
  [[nodiscard]] Answer settled(const Search& search, const Sought& sought, Answer own,
                               Solution& result) const;
  /// If set, answers stay as they are, since other choices do not continue the counts of turns.
  void keep_own_choice(bool keeps) { keeps_own_choice_ = keeps; }

 private:
  const Values& values_;
  bool keeps_own_choice_ = false;
};

}  // namespace assur::mechanism::solve
