// The solution of a mechanism with other redundant constraints left out, where its own choice of
// these does not determine the configurations.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <functional>
#include <optional>

namespace assur::mechanism::solve {

class MechanismSolver;

/// Every configuration of a mechanism is one of the mechanism without some of its constraints,
/// whichever these are. If the rest moves freely for one choice of the constraints left out, or
/// hardly determines where links stand, it may have regular configurations for another choice, and
/// these are listed.
class OtherConstraints {
 public:
  using Question = std::function<void(MechanismSolver&, Solution&)>;

  /// The values must outlive it.
  explicit OtherConstraints(const Values& values) : values_(values) {}

  /// Takes the `result` of a search of `own` for the mechanism's own choice of constraints to leave
  /// out, and the `refusal` of that search. Where rounding may have kept it from all
  /// configurations, or it has families that do not remain under all constraints, `result` becomes
  /// that of the first choice without either. If there is no such choice, families that do not
  /// remain get mobility zero and a reason. Returns whether `result` is for another choice, for
  /// which the question was then asked last. The refusal becomes that of the mechanism as a whole.
  [[nodiscard]] bool settle(const MechanismSolver& own, const Question& ask, Solution& result,
                            std::optional<OverConstrained>& refusal);
  /// If set, answers stay as they are, since other choices do not continue the counts of turns.
  void keep_own_choice(bool keeps) { keeps_own_choice_ = keeps; }

 private:
  const Values& values_;
  bool keeps_own_choice_ = false;
};

}  // namespace assur::mechanism::solve
