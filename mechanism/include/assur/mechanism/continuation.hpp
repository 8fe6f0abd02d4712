// Turns sets of parameters' values, one after the other, into configurations along branches.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <memory>
#include <optional>
#include <vector>

namespace assur::mechanism {

/// Follows branches through sets of values, which may change several parameters at once. Each set
/// is reached from the last one that the branches went to, along the straight line between their
/// values. Singular configurations are passed, so that a crossing is gone straight through.
///
///     Continuation branches(mechanism, request, {phi, length});
///     Values values = branches.plan().values();
///     branches.solve(values);
///     branches.go_to();
///     values.set({{phi, 0.1}, {length, 2.5}});
///     const Solution& solution = branches.solve(values);
///     const auto next = branches.next();  // of each configuration before, that in `solution`
///
/// A step is clear by the test of `sweep`; otherwise it is halved, and what is not clear in small
/// steps either is decided by a sweep along the line. Laws that read angles of joints that groups
/// place have them in (-pi, pi] at every set.
class Continuation {
 public:
  /// For each configuration of one set, by its index, the one of another set that continues it.
  using Next = std::vector<std::optional<std::size_t>>;

  /// `changing` has every parameter that differs between the sets. Throws MechanismError as Plan.
  Continuation(const Mechanism& mechanism, const Request& request,
               std::vector<ParameterIndex> changing);
  ~Continuation();
  Continuation(const Continuation&) = delete;
  Continuation& operator=(const Continuation&) = delete;

  /// The plan of which the values are. It solves what the request wants, and carries the
  /// derivatives that following takes.
  [[nodiscard]] const Plan& plan() const;
  /// Solves a set of values of the plan. The solution lives until the next call. Throws
  /// MechanismError as Plan::solve does; the branches then stay where they are.
  const Solution& solve(const Values& values);
  /// The configurations of the last solution that continue those of the set where the branches are.
  [[nodiscard]] Next next();
  /// Takes the branches to the last solution: the next sets are reached from there. Returns whether
  /// they are there: they stay at regular configurations if some of the last ones are singular.
  bool go_to();

 private:
  class Follower;
  std::unique_ptr<Follower> follower_;
};

}  // namespace assur::mechanism
