#include "moved_by_parameter.hpp"

#include <algorithm>

#include "plan/driver_laws.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

namespace {

/// The parts of a mechanism that a parameter moves, found from the formulas that read it.
class MovedParts {
 public:
  MovedParts(const Values& values, ParameterIndex parameter)
      : plan_(values.plan()),
        parameters_(plan_.mechanism.parameters().size(), false),
        drivers_(plan_.mechanism.drivers().size(), false) {
    parameters_[parameter] = true;
    for (const ParameterIndex other : plan_.evaluation.parameters) {
      const bool is_replaced = std::ranges::any_of(
          values.replaced(), [other](const auto& entry) { return entry.first == other; });
      parameters_[other] = parameters_[other] ||
                           (!is_replaced && is_moved(plan_.mechanism.parameters()[other].value));
    }
    for (const DriverIndex driver : plan_.evaluation.drivers) {
      drivers_[driver] = is_law_moved(driver);
    }
  }

  [[nodiscard]] std::vector<FeatureIndex> features() const {
    std::vector<FeatureIndex> moved;
    for (const FeatureIndex index : plan_.evaluation.features) {
      const Feature& feature = plan_.mechanism.features()[index];
      if (is_moved(feature.x) || is_moved(feature.y) ||
          (feature.is_line && (is_moved(feature.along_x) || is_moved(feature.along_y)))) {
        moved.push_back(index);
      }
    }
    return moved;
  }

  /// Whether the shape of some group's links changes.
  [[nodiscard]] bool are_shapes_moved() const {
    const auto shapes = [this](const auto& what) {
      return !plan::groups_carried_by(what, plan_).empty();
    };
    bool moved = false;
    for (const DriverIndex driver : drivers_.keys()) {
      moved = moved || (drivers_[driver] && shapes(driver));
    }
    for (const GroupIndex group : plan_.structure.groups.keys()) {
      moved = moved || (is_moved_on_base(group) && shapes(group));
    }
    return moved;
  }

 private:
  [[nodiscard]] bool is_moved(NumberIndex number) const {
    return std::ranges::any_of(
        plan_.mechanism.numbers()[number].formula.parameters(),
        [this](ParameterIndex parameter) { return bool(parameters_[parameter]); });
  }
  /// A law that reads links changes whenever any part moves.
  [[nodiscard]] bool is_law_moved(DriverIndex driver) const {
    return plan_.evaluation.reads_links[driver] ||
           is_moved(plan_.mechanism.drivers()[driver].position) ||
           std::ranges::any_of(plan::joints_in_law(plan_.mechanism, driver),
                               [this](JointIndex joint) {
                                 const DriverIndex other = plan_.mechanism.driver_of(joint);
                                 return other.exists() && drivers_[other];
                               });
  }
  /// Whether a moved driver moves links that hold a group, relative to the base of this group.
  [[nodiscard]] bool is_moved_on_base(GroupIndex group) const {
    return std::ranges::any_of(plan_.structure.carried_by_base(group), [this](std::size_t place) {
      const CarriedLink& link = plan_.structure.carried[place];
      return link.driver.exists() && drivers_[link.driver];
    });
  }

  const PlanData& plan_;
  Table<ParameterIndex, bool> parameters_;
  Table<DriverIndex, bool> drivers_;
};

}  // namespace

bool moves_drivers_alone(const Values& values, ParameterIndex parameter) {
  const MovedParts moved(values, parameter);
  return moved.features().empty() && !moved.are_shapes_moved();
}

std::vector<FeatureIndex> features_moved_by(const Values& values, ParameterIndex parameter) {
  return MovedParts(values, parameter).features();
}

}  // namespace assur::mechanism::solve
