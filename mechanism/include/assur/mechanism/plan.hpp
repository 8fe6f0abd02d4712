// Turns a mechanism and what is wanted of it, once, into what any number of values is solved with.
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
  /// Throws MechanismError for a mechanism that is over- or under-constrained, that has no ground,
  /// that holds a group that is not known, or whose parameters depend on themselves. Constraints
  /// that are too many are left out if that leaves known groups; `solve` tells whether they hold.
  explicit Plan(const Mechanism& mechanism, const Request& request = {});
  /// Throws InputError, with the scene's file before what a MechanismError says.
  explicit Plan(const Scene& scene);

  /// The mechanism's numbers, with values in place of some parameters' formulas.
  [[nodiscard]] Values values(
      const std::vector<std::pair<std::string, double>>& replaced = {}) const;

  /// The driven links, then the groups one after the other; every combination of their
  /// configurations is one of the mechanism. Throws MechanismError where the lengths differ by more
  /// powers of ten than double precision holds, where constraints that are too many hold in no
  /// configuration, and where there are more configurations than `most_listed`, or than can be
  /// found in a bounded time.
  [[nodiscard]] Solution solve(const Values& values) const;
  /// The same in the memory of an earlier solution, which saves most allocations. What `result`
  /// holds after an error is not specified.
  void solve(const Values& values, Solution& result) const;
  /// Nothing for a solution without configurations. Throws MechanismError where the request has no
  /// reference.
  [[nodiscard]] std::optional<Nearest> nearest(const Values& values,
                                               const Solution& solution) const;
  /// The configuration nearest to the request's reference, alone in the solution, and in the memory
  /// of one: what is farther than the runner-up so far, or beyond limits, is left as soon as it is
  /// placed. Of families the first is told. Throws MechanismError as `solve` and `nearest` do.
  [[nodiscard]] std::optional<Nearest> solve_nearest(const Values& values, Solution& result) const;
  /// The configuration of a number, from 1, alone in the solution. Returns how many configurations
  /// were passed to find it: all of them where there are fewer, and the solution holds none then.
  /// Where there may be more than `most_listed`, in the memory of one, and in a time that grows
  /// with the number alone. Throws MechanismError as `solve` does, and for the number zero.
  [[nodiscard]] std::size_t solve_one(const Values& values, std::size_t number,
                                      Solution& result) const;
  /// How many configurations there are at most, by the models of the groups.
  [[nodiscard]] double most_configurations() const;
  /// How many of them `solve` lists at most. Where there may be more, it leaves what is beyond the
  /// limits of joints as soon as it is placed, and does not count it; and it numbers configurations
  /// group by group, in the order of the groups, those of each group as if it were alone.
  static constexpr std::size_t most_listed = 20000;
  /// Why there are no configurations: which group fails to close and by how much at least, or what
  /// moves freely. Takes longer than to solve. Empty where there are configurations.
  [[nodiscard]] std::string obstacle(const Values& values) const;

  /// The joints that hold where the others do: they have constraints that are left out.
  [[nodiscard]] const std::vector<RedundantJoint>& redundant() const;
  /// Whether a joint of `mechanism()` is not one that was described, but a slot that stands for a
  /// redundant pin.
  [[nodiscard]] bool is_stand_in(JointIndex joint) const;
  /// Whether a number depends on a parameter that has rates in time.
  [[nodiscard]] bool has_rates(NumberIndex number) const;
  /// Throws MechanismError for values of another plan, or that were left by a refused
  /// `Values::set`.
  void expect_usable(const Values& values) const;

  [[nodiscard]] const Mechanism& mechanism() const;
  [[nodiscard]] const Request& request() const;
  [[nodiscard]] const Structure& structure() const;

 private:
  std::shared_ptr<const PlanData> data_;
};

}  // namespace assur::mechanism
