// Plan of a mechanism's solution, made once and used for any number of sets of values.
#pragma once

#include <assur/mechanism/request.hpp>
#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/structure.hpp>
#include <assur/mechanism/values.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace assur::mechanism {

struct Scene;

/// The order in which a mechanism's formulas are evaluated and its links are placed.
///
///     const Plan plan(mechanism);
///     const Solution solution = plan.solve(plan.values({{"phi", 1.0}}));
///     solution.configurations[0].output("P").velocity;
class Plan {
 public:
  /// Throws MechanismError for a mechanism that is over- or under-constrained, without a ground,
  /// with an unsupported group, or whose parameters depend on themselves. Redundant constraints are
  /// left out if the rest consists of supported groups; `solve` checks whether they hold.
  explicit Plan(const Mechanism& mechanism, const Request& request = {});
  /// Throws InputError, with the name of the scene's file before the text of a MechanismError.
  explicit Plan(const Scene& scene);

  /// The mechanism's numbers, with values instead of some parameters' formulas.
  [[nodiscard]] Values values(
      const std::vector<std::pair<std::string, double>>& replaced = {}) const;

  /// Solves the driven links, then the groups one after the other; every combination of the groups'
  /// configurations is one of the mechanism. Throws MechanismError if the lengths differ by more
  /// powers of ten than double precision holds, if the redundant constraints hold in no
  /// configuration, and if there are more configurations than `most_listed`, or than can be found
  /// in a bounded time.
  [[nodiscard]] Solution solve(const Values& values) const;
  /// Does the same in the memory of an earlier solution, which saves most allocations. After an
  /// error the content of `result` is not specified.
  void solve(const Values& values, Solution& result) const;
  /// The configuration of a solution nearest to the request's reference; nothing for a solution
  /// without configurations. Throws MechanismError if the request has no reference.
  [[nodiscard]] std::optional<Nearest> nearest(const Values& values,
                                               const Solution& solution) const;
  /// Finds the configuration nearest to the request's reference, alone in the solution, in the
  /// memory of one configuration: the search abandons a partial configuration as soon as a link is
  /// farther than the runner-up so far, or beyond limits. If there are only families, the first one
  /// is reported. Throws MechanismError as `solve` and `nearest` do.
  [[nodiscard]] std::optional<Nearest> solve_nearest(const Values& values, Solution& result) const;
  /// Finds the configuration with a number, from 1, alone in the solution. Returns the number of
  /// configurations met to find it; if there are fewer, that is all of them, and the solution is
  /// empty. Where there may be more than `most_listed`, it needs the memory of one configuration,
  /// and a time that grows with the number only. Throws MechanismError as `solve` does, and for the
  /// number zero.
  [[nodiscard]] std::size_t solve_one(const Values& values, std::size_t number,
                                      Solution& result) const;
  /// The largest possible number of configurations, by the models of the groups.
  [[nodiscard]] double most_configurations() const;
  /// The largest number of configurations that `solve` lists. Where there may be more, it drops
  /// those beyond the limits of joints as soon as the joint is placed, and does not count them. It
  /// then numbers configurations group by group, in the order of the groups, those of each group in
  /// the order of the group alone.
  static constexpr std::size_t most_listed = 20000;
  /// The reason why there are no configurations: the group that fails to close and its least gap,
  /// or the links that move freely. This takes longer than solving. Empty if there are
  /// configurations.
  [[nodiscard]] std::string obstacle(const Values& values) const;

  /// The configuration that comes nearest to the limits of joints; nothing if there are
  /// configurations within them, or none at all, or too many to be listed.
  [[nodiscard]] std::optional<NearestToLimits> nearest_to_limits(const Values& values) const;

  /// The redundant joints, whose constraints are left out and checked after solving.
  [[nodiscard]] const std::vector<RedundantJoint>& redundant() const;
  /// Whether a joint of `mechanism()` was not described, but is a slot or pin that replaces a
  /// redundant joint with fewer constraints.
  [[nodiscard]] bool is_stand_in(JointIndex joint) const;
  /// Whether a number depends on a parameter that has rates in time.
  [[nodiscard]] bool has_rates(NumberIndex number) const;
  /// Throws MechanismError for values of another plan, and for values that are unusable after a
  /// refused `Values::set`.
  void expect_usable(const Values& values) const;

  [[nodiscard]] const Mechanism& mechanism() const;
  [[nodiscard]] const Request& request() const;
  [[nodiscard]] const Structure& structure() const;

 private:
  std::shared_ptr<const PlanData> data_;
};

}  // namespace assur::mechanism
