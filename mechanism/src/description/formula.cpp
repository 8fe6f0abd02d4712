// Formulas: compiled from expressions, simplified and inspected.
#include <algorithm>
#include <assur/mechanism/formula.hpp>

namespace assur::mechanism {

Formula::Formula(const text::Expression& expression, const Names& names) {
  append(expression, names);
}

void Formula::append(const text::Expression& expression, const Names& names) {
  using Kind = text::Expression::Kind;
  constexpr auto none = text::Operation::other;
  if (expression.kind == Kind::number) {
    steps_.push_back({Step::Kind::number, none, expression.number, {}, {}});
    return;
  }
  if (expression.kind == Kind::name) {
    steps_.push_back({Step::Kind::parameter, none, 0, names.parameter(expression.name), {}});
    return;
  }
  const std::vector<text::Expression>& arguments = expression.arguments;
  if (expression.operation == none) {
    if (arguments[0].kind != Kind::name) {
      throw text::ExpressionError("expected the name of a joint", arguments[0].column);
    }
    steps_.push_back({Step::Kind::joint, none, 0, {}, names.joint(arguments[0].name)});
    return;
  }
  append(arguments[0], names);
  if (expression.operation == text::Operation::power && text::is_constant(arguments[1])) {
    const std::optional<double> exponent = Formula(arguments[1], names).constant();
    steps_.push_back({Step::Kind::constant_power, none, *exponent, {}, {}});
    return;
  }
  if (arguments.size() == 2) {
    append(arguments[1], names);
  }
  const auto kind = arguments.size() == 2 ? Step::Kind::binary : Step::Kind::unary;
  steps_.push_back({kind, expression.operation, 0, {}, {}});
}

Formula Formula::difference(const Formula& one, const Formula& other) {
  Formula result = one;
  result.steps_.insert(result.steps_.end(), other.steps_.begin(), other.steps_.end());
  result.steps_.push_back({Step::Kind::binary, text::Operation::subtract, 0, {}, {}});
  return result;
}

Formula Formula::of(ParameterIndex parameter) {
  Formula result;
  result.steps_ = {{Step::Kind::parameter, text::Operation::other, 0, parameter, {}}};
  return result;
}

Formula Formula::of(text::Operation operation, const Formula& argument) {
  Formula result = argument;
  result.steps_.push_back({Step::Kind::unary, operation, 0, {}, {}});
  const std::optional<double> value = result.constant();
  return value ? Formula(*value) : result;
}

Formula Formula::of(text::Operation operation, const Formula& first, const Formula& second) {
  using text::Operation;
  const std::optional<double> one = first.constant();
  const std::optional<double> other = second.constant();
  const bool adds = operation == Operation::add;
  const bool multiplies = operation == Operation::multiply;
  const bool divides = operation == Operation::divide;
  if (!(one && other)) {
    if ((adds && one == 0) || (multiplies && one == 1) || (multiplies && other == 0)) {
      return second;
    }
    if (((adds || operation == Operation::subtract) && other == 0) ||
        ((multiplies || divides) && other == 1) || ((multiplies || divides) && one == 0)) {
      return first;
    }
  }
  Formula result = first;
  result.steps_.insert(result.steps_.end(), second.steps_.begin(), second.steps_.end());
  result.steps_.push_back({Step::Kind::binary, operation, 0, {}, {}});
  return one && other ? Formula(*result.constant()) : result;
}

std::optional<double> Formula::constant() const {
  const bool is_constant = std::ranges::none_of(steps_, [](const Step& step) {
    return step.kind == Step::Kind::parameter || step.kind == Step::Kind::joint;
  });
  return is_constant ? std::optional(evaluate<double>([](ParameterIndex) { return 0.0; }))
                     : std::nullopt;
}

std::vector<ParameterIndex> Formula::parameters() const {
  std::vector<ParameterIndex> found;
  for (const Step& step : steps_) {
    if (step.kind == Step::Kind::parameter &&
        std::find(found.begin(), found.end(), step.parameter) == found.end()) {
      found.push_back(step.parameter);
    }
  }
  return found;
}

std::vector<JointIndex> Formula::joints() const {
  std::vector<JointIndex> found;
  for (const Step& step : steps_) {
    if (step.kind == Step::Kind::joint &&
        std::find(found.begin(), found.end(), step.joint) == found.end()) {
      found.push_back(step.joint);
    }
  }
  return found;
}

std::vector<Formula> Formula::deciders() const {
  std::vector<Formula> found;
  std::vector<Formula> stack;  // of the operands that are open, as `evaluate` has their values
  for (const Step& step : steps_) {
    const bool is_binary = step.kind == Step::Kind::binary;
    Formula whole;
    whole.steps_.clear();
    if (is_binary) {
      const Formula last = std::move(stack.back());
      stack.pop_back();
      if (step.operation == text::Operation::minimum ||
          step.operation == text::Operation::maximum) {
        found.push_back(stack.back() - last);
      }
      whole.steps_ = std::move(stack.back().steps_);
      whole.steps_.insert(whole.steps_.end(), last.steps_.begin(), last.steps_.end());
    } else if (step.kind == Step::Kind::unary || step.kind == Step::Kind::constant_power) {
      if (step.operation == text::Operation::absolute) {
        found.push_back(stack.back());
      }
      whole.steps_ = std::move(stack.back().steps_);
    }
    if (!whole.steps_.empty()) {
      stack.pop_back();
    }
    whole.steps_.push_back(step);
    stack.push_back(std::move(whole));
  }
  std::erase_if(found, [](const Formula& formula) { return !formula.joints().empty(); });
  return found;
}

bool Formula::has_corners() const {
  return std::ranges::any_of(steps_, [](const Step& step) {
    return step.operation == text::Operation::absolute ||
           step.operation == text::Operation::minimum || step.operation == text::Operation::maximum;
  });
}

Formula Formula::renumbered(const Table<JointIndex, JointIndex>& joint_of) const {
  Formula result = *this;
  for (Step& step : result.steps_) {
    if (step.kind == Step::Kind::joint) {
      step.joint = joint_of[step.joint];
    }
  }
  return result;
}

}  // namespace assur::mechanism
