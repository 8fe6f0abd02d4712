// Turns a configuration of a mechanism without its redundant constraints into that of all of them.
#pragma once

#include <optional>

#include "all_constraints.hpp"
#include "group_solver.hpp"

namespace assur::mechanism::solve {

/// Where the mechanism without its redundant constraints is singular, rounding moves a
/// configuration far, while all constraints together may tell it, and its rates, to all digits.
class SettledRedundancy {
 public:
  /// Of two configurations nearby: which of them the constraints rule out, if any.
  enum class Comparison : unsigned char { differ, first_is_none, second_is_none, alike };

  /// Where there is something to settle: constraints that hold to rounding and not to a tolerance,
  /// of few links, and no law that reads where links are. The values must outlive it.
  [[nodiscard]] static std::optional<SettledRedundancy> made_for(const Values& values);
  /// Whether constraints hold to rounding, and no law reads where links are.
  [[nodiscard]] static bool can_close(const PlanData& plan);

  /// Closes all constraints from nearby as far as they can be closed, by Gauss's and Newton's steps
  /// J^+ f. Where J has full column rank to rounding, regularity, rates and derivatives are those
  /// that all constraints tell; what they contradict is not known. Returns by how much they stay
  /// open, in the unit of length, and zero where that may be rounding.
  [[nodiscard]] double settle(PlacedLinks& placed);
  /// The same of a configuration that is followed by itself: one that belongs to another place
  /// stays where it is, and open by how far that is.
  [[nodiscard]] double settle_nearby(PlacedLinks& placed);
  /// Whether the rates of the one that was settled last, where they are known, hold for all
  /// constraints; in regular ones the second rates, too.
  [[nodiscard]] bool goes_on() const { return goes_on_; }

  /// Marks the configurations of a sweep that are inconsistent, since another one nearby closes
  /// much better.
  void mark_inconsistent(std::vector<Configuration>& configurations);
  /// Of two that were settled: one is none where the other is nearby and closes much better, or
  /// where rounding does not tell what is between them from either.
  [[nodiscard]] Comparison compared(const AllConstraints::Poses& first,
                                    const AllConstraints::Poses& second);

 private:
  /// Compares two configurations by how well they close alone.
  [[nodiscard]] Comparison compared_by_misses(const AllConstraints::Poses& first,
                                              const AllConstraints::Poses& second);
  explicit SettledRedundancy(const Values& values) : values_(values), constraints_(values) {}
  void close(AllConstraints::Poses& links) const;
  void find_rates(const AllConstraints::Poses& poses, PlacedLinks& placed);
  [[nodiscard]] double missed(const AllConstraints::Poses& links) const;

  const Values& values_;
  AllConstraints constraints_;
  bool goes_on_ = true;
};

}  // namespace assur::mechanism::solve
