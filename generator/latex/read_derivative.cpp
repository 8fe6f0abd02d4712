// Turns derivatives, partial and by the time, into their trees.
#include "latex/formula_reader.hpp"
#include "latex/rows.hpp"

namespace assur::generator::latex {

Expression FormulaReader::derivative(const Tokens& of, const Tokens& by, std::size_t at) {
  if (!of.empty() && of[0].is("^")) {
    fail("second partial derivatives are not read", at);
  }
  Expression first = read(of, at);
  return binary("derivative", Operation::other, std::move(first), read(by, at), at);
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

Expression FormulaReader::time_derivative(const Tokens& above, const Tokens& below,
                                          std::size_t at) {
  if (reading_.notations.at(above, 0)) {
    fail("'d' is a quantity, so this may be a quotient; say in the map what it is", at);
  }
  const std::optional<Atom> d = read_atom(above, 0);
  const std::string time = letters_of(slice(below, read_atom(below, 0)->end, below.size()));
  const bool second = d->superscript == "2";
  if ((!second && !d->superscript.empty()) ||
      (second ? time != "t^2" && time != "t^{2}" : time != "t")) {
    fail("only derivatives by the time t are read in this form", at);
  }
  Expression of = read(slice(above, d->end, above.size()), at);
  return call(second ? "rate2" : "rate", Operation::other, {std::move(of)}, at);
}

}  // namespace assur::generator::latex
