// The solution of a mechanism with other redundant constraints left out, where its own choice of
// these does not determine the configurations.
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
/// whichever these are. If the rest moves freely for one choice of the constraints left out, or
/// hardly determines where links stand, it may have regular configurations for another choice, and
/// these are listed.
class OtherWays {
 public:
  using Question = std::function<void(MechanismSolver&, Solution&)>;

  /// The values must outlive it.
  explicit OtherWays(const Values& values) : values_(values) {}

  /// Runs the search of `own` for the mechanism's own choice of constraints to leave out, which
  /// fills `result`. Where rounding may have kept it from all configurations, or it has families
  /// that do not remain under all constraints, `result` becomes that of the first choice without
  /// either. If there is no such choice, families that do not remain get mobility zero and a
  /// reason. Returns whether `result` is for another choice, for which the question was then asked
  /// last. Throws OverConstrained where the constraints hold in no configuration.
  [[nodiscard]] bool settle(const MechanismSolver& own, const std::function<void()>& search,
                            const Question& ask, Solution& result);
  /// If set, answers stay as they are, since other choices do not continue the counts of turns.
  void stay_away(bool stays) { stays_away_ = stays; }

 private:
  const Values& values_;
  bool stays_away_ = false;
  std::optional<std::vector<std::shared_ptr<const PlanData>>> plans_;
};

}  // namespace assur::mechanism::solve
