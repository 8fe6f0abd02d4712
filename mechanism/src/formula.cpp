#include <algorithm>
#include <assur/mechanism/formula.hpp>

namespace assur::mechanism {

Formula::Formula(const text::Expression& expression,
                 const std::function<ParameterIndex(const std::string&)>& parameter_named) {
  append(expression, parameter_named);
}

void Formula::append(const text::Expression& expression,
                     const std::function<ParameterIndex(const std::string&)>& parameter_named) {
  using Kind = text::Expression::Kind;
  constexpr auto none = text::Operation::other;
  if (expression.kind == Kind::number) {
    steps_.push_back({Step::Kind::number, none, expression.number, {}});
    return;
  }
  if (expression.kind == Kind::name) {
    steps_.push_back({Step::Kind::parameter, none, 0, parameter_named(expression.name)});
    return;
  }
  const std::vector<text::Expression>& arguments = expression.arguments;
  append(arguments[0], parameter_named);
  if (expression.operation == text::Operation::power && text::is_constant(arguments[1])) {
    steps_.push_back({Step::Kind::constant_power, none, text::constant_value(arguments[1]), {}});
    return;
  }
  if (arguments.size() == 2) {
    append(arguments[1], parameter_named);
  }
  const auto kind = arguments.size() == 2 ? Step::Kind::binary : Step::Kind::unary;
  steps_.push_back({kind, expression.operation, 0, {}});
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

}  // namespace assur::mechanism
