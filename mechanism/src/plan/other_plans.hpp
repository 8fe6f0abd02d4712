// Plans of an over-constrained mechanism without the excess constraints.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/mechanism/request.hpp>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "plan_data.hpp"

namespace assur::mechanism::plan {

/// A mechanism as described, with all its constraints, and the request for it.
struct Described {
  Mechanism mechanism;
  Request request;
  OverConstrained excess;

  /// The names of the joints in the request's list of reported joints.
  [[nodiscard]] std::vector<std::string> reported_joints() const;
};

/// The plan of a mechanism with constraints left out. `mechanism` is that of the part, with its
/// drivers possibly advanced.
[[nodiscard]] PlanData reduced_plan(const Described& described, const BalancedMechanism& part,
                                    const Mechanism& mechanism);

/// The choices of excess constraints to leave out, those with the smallest groups first. Joints
/// that the request reports are kept if possible.
[[nodiscard]] std::vector<BalancedMechanism> ways_to_balance(const Described& described);

/// The plans of one mechanism that leave out other constraints than a given one does.
class OtherPlans {
 public:
  /// `redundant`: the joints that the given plan leaves out.
  OtherPlans(std::shared_ptr<const Described> described,
             const std::vector<RedundantJoint>& redundant);

  /// Plans that keep the joints left out of the given plan come first. Their own left-out
  /// constraints need not hold. They are made on the first call, since few mechanisms need them;
  /// any number of threads may call.
  [[nodiscard]] const std::vector<std::shared_ptr<const PlanData>>& all() const;

 private:
  [[nodiscard]] std::vector<std::shared_ptr<const PlanData>> made() const;

  std::shared_ptr<const Described> described_;
  std::vector<std::string> kept_;
  mutable std::once_flag is_made_;
  mutable std::vector<std::shared_ptr<const PlanData>> plans_;
};

}  // namespace assur::mechanism::plan
