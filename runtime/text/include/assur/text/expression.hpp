// Parser for arithmetic expressions, and their evaluation in any scalar type.
#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace assur::text {

/// A fault in an expression, and its column (the first is 1).
class ExpressionError : public std::runtime_error {
 public:
  ExpressionError(const std::string& what, std::size_t at) : std::runtime_error(what), column(at) {}
  std::size_t column;
};

/// The function of a call; `other` is one defined by the caller.
enum class Operation : unsigned char {
  other,
  negate,
  sqrt,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  add,
  subtract,
  multiply,
  divide,
  power,
  atan2,
  // The following are not smooth. They are available only if the caller names them in `more`, and
  // `applied` does not evaluate them.
  absolute,
  minimum,
  maximum
};

/// A tree over numbers, names, + - * / ^, and the functions sqrt sin cos tan asin acos atan atan2.
struct Expression {
  enum class Kind : unsigned char { number, name, call };

  Kind kind = Kind::number;
  double number = 0;
  std::string name;  ///< of a parameter, an operator or a function; the text of a number
  std::vector<Expression> arguments;
  Operation operation = Operation::other;  ///< the function of a call
  std::size_t column = 1;  ///< its first column; for an operator, the end of its last operand
};

/// A function that an expression may call: its name and its number of arguments.
struct ExpressionFunction {
  std::string_view name;
  std::size_t arguments;
  Operation operation = Operation::other;
  bool may_be_name = false;  ///< also a name if no parenthesis follows
};

/// Parses an expression; throws ExpressionError. Powers bind tighter than signs, and associate to
/// the right. `more` are further functions of the caller, which `evaluate` does not support.
[[nodiscard]] Expression parse_expression(const std::string& text,
                                          std::span<const ExpressionFunction> more = {});
/// Whether an expression contains no names.
[[nodiscard]] bool is_constant(const Expression& expression);
/// The value of a constant expression.
[[nodiscard]] double constant_value(const Expression& expression);
/// The names of functions and constants, which no parameter may take.
[[nodiscard]] bool is_reserved_name(const std::string& name);
/// Whether a text can be a parameter's name: letters, digits and underscores, not starting with a
/// digit.
[[nodiscard]] bool is_identifier(const std::string& text);

/// The operation applied to one argument. Operators and functions of `Scalar` are found by
/// argument-dependent look-up.
template <typename Scalar>
[[nodiscard]] Scalar applied(Operation operation, const Scalar& argument) {
  using std::acos;
  using std::asin;
  using std::atan;
  using std::cos;
  using std::sin;
  using std::sqrt;
  using std::tan;
  switch (operation) {
    case Operation::negate:
      return Scalar(-argument);
    case Operation::sqrt:
      return Scalar(sqrt(argument));
    case Operation::sin:
      return Scalar(sin(argument));
    case Operation::cos:
      return Scalar(cos(argument));
    case Operation::tan:
      return Scalar(tan(argument));
    case Operation::asin:
      return Scalar(asin(argument));
    case Operation::acos:
      return Scalar(acos(argument));
    case Operation::atan:
      return Scalar(atan(argument));
    default:
      return argument;  // no operation of one argument is left
  }
}

/// The operation applied to two arguments.
template <typename Scalar>
[[nodiscard]] Scalar applied(Operation operation, const Scalar& first, const Scalar& second) {
  using std::atan2;
  using std::pow;
  switch (operation) {
    case Operation::add:
      return Scalar(first + second);
    case Operation::subtract:
      return Scalar(first - second);
    case Operation::multiply:
      return Scalar(first * second);
    case Operation::divide:
      return Scalar(first / second);
    case Operation::power:
      return Scalar(pow(first, second));
    case Operation::atan2:
      return Scalar(atan2(first, second));
    default:
      return first;  // no operation of two arguments is left
  }
}

/// Evaluates an expression with `value_of(name)` for names. `Scalar` is constructed from a double.
/// Functions of the caller are not supported.
template <typename Scalar, typename ValueOf>
Scalar evaluate(const Expression& expression, const ValueOf& value_of) {
  if (expression.kind == Expression::Kind::number) {
    return Scalar(expression.number);
  }
  if (expression.kind == Expression::Kind::name) {
    return value_of(expression.name);
  }
  const auto first = evaluate<Scalar>(expression.arguments[0], value_of);
  if (expression.arguments.size() == 1) {
    return applied<Scalar>(expression.operation, first);
  }
  if (expression.operation == Operation::power && is_constant(expression.arguments[1])) {
    using std::pow;  // without a derivative with respect to the exponent
    return Scalar(pow(first, constant_value(expression.arguments[1])));
  }
  return applied<Scalar>(expression.operation, first,
                         evaluate<Scalar>(expression.arguments[1], value_of));
}

}  // namespace assur::text
