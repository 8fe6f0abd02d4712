#include "emission/cpp/cpp_text.hpp"

#include <algorithm>
#include <array>
#include <assur/text/names.hpp>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <sstream>

namespace assur::generator::emission::cpp {

namespace {

using Operation = program::ExpressionGraph::Operation;

constexpr int small = 1000000;  ///< whole numbers below this are printed as such

/// A number that is a product of named constants.
struct ConstantProduct {
  GiNaC::numeric factor;
  std::vector<std::string> names;
};

/// A coefficient as a product of named constants; empty if it is not one, or if rounding to double
/// would change it.
std::optional<ConstantProduct> constant_product(const program::Coefficient& coefficient,
                                                const program::SymbolOrder& order) {
  ConstantProduct product{1, {}};
  bool is_product = true;
  std::vector<program::SymbolRank> ranks;
  const auto multiply = [&](const GiNaC::ex& factor) {
    const bool power =
        GiNaC::is_a<GiNaC::power>(factor) && factor.op(1).info(GiNaC::info_flags::posint);
    const GiNaC::ex base = power ? factor.op(0) : factor;
    if (GiNaC::is_a<GiNaC::numeric>(factor)) {
      product.factor *= GiNaC::ex_to<GiNaC::numeric>(factor);
    } else if (GiNaC::is_a<GiNaC::symbol>(base)) {
      const int times = power ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int() : 1;
      ranks.insert(ranks.end(), static_cast<std::size_t>(times),
                   order.rank(GiNaC::ex_to<GiNaC::symbol>(base)));
    } else {
      is_product = false;
    }
  };
  const GiNaC::ex& origin = coefficient.origin();
  if (GiNaC::is_a<GiNaC::mul>(origin)) {
    std::for_each(origin.begin(), origin.end(), multiply);
  } else {
    multiply(origin);
  }
  if (!is_product || ranks.empty()) {
    return std::nullopt;
  }
  std::sort(ranks.begin(), ranks.end());
  GiNaC::numeric partial = product.factor;
  bool rounded = !is_double(partial);
  for (const program::SymbolRank rank : ranks) {
    product.names.push_back(order.name(rank));
    const GiNaC::numeric value = *order.constant(product.names.back());
    partial *= value;
    rounded = rounded || !is_double(value) || !is_double(partial);
  }
  return rounded ? std::nullopt : std::optional(product);
}

/// The named constant that equals a coefficient up to its sign, if no double equals it.
std::optional<GiNaC::symbol> quotient(const program::Coefficient& coefficient,
                                      const program::SymbolOrder& order) {
  for (const GiNaC::ex& origin : {coefficient.origin(), GiNaC::ex(-coefficient.origin())}) {
    if (GiNaC::is_a<GiNaC::symbol>(origin) && !is_double(*order.number(origin))) {
      return GiNaC::ex_to<GiNaC::symbol>(origin);
    }
  }
  return std::nullopt;
}

/// The coefficients of all computations of a program.
std::vector<program::Coefficient> coefficients_of(const program::Program& program) {
  std::vector<program::Coefficient> list;
  for (const program::ScaledNode& value : program.values()) {
    list.push_back(value.coefficient);
  }
  for (const program::NodeIndex node : program.computed()) {
    for (const program::ScaledNode& term : program.graph().nodes()[node].terms) {
      list.push_back(term.coefficient);
    }
  }
  return list;
}

class CppText {
 public:
  CppText(const program::Program& program, const Spelling& spelling)
      : program_(program), spelling_(spelling) {}

  [[nodiscard]] std::string scaled(const program::ScaledNode& value) const {
    const Number number = number_of(value.coefficient);
    const bool scales = value.coefficient.scales();
    if (!scales && program_.name_of(value.node).empty() &&
        content(value.node).operation == Operation::sum) {
      return sum(value.node, number.negative);
    }
    std::string text = number.negative ? "-" : "";
    if (content(value.node).operation == Operation::constant) {
      return text.append(number.text);
    }
    if (scales) {
      text.append(number.text).append(" * ");
    }
    return text.append(operand(value.node, scales || number.negative));
  }

  /// The right-hand side of the step that computes a node itself.
  [[nodiscard]] std::string computed(const program::Program::Step& step) const {
    if (step.form == equations::NamedQuantity::Form::square_root) {
      return "sqrt(" + scaled(step.value) + ")";
    }
    if (step.form == equations::NamedQuantity::Form::reciprocal) {
      const bool simple = !program_.name_of(step.value.node).empty();
      return "Scalar(1) / " + (simple ? scaled(step.value) : "(" + scaled(step.value) + ")");
    }
    if (program_.name_of(step.value.node) == step.name) {
      return expression(step.value.node);
    }
    return scaled(step.value);
  }

  /// Declares each named constant that no double equals.
  void add_quotients(FilledLines& lines) const {
    std::map<std::string, GiNaC::numeric> values;
    const program::SymbolOrder& order = program_.graph().order();
    for (const program::Coefficient& coefficient : coefficients_of(program_)) {
      if (const auto name = quotient(coefficient, order)) {
        values[name->get_name()] = *order.number(*name);
      }
    }
    for (const auto& [name, value] : values) {
      lines.declare(name, (value.is_negative() ? "-" : "") + literal(GiNaC::abs(value)));
    }
  }

 private:
  [[nodiscard]] const program::ExpressionGraph::Node& content(program::NodeIndex node) const {
    return program_.graph().nodes()[node];
  }

  /// A number in C++, and whether a minus sign precedes it.
  struct Number {
    bool negative;
    std::string text;
  };

  /// A product of named constants by their names, any other number by its digits.
  [[nodiscard]] Number number_of(const program::Coefficient& coefficient) const {
    if (const auto product = constant_product(coefficient, program_.graph().order())) {
      std::vector<std::string> factors = product->names;
      const GiNaC::numeric size = GiNaC::abs(product->factor);
      if (size != 1) {
        factors.insert(factors.begin(), digits(size));
      }
      return {product->factor.is_negative(), "Scalar(" + text::joined(factors, " * ") + ")"};
    }
    if (const auto name = quotient(coefficient, program_.graph().order())) {
      return {!coefficient.origin().is_equal(*name), name->get_name()};
    }
    return {coefficient.is_negative(), literal(coefficient.size().value())};
  }

  /// A number that equals a double is written in digits, and one like a third as a quotient. Any
  /// other is the sum of the nearest double and the double nearest to the remainder, so that its
  /// error in double-double arithmetic is that of one operation.
  static std::string literal(const GiNaC::numeric& number) {
    if (is_double(number)) {
      return "Scalar(" + digits(number) + ")";
    }
    if (number.numer() < small && number.denom() < 10) {
      return "Scalar(" + digits(number.numer()) + ") / Scalar(" + digits(number.denom()) + ")";
    }
    const GiNaC::numeric rest = number - exact(number.to_double());
    return "constant<Scalar>(" + round_trip(number.to_double()) + ", " +
           round_trip(rest.to_double()) + ")";
  }

  /// A number that equals a double.
  static std::string digits(const GiNaC::numeric& number) {
    return number.is_integer() && number < small ? std::to_string(number.to_int())
                                                 : round_trip(number.to_double());
  }

  [[nodiscard]] std::string operand(program::NodeIndex node, bool inside_product) const {
    if (!program_.name_of(node).empty()) {
      return spelling_(program_.name_of(node));
    }
    const bool bracketed = inside_product && content(node).operation == Operation::sum;
    std::string text = bracketed ? "(" : "";
    return text.append(expression(node)).append(bracketed ? ")" : "");
  }

  [[nodiscard]] std::string expression(program::NodeIndex node) const {
    const program::ExpressionGraph::Node& at = content(node);
    if (at.operation == Operation::constant) {
      return literal(1);
    }
    if (at.operation == Operation::product) {
      std::vector<program::NodeIndex> factors = at.factors;
      std::stable_sort(
          factors.begin(), factors.end(), [&](program::NodeIndex left, program::NodeIndex right) {
            return program_.graph().measure(left).place() < program_.graph().measure(right).place();
          });
      std::string text;
      for (const program::NodeIndex factor : factors) {
        text.append(text.empty() ? "" : " * ").append(operand(factor, true));
      }
      return text;
    }
    return sum(node, false);
  }

  /// A sum or its negative, with a positive term in front if it has one.
  [[nodiscard]] std::string sum(program::NodeIndex node, bool negated) const {
    std::vector<std::string> parts;
    for (const program::ScaledNode& term : content(node).terms) {
      parts.push_back(scaled({negated ? -term.coefficient : term.coefficient, term.node}));
    }
    std::stable_partition(parts.begin(), parts.end(),
                          [](const std::string& part) { return part.front() != '-'; });
    std::string text;
    for (const std::string& part : parts) {
      if (text.empty()) {
        text = part;
      } else if (part.front() == '-') {
        text.append(" - ").append(part.substr(1));
      } else {
        text.append(" + ").append(part);
      }
    }
    return text;
  }

  const program::Program& program_;
  const Spelling& spelling_;
};

/// Whether one of these operators, between spaces, is at the position.
bool is_operator(const std::string& line, std::size_t place, std::string_view operators) {
  return place > 0 && place + 1 < line.size() && line[place - 1] == ' ' && line[place + 1] == ' ' &&
         operators.find(line[place]) != std::string_view::npos;
}

/// The last position within the line width at which code may be broken: at a space after a comma or
/// before an operator, or else at any space after `start`.
std::size_t break_of_code(const std::string& line, std::size_t start) {
  std::size_t any = std::string::npos;
  std::size_t good = std::string::npos;
  int angles = 0;  // a break inside template arguments reads badly
  for (std::size_t at = start; at < line.size() && at <= line_width; ++at) {
    angles += line[at] == '<' ? 1 : line[at] == '>' ? -1 : 0;
    if (line[at] != ' ') {
      continue;
    }
    any = at;
    if ((line[at - 1] == ',' && angles == 0) || is_operator(line, at + 1, "+-")) {
      good = at;
    }
  }
  return good == std::string::npos ? any : good;
}

/// The last position in the second half of the line width at which a comment may be broken: at a
/// space outside formulas, or before a plus or minus; else at any space after `start`.
std::size_t break_of_comment(const std::string& line, std::size_t start) {
  std::size_t any = std::string::npos;
  std::size_t before_term = 0;
  std::size_t outside = 0;
  int parentheses = 0;
  for (std::size_t at = start; at < line.size() && at <= line_width; ++at) {
    parentheses += line[at] == '(' ? 1 : line[at] == ')' ? -1 : 0;
    if (line[at] != ' ') {
      continue;
    }
    any = at;
    constexpr std::string_view operators = "+-*/=";
    if (is_operator(line, at + 1, "+-")) {
      before_term = at;
    } else if (parentheses == 0 && !is_operator(line, at - 1, operators) &&
               !is_operator(line, at + 1, operators)) {
      outside = at;
    }
  }
  constexpr std::size_t half = line_width / 2;
  return outside > half ? outside : before_term > half ? before_term : any;
}

}  // namespace

GiNaC::numeric exact(double value) {
  constexpr int digits = std::numeric_limits<double>::digits;
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  const auto whole = static_cast<long>(std::ldexp(mantissa, digits));
  return GiNaC::numeric(whole) * GiNaC::pow(GiNaC::numeric(2), GiNaC::numeric(exponent - digits));
}

bool is_double(const GiNaC::numeric& number) { return number == exact(number.to_double()); }

std::string round_trip(double value) {
  std::array<char, 32> text{};
  const double unsigned_zero = value + 0.0;  // -0.0 + 0.0 is 0.0, any other number is unchanged
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), unsigned_zero);
  std::string digits(text.data(), end);
  return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
}

void add_program(const program::Program& program, const Spelling& spelling, FilledLines& lines) {
  add_steps(program, spelling, lines);
  add_assignments(program, spelling, lines);
}

void add_steps(const program::Program& program, const Spelling& spelling, FilledLines& lines) {
  const CppText text(program, spelling);
  text.add_quotients(lines);
  for (const program::Program::Step& step : program.steps()) {
    const bool root = step.form == equations::NamedQuantity::Form::square_root;
    const std::string value = text.computed(step);
    if (step.degeneracy.empty()) {
      lines.declare(step.name, value);
      continue;
    }
    const std::string comment =
        "// " +
        std::string(root ? "Where the radicand is not positive, " : "A zero divisor means ") +
        step.degeneracy + ".";
    const std::string statement = "const Scalar " + step.name + " = " + value + ";";
    if (statement.size() + comment.size() + 2 > line_width - body_indentation) {
      lines.add(comment);
      lines.add(statement);
    } else {
      lines.add(statement + "  " + comment);
    }
  }
}

void add_assignments(const program::Program& program, const Spelling& spelling,
                     FilledLines& lines) {
  const CppText text(program, spelling);
  for (const program::Program::Assignment& assignment : program.assignments()) {
    lines.assign(assignment.target, text.scaled(assignment.value));
  }
}

std::set<std::string> constants_of(const program::Program& program) {
  std::set<std::string> names;
  for (const program::Coefficient& coefficient : coefficients_of(program)) {
    if (const auto product = constant_product(coefficient, program.graph().order())) {
      names.insert(product->names.begin(), product->names.end());
    }
  }
  return names;
}

std::string fitted_to_width(const std::string& text) {
  std::string fitted;
  std::istringstream in(text);
  std::string line;
  while (std::getline(in, line)) {
    const std::size_t indentation = line.find_first_not_of(' ');
    const std::size_t slash = line.find("//");
    const bool comment = slash != std::string::npos;
    const bool directive = line.starts_with('#');  // ends with its line
    const std::string slashes =
        comment ? std::string(slash, ' ') + line.substr(slash, line.find(' ', slash) - slash) : "";
    while (line.size() > line_width && !directive) {
      const std::string lead = comment ? slashes + "     " : std::string(indentation + 4, ' ');
      const std::size_t start = std::max(lead.size(), indentation + 1);
      const std::size_t at = comment ? break_of_comment(line, start) : break_of_code(line, start);
      if (at == std::string::npos) {
        break;
      }
      fitted += line.substr(0, at) + "\n";
      line = lead + line.substr(at + 1);
    }
    fitted += line + "\n";
  }
  return fitted;
}

}  // namespace assur::generator::emission::cpp
