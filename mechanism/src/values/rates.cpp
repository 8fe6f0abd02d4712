#include "rates.hpp"

#include <algorithm>
#include <assur/mechanism/values.hpp>

#include "group_numbers.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::values {

Dual in_time(double value, double rate, double second_rate) {
  return {value, Eigen::VectorXd::Constant(1, rate), Eigen::MatrixXd::Constant(1, 1, second_rate)};
}

double rate_of(const Dual& number) {
  return number.derivatives().size() == 0 ? 0.0 : number.derivatives()(0);
}
double second_rate_of(const Dual& number) {
  return number.has_hessian() ? number.hessian()(0, 0) : 0.0;
}

void set_rates(const GroupGeometry<Dual>& geometry, const Structure& structure,
               const FoundGroup& group, Values::GroupNumbers& numbers) {
  const std::vector<DimensionValue<Dual>> dimensions = geometry.dimensions();
  numbers.d_rate.resize(std::ssize(dimensions));
  numbers.d_second_rate.resize(std::ssize(dimensions));
  Eigen::Index row = 0;
  for (const DimensionValue<Dual>& value : dimensions) {
    const Dual quantity = value.is_angle ? angle_of(value.angle) : value.length;
    numbers.d_rate(row) = rate_of(quantity);
    numbers.d_second_rate(row) = second_rate_of(quantity);
    ++row;
  }
  for (std::size_t axis = 0; axis < numbers.across.size(); ++axis) {
    numbers.across[axis].rate = rate_of(geometry.held_axes[axis].across);
    numbers.across[axis].second_rate = second_rate_of(geometry.held_axes[axis].across);
  }
  for (std::size_t link = 0; link < numbers.own.size(); ++link) {
    numbers.own[link].move(inverse(geometry.links[link].frame));
  }
  std::size_t slide = 0;
  for (const ModelUnknown& unknown : group.model->unknowns) {
    if (!unknown.is_angle) {
      const Dual shift = slide_measure(structure, group, geometry, unknown.owner, Dual(0.0)).shift;
      numbers.slides[slide].shift_rate = rate_of(shift);
      numbers.slides[slide].shift_second_rate = second_rate_of(shift);
      ++slide;
    }
  }
}

}  // namespace assur::mechanism::values

namespace assur::mechanism {

void Values::evaluate_parameter_in_time(ParameterIndex index) {
  if (!plan_->evaluation.moves[index]) {
    parameters_in_time_[index] = Dual(parameters_[index].value());
    return;
  }
  const Parameter& parameter = plan_->mechanism.parameters()[index];
  const bool is_replaced = std::ranges::any_of(
      replaced_, [index](const auto& replacement) { return replacement.first == index; });
  const Dual follows = is_replaced ? Dual() : in_time(parameter.value, nullptr);
  parameters_in_time_[index] = values::in_time(
      parameters_[index].value(),
      parameter.velocity.exists() ? numbers_[parameter.velocity].value() : values::rate_of(follows),
      parameter.acceleration.exists() ? numbers_[parameter.acceleration].value()
                                      : values::second_rate_of(follows));
}

bool Values::moves(NumberIndex number) const {
  return std::ranges::any_of(
      plan_->mechanism.numbers()[number].formula.parameters(),
      [this](ParameterIndex parameter) { return plan_->evaluation.moves[parameter]; });
}

bool Values::moves(FeatureIndex index) const {
  if (!index.exists()) {
    return false;
  }
  const Feature& feature = plan_->mechanism.features()[index];
  return moves(feature.x) || moves(feature.y) ||
         (feature.is_line && (moves(feature.along_x) || moves(feature.along_y)));
}

bool Values::moves(const FoundGroup& group) const {
  const std::vector<ElementaryJointIndex>& joints = group.assignments.front().joints;
  return std::ranges::any_of(joints, [this](ElementaryJointIndex joint) {
    const ElementaryJoint& at = plan_->structure.linkage.joints[joint];
    return moves(at.on_first) || moves(at.on_second) || at.first != at.holder_first ||
           at.second != at.holder_second;
  });
}

Dual Values::in_time(NumberIndex number,
                     const std::function<JointMotion(JointIndex)>& coordinate_of) const {
  return plan_->mechanism.numbers()[number].formula.evaluate<Dual>(
      [this](ParameterIndex parameter) -> const Dual& { return parameters_in_time_[parameter]; },
      [&](JointIndex joint) {
        const JointMotion motion = coordinate_of(joint);
        return values::in_time(motion.position.value(), motion.velocity, motion.acceleration);
      });
}

LinkFeature<Dual> Values::in_time(FeatureIndex index, bool is_line) const {
  LinkFeature<Dual> result{is_line, Dual(0.0), Dual(0.0), {Dual(1.0), Dual(0.0)}};
  if (!index.exists()) {  // a feature of a block
    return result;
  }
  const Feature& feature = plan_->mechanism.features()[index];
  result.line = feature.is_line;
  result.x = in_time(feature.x, nullptr);
  result.y = in_time(feature.y, nullptr);
  if (feature.is_line) {
    result.along =
        unit_direction(in_time(feature.along_x, nullptr), in_time(feature.along_y, nullptr));
  }
  return result;
}

LinkFeature<Dual> Values::in_time(const ElementaryJoint& at, LinkIndex link) const {
  const auto feature_of = [this](FeatureIndex feature, bool is_line) {
    return in_time(feature, is_line);
  };
  return carried_feature<Dual>(
      plan_->structure, at, link, feature_of,
      [&](const LinkFeature<Dual>& feature, const CarriedLink& carried) {
        if (carried.group.exists()) {
          return placed_feature(feature, carried_frames_[place_of(carried)].in_time());
        }
        const JointMotion& motion = motions_[carried.driver];
        return moved_feature(
            feature, plan_->structure, carried, feature_of,
            values::in_time(motion.position.value(), motion.velocity, motion.acceleration));
      });
}

GroupGeometry<Dual> Values::in_time(const FoundGroup& group) const {
  return group_geometry(
      plan_->structure, group,
      [this](const ElementaryJoint& at, LinkIndex link) { return in_time(at, link); }, Dual(0.0));
}

}  // namespace assur::mechanism
