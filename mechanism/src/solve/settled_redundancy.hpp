// Correction of configurations by all constraints of a mechanism, redundant ones included.
#pragma once

#include <optional>

#include "all_constraints.hpp"
#include "group_solver.hpp"

namespace assur::mechanism::solve {

/// Corrects configurations by all constraints. Where the mechanism without its redundant
/// constraints is singular, rounding moves a configuration far, while all constraints together may
/// determine it, and its rates, to all digits.
class SettledRedundancy {
 public:
  /// Whether the constraints rule out one of two neighbouring configurations, and which.
  enum class Comparison : unsigned char { differ, first_is_none, second_is_none };

  /// Returns an object if there is something to settle: redundant constraints that must hold to
  /// rounding and not to a tolerance, not too many links, and no law that reads joints. The values
  /// must outlive it.
  [[nodiscard]] static std::optional<SettledRedundancy> made_for(const Values& values);
  /// Whether redundant constraints must hold to rounding, and no law reads joints.
  [[nodiscard]] static bool can_close(const PlanData& plan);

  /// Closes all constraints from nearby as far as possible, by the Gauss-Newton steps J^+ f. Where
  /// J has full column rank up to rounding, regularity, rates and derivatives are those that all
  /// constraints determine; those that contradict them become unknown. Returns the residual in the
  /// unit of length, and zero where that may be rounding.
  [[nodiscard]] double settle(PlacedLinks& placed);
  /// Whether the known rates of the configuration settled last satisfy all constraints; in a
  /// regular one the second rates must satisfy them, too.
  [[nodiscard]] bool goes_on() const { return goes_on_; }

  /// Compares two settled configurations. One is ruled out where the other is nearby and closes
  /// much better, or where the place halfway between them closes as well, so that rounding does not
  /// separate them.
  [[nodiscard]] Comparison compared(const AllConstraints::Poses& first,
                                    const AllConstraints::Poses& second);

 private:
  explicit SettledRedundancy(const Values& values) : values_(values), constraints_(values) {}
  void find_rates(const AllConstraints::Poses& poses, PlacedLinks& placed);
  void forget_rates(bool is_at_rest, PlacedLinks& placed) const;
  [[nodiscard]] double missed(const AllConstraints::Poses& links) const;

  const Values& values_;
  AllConstraints constraints_;
  bool goes_on_ = true;
};

}  // namespace assur::mechanism::solve
