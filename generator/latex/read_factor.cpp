// Reads the factors of a formula: numbers, quantities, brackets, roots, fractions.
#include <assur/text/quoted.hpp>

#include "latex/formula_reader.hpp"
#include "latex/rows.hpp"

namespace assur::generator::latex {

namespace {

const char* closing_of(const Token& token) {
  return token.is("(") ? ")" : token.is("[") ? "]" : "\\}";
}
bool is_d(const Tokens& tokens, std::size_t at) {
  const std::optional<Atom> atom = read_atom(tokens, at);
  return atom && atom->name == "d";
}

}  // namespace

Expression FormulaReader::raised(Expression base) {
  if (at_ >= tokens_.size() || !tokens_[at_].is("^")) {
    return base;
  }
  const std::size_t mark = at_++;
  return powered(std::move(base), take_argument(tokens_, at_), mark);
}

Expression FormulaReader::powered(Expression base, const Tokens& exponent, std::size_t at) {
  const bool bracketed = exponent.size() == 3 && exponent[0].is("(") && exponent[2].is(")");
  if (bracketed) {
    fail(
        "this may be an index or a power; say in the map what it is, or write the power without "
        "brackets",
        at);
  }
  return binary("^", Operation::power, std::move(base), read(exponent, at), at);
}

Factor FormulaReader::factor() {
  if (at_ >= tokens_.size()) {
    fail("a factor is missing", at_);
  }
  const Token& token = tokens_[at_];
  if (token.is_digit() || token.is(".")) {
    Expression tree = number();
    const bool bare = tree.kind == Expression::Kind::number;
    return {std::move(tree), bare ? FactorKind::number : FactorKind::closed};
  }
  if (const std::optional<Meaning> meaning = reading_.notations.at(tokens_, at_)) {
    return {quantity(*meaning), meaning->power.empty() ? FactorKind::symbol : FactorKind::closed};
  }
  if (const Function* function = find_function(at_)) {
    return called(*function);
  }
  if (opens(token)) {
    Expression inside = bracketed();
    return {raised(std::move(inside)), FactorKind::closed};
  }
  if (is_fraction(token)) {
    Expression fraction_tree = fraction();
    return {raised(std::move(fraction_tree)), FactorKind::closed};
  }
  if (token.is("\\sqrt")) {
    Expression root_tree = root();
    return {raised(std::move(root_tree)), FactorKind::closed};
  }
  if (token.is("\\pi")) {
    const std::size_t at = at_++;
    return {raised({Expression::Kind::number, 0, "pi", {}, Operation::other, column(at)}),
            FactorKind::symbol};
  }
  if (token.is("\\partial")) {
    return {inline_derivative(), FactorKind::closed};
  }
  if (token.is("{")) {
    return group();
  }
  refuse(token);
}

void FormulaReader::refuse(const Token& token) const {
  if (token.is("|") || token.is("\\lvert") || token.is("\\vert")) {
    fail("an absolute value or a determinant is not read", at_);
  }
  if (token.is("\\pm") || token.is("\\mp")) {
    fail("'" + token.text + "' is two statements; write each of them", at_);
  }
  if (token.is("\\begin")) {
    fail("a matrix stands where a number is expected", at_);
  }
  if (const std::optional<Atom> atom = read_atom(tokens_, at_)) {
    fail("no quantity is known as '" + atom->name +
             (atom->superscript.empty() ? "" : "^" + atom->superscript) + "'",
         at_);
  }
  fail(token.is_command() ? token.text + " is not read"
                          : "'" + token.text + "' is not expected here",
       at_);
}

Expression FormulaReader::number() {
  const std::size_t from = at_;
  std::string digits;
  bool point = false;
  while (at_ < tokens_.size() && (tokens_[at_].is_digit() || (tokens_[at_].is(".") && !point))) {
    point = point || tokens_[at_].is(".");
    digits += tokens_[at_++].text;
  }
  if (digits == "." || digits.size() > 40) {
    fail("expected a number", from);
  }
  if (digits.back() == '.') {
    fail("a digit is missing after the point", at_ - 1);
  }
  Expression tree = number_tree(digits, from);
  if (at_ + 1 < tokens_.size() && tokens_[at_].is("^")) {
    std::size_t behind = at_ + 1;
    const Tokens script = take_argument(tokens_, behind);
    if (script.size() == 1 && script[0].is("\\circ")) {
      at_ = behind;
      return binary("*", Operation::multiply, std::move(tree),
                    {Expression::Kind::number, 0, "deg", {}, Operation::other, column(from)}, from);
    }
  }
  return raised(std::move(tree));
}

Expression FormulaReader::quantity(const Meaning& meaning) {
  const std::size_t at = at_;
  at_ = meaning.end;
  Expression tree = formula_of(meaning, at);
  if (meaning.dots > 0) {
    tree = rates(std::move(tree), meaning.dots, at);
  }
  if (!meaning.power.empty()) {
    return powered(std::move(tree), meaning.power, at);
  }
  return tree;
}

Expression FormulaReader::formula_of(const Meaning& meaning, std::size_t at) {
  if (meaning.formula.empty()) {
    return {Expression::Kind::name, 0,         printed_name(meaning.name), {},
            Operation::other,       column(at)};
  }
  spend(meaning.formula.size(), at);
  try {
    Expression tree = text::parse_expression(meaning.formula, closures::formula_functions());
    move_to(tree, column(at));
    return tree;
  } catch (const text::ExpressionError& error) {
    fail("the map has " + text::in_quotes(meaning.formula) + " for this, and " + error.what(), at);
  }
}

void FormulaReader::move_to(Expression& tree, std::size_t column) {
  tree.column = column;
  for (Expression& argument : tree.arguments) {
    move_to(argument, column);
  }
}

Tokens FormulaReader::take_brackets() {
  const std::size_t open = at_;
  int depth = 0;
  for (std::size_t at = open; at < tokens_.size(); ++at) {
    const Token& token = tokens_[at];
    depth += token.is("{") || opens(token) ? 1 : 0;
    depth -= token.is("}") || closes(token) ? 1 : 0;
    if (depth == 0) {
      if (!token.is(closing_of(tokens_[open]))) {
        fail("'" + tokens_[open].text + "' is closed by '" + token.text + "'", at);
      }
      at_ = at + 1;
      return slice(tokens_, open + 1, at);
    }
  }
  fail("'" + tokens_[open].text + "' is not closed", open);
}

Expression FormulaReader::bracketed() {
  const std::size_t open = at_;
  return read(take_brackets(), open);
}

Factor FormulaReader::group() {
  const std::size_t open = at_;
  const Tokens inside = take_argument(tokens_, at_);
  int depth = 0;
  for (const Token& token : inside) {
    depth += token.is("{") || opens(token) ? 1 : 0;
    depth -= token.is("}") || closes(token) ? 1 : 0;
    if (depth == 0 && (token.is("+") || token.is("-")) && inside.size() + 2 < tokens_.size()) {
      fail("braces around a sum are not printed; write brackets", open);
    }
  }
  if (at_ < tokens_.size() && tokens_[at_].is("^")) {
    fail("braces are not printed, so the base of the power is not clear; write brackets", at_);
  }
  return {read(inside, open), FactorKind::symbol};
}

Expression FormulaReader::root() {
  const std::size_t at = at_++;
  std::string degree = "2";
  if (at_ < tokens_.size() && tokens_[at_].is("[")) {
    degree = letters_of(take_brackets());
  }
  const Tokens inside = take_argument(tokens_, at_);
  Expression tree = call("sqrt", Operation::sqrt, {read(inside, at)}, at);
  if (degree != "2") {
    fail("only square roots can be compared", at);
  }
  return tree;
}

Expression FormulaReader::fraction() {
  const std::size_t at = at_++;
  const Tokens above = take_argument(tokens_, at_);
  const Tokens below = take_argument(tokens_, at_);
  if (!above.empty() && !below.empty()) {
    if (above[0].is("\\partial") && below[0].is("\\partial")) {
      return derivative(slice(above, 1, above.size()), slice(below, 1, below.size()), at);
    }
    if (is_d(above, 0) && is_d(below, 0) && below.size() > 1) {
      return total_derivative(above, below, at);
    }
  }
  Expression numerator = read(above, at);
  return binary("/", Operation::divide, std::move(numerator), read(below, at), at);
}

}  // namespace assur::generator::latex
