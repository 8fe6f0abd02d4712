#include "emission/cpp/cpp_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

namespace assur::generator::emission::cpp {

namespace {

using Operation = program::ExpressionGraph::Operation;

constexpr std::size_t line_width = 100;
constexpr int small = 1000000;  ///< whole numbers below this are printed as such

class CppText {
 public:
  CppText(const program::Program& program, const Spelling& spelling)
      : program_(program), spelling_(spelling) {}

  [[nodiscard]] std::string scaled(const program::ScaledNode& value) const {
    const bool negative = value.coefficient.is_negative();
    const GiNaC::numeric size = GiNaC::abs(value.coefficient);
    if (size == 1 && program_.name_of(value.node).empty() &&
        content(value.node).operation == Operation::sum) {
      return sum(value.node, negative);
    }
    std::string text = negative ? "-" : "";
    if (content(value.node).operation == Operation::constant) {
      return text.append(literal(size));
    }
    if (size != 1) {
      text.append(literal(size)).append(" * ");
    }
    return text.append(operand(value.node, size != 1 || negative));
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

 private:
  [[nodiscard]] const program::ExpressionGraph::Node& content(program::NodeIndex node) const {
    return program_.graph().nodes()[node];
  }

  /// A small whole number and what a double holds as they are, a third and the like as a quotient;
  /// any other by the double nearest to it and the double nearest to what is left: so that the
  /// number is as exact in double-double arithmetic as the operations are.
  static std::string literal(const GiNaC::numeric& number) {
    if (number.is_integer() && number < small) {
      return "Scalar(" + whole(number) + ")";
    }
    const double high = number.to_double();
    const GiNaC::numeric rest = number - exact(high);
    if (rest.is_zero()) {
      return "Scalar(" + round_trip(high) + ")";
    }
    if (number.numer() < small && number.denom() < 10) {
      return "Scalar(" + whole(number.numer()) + ") / Scalar(" + whole(number.denom()) + ")";
    }
    return "constant<Scalar>(" + round_trip(high) + ", " + round_trip(rest.to_double()) + ")";
  }

  static std::string whole(const GiNaC::numeric& number) { return std::to_string(number.to_int()); }

  [[nodiscard]] std::string operand(program::NodeIndex node, bool inside_product) const {
    if (!program_.name_of(node).empty()) {
      return content(node).operation == Operation::symbol ? spelling_(program_.name_of(node))
                                                          : program_.name_of(node);
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
      std::string text;
      for (const program::NodeIndex factor : at.factors) {
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

/// The last place up to `width` where a line may be broken: before a space that follows a comma or
/// goes before an operator, else before any space behind the indentation.
std::size_t break_position(const std::string& line, std::size_t start, bool comment) {
  std::size_t any = std::string::npos;
  std::size_t good = std::string::npos;
  int angles = 0;  // a break inside template arguments reads badly
  for (std::size_t at = start; at < line.size() && at <= line_width; ++at) {
    angles += line[at] == '<' ? 1 : line[at] == '>' ? -1 : 0;
    if (line[at] != ' ') {
      continue;
    }
    any = at;
    const bool before_operator =
        at + 2 < line.size() && line[at + 2] == ' ' && (line[at + 1] == '+' || line[at + 1] == '-');
    if ((line[at - 1] == ',' && angles == 0) || before_operator) {
      good = at;
    }
  }
  return comment || good == std::string::npos ? any : good;
}

}  // namespace

GiNaC::numeric exact(double value) {
  constexpr int digits = std::numeric_limits<double>::digits;
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  const auto whole = static_cast<long>(std::ldexp(mantissa, digits));
  return GiNaC::numeric(whole) * GiNaC::pow(GiNaC::numeric(2), GiNaC::numeric(exponent - digits));
}

std::string round_trip(double value) {
  std::array<char, 32> text{};
  const double unsigned_zero = value + 0.0;  // -0.0 + 0.0 is 0.0, any other number stays itself
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), unsigned_zero);
  std::string digits(text.data(), end);
  return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
}

std::vector<std::string> cpp_lines(const program::Program& program, const Spelling& spelling) {
  const CppText text(program, spelling);
  std::vector<std::string> lines;
  for (const program::Program::Step& step : program.steps()) {
    const bool root = step.form == equations::NamedQuantity::Form::square_root;
    const std::string comment =
        step.degeneracy.empty() ? ""
                                : (root ? "  // not positive: " : "  // zero: ") + step.degeneracy;
    lines.push_back("const Scalar " + step.name + " = " + text.computed(step) + ";" + comment);
  }
  for (const program::Program::Assignment& assignment : program.assignments()) {
    lines.push_back(assignment.target + " = " + text.scaled(assignment.value) + ";");
  }
  return lines;
}

std::string fitted_to_width(const std::string& text) {
  std::string fitted;
  std::istringstream in(text);
  std::string line;
  while (std::getline(in, line)) {
    const std::size_t indentation = line.find_first_not_of(' ');
    const std::size_t slash = line.find("//");
    const bool comment = slash != std::string::npos;
    const std::string slashes =
        comment ? std::string(slash, ' ') + line.substr(slash, line.find(' ', slash) - slash) : "";
    while (line.size() > line_width) {
      const std::string lead = comment ? slashes + "     " : std::string(indentation + 4, ' ');
      const std::size_t at = break_position(line, std::max(lead.size(), indentation + 1), comment);
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
