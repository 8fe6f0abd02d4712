#include "audit/numeric_example.hpp"

#include <algorithm>
#include <assur/text/suggestion.hpp>
#include <charconv>
#include <cmath>
#include <sstream>

#include "closures/read_formula.hpp"

namespace assur::generator::audit {

namespace {

constexpr double rounding = 1e-9;  // relative, of numbers computed in double

std::string shown(double value) {
  std::ostringstream text;
  text.precision(10);
  text << value;
  return text.str();
}

void collect_names(const text::Expression& node, std::vector<const text::Expression*>& names) {
  if (node.kind == text::Expression::Kind::name) {
    names.push_back(&node);
  }
  for (const text::Expression& argument : node.arguments) {
    collect_names(argument, names);
  }
}

bool close(double value, double other, double half_unit) {
  return std::abs(value - other) <= half_unit * (1 + 1e-6) + rounding * std::abs(other);
}

}  // namespace

void NumericExample::define(const std::string& name, double value) {
  values_[name] = {value, value, 0, false};
}

NumericExample::Value NumericExample::read_number(const closures::PlacedText& number) {
  if (number.empty()) {
    throw closures::FormulaError("a number is missing", number.place);
  }
  double value = 0;
  const char* begin = number.text.data();
  const char* const last = begin + number.text.size();
  const auto [end, error] = std::from_chars(begin, last, value);
  if (error != std::errc() || end != last) {
    throw closures::FormulaError("expected a number, found '" + number.text + "'", number.place);
  }
  const std::size_t mark = number.text.find_first_of("eE");
  const std::string digits = number.text.substr(0, mark);
  const std::size_t point = digits.find('.');
  const std::string decimals = point == std::string::npos ? "" : digits.substr(point + 1);
  int exponent = 0;
  if (mark != std::string::npos) {
    const char* const sign = number.text.data() + mark + 1;
    if (std::from_chars(sign + (*sign == '+' ? 1 : 0), last, exponent).ec != std::errc()) {
      throw closures::FormulaError("the exponent of '" + number.text + "' is out of range",
                                   number.place);
    }
  }
  return {value, value, 0.5 * std::pow(10.0, exponent - std::ssize(decimals)), true};
}

void NumericExample::give(const std::string& name, const closures::PlacedText& number) {
  values_[name] = read_number(number);
  values_[name].half_unit = 0;  // a given 300 mm is exact, not 299.5 to 300.5
}

/// Throws ExpressionError, also for an unknown name.
text::Expression NumericExample::read_tree(const closures::PlacedText& formula) const {
  text::Expression tree = text::parse_expression(formula.text);
  std::vector<const text::Expression*> used;
  collect_names(tree, used);
  for (const text::Expression* node : used) {
    if (!is_known(node->name)) {
      std::vector<std::string> names;
      for (const auto& [known, value] : values_) {
        names.push_back(known);
      }
      throw text::ExpressionError(
          "no quantity named '" + node->name + "'" + text::suggestion_or_choice(node->name, names),
          node->column);
    }
  }
  return tree;
}

void NumericExample::define(const std::string& name, const closures::PlacedText& formula) {
  try {
    define(name, evaluate(read_tree(formula), Reading::derived));
  } catch (const text::ExpressionError& error) {
    throw closures::FormulaError(error.what(), formula.at(error.column));
  }
}

double NumericExample::evaluate(const text::Expression& formula, Reading reading,
                                const std::map<std::string, double>& replaced) const {
  return text::evaluate<double>(formula, [&](const std::string& name) {
    if (const auto other = replaced.find(name); other != replaced.end()) {
      return other->second;
    }
    const Value& value = values_.at(name);
    return reading == Reading::printed && value.is_printed ? value.printed : value.derived;
  });
}

Finding NumericExample::audit(const std::string& name, const closures::PlacedText& number,
                              const closures::PlacedText& formula) {
  Value result = read_number(number);
  Finding finding{name, number.place, {}, number.text, "", ""};
  text::Expression tree;
  try {
    tree = read_tree(formula);
  } catch (const text::ExpressionError& error) {
    finding.place = formula.at(error.column);
    finding.comparison = {Verdict::unreadable, error.what(), "", ""};
    return finding;
  }
  result.derived = evaluate(tree, Reading::derived);
  finding.derived = shown(result.derived);
  Comparison& comparison = finding.comparison;
  comparison.evidence = "to half a unit of the last digit";
  if (!std::isfinite(result.derived)) {
    comparison = {Verdict::undecided, "the formula has no finite value", "", ""};
  } else if (close(result.printed, result.derived, result.half_unit)) {
    comparison.verdict = Verdict::agrees;
  } else {
    const bool sign = close(-result.printed, result.derived, result.half_unit);
    comparison.verdict = sign ? Verdict::differs_by_sign : Verdict::differs;
    comparison.difference = shown(result.printed - result.derived);
    finding.note = explanation(tree, result);
  }
  values_[name] = result;
  return finding;
}

/// Names the printed numbers that yield the printed result, or the one that would have to differ.
std::string NumericExample::explanation(const text::Expression& formula,
                                        const Value& result) const {
  std::vector<const text::Expression*> used;
  collect_names(formula, used);
  std::vector<std::string> inputs;
  for (const text::Expression* node : used) {
    const bool fresh = std::find(inputs.begin(), inputs.end(), node->name) == inputs.end();
    if (fresh && values_.at(node->name).is_printed) {
      inputs.push_back(node->name);
    }
  }
  if (inputs.empty()) {
    return "";
  }
  std::string culprits;
  for (const std::string& name : inputs) {
    const Value& value = values_.at(name);
    const double with_it = evaluate(formula, Reading::derived, {{name, value.printed}});
    if (close(result.printed, with_it, result.half_unit)) {
      culprits += (culprits.empty() ? "" : ", or from ") + name + " = " + shown(value.printed) +
                  " as printed (derived " + shown(value.derived) + ")";
    }
  }
  if (!culprits.empty()) {
    return "follows from " + culprits;
  }
  const double from_print = evaluate(formula, Reading::printed);
  if (close(result.printed, from_print, result.half_unit)) {
    return "follows from the printed numbers together";
  }
  double slack = result.half_unit;
  for (const std::string& name : inputs) {
    const Value& value = values_.at(name);
    const double moved =
        evaluate(formula, Reading::printed, {{name, value.printed + value.half_unit}});
    slack += std::abs(moved - from_print);
  }
  if (close(result.printed, from_print, slack)) {
    return "follows from the printed numbers within their rounding";
  }
  return "the printed numbers give " + shown(from_print) +
         needed_inputs(formula, result.printed, inputs);
}

/// For each input, the value that would yield the printed result.
std::string NumericExample::needed_inputs(const text::Expression& formula, double result,
                                          const std::vector<std::string>& inputs) const {
  std::string text;
  for (const std::string& name : inputs) {
    const auto off = [&](double value) {
      return evaluate(formula, Reading::printed, {{name, value}}) - result;
    };
    double last = values_.at(name).printed;
    double next = last == 0 ? 1e-3 : last * (1 + 1e-3);
    double last_off = off(last);
    for (int step = 0; step < 60; ++step) {  // secant
      const double next_off = off(next);
      if (next_off == last_off || !std::isfinite(next_off)) {
        break;
      }
      const double after = next - next_off * (next - last) / (next_off - last_off);
      last = next;
      last_off = next_off;
      next = after;
    }
    if (std::isfinite(next) && std::abs(off(next)) <= 1e-9 * (1 + std::abs(result))) {
      text +=
          (text.empty() ? "; it would be right with " : ", or with ") + name + " = " + shown(next);
    }
  }
  return text;
}

}  // namespace assur::generator::audit
