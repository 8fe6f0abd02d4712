// Solution that a search through the groups builds: its configurations, or the reason why there are
// none.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/mechanism/solution.hpp>
#include <optional>

#include "closing_gaps.hpp"
#include "configuration_order.hpp"
#include "nearness.hpp"
#include "placement.hpp"
#include "search_options.hpp"
#include "settled_redundancy.hpp"
#include "watched_limits.hpp"

namespace assur::mechanism::solve {

/// Writes the solution of one search after another.
class FoundConfigurations {
 public:
  /// All must outlive it.
  FoundConfigurations(Placement& placement, Nearness& nearness, const WatchedLimits& limits);

  /// Begins a search for the configuration with a number; the number zero stands for all or the
  /// nearest one. `cuts`: configurations beyond limits are abandoned early and not counted.
  void begin(const SearchOptions& search, std::size_t number, bool cuts, Solution& result);
  [[nodiscard]] Solution& solution() { return *solution_; }
  /// Whether a single configuration is sought; the list then needs the memory of one.
  [[nodiscard]] bool seeks_one() const { return nearness_.is_sought() || number_ > 0; }
  /// Whether the configuration with the sought number has been found.
  [[nodiscard]] bool is_complete() const { return number_ > 0 && passed_ == number_; }
  [[nodiscard]] bool is_empty() const { return listed_ == 0; }
  /// How many configurations were found so far.
  [[nodiscard]] std::size_t passed() const { return passed_; }
  /// Whether neither a configuration nor a family was found, not even beyond limits.
  [[nodiscard]] bool lacks_all() const;
  /// Whether places at which redundant constraints do not hold are omitted. A sweep keeps them
  /// where a tolerance lets these hold in a part of its range.
  [[nodiscard]] bool takes_only_consistent() const { return only_consistent_; }
  /// Whether this search has rejected a place that groups hardly determine: rounding may have moved
  /// it away from a configuration.
  [[nodiscard]] bool is_unsure() const { return is_unsure_; }
  void become_unsure() { is_unsure_ = true; }

  /// Lists the configuration that is placed. If the groups hardly determine it and constraints are
  /// redundant, all constraints together correct it. Throws MechanismError where there is no room.
  void list();
  /// Removes the remains of an earlier solution.
  void trim() { solution_->configurations.resize(listed_); }
  /// Sorts the configurations unless they are numbered as they were met. If there are none, the
  /// solution gets the reason: `has_cut` says that some were abandoned beyond limits, `gaps` by how
  /// much groups fail to close. Returns the refusal of a search within limits where redundant
  /// constraints hold nowhere. Throws MechanismError where a law has no value in any of them.
  [[nodiscard]] std::optional<OverConstrained> conclude(bool is_numbered, bool has_cut,
                                                        const ClosingGaps& gaps);

 private:
  void list_placed(double gap, bool goes_on);
  [[nodiscard]] bool is_told_apart();
  void conclude_without_configurations(bool has_cut, const ClosingGaps& gaps);

  Placement& placement_;
  PlacedLinks& placed_;  ///< of the placement
  const PlanData& plan_;
  const Values& values_;
  Nearness& nearness_;
  const WatchedLimits& limits_;
  ConfigurationOrder order_;
  std::optional<SettledRedundancy> redundancy_;
  SearchOptions search_;
  bool cuts_ = false;
  std::size_t number_ = 0;        ///< of the sought configuration; zero if none is
  std::size_t passed_ = 0;        ///< configurations so far
  std::size_t listed_ = 0;        ///< configurations; those behind are of an earlier solution
  Solution* solution_ = nullptr;  ///< being written
  bool only_consistent_ = true;
  bool is_inconsistent_ = false;  ///< redundant constraints did not hold somewhere
  double least_gap_ = 0;          ///< by which they failed to hold
  bool has_settled_ = false;      ///< whether all constraints corrected some of them
  bool is_unsure_ = false;
};

}  // namespace assur::mechanism::solve
