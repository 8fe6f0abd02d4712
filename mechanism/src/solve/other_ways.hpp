// Turns the values at which a mechanism without its redundant constraints has families into the
// solution of the same mechanism with other constraints left out.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace assur::mechanism::solve {

class MechanismSolver;

/// Every configuration of a mechanism is one of the mechanism without some of its constraints,
/// whichever these are. If the rest moves freely for one choice of the constraints left out, it may
/// have isolated configurations for another choice, and these are listed.
class OtherWays {
 public:
  using Question = std::function<void(MechanismSolver&, Solution&)>;

  /// The values must outlive it.
  explicit OtherWays(const Values& values) : values_(values) {}

  /// Replaces `result`, the answer for the mechanism's own choice of constraints to leave out, with
  /// that for the first choice whose families all remain under all constraints. If there is no such
  /// choice, families that do not remain get mobility zero and a reason. Returns whether `result`
  /// is for another choice, for which the question was then asked last. Throws OverConstrained
  /// where the constraints hold in no configuration of that choice.
  bool settle(const Question& ask, Solution& result);
  /// If set, answers stay as they are, since other choices do not continue the counts of turns.
  void stay_away(bool stays) { stays_away_ = stays; }

 private:
  const Values& values_;
  bool stays_away_ = false;
  std::optional<std::vector<std::shared_ptr<const PlanData>>> plans_;
};

}  // namespace assur::mechanism::solve
