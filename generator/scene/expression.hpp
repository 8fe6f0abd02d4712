// Turns the text of an arithmetic expression into a tree that any scalar type can evaluate.
#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace assur::generator {

/// What is wrong with an expression, and at which column (the first is 1).
class ExpressionError : public std::runtime_error {
 public:
  ExpressionError(const std::string& what, std::size_t at) : std::runtime_error(what), column(at) {}
  std::size_t column;
};

/// A tree over numbers, names, + - * / ^, and the functions sqrt sin cos tan asin acos atan atan2.
struct Expression {
  enum class Kind : unsigned char { number, name, call };

  Kind kind = Kind::number;
  double number = 0;
  std::string name;  ///< of a parameter, an operator or a function; of a number, its text
  std::vector<Expression> arguments;
  std::size_t column = 1;  ///< where it begins; of an operator, where its last operand ends
};

/// A function that a text may call: its name and how many arguments it takes.
struct ExpressionFunction {
  std::string_view name;
  std::size_t arguments;
};

/// Parses an expression; throws ExpressionError. Powers bind tighter than signs and to the right.
/// `more` are functions of the caller's beside those above, which `evaluate` does not know.
[[nodiscard]] Expression parse_expression(const std::string& text,
                                          std::span<const ExpressionFunction> more = {});
/// Whether an expression has no names in it.
[[nodiscard]] bool is_constant(const Expression& expression);
/// The value of a constant expression.
[[nodiscard]] double constant_value(const Expression& expression);
/// The names of functions and constants, which no parameter may take.
[[nodiscard]] bool is_reserved_name(const std::string& name);
/// Whether a text could be a parameter's name: letters, digits and underscores, no digit first.
[[nodiscard]] bool is_identifier(const std::string& text);

/// Evaluates with `value_of(name)` for names. `Scalar` needs the operators and functions by
/// argument-dependent look-up; it is made from a double.
template <typename Scalar, typename ValueOf>
Scalar evaluate(const Expression& expression, const ValueOf& value_of) {
  using std::acos;
  using std::asin;
  using std::atan;
  using std::atan2;
  using std::cos;
  using std::exp;
  using std::log;
  using std::pow;
  using std::sin;
  using std::sqrt;
  using std::tan;
  if (expression.kind == Expression::Kind::number) {
    return Scalar(expression.number);
  }
  if (expression.kind == Expression::Kind::name) {
    return value_of(expression.name);
  }
  const std::string& name = expression.name;
  const auto first = evaluate<Scalar>(expression.arguments[0], value_of);
  if (expression.arguments.size() == 1) {
    if (name == "-") return Scalar(-first);
    if (name == "sqrt") return Scalar(sqrt(first));
    if (name == "sin") return Scalar(sin(first));
    if (name == "cos") return Scalar(cos(first));
    if (name == "tan") return Scalar(tan(first));
    if (name == "asin") return Scalar(asin(first));
    if (name == "acos") return Scalar(acos(first));
    return Scalar(atan(first));
  }
  if (name == "^" && is_constant(expression.arguments[1])) {  // no logarithm, so any base
    return Scalar(pow(first, constant_value(expression.arguments[1])));
  }
  const auto second = evaluate<Scalar>(expression.arguments[1], value_of);
  if (name == "+") return Scalar(first + second);
  if (name == "-") return Scalar(first - second);
  if (name == "*") return Scalar(first * second);
  if (name == "/") return Scalar(first / second);
  if (name == "^") return Scalar(exp(second * log(first)));
  return Scalar(atan2(first, second));
}

}  // namespace assur::generator
