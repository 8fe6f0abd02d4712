// Turns the values at which a mechanism without its redundant constraints has families into the
// solution of the same mechanism without others of them.
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
/// whichever these are. Where the rest moves freely in one way to leave them out, it need not in
/// another, and lists what is left of the family there.
class OtherWays {
 public:
  using Question = std::function<void(MechanismSolver&, Solution&)>;

  /// The values must outlive it.
  explicit OtherWays(const Values& values) : values_(values) {}

  /// Puts the answer to a question by the first way of which all constraints leave all families in
  /// place of `result`, the answer by the mechanism's own way. Where they leave some of none,
  /// families that they do not leave have no mobility, and say why. Returns whether `result` is of
  /// another way, of which the question was asked last. Throws OverConstrained where the
  /// constraints hold in no configuration of that.
  bool settle(const Question& ask, Solution& result);
  /// Whether answers are to stay as they are: other ways do not count angles on from elsewhere.
  void stay_away(bool stays) { stays_away_ = stays; }

 private:
  const Values& values_;
  bool stays_away_ = false;
  std::optional<std::vector<std::shared_ptr<const PlanData>>> plans_;
};

}  // namespace assur::mechanism::solve
