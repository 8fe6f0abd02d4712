#include "latex/read_latex.hpp"

#include <algorithm>
#include <array>

#include "latex/formula_reader.hpp"
#include "latex/indices.hpp"
#include "latex/rows.hpp"

namespace assur::generator::latex {

namespace {

/// The largest number of tokens of an equation.
constexpr std::size_t most_parts = 20'000;

bool is_product_sign(const Token& token) {
  return token.is("\\cdot") || token.is("\\times") || token.is("*") || token.is("\\ast");
}

}  // namespace

std::string printed_name(const std::string& notation) { return "printed " + notation; }

LatexFormula read_latex(const Tokens& tokens, const Reading& reading, Place place) {
  Progress progress;
  Expression tree = FormulaReader(tokens, reading, progress, place, 0).whole();
  return {std::move(tree), std::move(progress.places)};
}

Expression FormulaReader::whole() {
  skip_spaces();
  if (at_ == tokens_.size()) {
    throw FormulaError("a formula is missing", place_);
  }
  Expression result = sum();
  if (at_ < tokens_.size()) {
    fail("'" + tokens_[at_].text + "' is not expected here", at_);
  }
  return result;
}

Expression FormulaReader::sum() {
  Expression left;
  bool first = true;
  while (at_ < tokens_.size()) {
    skip_spaces();
    const std::size_t sign_at = at_;
    const bool minus = at_ < tokens_.size() && tokens_[at_].is("-");
    const bool plus = at_ < tokens_.size() && tokens_[at_].is("+");
    at_ += minus || plus ? 1 : 0;
    const std::size_t end = end_of_term();
    Expression one = term(slice(tokens_, at_, end), at_);
    at_ = end;
    if (first) {
      left = minus ? call("-", Operation::negate, {std::move(one)}, sign_at) : std::move(one);
    } else {
      left = binary(minus ? "-" : "+", minus ? Operation::subtract : Operation::add,
                    std::move(left), std::move(one), sign_at);
    }
    first = false;
  }
  return left;
}

std::size_t FormulaReader::end_of_term() const {
  int depth = 0;
  for (std::size_t at = at_; at < tokens_.size(); ++at) {
    const Token& token = tokens_[at];
    depth += token.is("{") || opens(token) ? 1 : 0;
    depth -= token.is("}") || closes(token) ? 1 : 0;
    if (depth == 0 && (token.is("+") || token.is("-"))) {
      return at;
    }
  }
  return tokens_.size();
}

Expression FormulaReader::term(const Tokens& tokens, std::size_t at) {
  for (const auto& [index, values] : reading_.summed) {
    if (has_index(tokens, index)) {
      return summed(tokens, index, values, at);
    }
  }
  std::size_t first = 0;
  while (first < tokens.size() && (is_thin_space(tokens[first]))) {
    ++first;
  }
  if (first < tokens.size() && tokens[first].is("\\sum")) {
    return explicit_sum(tokens, first + 1, at);
  }
  FormulaReader reader(tokens, reading_, progress_, place_of(at), depth_ + 1);
  return reader.product();
}

Expression FormulaReader::summed(const Tokens& tokens, const std::string& index,
                                 const std::vector<std::string>& values, std::size_t at) {
  Expression left;
  for (std::size_t place = 0; place < values.size(); ++place) {
    if (progress_.places.size() > most_parts) {
      fail("written out, the sums have more than " + std::to_string(most_parts) +
               " parts; let the map skip this equation",
           at);
    }
    Expression one = term(with_index(tokens, index, values[place]), at);
    left = place == 0 ? std::move(one)
                      : binary("+", Operation::add, std::move(left), std::move(one), at);
  }
  return left;
}

Expression FormulaReader::explicit_sum(const Tokens& tokens, std::size_t behind, std::size_t at) {
  std::array<Tokens, 2> bounds;
  for (const char* mark : {"_", "^"}) {
    if (behind >= tokens.size() || !tokens[behind].is(mark)) {
      fail("write a sum as \\sum_{i=1}^{4}", at);
    }
    bounds[*mark == '_' ? 0 : 1] = take_argument(tokens, ++behind);
  }
  const std::string from = letters_of(bounds[0]);
  const std::string to = letters_of(bounds[1]);
  const auto is_number = [](const std::string& text) {
    return !text.empty() && text.size() < 3 &&
           text.find_first_not_of("0123456789") == std::string::npos;
  };
  if (from.size() < 3 || from[1] != '=' || !bounds[0][0].is_letter() ||
      !is_number(from.substr(2)) || !is_number(to) || behind >= tokens.size()) {
    fail("write a sum as \\sum_{i=1}^{4}", at);
  }
  std::vector<std::string> values;
  for (int value = std::stoi(from.substr(2)); value <= std::stoi(to); ++value) {
    values.push_back(std::to_string(value));
  }
  const Tokens rest = slice(tokens, behind, tokens.size());
  if (values.empty() || !has_index(rest, from.substr(0, 1))) {
    fail("nothing in this sum has its index", at);
  }
  return summed(rest, from.substr(0, 1), values, at);
}

Expression FormulaReader::product() {
  skip_spaces();
  Factor left = factor();
  bool divided = false;
  while (true) {
    const std::size_t before = at_;
    skip_spaces();
    if (at_ == tokens_.size()) {
      return std::move(left.tree);
    }
    const bool spaced = at_ > before;
    const Token& token = tokens_[at_];
    if (divided) {
      fail("what is below the '/' is not clear; write \\frac or brackets", at_);
    }
    if (token.is("/")) {
      if (left.kind == FactorKind::bare_function) {
        fail("is the function divided or its argument? write \\frac or brackets", at_);
      }
      const std::size_t sign = at_++;
      skip_spaces();
      left.tree = binary("/", Operation::divide, std::move(left.tree), factor().tree, sign);
      left.kind = FactorKind::closed;
      divided = true;
      continue;
    }
    const std::size_t sign = at_;
    if (is_product_sign(token)) {
      ++at_;
      skip_spaces();
    } else {
      expect_clear_product(left, token, spaced);
    }
    Factor right = factor();
    left.tree = binary("*", Operation::multiply, std::move(left.tree), std::move(right.tree), sign);
    left.kind = right.kind;
  }
}

bool FormulaReader::is_fraction_of_numbers(std::size_t at) const {
  if (!is_fraction(tokens_[at++])) {
    return false;
  }
  const auto is_number = [](const Tokens& part) {
    return std::all_of(part.begin(), part.end(), [](const Token& each) { return each.is_digit(); });
  };
  const Tokens above = take_argument(tokens_, at);
  return is_number(above) && is_number(take_argument(tokens_, at));
}

void FormulaReader::expect_clear_product(const Factor& left, const Token& next, bool spaced) const {
  if (closes(next) || next.is("}")) {
    fail("'" + next.text + "' closes nothing", at_);
  }
  if (next.is("^") || next.is("_")) {
    fail(left.kind == FactorKind::bare_function || left.kind == FactorKind::closed
             ? "the base of this power is not clear; write \\sin^2 x, or brackets around it all"
             : "'" + next.text + "' is not expected here",
         at_);
  }
  if (next.is_digit() || next.is(".")) {
    fail(
        "a number stands directly after a factor; write \\cdot, or braces around an index or "
        "a power of two digits",
        at_);
  }
  if (left.kind == FactorKind::number && !spaced && is_fraction_of_numbers(at_)) {
    fail("this may be a mixed number or a product; write \\cdot, or a sum in brackets", at_);
  }
  const bool derivative =
      is_fraction(next) && at_ + 2 < tokens_.size() && tokens_[at_ + 2].is("\\partial");
  const bool ends_argument = derivative || find_function(at_) != nullptr;
  const bool brackets_apart = opens(next) && (next.spaced || reading_.brackets_multiply);
  if (left.kind == FactorKind::bare_function && !spaced && !ends_argument && !brackets_apart) {
    fail("does the function's argument go on here? write brackets, or \\, after the argument", at_);
  }
  if (left.kind == FactorKind::symbol && opens(next) && !spaced && !reading_.brackets_multiply) {
    fail(
        "this may be a product or a function's argument; write \\cdot, or 'brackets multiply' in "
        "the map",
        at_);
  }
}

}  // namespace assur::generator::latex
