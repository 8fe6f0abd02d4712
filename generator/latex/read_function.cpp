// Reads functions with their powers and arguments.
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "latex/formula_reader.hpp"
#include "latex/rows.hpp"

namespace assur::generator::latex {

struct Function {
  std::string_view command;
  std::string_view name;
  Operation operation;
};
namespace {

constexpr std::array<Function, 12> functions = {{{"\\sin", "sin", Operation::sin},
                                                 {"\\cos", "cos", Operation::cos},
                                                 {"\\tan", "tan", Operation::tan},
                                                 {"\\cot", "cot", Operation::tan},
                                                 {"\\arcsin", "asin", Operation::asin},
                                                 {"\\arccos", "acos", Operation::acos},
                                                 {"\\arctan", "atan", Operation::atan},
                                                 {"atan2", "atan2", Operation::atan2},
                                                 {"atan_{2}", "atan2", Operation::atan2},
                                                 {"asin", "asin", Operation::asin},
                                                 {"acos", "acos", Operation::acos},
                                                 {"atan", "atan", Operation::atan}}};

bool is_word(const Token& token) {
  return token.is("\\operatorname") || token.is("\\mathrm") || token.is("\\text");
}

/// Returns the name of a function that is a word, `\operatorname{atan}_{2}` with its subscript, and
/// moves `at` past it.
std::string take_word(const Tokens& tokens, std::size_t& at) {
  std::string name = letters_of(take_argument(tokens, ++at));
  if (name == "atan" && at < tokens.size() && tokens[at].is("_")) {
    std::size_t behind = at + 1;
    if (letters_of(take_argument(tokens, behind)) == "2") {
      at = behind;
      return "atan2";
    }
  }
  return name == "arcsin" || name == "arccos" || name == "arctan" ? "\\" + name : name;
}

}  // namespace

const Function* FormulaReader::find_function(std::size_t at) const {
  std::string name = tokens_[at].text;
  if (is_word(tokens_[at])) {
    std::size_t behind = at;
    name = take_word(tokens_, behind);
  } else if (!tokens_[at].is_command()) {
    return nullptr;
  }
  const auto* const found =
      std::find_if(functions.begin(), functions.end(),
                   [&](const Function& function) { return function.command == name; });
  return found == functions.end() ? nullptr : &*found;
}

Factor FormulaReader::called(const Function& function) {
  const std::size_t at = at_;
  if (is_word(tokens_[at])) {
    static_cast<void>(take_word(tokens_, at_));
  } else {
    ++at_;
  }
  Tokens power;
  if (at_ < tokens_.size() && tokens_[at_].is("^")) {
    power = take_argument(tokens_, ++at_);
    if (std::any_of(power.begin(), power.end(),
                    [](const Token& token) { return !token.is_digit(); })) {
      fail("only whole powers of functions are clear; write brackets around the function", at);
    }
    // Whether the function and its argument are one notation of the map.
    Tokens without{tokens_[at]};
    without.insert(without.end(), tokens_.begin() + static_cast<std::ptrdiff_t>(at_),
                   tokens_.end());
    if (const std::optional<Meaning> meaning = reading_.notations.at(without, 0);
        meaning && meaning->dots == 0 && meaning->power.empty()) {
      Expression base = formula_of(*meaning, at);
      at_ += meaning->end - 1;
      return {powered(std::move(base), power, at), FactorKind::symbol};
    }
  }
  skip_spaces();
  auto [arguments, bare] = function_arguments(function, at);
  Expression tree =
      function.name == "cot"
          ? binary("/", Operation::divide, number_tree("1", at),
                   call("tan", Operation::tan, std::move(arguments), at), at)
          : call(std::string(function.name), function.operation, std::move(arguments), at);
  if (!power.empty()) {
    tree = powered(std::move(tree), power, at);
  }
  return {std::move(tree), bare ? FactorKind::bare_function : FactorKind::closed};
}

std::pair<std::vector<Expression>, bool> FormulaReader::function_arguments(const Function& function,
                                                                           std::size_t at) {
  if (at_ >= tokens_.size()) {
    fail("the function has no argument", at);
  }
  std::vector<Expression> list;
  unwrap_brackets();
  if (opens(tokens_[at_])) {
    const std::size_t open = at_;
    const Tokens inside = take_brackets();
    std::vector<Tokens> arguments(1);
    int depth = 0;
    for (const Token& token : inside) {
      depth += token.is("{") || opens(token) ? 1 : 0;
      depth -= token.is("}") || closes(token) ? 1 : 0;
      if (depth == 0 && token.is(",")) {
        arguments.emplace_back();
      } else {
        arguments.back().push_back(token);
      }
    }
    if (arguments.size() != (function.operation == Operation::atan2 ? 2U : 1U)) {
      fail(std::string(function.name) + " takes another number of arguments", open);
    }
    for (const Tokens& argument : arguments) {
      list.push_back(read(argument, open));
    }
    return {std::move(list), false};
  }
  if (function.operation == Operation::atan2) {
    fail("atan2 needs brackets", at_);
  }
  list.push_back(bare_argument());
  return {std::move(list), true};
}

void FormulaReader::unwrap_brackets() {
  if (!tokens_[at_].is("{")) {
    return;
  }
  const std::size_t end = end_of_argument(tokens_, at_) - 1;
  std::size_t inside = at_ + 1;
  if (inside < end && opens(tokens_[inside])) {
    const std::size_t before = std::exchange(at_, inside);
    static_cast<void>(take_brackets());
    inside = std::exchange(at_, before);
    if (inside == end) {
      tokens_.erase(tokens_.begin() + static_cast<std::ptrdiff_t>(end));
      tokens_.erase(tokens_.begin() + static_cast<std::ptrdiff_t>(at_));
    }
  }
}

Expression FormulaReader::bare_argument() {
  const std::size_t at = at_;
  if (tokens_[at_].is_digit()) {
    Expression factor_tree = number();
    skip_spaces();
    const bool goes_on =
        at_ < tokens_.size() && (read_atom(tokens_, at_) || tokens_[at_].is("\\pi"));
    return goes_on ? binary("*", Operation::multiply, std::move(factor_tree), bare_symbol(), at)
                   : std::move(factor_tree);
  }
  if (is_fraction(tokens_[at_])) {
    return fraction();
  }
  return bare_symbol();
}

Expression FormulaReader::bare_symbol() {
  if (tokens_[at_].is("\\pi")) {
    return std::move(factor().tree);
  }
  const std::optional<Meaning> meaning = reading_.notations.at(tokens_, at_);
  if (!meaning) {
    if (read_atom(tokens_, at_)) {
      refuse(tokens_[at_]);
    }
    fail("the function's argument is not clear; write brackets", at_);
  }
  if (!meaning->power.empty()) {
    fail("is the function raised or its argument? write \\sin^2 x, or brackets", at_);
  }
  return quantity(*meaning);
}

}  // namespace assur::generator::latex
