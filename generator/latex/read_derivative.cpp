// Reads derivatives of any order: partial, total and with respect to time.
#include "latex/formula_reader.hpp"
#include "latex/rows.hpp"

namespace assur::generator::latex {

int FormulaReader::order_of(const std::string& digits, std::size_t at) const {
  if (digits.size() != 1 || digits[0] < '1' || digits[0] > '9') {
    fail("the order of a derivative is a number from 1 to 9", at);
  }
  return digits[0] - '0';
}

FormulaReader::By FormulaReader::read_by(const Tokens& tokens, std::size_t at) {
  for (std::size_t mark = 0; mark < tokens.size(); ++mark) {
    std::size_t behind = mark + 1;
    if (tokens[mark].is("^") && behind < tokens.size()) {
      const std::string digits = letters_of(take_argument(tokens, behind));
      if (behind == tokens.size()) {
        return {read(slice(tokens, 0, mark), at), order_of(digits, at)};
      }
    }
  }
  return {read(tokens, at), 1};
}

Expression FormulaReader::derivative(const Tokens& of, const Tokens& by, std::size_t at) {
  std::size_t behind = 0;
  int order = 1;
  if (!of.empty() && of[0].is("^")) {
    behind = 1;
    order = order_of(letters_of(take_argument(of, behind)), at);
  }
  Expression tree = behind == of.size() ? operand() : read(slice(of, behind, of.size()), at);
  return by_all(
      "derivative", std::move(tree), order, by,
      [](const Tokens& tokens, std::size_t place) {
        return tokens[place].is("\\partial") ? place + 1 : place;
      },
      at);
}

Expression FormulaReader::by_all(const std::string& name, Expression tree, int order,
                                 const Tokens& by, const BehindSign& behind_sign, std::size_t at) {
  for (std::size_t from = 0; from <= by.size();) {
    std::size_t to = from;
    while (to < by.size() && behind_sign(by, to) == to) {
      ++to;
    }
    const By one = read_by(slice(by, from, to), at);
    for (int time = 0; time < one.times; ++time) {
      tree = binary(name, Operation::other, std::move(tree), one.symbol, at);
    }
    order -= one.times;
    from = to == by.size() ? to + 1 : behind_sign(by, to);
  }
  if (order != 0) {
    fail("the orders of this derivative above and below the bar differ", at);
  }
  return tree;
}

Expression FormulaReader::inline_derivative() {
  const std::size_t at = at_++;
  const std::optional<Meaning> of =
      at_ < tokens_.size() ? reading_.notations.at(tokens_, at_) : std::nullopt;
  if (!of || of->end + 1 >= tokens_.size() || !tokens_[of->end].is("/") ||
      !tokens_[of->end + 1].is("\\partial")) {
    fail("expected \\partial a/\\partial b of two quantities", at);
  }
  Expression first = quantity(*of);
  at_ = of->end + 2;
  const std::optional<Meaning> by =
      at_ < tokens_.size() ? reading_.notations.at(tokens_, at_) : std::nullopt;
  if (!by) {
    fail("expected \\partial a/\\partial b of two quantities", at);
  }
  return binary("derivative", Operation::other, std::move(first), quantity(*by), at);
}

Expression FormulaReader::total_derivative(const Tokens& above, const Tokens& below,
                                           std::size_t at) {
  if (reading_.notations.at(above, 0)) {
    fail("'d' is a quantity, so this may be a quotient; say in the map what it is", at);
  }
  const std::optional<Atom> d = read_atom(above, 0);
  const int order = d->superscript.empty() ? 1 : order_of(d->superscript, at);
  const Tokens by = slice(below, read_atom(below, 0)->end, below.size());
  Expression tree =
      d->end == above.size() ? operand() : read(slice(above, d->end, above.size()), at);
  const std::string time = letters_of(by);
  const std::string power = order == 1 ? "" : "^" + std::to_string(order);
  if (time == "t" + power || time == "t^{" + std::to_string(order) + "}") {
    return rates(std::move(tree), order, at);
  }
  if (!time.empty() && time[0] == 't' && !reading_.notations.at(by, 0)) {
    fail("the orders of this derivative above and below the bar differ", at);
  }
  return by_all(
      "total", std::move(tree), order, by,
      [](const Tokens& tokens, std::size_t place) {
        const std::optional<Atom> atom = read_atom(tokens, place);
        return atom && atom->name == "d" ? atom->end : place;
      },
      at);
}

Expression FormulaReader::operand() {
  const bool is_bracketed = at_ < tokens_.size() && opens(tokens_[at_]);
  Expression tree = factor().tree;
  const auto ends = [](const Token& token) {
    return token.is("+") || token.is("-") || token.is("=") || closes(token);
  };
  if (!is_bracketed && at_ < tokens_.size() && !ends(tokens_[at_])) {
    fail("write brackets around what is differentiated", at_);
  }
  return tree;
}

Expression FormulaReader::rates(Expression of, int order, std::size_t at) {
  for (int left = order; left > 0; left -= 2) {
    of = call(left == 1 ? "rate" : "rate2", Operation::other, {std::move(of)}, at);
  }
  return of;
}

}  // namespace assur::generator::latex
