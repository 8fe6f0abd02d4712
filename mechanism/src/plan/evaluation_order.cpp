#include "plan/evaluation_order.hpp"

#include <algorithm>

#include "description/parameter_order.hpp"
#include "plan/driver_laws.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::plan {

namespace {

class OrderFinder {
 public:
  OrderFinder(const Mechanism& mechanism, const Request& request,
              const std::vector<FeatureIndex>& more)
      : mechanism_(mechanism), request_(request) {
    order_.parameters = description::parameter_order(mechanism);
    list_numbers(more);
    list_drivers();
    list_moving();
    choose_columns();
  }

  [[nodiscard]] EvaluationOrder order() { return std::move(order_); }

 private:
  [[nodiscard]] const Number& number(NumberIndex index) const {
    return mechanism_.numbers()[index];
  }

  /// Lists the numbers needed for solving, without the ends of a sweep and features without a joint
  /// or an output.
  void list_numbers(const std::vector<FeatureIndex>& more) {
    Table<FeatureIndex, bool> used(mechanism_.features().size(), false);
    for (const FeatureIndex feature : more) {
      used[feature] = true;
    }
    for (const Joint& joint : mechanism_.joints()) {
      for (const FeatureIndex feature : joint.between) {
        used[feature] = true;
      }
    }
    for (const Output& output : mechanism_.outputs()) {
      used[output.point] = true;
    }
    for (const FeatureIndex index : used.keys()) {
      if (used[index]) {
        order_.features.push_back(index);
        const Feature& feature = mechanism_.features()[index];
        add({feature.x, feature.y, feature.along_x, feature.along_y});
      }
    }
    for (const Joint& joint : mechanism_.joints()) {
      add({joint.lowest, joint.highest});
    }
    for (const Driver& driver : mechanism_.drivers()) {
      add({driver.velocity, driver.acceleration});
    }
    for (const ReferenceAngle& angle : request_.reference) {
      add({angle.theta});
    }
    add({request_.redundancy_tolerance});
    for (const Parameter& parameter : mechanism_.parameters()) {
      add({parameter.tolerance, parameter.velocity, parameter.acceleration});
    }
    if (request_.covariance) {
      for (const std::vector<NumberIndex>& row : request_.covariance->matrix) {
        add(row);
      }
    }
  }

  void add(const std::vector<NumberIndex>& numbers) {
    for (const NumberIndex index : numbers) {
      if (index.exists()) {
        order_.numbers.push_back(index);
      }
    }
  }

  void list_drivers() {
    order_.drivers = laws_in_order(mechanism_);
    for (const DriverIndex driver : mechanism_.drivers().keys()) {
      order_.reads_links.add(!joints_read(mechanism_, driver).empty());
    }
  }

  void list_moving() {
    order_.moves.assign(mechanism_.parameters().size(), false);
    for (const ParameterIndex index : order_.parameters) {
      const Parameter& parameter = mechanism_.parameters()[index];
      const std::vector<ParameterIndex> used = number(parameter.value).formula.parameters();
      order_.moves[index] =
          parameter.velocity.exists() || parameter.acceleration.exists() ||
          std::ranges::any_of(used, [this](ParameterIndex other) { return order_.moves[other]; });
    }
  }

  void choose_columns() {
    const auto& parameters = mechanism_.parameters();
    order_.column_of.assign(parameters.size(), -1);
    for (const ParameterIndex parameter : parameters.keys()) {
      const bool swept = request_.sweep && request_.sweep->parameter == parameter;
      if (request_.want.sensitivity || swept) {
        order_.column_of[parameter] = static_cast<std::ptrdiff_t>(order_.columns.size());
        order_.columns.push_back(parameter);
      }
    }
    order_.second_order = request_.covariance && request_.want.sensitivity;
  }

  const Mechanism& mechanism_;
  const Request& request_;
  EvaluationOrder order_;
};

}  // namespace

EvaluationOrder evaluation_order(const Mechanism& mechanism, const Request& request,
                                 const std::vector<FeatureIndex>& more) {
  return OrderFinder(mechanism, request, more).order();
}

namespace {

/// Whether a tolerance or an entry of the covariance is among the changed numbers.
bool spread_depends(const Table<NumberIndex, bool>& changes, const PlanData& plan) {
  for (const Parameter& parameter : plan.mechanism.parameters()) {
    if (parameter.tolerance.exists() && changes[parameter.tolerance]) {
      return true;
    }
  }
  if (plan.request.covariance) {
    for (const std::vector<NumberIndex>& row : plan.request.covariance->matrix) {
      if (std::any_of(row.begin(), row.end(), [&](NumberIndex entry) { return changes[entry]; })) {
        return true;
      }
    }
  }
  return false;
}

/// Whether one of the carried links that carry the features of a joint in its group has a property.
template <typename Has>
bool is_carried(const Structure& structure, const ElementaryJoint& at, const Has& has) {
  const auto any_between = [&](LinkIndex carrier, LinkIndex holder) {
    while (holder != carrier) {
      const CarriedLink& link = *structure.carried_link(holder);
      if (has(link)) {
        return true;
      }
      holder = link.from;
    }
    return false;
  };
  return any_between(at.first, at.holder_first) || any_between(at.second, at.holder_second);
}

/// The groups in which a carried link with a property carries features of joints.
template <typename Has>
std::vector<GroupIndex> groups_with_links(const Structure& structure, const Has& has) {
  std::vector<GroupIndex> result;
  for (const GroupIndex group : structure.groups.keys()) {
    const auto& joints = structure.groups[group].assignments.front().joints;
    if (std::ranges::any_of(joints, [&](ElementaryJointIndex joint) {
          return is_carried(structure, structure.linkage.joints[joint], has);
        })) {
      result.push_back(group);
    }
  }
  return result;
}

}  // namespace

std::vector<GroupIndex> groups_carried_by(DriverIndex driver, const PlanData& plan) {
  return groups_with_links(plan.structure,
                           [driver](const CarriedLink& link) { return link.driver == driver; });
}

std::vector<GroupIndex> groups_carried_by(GroupIndex group, const PlanData& plan) {
  return groups_with_links(plan.structure,
                           [group](const CarriedLink& link) { return link.group == group; });
}

Dependents dependents_of(const std::vector<ParameterIndex>& changed, const PlanData& plan) {
  const Mechanism& mechanism = plan.mechanism;
  Dependents result;
  Table<ParameterIndex, bool> moves(mechanism.parameters().size(), false);
  for (const ParameterIndex parameter : changed) {
    moves[parameter] = true;
  }
  const auto depends = [&](NumberIndex index) {
    const std::vector<ParameterIndex> used = mechanism.numbers()[index].formula.parameters();
    return std::any_of(used.begin(), used.end(),
                       [&](ParameterIndex parameter) { return moves[parameter]; });
  };
  for (const ParameterIndex parameter : plan.evaluation.parameters) {
    if (moves[parameter] || depends(mechanism.parameters()[parameter].value)) {
      moves[parameter] = true;
      result.parameters.push_back(parameter);
    }
  }
  // A parameter that varies in time may change the rates of others, so all rates are computed
  // again.
  const bool rates_change =
      std::ranges::any_of(
          changed, [&](ParameterIndex parameter) { return plan.evaluation.moves[parameter]; }) ||
      std::ranges::any_of(mechanism.parameters(), [&](const Parameter& one) {
        return (one.velocity.exists() && depends(one.velocity)) ||
               (one.acceleration.exists() && depends(one.acceleration));
      });
  Table<NumberIndex, bool> changes(mechanism.numbers().size(), false);
  for (const NumberIndex index : plan.evaluation.numbers) {
    if (depends(index)) {
      changes[index] = true;
      result.numbers.push_back(index);
    }
  }
  Table<DriverIndex, bool> is_moved(mechanism.drivers().size(), false);
  for (const DriverIndex index : plan.evaluation.drivers) {
    const Driver& driver = mechanism.drivers()[index];
    const auto changes_if_given = [&](NumberIndex number) {
      return number.exists() && changes[number];
    };
    const std::vector<JointIndex> read = joints_in_law(mechanism, index);
    is_moved[index] = depends(driver.position) || changes_if_given(driver.velocity) ||
                      changes_if_given(driver.acceleration) || rates_change ||
                      std::ranges::any_of(read, [&](JointIndex joint) {
                        const DriverIndex other = mechanism.driver_of(joint);
                        return other.exists() && is_moved[other];
                      });
    if (is_moved[index]) {
      result.drivers.push_back(index);
    }
  }
  result.spread = spread_depends(changes, plan);
  Table<FeatureIndex, bool> touched(mechanism.features().size(), false);
  for (const FeatureIndex index : plan.evaluation.features) {
    const Feature& feature = mechanism.features()[index];
    touched[index] = changes[feature.x] || changes[feature.y] || rates_change ||
                     (feature.is_line && (changes[feature.along_x] || changes[feature.along_y]));
    if (touched[index]) {
      result.features.push_back(index);
    }
  }
  const auto is_touched = [&](FeatureIndex feature) {
    return feature.exists() && touched[feature];
  };
  for (const GroupIndex group : plan.structure.groups.keys()) {
    const auto& joints = plan.structure.groups[group].assignments.front().joints;
    const bool any = std::any_of(joints.begin(), joints.end(), [&](ElementaryJointIndex joint) {
      const ElementaryJoint& at = plan.structure.linkage.joints[joint];
      const auto is_moved_by = [&](const CarriedLink& link) {
        if (link.group.exists()) {
          return false;  // settling that group evaluates this one
        }
        const ElementaryJoint& driven = plan.structure.linkage.joints[link.joint];
        return is_moved[link.driver] || is_touched(driven.on_first) || is_touched(driven.on_second);
      };
      return is_touched(at.on_first) || is_touched(at.on_second) ||
             is_carried(plan.structure, at, is_moved_by);
    });
    if (any) {
      result.groups.push_back(group);
    }
  }
  return result;
}

}  // namespace assur::mechanism::plan
