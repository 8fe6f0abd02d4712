// Turns a mechanism with too many constraints into plans without the excess ones.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/mechanism/request.hpp>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "plan_data.hpp"

namespace assur::mechanism::plan {

/// A mechanism as it is described, with all its constraints, and what is wanted of it.
struct Described {
  Mechanism mechanism;
  Request request;
  OverConstrained excess;

  /// The names of the joints that the request lists to be reported.
  [[nodiscard]] std::vector<std::string> reported_joints() const;
};

/// The plan of a mechanism with constraints left out. `mechanism` is that of the part, with its
/// drivers possibly moved on.
[[nodiscard]] PlanData reduced_plan(const Described& described, const BalancedMechanism& part,
                                    const Mechanism& mechanism);

/// The ways to leave out what is too much, those with the smallest groups first. Joints that the
/// request reports are kept where that can be.
[[nodiscard]] std::vector<BalancedMechanism> ways_to_balance(const Described& described);

/// The plans of one mechanism that leave out other constraints than a given one does.
class OtherPlans {
 public:
  /// `redundant`: the joints that the given plan does without.
  OtherPlans(std::shared_ptr<const Described> described,
             const std::vector<RedundantJoint>& redundant);

  /// Those that keep the joints that the given plan does without come first. Whether the
  /// constraints that they leave out hold is not known. They are made at the first call, since few
  /// mechanisms need them; any number of threads may call.
  [[nodiscard]] const std::vector<std::shared_ptr<const PlanData>>& all() const;

 private:
  [[nodiscard]] std::vector<std::shared_ptr<const PlanData>> made() const;

  std::shared_ptr<const Described> described_;
  std::vector<std::string> kept_;
  mutable std::once_flag is_made_;
  mutable std::vector<std::shared_ptr<const PlanData>> plans_;
};

}  // namespace assur::mechanism::plan
