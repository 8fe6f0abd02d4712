// Sweep along the straight line between two sets of parameters' values.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace assur::mechanism::follow {

/// A mechanism in which some parameters change from one value to another together: their formulas
/// are from (1 - t) + to t, with t from 0 to 1.
class StraightWay {
 public:
  /// The values of the changing parameters, in their order.
  using Place = std::vector<double>;

  StraightWay(Mechanism mechanism, Request request, const std::vector<ParameterIndex>& changing);

  /// A configuration at the start, by its number from 1, and the one at the end that continues it.
  struct ContinuedPair {
    int number;
    Configuration end;
  };
  /// The branches that a sweep follows from `from` to `to`. A branch that ends before, or cannot be
  /// distinguished from another, is left out. `others` are the values of parameters that do not
  /// change.
  [[nodiscard]] std::vector<ContinuedPair> branches(
      const Place& from, const Place& to,
      const std::vector<std::pair<std::string, double>>& others) const;

 private:
  struct Ends {
    std::string from, to;  ///< the names of the parameters that hold the two values
  };

  std::vector<Ends> ends_;
  std::optional<Plan> plan_;
};

}  // namespace assur::mechanism::follow
