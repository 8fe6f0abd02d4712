// Numbers of a mechanism at given parameter values, with derivatives by the parameters.
#pragma once

#include <Eigen/Core>
#include <assur/mechanism/dual.hpp>
#include <assur/mechanism/frame.hpp>
#include <assur/mechanism/group_geometry.hpp>
#include <assur/support/displaced_frame.hpp>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace assur::mechanism {

struct Dependents;
struct PlanData;

/// The variation of the parameters about their values.
struct Spread {
  Eigen::VectorXd tolerances;  ///< half-widths of all parameters; zero without a tolerance
  /// The covariance of all parameters, zero for those that the request does not name; empty without
  /// a covariance.
  Eigen::MatrixXd covariance;
};

/// The coordinate of a joint, the angle theta_second - theta_first or the displacement, and its
/// rates in time.
struct JointMotion {
  Dual position;
  double velocity = 0;
  double acceleration = 0;

  [[nodiscard]] bool has_known_derivatives() const {
    return position.derivatives().allFinite() && position.hessian().allFinite();
  }
  [[nodiscard]] bool is_known() const {
    return has_known_derivatives() && std::isfinite(velocity) && std::isfinite(acceleration);
  }
};

/// The numbers of a mechanism at one set of parameter values. A parameter may be a formula in
/// others; its own derivative is one, and the parameters in its formula enter by the chain rule.
/// `Plan::values` makes them; `set` evaluates only the numbers that depend on the parameter.
class Values {
 public:
  /// Replaces the formulas of some parameters by values. Throws MechanismError for a value or a
  /// derivative that is not finite, a negative tolerance, a line without a direction, or a
  /// covariance that is not positive semidefinite.
  Values(std::shared_ptr<const PlanData> plan,
         std::vector<std::pair<ParameterIndex, double>> replaced);

  /// Sets another value of one parameter. Throws as the constructor does; these values then cannot
  /// be solved until a usable value is set.
  void set(ParameterIndex parameter, double value);
  /// Sets other values of some parameters, and evaluates the numbers that depend on any of them
  /// once. The list of dependents is kept for further calls with the same parameters.
  void set(const std::vector<std::pair<ParameterIndex, double>>& changed);
  /// The parameters with a value instead of their formula, with that value.
  [[nodiscard]] const std::vector<std::pair<ParameterIndex, double>>& replaced() const {
    return replaced_;
  }
  /// Whether the last `set` succeeded.
  [[nodiscard]] bool usable() const { return usable_; }

  [[nodiscard]] double parameter(ParameterIndex parameter) const {
    return parameters_[parameter].value();
  }
  /// A number of a joint's or an output's feature, of a driver or a tolerance, with its
  /// derivatives.
  [[nodiscard]] const Dual& number(NumberIndex number) const { return numbers_[number]; }
  /// A parameter as a function of time: its derivative is its rate, its second derivative the
  /// second rate. It is a constant if it is at rest.
  [[nodiscard]] const Dual& in_time(ParameterIndex parameter) const {
    return parameters_in_time_[parameter];
  }
  /// The value of a driver's law. A law that reads joints has no value until their links are
  /// placed.
  [[nodiscard]] const JointMotion& motion(DriverIndex driver) const { return motions_[driver]; }
  /// Evaluates a law that reads joints without drivers, and the numbers that depend on it, from the
  /// joints' coordinates. Throws as the constructor does, except that derivatives may be infinite
  /// or NaN where those of the joints are.
  void settle(DriverIndex driver, const std::function<JointMotion(JointIndex)>& coordinate_of);
  /// Sets the frames of a group's links in the frame of the link relative to which it is solved,
  /// and evaluates the groups that they shape.
  void settle(GroupIndex group, const Table<LinkIndex, Frame>& links,
              const Table<LinkIndex, support::Displacement>& displaced);
  /// The value of any number, evaluated at once. Throws MechanismError if it is not finite.
  [[nodiscard]] double value_of(NumberIndex index) const;
  /// The parts whose formulas have a corner at these values, to within rounding: an abs, min or max
  /// that reads no joint. Derivatives are those of the side where the argument of an abs is
  /// positive, and of the first argument of a min or max.
  [[nodiscard]] std::vector<std::string> corners() const;
  /// A feature in its link's frame. A block has no feature; the result is then its origin.
  [[nodiscard]] LinkFeature<Dual> feature(FeatureIndex feature, bool is_line) const;
  /// A joint's feature in the frame of a link that has it, or that carries the link that has it.
  [[nodiscard]] LinkFeature<Dual> feature(const ElementaryJoint& at, LinkIndex link) const;
  /// The frame of a feature on its link: a line along its x-axis, a point on the link's axes.
  [[nodiscard]] const Frame& frame(FeatureIndex feature) const {
    return feature.exists() ? frames_[feature] : block_;
  }
  /// A carried link's own frame, by its index among the carried links: in the frame of the driven
  /// joint on it, or, if a group places it, in the frame of the link that carries it, once the
  /// group is settled. The second function bounds its displacement by rounding.
  [[nodiscard]] const Frame& carried_frame(std::size_t place) const {
    return carried_frames_[place];
  }
  [[nodiscard]] const support::Displacement& carried_rounding(std::size_t place) const {
    return carried_roundings_[place];
  }
  /// The bound on a feature's displacement and turn on its link by rounding, beyond that of its own
  /// coordinates.
  [[nodiscard]] support::Displacement rounding(FeatureIndex feature) const {
    return feature.exists() ? roundings_[feature] : support::Displacement();
  }
  /// The same for a joint's feature, on a link that has it or carries it.
  [[nodiscard]] support::Displacement rounding(const ElementaryJoint& at, LinkIndex link) const;
  [[nodiscard]] const GroupGeometry<Dual>& group(GroupIndex group) const { return groups_[group]; }
  [[nodiscard]] SlideMeasure<Dual> slide_measure(GroupIndex group, int model_joint) const;

  /// The parameters with respect to which derivatives are taken, in the order of their columns: all
  /// of them if sensitivities are requested, otherwise the swept one, if any.
  [[nodiscard]] const std::vector<ParameterIndex>& columns() const;
  /// Whether second derivatives are carried: a covariance and sensitivities are requested.
  [[nodiscard]] bool second_order() const;
  [[nodiscard]] const Spread& spread() const { return spread_; }
  [[nodiscard]] const PlanData& plan() const { return *plan_; }
  [[nodiscard]] const std::shared_ptr<const PlanData>& shared_plan() const { return plan_; }
  /// A number that does not depend on the parameters.
  [[nodiscard]] Dual constant(double value) const;

  /// The plain numbers of a group needed for solving; they are computed with the group's geometry.
  struct GroupNumbers;
  /// The numbers of a group, which must have a normal form.
  [[nodiscard]] const GroupNumbers& numbers_of(GroupIndex group) const {
    return *group_numbers_[group];
  }

 private:
  void expect_finite(ParameterIndex parameter, double value) const;
  void expect_limits() const;
  /// Throws MechanismError if all coordinates are too small to be divisors.
  void expect_unit() const;
  void evaluate();
  void replace(ParameterIndex parameter, double value);
  void evaluate_again(const Dependents& dependents);
  void evaluate_parameter(ParameterIndex parameter);
  void evaluate_number(NumberIndex number);
  void evaluate_feature(FeatureIndex index);
  void evaluate_parameter_in_time(ParameterIndex index);
  void evaluate_driver(DriverIndex index,
                       const std::function<JointMotion(JointIndex)>& coordinate_of);
  void evaluate_carried_frames();
  /// The index of a carried link among the carried links.
  [[nodiscard]] std::size_t place_of(const CarriedLink& link) const;
  void evaluate_group(GroupIndex index);
  void evaluate_requests();
  [[nodiscard]] Dual evaluated(
      NumberIndex index,
      const std::function<JointMotion(JointIndex)>& coordinate_of = nullptr) const;
  /// Throws MechanismError if a derivative of a number is not finite.
  void expect_derivatives(NumberIndex index, const Dual& value) const;
  [[nodiscard]] double rounding(NumberIndex index) const;
  // The following are functions of time; numbers at rest are constants.
  [[nodiscard]] bool moves(NumberIndex number) const;
  [[nodiscard]] bool moves(FeatureIndex index) const;
  [[nodiscard]] bool moves(const FoundGroup& group) const;
  [[nodiscard]] Dual in_time(NumberIndex number,
                             const std::function<JointMotion(JointIndex)>& coordinate_of) const;
  [[nodiscard]] LinkFeature<Dual> in_time(FeatureIndex index, bool is_line) const;
  [[nodiscard]] LinkFeature<Dual> in_time(const ElementaryJoint& at, LinkIndex link) const;
  [[nodiscard]] GroupGeometry<Dual> in_time(const FoundGroup& group) const;
  /// A parameter's value, or its deviation from its formula, with its own derivative one.
  [[nodiscard]] Dual independent(ParameterIndex parameter, double value) const;

  std::shared_ptr<const PlanData> plan_;
  std::vector<std::pair<ParameterIndex, double>> replaced_;
  /// The numbers that depend on each parameter that was set; null for the others.
  Table<ParameterIndex, std::shared_ptr<const Dependents>> dependents_;
  /// The parameters that were last set together, and the numbers that depend on them.
  std::vector<ParameterIndex> set_together_;
  std::shared_ptr<const Dependents> dependents_together_;
  Table<ParameterIndex, Dual> parameters_;
  Table<ParameterIndex, double> parameter_roundings_;
  Table<NumberIndex, Dual> numbers_;
  Table<DriverIndex, JointMotion> motions_;
  /// Parameters with rates, as functions of time: one derivative, and one second derivative.
  Table<ParameterIndex, Dual> parameters_in_time_;
  Table<FeatureIndex, LinkFeature<Dual>> features_;
  Table<FeatureIndex, Frame> frames_;
  Table<FeatureIndex, support::Displacement> roundings_;
  Frame block_;
  std::vector<Frame> carried_frames_;
  std::vector<support::Displacement> carried_roundings_;
  Table<GroupIndex, GroupGeometry<Dual>> groups_;
  Spread spread_;
  bool usable_ = true;
  Table<GroupIndex, std::shared_ptr<const GroupNumbers>> group_numbers_;
};

}  // namespace assur::mechanism
