// Turns the values of a planned mechanism into every assembly configuration.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "nearby_configurations.hpp"
#include "nearness.hpp"
#include "other_constraints.hpp"

namespace assur::mechanism::solve {

class ConfigurationWalk;

/// What is asked of the configurations of a mechanism.
struct Search {
  /// Whether configurations beyond the limits of joints are left out. A sweep keeps them, since
  /// branches go through them.
  bool within_limits = true;
  /// Whether a solution without configurations says by how much the links fail to close, and which
  /// configuration comes nearest to the limits of joints. This takes longer than solving.
  bool measures_gap = false;
};

/// Solves a mechanism at the present values, in memory that it keeps from one call to the next.
/// Throws MechanismError where there are more configurations than can be listed, or where they
/// cannot be found in a bounded time.
class MechanismSolver {
 public:
  /// The values must outlive the solver, and stay where they are.
  explicit MechanismSolver(const Values& values);
  ~MechanismSolver();
  MechanismSolver(const MechanismSolver&) = delete;
  MechanismSolver& operator=(const MechanismSolver&) = delete;

  /// See `Plan::solve`.
  void solve(const Search& search, Solution& result);
  /// See `Plan::solve_nearest`.
  [[nodiscard]] std::optional<Nearest> solve_nearest(Solution& result);
  /// Finds the configuration with a number, from 1, of a mechanism whose configurations are
  /// numbered group by group. Returns how many were passed; if there are fewer, that is all of
  /// them.
  [[nodiscard]] std::size_t solve_one(std::size_t number, Solution& result);
  /// Finds the configuration nearest to a point, within limits or not, alone in the solution.
  [[nodiscard]] std::optional<Nearest> solve_near(const SoughtPoint& point, Solution& result);
  /// See `Placement::count_from`.
  void count_from(std::vector<NearbyConfigurations> nearby);
  /// See `Placement`; of the last solution.
  [[nodiscard]] bool is_count_ambiguous() const;
  [[nodiscard]] bool is_count_in_doubt() const;
  /// Whether rounding may have kept the last search from a configuration: a place that groups
  /// hardly determine was found not to be one.
  [[nodiscard]] bool is_unsure() const;
  /// Why the last search within limits found nothing, if redundant constraints hold in none of the
  /// configurations. The solution has the same reason.
  [[nodiscard]] const std::optional<OverConstrained>& refusal() const { return refusal_; }

 private:
  /// Searches by the walk, and asks plans that leave out other constraints where these are needed.
  template <typename Search, typename Question>
  auto searched(const Search& search, const Question& question, Solution& result);

  std::unique_ptr<ConfigurationWalk> walk_;
  OtherConstraints others_;
  std::optional<OverConstrained> refusal_;
};

}  // namespace assur::mechanism::solve
