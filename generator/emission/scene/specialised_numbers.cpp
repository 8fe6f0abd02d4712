#include "emission/scene/specialised_numbers.hpp"

#include <algorithm>
#include <assur/directions.hpp>
#include <assur/text/names.hpp>
#include <cmath>
#include <iterator>

#include "emission/cpp/page.hpp"

namespace assur::generator::emission::scene {

namespace {

/// The longest lengths of a group.
struct Longest {
  double own = 0;   ///< of its dimensions, and between the joints that are fixed in its frame
  double arms = 0;  ///< of the moving links that hold it

  /// The largest power of two that is not above the longer one; 1 if there is no length.
  [[nodiscard]] double unit() const {
    const double longest = std::max(own, arms);
    return longest > 0 ? std::ldexp(1.0, std::ilogb(longest)) : 1;
  }
};

Longest longest_of(const SolverScene& solver, mechanism::GroupIndex group) {
  Longest longest;
  for (const auto& value : solver.numbers.group(group).dimensions()) {
    longest.own = std::max(longest.own, std::abs(value.length.value()));
  }
  std::optional<LinkFeature<SceneNumber>> first;
  for (const ExternalJoint& held : external_joints(solver, group)) {
    const LinkFeature<SceneNumber> feature = held.feature(solver);
    const bool fixed = held.is_in_frame;
    if (fixed && !first) {
      first = feature;
    }
    const double x = feature.x.value() - (fixed ? first->x.value() : 0);
    const double y = feature.y.value() - (fixed ? first->y.value() : 0);
    double& part = fixed ? longest.own : longest.arms;
    part = std::max({part, std::abs(x), std::abs(y)});
  }
  return longest;
}

DimensionValue<double> in_unit(const DimensionValue<SceneNumber>& value, double unit) {
  return {value.is_angle,
          value.length.value() / unit,
          {value.angle.cos.value(), value.angle.sin.value()}};
}

/// Collects values in the group's unit, each with its gradient with respect to the parameters.
class NumberList {
 public:
  NumberList(const ModelledParameters& parameters, double unit)
      : parameters_(parameters), unit_(unit), gradient_(0, parameters.count()) {}

  void add(const DimensionValue<SceneNumber>& value) {
    values_.emplace_back(in_unit(value, unit_));
    add_row(value.is_angle ? parameters_.gradient(angle_of(value.angle).number())
                           : parameters_.gradient(value.length.number()) / unit_);
  }
  /// Adds a value that varies: it has neither a number nor derivatives of its own.
  void add_input() {
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

std::string names_of(const SolverScene& solver, mechanism::GroupIndex group) {
  return text::listed(solver.plan.structure().names_of(solver.group(group).links));
}

/// Throws if parameters move a point across an axis that is held: the models have derivatives only
/// by their dimensions, and no dimension moves a point in that way.
void expect_followed(const SolverScene& solver,
                     const mechanism::GroupGeometry<SceneNumber>& geometry) {
  const mechanism::Structure& structure = solver.plan.structure();
  for (const mechanism::HeldAxis<SceneNumber>& axis : geometry.held_axes) {
    if (!solver.parameters.gradient(axis.across.number()).isZero(0)) {
      const mechanism::LinkIndex link = geometry.roles->links[static_cast<std::size_t>(axis.link)];
      throw mechanism::MechanismError(
          "links." + structure.linkage.links[link],
          "two of its joints coincide at the scene's own numbers, and parameters move them apart, "
          "so that an emitted solver has no sensitivities to these; give the scene other numbers");
    }
  }
}

/// Eliminations of a derived model whose eigenproblems fit on the stack. Throws if none does.
std::vector<loops::Elimination> emitted_eliminations(const SolverScene& solver,
                                                     mechanism::GroupIndex group) {
  // Eigen puts no matrix above 128 KiB on the stack: 90 times 90 complex numbers.
  constexpr int most_eigenvalues = 90;
  std::vector<loops::Elimination> result;
  const mechanism::GroupModel& model = *solver.group(group).model;
  std::ranges::copy_if(
      model.eliminations, std::back_inserter(result),
      [](const loops::Elimination& one) { return one.eigenvalues() <= most_eigenvalues; });
  if (model.is_derived() && result.empty() && model.starts.empty()) {
    throw mechanism::MechanismError(
        "links: " + names_of(solver, group),
        "their group needs an eigenproblem of more than " + std::to_string(most_eigenvalues) +
            " rows, for which no solver is emitted; solve the scene with the library");
  }
  return result;
}

bool varies(const SolverScene& solver, const DimensionValue<SceneNumber>& value) {
  return value.is_angle ? solver.numbers.varies(value.angle) : solver.numbers.varies(value.length);
}

}  // namespace

bool ExternalJoint::moves(const SolverScene& solver) const {
  const LinkFeature<SceneNumber> place = feature(solver);
  const SceneNumbers& numbers = solver.numbers;
  return !is_in_frame || numbers.moves(place.x) || numbers.moves(place.y) ||
         (place.line && (numbers.moves(place.along.cos) || numbers.moves(place.along.sin)));
}

bool ExternalJoint::is_fixed(const SolverScene& solver) const {
  const LinkFeature<SceneNumber> place = feature(solver);
  return !moves(solver) && !solver.numbers.varies(place.x) && !solver.numbers.varies(place.y) &&
         !(place.line && solver.numbers.varies(place.along));
}

const mechanism::GroupGeometry<SceneNumber>& normal_group(const SolverScene& solver,
                                                          mechanism::GroupIndex group) {
  const std::string part = "links: " + names_of(solver, group);
  if (!solver.group(group).model->rigid) {
    throw mechanism::MechanismError(
        part,
        "the group is degenerate: prismatic joints over-determine its angles, so it has no "
        "solver");
  }
  const mechanism::GroupGeometry<SceneNumber>& geometry = solver.numbers.group(group);
  if (geometry.roles == nullptr) {
    throw mechanism::MechanismError(part, "the group is degenerate: " + geometry.obstacle);
  }
  expect_followed(solver, geometry);
  return geometry;
}

std::vector<ExternalJoint> external_joints(const SolverScene& solver, mechanism::GroupIndex group) {
  std::vector<ExternalJoint> list;
  const mechanism::RoleAssignment& roles = *solver.numbers.group(group).roles;
  int joint = 0;
  for (const ModelJoint& wanted : solver.group(group).model->group->joints) {
    if (wanted.first == base_link) {
      const mechanism::ElementaryJoint& at = solver.played_joint(group, joint);
      const mechanism::LinkIndex base =
          at.other(roles.links[static_cast<std::size_t>(wanted.second)]);
      list.push_back({&at, base, solver.is_ground(base) || base == solver.group(group).base});
    }
    ++joint;
  }
  return list;
}

std::vector<FrameNeed> frame_needs(const SolverScene& solver, mechanism::GroupIndex group) {
  std::vector<FrameNeed> needs;
  for (const mechanism::LinkIndex link : normal_group(solver, group).roles->links) {
    needs.push_back(solver.needs[link]);
  }
  return needs;
}

std::vector<bool> moving_dimensions(const SolverScene& solver, mechanism::GroupIndex group) {
  std::vector<bool> moves;
  for (const DimensionValue<SceneNumber>& value : normal_group(solver, group).dimensions()) {
    moves.push_back(value.is_angle ? solver.numbers.moves(value.angle.cos) ||
                                         solver.numbers.moves(value.angle.sin)
                                   : solver.numbers.moves(value.length));
  }
  return moves;
}

SpecialisedNumbers specialised_numbers(const SolverScene& solver, mechanism::GroupIndex group) {
  const Longest longest = longest_of(solver, group);
  const double unit = longest.unit();
  NumberList of_dimensions(solver.parameters, unit);
  const std::vector<bool> dimension_moves = moving_dimensions(solver, group);
  std::size_t place = 0;
  for (const DimensionValue<SceneNumber>& value : normal_group(solver, group).dimensions()) {
    if (dimension_moves[place++]) {
      continue;
    }
    if (varies(solver, value)) {
      of_dimensions.add_input();
    } else {
      of_dimensions.add(value);
    }
  }
  NumberList of_inputs(solver.parameters, unit);
  std::vector<bool> input_moves;
  for (const ExternalJoint& held : external_joints(solver, group)) {
    const LinkFeature<SceneNumber> feature = held.feature(solver);
    std::vector<DimensionValue<SceneNumber>> values = {{false, feature.x, {}},
                                                       {false, feature.y, {}}};
    if (held.joint->prismatic) {
      values.push_back({true, SceneNumber(), feature.along});
    }
    for (const DimensionValue<SceneNumber>& value : values) {
      if (held.is_fixed(solver)) {
        of_inputs.add(value);
      } else {
        of_inputs.add_input();
      }
      input_moves.push_back(held.moves(solver));
    }
  }
  for (const bool moves : dimension_moves) {
    if (moves) {
      of_inputs.add_input();
      input_moves.push_back(true);
    }
  }
  return {&symbolic_model(solver.group(group)), unit,
          // A group without lengths of its own, such as one of slides, has the length of its unit.
          longest.own > 0 ? longest.own / unit : 1, solver.derivative_order, dimension_moves,
          of_dimensions.values(), of_dimensions.gradient(), of_inputs.values(),
          of_inputs.gradient(), input_moves, frame_needs(solver, group), solver.holds_groups(group),
          solver.gives_forces_by_groups(), emitted_eliminations(solver, group),
          solver.group(group).model->starts,
          static_cast<std::size_t>(solver.group(group).model->max_configurations),
          solver.group(group).model->slide_angles};
}

SpecialisedGroup specialised_group_of(const SolverScene& solver, mechanism::GroupIndex group) {
  const std::string number = std::to_string(group.place() + 1);
  const std::string title = "Group " + number + ", links " +
                            cpp::comment_text(names_of(solver, group)) + ", " +
                            symbolic_model(solver.group(group)).title();
  return specialised_group(specialised_numbers(solver, group), solver.group_struct(group), title);
}

}  // namespace assur::generator::emission::scene
