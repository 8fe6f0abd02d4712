#include "emission/group_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "emission/model_view.hpp"
#include "emission/scene_names.hpp"
#include "error.hpp"
#include "scene/model_values.hpp"
#include "scene/names.hpp"

namespace assur::generator {

namespace {

/// The power of two below the longest length of a group: of its dimensions, of the arms of the
/// moving links that hold it, and between the joints that the ground holds.
double unit_of(const SolverScene& solver, const PosedGroup& group) {
  double longest = 0;
  for (const DimensionValue<Dual>& value : dimension_values(group.problem)) {
    longest = std::max(longest, std::abs(value.length.value()));
  }
  const LinkFeature<Dual>* first = nullptr;
  for (const auto& [at, base] : external_joints(solver, group)) {
    const LinkFeature<Dual>& feature = at->on(base);
    const bool fixed = solver.is_ground(base);
    if (fixed && first == nullptr) {
      first = &feature;
    }
    const double x = feature.x.value() - (fixed ? first->x.value() : 0);
    const double y = feature.y.value() - (fixed ? first->y.value() : 0);
    longest = std::max({longest, std::abs(x), std::abs(y)});
  }
  return longest > 0 ? std::ldexp(1.0, std::ilogb(longest)) : 1;
}

DimensionValue<double> in_unit(const DimensionValue<Dual>& value, double unit) {
  DimensionValue<double> result = plain(value);
  result.length /= unit;
  return result;
}

/// Collects values in the group's unit, each with a row of derivatives to the parameters.
class NumberList {
 public:
  NumberList(const ModelledParameters& parameters, double unit)
      : parameters_(parameters), unit_(unit), gradient_(0, parameters.count()) {}

  void add(const DimensionValue<Dual>& value) {
    values_.emplace_back(in_unit(value, unit_));
    add_row(value.is_angle ? parameters_.gradient(angle_of(value.angle))
                           : parameters_.gradient(value.length) / unit_);
  }
  /// What moves is no number, and has no derivatives of its own.
  void add_moving() {
    values_.emplace_back(std::nullopt);
    add_row(Eigen::VectorXd::Zero(parameters_.count()));
  }

  [[nodiscard]] const std::vector<std::optional<DimensionValue<double>>>& values() const {
    return values_;
  }
  [[nodiscard]] const Eigen::MatrixXd& gradient() const { return gradient_; }

 private:
  void add_row(const Eigen::VectorXd& row) {
    gradient_.conservativeResize(gradient_.rows() + 1, Eigen::NoChange);
    gradient_.row(gradient_.rows() - 1) = row.transpose();
  }

  const ModelledParameters& parameters_;
  double unit_;
  std::vector<std::optional<DimensionValue<double>>> values_;
  Eigen::MatrixXd gradient_;
};

std::string place_of(const SolverScene& solver, std::size_t index) {
  return solver.scene.file + ": links: " + listed(solver.order.group_links[index]) + ": ";
}

}  // namespace

PosedGroup normal_group(const SolverScene& solver, std::size_t index) {
  const FoundGroup& found = solver.order.groups[index];
  const std::string where = place_of(solver, index);
  if (!verdict_of(*found.model).rigid) {
    throw InputError(where + "the group is degenerate, prismatic joints over-determine its " +
                     "angles, so it has no solver");
  }
  std::string obstacle;
  std::optional<PosedGroup> group =
      in_normal_form(solver.order.mechanism, found, solver.values, obstacle);
  if (!group) {
    throw InputError(where + "the group is degenerate: " + obstacle);
  }
  return *group;
}

std::vector<std::pair<const MechanismJoint*, int>> external_joints(const SolverScene& solver,
                                                                   const PosedGroup& group) {
  std::vector<std::pair<const MechanismJoint*, int>> list;
  const Group& structure = *group.group->model->group;
  for (int index = 0; index < structure.joint_count(); ++index) {
    const Joint& wanted = structure.joints()[static_cast<std::size_t>(index)];
    if (wanted.external()) {
      const MechanismJoint& at = played_joint(solver.order.mechanism, *group.roles, index);
      const int inner = group.roles->links[static_cast<std::size_t>(wanted.second)];
      list.emplace_back(&at, at.first == inner ? at.second : at.first);
    }
  }
  return list;
}

GroupNumbers group_numbers(const SolverScene& solver, const PosedGroup& group) {
  const double unit = unit_of(solver, group);
  std::vector<DimensionValue<double>> dimensions;
  NumberList of_dimensions(solver.parameters, unit);
  for (const DimensionValue<Dual>& value : dimension_values(group.problem)) {
    dimensions.push_back(in_unit(value, unit));
    of_dimensions.add(value);
  }
  NumberList of_inputs(solver.parameters, unit);
  for (const auto& [at, base] : external_joints(solver, group)) {
    const LinkFeature<Dual>& feature = at->on(base);
    std::vector<DimensionValue<Dual>> values = {{false, feature.x, {}}, {false, feature.y, {}}};
    if (at->prismatic) {
      values.push_back({true, Dual(0), feature.along});
    }
    for (const DimensionValue<Dual>& value : values) {
      if (solver.is_ground(base)) {
        of_inputs.add(value);
      } else {
        of_inputs.add_moving();
      }
    }
  }
  return {group.group->model,       unit,
          solver.derivative_order,  dimensions,
          of_dimensions.gradient(), of_inputs.values(),
          of_inputs.gradient()};
}

SpecialisedGroup specialised_group_of(const SolverScene& solver, const PosedGroup& group,
                                      std::size_t index) {
  const std::string number = std::to_string(index + 1);
  const std::string title = "Group " + number + ", links " +
                            comment_text(listed(solver.order.group_links[index])) + ", " +
                            group.group->model->title();
  try {
    return specialised_group(group_numbers(solver, group), solver.structure + "Group" + number,
                             title);
  } catch (const InputError& error) {
    throw InputError(place_of(solver, index) + error.what());
  }
}

}  // namespace assur::generator
