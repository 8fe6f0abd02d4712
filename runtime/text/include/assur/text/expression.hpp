// Turns the text of an arithmetic expression into a tree that any scalar type can evaluate.
#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace assur::text {

/// What is wrong with an expression, and at which column (the first is 1).
class ExpressionError : public std::runtime_error {
 public:
  ExpressionError(const std::string& what, std::size_t at) : std::runtime_error(what), column(at) {}
  std::size_t column;
};

/// What a call does with its arguments; `other` is a function of the caller's.
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
  // The following have corners. Only a caller that names them in `more` has them, and they are not
  // among those that `applied` knows.
  absolute,
  minimum,
  maximum
};

/// A tree over numbers, names, + - * / ^, and the functions sqrt sin cos tan asin acos atan atan2.
struct Expression {
  enum class Kind : unsigned char { number, name, call };

  Kind kind = Kind::number;
  double number = 0;
  std::string name;  ///< of a parameter, an operator or a function; of a number, its text
  std::vector<Expression> arguments;
  Operation operation = Operation::other;  ///< of a call
  std::size_t column = 1;  ///< where it begins; of an operator, where its last operand ends
};

/// A function that a text may call: its name and how many arguments it takes.
struct ExpressionFunction {
  std::string_view name;
  std::size_t arguments;
  Operation operation = Operation::other;
  bool may_be_name = false;  ///< a name, too, where no bracket follows
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

/// The operation on its one argument. `Scalar` needs the operators and functions by
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

/// The operation on its two arguments.
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

/// Evaluates with `value_of(name)` for names. `Scalar` is made from a double. Functions of the
/// caller's own are not known here.
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
    using std::pow;  // without a derivative by the exponent
    return Scalar(pow(first, constant_value(expression.arguments[1])));
  }
  return applied<Scalar>(expression.operation, first,
                         evaluate<Scalar>(expression.arguments[1], value_of));
}

}  // namespace assur::text
