// Formulas: expressions in parameters and joint coordinates, with names resolved to indices.
#pragma once

#include <algorithm>
#include <assur/text/expression.hpp>
#include <assur/text/index.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace assur::mechanism {

using text::Index;
using text::Table;

using ParameterIndex = Index<struct Parameter>;
using JointIndex = Index<struct Joint>;

/// A number of a mechanism, as a function of its parameters and, in the law of a driver, of the
/// coordinates of other joints: operations in postfix order.
class Formula {
 public:
  /// The meaning of the names in an expression; each function may throw.
  struct Names {
    std::function<ParameterIndex(const std::string&)> parameter;
    std::function<JointIndex(const std::string&)> joint;  ///< of `joint(K)`
  };

  /// A constant.
  Formula(double number = 0)
      : steps_{{Step::Kind::number, text::Operation::other, number, {}, {}}} {}
  /// The formula of an expression, with its names resolved.
  Formula(const text::Expression& expression, const Names& names);

  [[nodiscard]] static Formula difference(const Formula& one, const Formula& other);
  /// The formula of a parameter alone.
  [[nodiscard]] static Formula of(ParameterIndex parameter);
  /// The formula of an operation on others. Operations on constants are evaluated at once, and a
  /// term 0 or a factor 0 or 1 adds no operation.
  [[nodiscard]] static Formula of(text::Operation operation, const Formula& argument);
  [[nodiscard]] static Formula of(text::Operation operation, const Formula& first,
                                  const Formula& second);
  /// The value of a formula that names neither parameters nor joints; nothing for others.
  [[nodiscard]] std::optional<double> constant() const;

  /// Whether the formulas consist of the same operations, so that they agree for all parameters.
  [[nodiscard]] bool operator==(const Formula&) const = default;

  /// The parameters that occur in it, each once.
  [[nodiscard]] std::vector<ParameterIndex> parameters() const;
  /// The joints that occur in it, each once.
  [[nodiscard]] std::vector<JointIndex> joints() const;
  /// Formulas of parameters whose signs decide between the sides of a corner: the argument of each
  /// abs, and the difference of the arguments of each min and max. Where one of them is zero,
  /// derivatives are those of one side. Arguments that read joints are omitted.
  [[nodiscard]] std::vector<Formula> deciders() const;
  [[nodiscard]] bool has_corners() const;  ///< whether abs, min or max occurs in it
  /// The same formula in a mechanism with other indices of joints.
  [[nodiscard]] Formula renumbered(const Table<JointIndex, JointIndex>& joint_of) const;

  /// The value, with `value_of(parameter)` for parameters and `coordinate_of(joint)` for joints. A
  /// `Scalar` is constructible from a double, and its operators and functions are found by
  /// argument-dependent look-up.
  template <typename Scalar, typename ValueOf, typename CoordinateOf>
  [[nodiscard]] Scalar evaluate(const ValueOf& value_of, const CoordinateOf& coordinate_of) const {
    if (steps_.size() == 1 && steps_[0].kind != Step::Kind::joint) {
      // Most numbers are a constant, or one parameter.
      return steps_[0].kind == Step::Kind::number ? Scalar(steps_[0].number)
                                                  : Scalar(value_of(steps_[0].parameter));
    }
    std::vector<Scalar> stack;
    for (const Step& step : steps_) {
      if (step.kind == Step::Kind::joint) {
        stack.push_back(Scalar(coordinate_of(step.joint)));
      } else {
        apply(step, value_of, stack);
      }
    }
    return std::move(stack.back());
  }
  /// The value of a formula in which no joint occurs.
  template <typename Scalar, typename ValueOf>
  [[nodiscard]] Scalar evaluate(const ValueOf& value_of) const {
    return evaluate<Scalar>(
        value_of, [](JointIndex) { return Scalar(std::numeric_limits<double>::quiet_NaN()); });
  }

 private:
  struct Step {
    enum class Kind : unsigned char { number, parameter, joint, unary, binary, constant_power };
    Kind kind;
    text::Operation operation;  ///< of a unary or binary step
    double number;              ///< the constant, or the exponent of a constant power
    ParameterIndex parameter;
    JointIndex joint;

    [[nodiscard]] bool operator==(const Step&) const = default;
  };

  void append(const text::Expression& expression, const Names& names);

  /// The operation on two arguments; min and max of two equal ones are the first.
  template <typename Scalar>
  static Scalar chosen_or_applied(text::Operation operation, const Scalar& first,
                                  const Scalar& second) {
    using std::max;
    using std::min;
    return operation == text::Operation::minimum ? Scalar(min(first, second))
           : operation == text::Operation::maximum
               ? Scalar(max(first, second))
               : text::applied<Scalar>(operation, first, second);
  }

  template <typename Scalar, typename ValueOf>
  static void apply(const Step& step, const ValueOf& value_of, std::vector<Scalar>& stack) {
    using std::pow;
    switch (step.kind) {
      case Step::Kind::joint:  // a coordinate, which `evaluate` has put on the stack
        break;
      case Step::Kind::number:
        stack.push_back(Scalar(step.number));
        break;
      case Step::Kind::parameter:
        stack.push_back(Scalar(value_of(step.parameter)));
        break;
      case Step::Kind::unary: {
        using std::abs;
        stack.back() = step.operation == text::Operation::absolute
                           ? Scalar(abs(stack.back()))
                           : text::applied<Scalar>(step.operation, stack.back());
        break;
      }
      case Step::Kind::constant_power:  // without a derivative by the exponent
        stack.back() = Scalar(pow(stack.back(), step.number));
        break;
      case Step::Kind::binary: {
        const Scalar last = std::move(stack.back());
        stack.pop_back();
        stack.back() = chosen_or_applied<Scalar>(step.operation, stack.back(), last);
        break;
      }
    }
  }

  std::vector<Step> steps_;
};

[[nodiscard]] inline Formula operator+(const Formula& a, const Formula& b) {
  return Formula::of(text::Operation::add, a, b);
}
[[nodiscard]] inline Formula operator-(const Formula& a, const Formula& b) {
  return Formula::of(text::Operation::subtract, a, b);
}
[[nodiscard]] inline Formula operator*(const Formula& a, const Formula& b) {
  return Formula::of(text::Operation::multiply, a, b);
}
[[nodiscard]] inline Formula operator/(const Formula& a, const Formula& b) {
  return Formula::of(text::Operation::divide, a, b);
}

}  // namespace assur::mechanism
