#include "emission/cpp/statement_text.hpp"

#include <assur/text/identifiers.hpp>
#include <assur/text/names.hpp>
#include <cmath>
#include <iterator>
#include <map>

#include "emission/cpp/cpp_text.hpp"

namespace assur::generator::emission::cpp {

namespace {

using Form = Expression::Form;

class Printer {
 public:
  [[nodiscard]] std::string text(const Expression& one) const {
    switch (one.form) {
      case Form::number:
        return (one.value < 0 ? "-" : "") + ("Scalar(" + round_trip(std::abs(one.value)) + ")");
      case Form::word:
      case Form::variable:
        return one.text;
      case Form::local:
        return locals_.at(one.local);
      case Form::member:
        return text(one.parts[0]) + "." + one.text;
      case Form::entry:
        return text(one.parts[0]) + "(" + list(one.parts, 1, ", ") + ")";
      case Form::item:
        return text(one.parts[0]) + "[" + one.text + "]";
      case Form::call:
        return one.name.text + "(" + list(one.parts, 0, ", ") + ")";
      case Form::braces:
        return one.name.text + "{" + list(one.parts, 0, ", ") + "}";
      case Form::address:
        return "&" + text(one.parts[0]);
      case Form::parentheses:
        return "(" + text(one.parts[0]) + ")";
      case Form::negative:
        return "-" + operand(one.parts[0], {Form::sum, Form::infix});
      case Form::sum:
        return sum(one);
      case Form::product:
        return text::joined(one.parts, " * ", [this](const Expression& factor) {
          return operand(factor, {Form::sum, Form::infix});
        });
      case Form::quotient:
        return operand(one.parts[0], {Form::sum, Form::infix}) + " / " +
               operand(one.parts[1], {Form::sum, Form::infix, Form::product, Form::quotient});
      case Form::infix:
        return list(one.parts, 0, one.text);
    }
    return "";
  }

  /// The lines of a statement; its comment follows on the same line if there is room.
  void add(const Statement& statement, std::vector<std::string>& lines) {
    if (statement.type && statement.target->form == Form::local) {
      name(*statement.target);
    }
    std::string line = statement.type ? statement.type->text + " " : "";
    line += statement.is_result ? "return " : "";
    line += statement.target ? text(*statement.target) : "";
    line += statement.target && statement.value ? " = " : "";
    line += (statement.value ? text(*statement.value) : "") + ";";
    if (!statement.comment.empty()) {
      const std::string comment = "// " + statement.comment;
      if (indentation + line.size() + comment.size() + 2 <= line_width) {
        line += "  " + comment;
      } else {
        lines.push_back(comment);
      }
    }
    lines.push_back(line);
  }

 private:
  /// For the body of a function in a nested struct.
  static constexpr std::size_t indentation = 6;

  void name(const Expression& local) {
    taken_.push_back(text::member_names({local.text}, taken_).front());
    locals_[local.local] = taken_.back();
  }

  [[nodiscard]] std::string list(const std::vector<Expression>& parts, std::ptrdiff_t from,
                                 const std::string& between) const {
    const std::vector<Expression> some(std::next(parts.begin(), from), parts.end());
    return text::joined(some, between, [this](const Expression& part) { return text(part); });
  }

  /// A part, in parentheses if it has one of these forms.
  [[nodiscard]] std::string operand(const Expression& part, const std::vector<Form>& weaker) const {
    for (const Form form : weaker) {
      if (part.form == form) {
        return "(" + text(part) + ")";
      }
    }
    return text(part);
  }

  [[nodiscard]] std::string sum(const Expression& one) const {
    std::string result = text(one.parts.front());
    for (auto term = std::next(one.parts.begin()); term != one.parts.end(); ++term) {
      const bool is_negative =
          term->form == Form::negative || (term->is_number() && term->value < 0);
      result += is_negative ? " - " + operand(negative(*term), {Form::sum}) : " + " + text(*term);
    }
    return result;
  }

  std::vector<std::string> taken_;
  std::map<int, std::string> locals_;
};

}  // namespace

std::string printed(const Expression& expression) { return Printer().text(expression); }

std::vector<std::string> printed(const Block& block) {
  Printer printer;
  std::vector<std::string> lines;
  for (const Statement& statement : block) {
    printer.add(statement, lines);
  }
  return lines;
}

}  // namespace assur::generator::emission::cpp
