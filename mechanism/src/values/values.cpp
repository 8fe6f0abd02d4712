// Evaluation of a mechanism's numbers, with derivatives by the parameters.
#include <algorithm>
#include <assur/mechanism/values.hpp>
#include <assur/support/displaced_frame.hpp>
#include <cmath>
#include <limits>

#include "covariance.hpp"
#include "description/refusals.hpp"
#include "group_numbers.hpp"
#include "plan/plan_data.hpp"
#include "rates.hpp"
#include "rounded_number.hpp"

namespace assur::mechanism::values {

namespace {

/// Products of two coordinates and their derivatives must be finite.
const double largest_coordinate = std::ldexp(1.0, 400);
const double least_size = std::ldexp(1.0, -400);

LinkFeature<Dual> block_feature(const Values& values, bool is_line) {
  return {is_line,
          values.constant(0.0),
          values.constant(0.0),
          {values.constant(1.0), values.constant(0.0)}};
}

}  // namespace

}  // namespace assur::mechanism::values

namespace assur::mechanism {

Values::Values(std::shared_ptr<const PlanData> plan,
               std::vector<std::pair<ParameterIndex, double>> replaced)
    : plan_(std::move(plan)), replaced_(std::move(replaced)) {
  const Mechanism& mechanism = plan_->mechanism;
  dependents_.resize(mechanism.parameters().size());
  parameters_.resize(mechanism.parameters().size());
  numbers_.resize(mechanism.numbers().size());
  motions_.resize(mechanism.drivers().size());
  parameters_in_time_.resize(mechanism.parameters().size());
  features_.resize(mechanism.features().size());
  frames_.resize(mechanism.features().size());
  parameter_roundings_.assign(mechanism.parameters().size(), 0);
  roundings_.resize(mechanism.features().size());
  groups_.resize(plan_->structure.groups.size());
  group_numbers_.resize(plan_->structure.groups.size());
  for (const auto& [parameter, value] : replaced_) {
    expect_finite(parameter, value);
  }
  const LinkFeature<Dual> centre = values::block_feature(*this, true);
  block_ = Frame::at({centre.x, centre.y, centre.along});
  evaluate();
}

/// Evaluates all numbers, in the plan's order.
void Values::evaluate() {
  const plan::EvaluationOrder& order = plan_->evaluation;
  for (const ParameterIndex parameter : order.parameters) {
    evaluate_parameter(parameter);
  }
  for (const NumberIndex number : order.numbers) {
    evaluate_number(number);
  }
  for (const ParameterIndex parameter : order.parameters) {
    evaluate_parameter_in_time(parameter);
  }
  for (const DriverIndex driver : order.drivers) {
    evaluate_driver(driver, nullptr);
  }
  for (const FeatureIndex feature : order.features) {
    evaluate_feature(feature);
  }
  expect_unit();
  evaluate_carried_frames();
  for (const GroupIndex group : groups_.keys()) {
    evaluate_group(group);
  }
  evaluate_requests();
  expect_limits();
}

/// Throws MechanismError if a lowest limit is above the highest one.
void Values::expect_limits() const {
  for (const Joint& joint : plan_->mechanism.joints()) {
    if (joint.lowest.exists() &&
        !(numbers_[joint.lowest].value() <= numbers_[joint.highest].value())) {
      throw MechanismError("joints." + joint.name + ".limits",
                           "the lowest is above the highest; exchange the two");
    }
  }
}

void Values::expect_finite(ParameterIndex parameter, double value) const {
  if (!parameter.exists() || parameter.place() >= parameters_.size()) {
    throw MechanismError("", "no such parameter");
  }
  if (!std::isfinite(value)) {
    throw MechanismError("parameters." + plan_->mechanism.parameters()[parameter].name,
                         "the value is not a finite number");
  }
}

void Values::replace(ParameterIndex parameter, double value) {
  expect_finite(parameter, value);
  const auto found =
      std::ranges::find(replaced_, parameter, &std::pair<ParameterIndex, double>::first);
  if (found != replaced_.end()) {
    found->second = value;
  } else {
    replaced_.emplace_back(parameter, value);
  }
}

void Values::set(ParameterIndex parameter, double value) {
  const bool were_usable = usable_;
  usable_ = false;
  replace(parameter, value);
  if (!were_usable) {  // the failed evaluation may have changed some numbers
    evaluate();
  } else {
    std::shared_ptr<const Dependents>& dependents = dependents_[parameter];
    if (!dependents) {
      dependents = std::make_shared<const Dependents>(plan::dependents_of({parameter}, *plan_));
    }
    evaluate_again(*dependents);
  }
  usable_ = true;
}

void Values::set(const std::vector<std::pair<ParameterIndex, double>>& changed) {
  const bool were_usable = usable_;
  usable_ = false;
  for (const auto& [parameter, value] : changed) {
    replace(parameter, value);
  }
  if (!were_usable) {
    evaluate();
  } else {
    if (!dependents_together_ || !std::ranges::equal(changed, set_together_, {},
                                                     &std::pair<ParameterIndex, double>::first)) {
      set_together_.clear();
      for (const auto& [parameter, value] : changed) {
        set_together_.push_back(parameter);
      }
      dependents_together_ =
          std::make_shared<const Dependents>(plan::dependents_of(set_together_, *plan_));
    }
    evaluate_again(*dependents_together_);
  }
  usable_ = true;
}

void Values::evaluate_again(const Dependents& dependents) {
  for (const ParameterIndex parameter : dependents.parameters) {
    evaluate_parameter(parameter);
  }
  for (const NumberIndex number : dependents.numbers) {
    evaluate_number(number);
  }
  for (const ParameterIndex moving : plan_->evaluation.parameters) {
    evaluate_parameter_in_time(moving);
  }
  for (const DriverIndex driver : dependents.drivers) {
    evaluate_driver(driver, nullptr);
  }
  for (const FeatureIndex feature : dependents.features) {
    evaluate_feature(feature);
  }
  if (!dependents.features.empty()) {
    evaluate_carried_frames();
  }
  for (const GroupIndex group : dependents.groups) {
    evaluate_group(group);
  }
  if (dependents.spread) {
    evaluate_requests();
  }
  expect_limits();
}

double Values::value_of(NumberIndex index) const {
  const Number& number = plan_->mechanism.numbers()[index];
  const auto value = number.formula.evaluate<double>(
      [&](ParameterIndex parameter) { return parameters_[parameter].value(); });
  if (!std::isfinite(value)) {
    throw MechanismError(number.part, "the value is not a finite number");
  }
  return value;
}

Dual Values::constant(double value) const {
  const auto count = static_cast<Eigen::Index>(columns().size());
  const Eigen::Index order = second_order() ? count : 0;
  return {value, Eigen::VectorXd::Zero(count), Eigen::MatrixXd::Zero(order, order)};
}

Dual Values::independent(ParameterIndex parameter, double value) const {
  const Eigen::Index column = plan_->evaluation.column_of[parameter];
  if (column < 0) {
    return constant(value);
  }
  const auto count = static_cast<Eigen::Index>(columns().size());
  const Eigen::Index order = second_order() ? count : 0;
  return {value, Eigen::VectorXd::Unit(count, column), Eigen::MatrixXd::Zero(order, order)};
}

const std::vector<ParameterIndex>& Values::columns() const { return plan_->evaluation.columns; }
bool Values::second_order() const { return plan_->evaluation.second_order; }

void Values::evaluate_parameter(ParameterIndex parameter) {
  for (const auto& [index, value] : replaced_) {
    if (index == parameter) {
      parameters_[parameter] = independent(parameter, value);
      parameter_roundings_[parameter] = 0;
      return;
    }
  }
  const NumberIndex formula = plan_->mechanism.parameters()[parameter].value;
  const Dual value = evaluated(formula);
  expect_derivatives(formula, value);
  parameters_[parameter] = value + independent(parameter, 0.0);
  parameter_roundings_[parameter] = rounding(formula);
}

void Values::evaluate_number(NumberIndex number) {
  numbers_[number] = evaluated(number);
  expect_derivatives(number, numbers_[number]);
}

Dual Values::evaluated(NumberIndex index,
                       const std::function<JointMotion(JointIndex)>& coordinate_of) const {
  const Number& number = plan_->mechanism.numbers()[index];
  Dual result = number.formula.evaluate<Dual>(
      [&](ParameterIndex parameter) -> const Dual& { return parameters_[parameter]; },
      [&](JointIndex joint) { return coordinate_of(joint).position; });
  if (result.derivatives().size() == 0) {  // a bare number has no gradient
    result = constant(result.value());
  }
  if (!std::isfinite(result.value())) {
    throw MechanismError(number.part, "the value is not a finite number");
  }
  return result;
}

void Values::expect_derivatives(NumberIndex index, const Dual& value) const {
  const std::string& part = plan_->mechanism.numbers()[index].part;
  // Derivatives that do not exist are unknown; see `pow` of two numbers.
  if (value.derivatives().array().isInf().any()) {
    throw MechanismError(part, "the derivative with respect to the parameters is not finite here");
  }
  if (!value.hessian().allFinite()) {
    throw MechanismError(part,
                         "the second derivative with respect to the parameters is not finite here, "
                         "and a covariance needs it");
  }
}

double Values::rounding(NumberIndex index) const {
  return plan_->mechanism.numbers()[index]
      .formula
      .evaluate<values::RoundedNumber>([&](ParameterIndex parameter) {
        return values::RoundedNumber(parameters_[parameter].value(),
                                     parameter_roundings_[parameter]);
      })
      .error;
}

std::vector<std::string> Values::corners() const {
  const Mechanism& mechanism = plan_->mechanism;
  std::vector<std::string> parts;
  const auto look_at = [&](NumberIndex index) {
    const Number& number = mechanism.numbers()[index];
    if (!number.formula.has_corners()) {
      return;
    }
    const std::vector<Formula> deciders = number.formula.deciders();
    const bool is_corner = std::ranges::any_of(deciders, [&](const Formula& decider) {
      const auto side = decider.evaluate<values::RoundedNumber>([&](ParameterIndex parameter) {
        return values::RoundedNumber(parameters_[parameter].value(),
                                     parameter_roundings_[parameter]);
      });
      return std::abs(side.value) <= side.error;
    });
    if (is_corner) {
      parts.push_back(number.part);
    }
  };
  for (const ParameterIndex parameter : plan_->evaluation.parameters) {
    const bool is_replaced =
        std::ranges::find(replaced_, parameter, &std::pair<ParameterIndex, double>::first) !=
        replaced_.end();
    if (!is_replaced) {
      look_at(mechanism.parameters()[parameter].value);
    }
  }
  for (const NumberIndex number : plan_->evaluation.numbers) {
    look_at(number);
  }
  for (const Driver& driver : mechanism.drivers()) {
    look_at(driver.position);
  }
  return parts;
}

void Values::expect_unit() const {
  double largest = 0;
  for (const FeatureIndex feature : plan_->evaluation.features) {
    const Pose<double>& pose = frames_[feature].pose;
    largest = std::max({largest, std::abs(pose.x), std::abs(pose.y)});
  }
  for (const DriverIndex driver : plan_->evaluation.drivers) {
    const JointIndex joint = plan_->mechanism.drivers()[driver].joint;
    if (plan_->mechanism.joints()[joint].type != JointType::revolute) {
      largest = std::max(largest, std::abs(motions_[driver].position.value()));
    }
  }
  if (largest > 0 && largest < values::least_size) {
    throw MechanismError(
        "links", "all coordinates are smaller than 2^-400; give the lengths in another unit");
  }
}

void Values::evaluate_feature(FeatureIndex index) {
  const Feature& feature = plan_->mechanism.features()[index];
  LinkFeature<Dual> result = values::block_feature(*this, feature.is_line);
  result.x = numbers_[feature.x];
  result.y = numbers_[feature.y];
  if (std::max(std::abs(result.x.value()), std::abs(result.y.value())) >
      values::largest_coordinate) {
    throw MechanismError(
        "links." + plan_->mechanism.links()[feature.link].name + "." + feature.name,
        "a coordinate is larger than 2^400; give the lengths in another unit");
  }
  if (feature.is_line) {
    const Dual& dx = numbers_[feature.along_x];
    const Dual& dy = numbers_[feature.along_y];
    if (dx.value() == 0 && dy.value() == 0) {
      const std::string link = plan_->mechanism.links()[feature.link].name;
      throw description::refusal_of_direction("links." + link + "." + feature.name);
    }
    result.along = unit_direction(dx, dy);
  }
  frames_[index] = Frame::at({result.x, result.y, result.along});
  if (moves(index)) {
    const LinkFeature<Dual> moving = in_time(index, feature.is_line);
    frames_[index].move({moving.x, moving.y, moving.along});
  }
  roundings_[index] = support::Displacement::of_rounding(
      std::max(rounding(feature.x), rounding(feature.y)),
      feature.is_line
          ? (rounding(feature.along_x) + rounding(feature.along_y)) /
                std::hypot(numbers_[feature.along_x].value(), numbers_[feature.along_y].value())
          : 0);
  features_[index] = std::move(result);
}

LinkFeature<Dual> Values::feature(FeatureIndex feature, bool is_line) const {
  return feature.exists() ? features_[feature] : values::block_feature(*this, is_line);
}

void Values::evaluate_group(GroupIndex index) {
  const FoundGroup& group = plan_->structure.groups[index];
  groups_[index] = group_geometry(
      plan_->structure, group,
      [this](const ElementaryJoint& at, LinkIndex link) { return feature(at, link); },
      constant(0.0));
  if (groups_[index].roles == nullptr) {
    group_numbers_[index] = nullptr;
    return;
  }
  GroupNumbers numbers = values::group_numbers(*this, index);
  if (moves(group)) {
    values::set_rates(in_time(group), plan_->structure, group, numbers);
  }
  group_numbers_[index] = std::make_shared<const GroupNumbers>(std::move(numbers));
}

void Values::evaluate_driver(DriverIndex index,
                             const std::function<JointMotion(JointIndex)>& coordinate_of) {
  if (plan_->evaluation.reads_links[index] && !coordinate_of) {
    motions_[index] = {constant(std::numeric_limits<double>::quiet_NaN()), 0, 0};
    return;
  }
  const auto of_joint = [&](JointIndex joint) {
    const DriverIndex driver = plan_->mechanism.driver_of(joint);
    return driver.exists() ? motions_[driver] : coordinate_of(joint);
  };
  const Driver& driver = plan_->mechanism.drivers()[index];
  JointMotion& motion = motions_[index];
  motion.position = evaluated(driver.position, of_joint);
  // A link that the law reads may be in a singular configuration, where derivatives do not exist.
  if (!plan_->evaluation.reads_links[index]) {
    expect_derivatives(driver.position, motion.position);
  }
  const bool follows = !driver.velocity.exists() || !driver.acceleration.exists();
  const Dual law = follows ? in_time(driver.position, of_joint) : Dual();
  motion.velocity =
      driver.velocity.exists() ? numbers_[driver.velocity].value() : values::rate_of(law);
  motion.acceleration = driver.acceleration.exists() ? numbers_[driver.acceleration].value()
                                                     : values::second_rate_of(law);
}

SlideMeasure<Dual> Values::slide_measure(GroupIndex group, int model_joint) const {
  return mechanism::slide_measure(plan_->structure, plan_->structure.groups[group], groups_[group],
                                  model_joint, constant(0.0));
}

/// Evaluates half-widths, the covariance, and the tolerance of redundant constraints.
void Values::evaluate_requests() {
  const auto& parameters = plan_->mechanism.parameters();
  spread_.tolerances = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(parameters.size()));
  for (const ParameterIndex index : parameters.keys()) {
    const NumberIndex tolerance = parameters[index].tolerance;
    if (tolerance.exists()) {
      const double half_width = numbers_[tolerance].value();
      if (half_width < 0) {
        throw MechanismError(plan_->mechanism.numbers()[tolerance].part,
                             "a tolerance is a half-width and cannot be negative");
      }
      spread_.tolerances(index.row()) = half_width;
    }
  }
  const NumberIndex miss = plan_->request.redundancy_tolerance;
  if (miss.exists() && numbers_[miss].value() < 0) {
    throw MechanismError(plan_->mechanism.numbers()[miss].part,
                         "a tolerance is a distance and cannot be negative");
  }
  if (plan_->request.covariance) {
    spread_.covariance =
        values::covariance_matrix(*plan_->request.covariance, *this, parameters.size());
  }
}

}  // namespace assur::mechanism
