// Continuation of configurations along branches through sets of parameter values.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <memory>
#include <optional>
#include <vector>

namespace assur::mechanism {

/// Follows branches through sets of values, which may change several parameters at once. Each set
/// is reached along the straight line from the values at which the branches are. Branches go
/// through singular configurations, and straight on at a crossing.
///
///     Continuation branches(mechanism, request, {phi, length});
///     Values values = branches.plan().values();
///     branches.solve(values);
///     branches.go_to();
///     values.set({{phi, 0.1}, {length, 2.5}});
///     const Solution& solution = branches.solve(values);
///     const auto next = branches.next();  // of each configuration before, that in `solution`
///
/// A step is accepted by the test of `sweep`; otherwise it is halved, and a sweep along the line
/// decides if small steps are not accepted either. Laws read angles of joints that groups place in
/// (-pi, pi] at every set.
class Continuation {
 public:
  /// For each configuration of one set, by its index, its continuation in another set.
  using Next = std::vector<std::optional<std::size_t>>;

  /// `changing` holds every parameter that differs between the sets. Throws MechanismError as Plan.
  Continuation(const Mechanism& mechanism, const Request& request,
               std::vector<ParameterIndex> changing);
  ~Continuation();
  Continuation(const Continuation&) = delete;
  Continuation& operator=(const Continuation&) = delete;

  /// The plan for the values. It solves what the request asks for, and carries the derivatives that
  /// continuation needs.
  [[nodiscard]] const Plan& plan() const;
  /// Solves a set of values of the plan. The solution lives until the next call. Throws
  /// MechanismError as Plan::solve does; the branches then keep their position.
  const Solution& solve(const Values& values);
  /// The configurations of the last solution that continue those at which the branches are.
  [[nodiscard]] Next next();
  /// Moves the branches to the last solution, from which the next sets are then reached. Returns
  /// whether they moved: they stay at regular configurations if some of the last ones are singular.
  bool go_to();

 private:
  class Follower;
  std::unique_ptr<Follower> follower_;
};

}  // namespace assur::mechanism
