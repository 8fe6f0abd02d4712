#include "latex/read_latex.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "latex/rows.hpp"

namespace assur::generator::latex {

namespace {

using text::Expression;
using text::Operation;

constexpr int most_nested = 60;

struct Function {
  std::string_view command;
  std::string_view name;
  Operation operation;
};
constexpr std::array<Function, 11> functions = {{{"\\sin", "sin", Operation::sin},
                                                 {"\\cos", "cos", Operation::cos},
                                                 {"\\tan", "tan", Operation::tan},
                                                 {"\\cot", "cot", Operation::tan},
                                                 {"\\arcsin", "asin", Operation::asin},
                                                 {"\\arccos", "acos", Operation::acos},
                                                 {"\\arctan", "atan", Operation::atan},
                                                 {"atan2", "atan2", Operation::atan2},
                                                 {"asin", "asin", Operation::asin},
                                                 {"acos", "acos", Operation::acos},
                                                 {"atan", "atan", Operation::atan}}};

bool is_product_sign(const Token& token) {
  return token.is("\\cdot") || token.is("\\times") || token.is("*") || token.is("\\ast");
}
bool is_fraction(const Token& token) {
  return token.is("\\frac") || token.is("\\dfrac") || token.is("\\tfrac") || token.is("\\cfrac");
}
bool opens(const Token& token) { return token.is("(") || token.is("[") || token.is("\\{"); }
bool closes(const Token& token) { return token.is(")") || token.is("]") || token.is("\\}"); }
const char* closing_of(const Token& token) {
  return token.is("(") ? ")" : token.is("[") ? "]" : "\\}";
}
bool is_d(const Tokens& tokens, std::size_t at) {
  const std::optional<Atom> atom = read_atom(tokens, at);
  return atom && atom->name == "d";
}

/// What a factor is, which decides what may stand behind it without a sign.
enum class FactorKind : unsigned char { number, symbol, closed, bare_function };

struct Factor {
  Expression tree;
  FactorKind kind;
};

/// Reads one range of tokens to its end.
class Reader {
 public:
  Reader(Tokens tokens, const Reading& reading, std::vector<Place>& places, Place place, int depth)
      : tokens_(std::move(tokens)),
        reading_(reading),
        places_(places),
        place_(place),
        depth_(depth) {
    std::erase_if(tokens_, [](const Token& token) { return is_layout(token); });
    if (!tokens_.empty()) {
      place_ = tokens_[0].place;
    }
    if (depth_ > most_nested) {
      throw FormulaError("nested too deeply", place_);
    }
  }

  Expression whole() {
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

 private:
  [[noreturn]] void fail(const std::string& what, std::size_t at) const {
    const bool inside = at < tokens_.size();
    throw FormulaError(what, inside || tokens_.empty() ? (inside ? tokens_[at].place : place_)
                                                       : tokens_.back().place);
  }

  void skip_spaces() {
    while (at_ < tokens_.size() && is_thin_space(tokens_[at_])) {
      ++at_;
    }
  }

  Expression read(Tokens tokens, std::size_t at) {
    return Reader(std::move(tokens), reading_, places_, place_of(at), depth_ + 1).whole();
  }

  [[nodiscard]] Place place_of(std::size_t at) const {
    return at < tokens_.size() ? tokens_[at].place
           : tokens_.empty()   ? place_
                               : tokens_.back().place;
  }

  std::size_t column(std::size_t at) {
    places_.push_back(place_of(at));
    return places_.size();
  }

  Expression call(const std::string& name, Operation operation, std::vector<Expression> arguments,
                  std::size_t at) {
    return {Expression::Kind::call, 0, name, std::move(arguments), operation, column(at)};
  }

  Expression binary(const std::string& name, Operation operation, Expression left, Expression right,
                    std::size_t at) {
    std::vector<Expression> both;
    both.push_back(std::move(left));
    both.push_back(std::move(right));
    return call(name, operation, std::move(both), at);
  }

  Expression number_tree(const std::string& digits, std::size_t at) {
    return {Expression::Kind::number, std::stod(digits), digits, {}, Operation::other, column(at)};
  }

  Expression sum() {
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

  /// The next plus or minus outside brackets and groups.
  [[nodiscard]] std::size_t end_of_term() const {
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

  /// A product, summed over the indices that it has.
  Expression term(const Tokens& tokens, std::size_t at) {
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
    Reader reader(tokens, reading_, places_, place_of(at), depth_ + 1);
    return reader.product();
  }

  Expression summed(const Tokens& tokens, const std::string& index,
                    const std::vector<std::string>& values, std::size_t at) {
    Expression left;
    for (std::size_t place = 0; place < values.size(); ++place) {
      Expression one = term(with_index(tokens, index, values[place]), at);
      left = place == 0 ? std::move(one)
                        : binary("+", Operation::add, std::move(left), std::move(one), at);
    }
    return left;
  }

  /// \sum_{i=1}^{4} and the product behind it.
  Expression explicit_sum(const Tokens& tokens, std::size_t behind, std::size_t at) {
    Tokens bounds[2];
    for (const char* mark : {"_", "^"}) {
      if (behind >= tokens.size() || !tokens[behind].is(mark)) {
        fail("a sum is read as \\sum_{i=1}^{4}", at);
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
      fail("a sum is read as \\sum_{i=1}^{4}", at);
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

  Expression product() {
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
      left.tree =
          binary("*", Operation::multiply, std::move(left.tree), std::move(right.tree), sign);
      left.kind = right.kind;
    }
  }

  /// Whether a factor may stand behind another without a sign between them.
  void expect_clear_product(const Factor& left, const Token& next, bool spaced) const {
    if (closes(next) || next.is("}")) {
      fail("'" + next.text + "' closes nothing", at_);
    }
    if (next.is("^") || next.is("_")) {
      fail(left.kind == FactorKind::bare_function || left.kind == FactorKind::closed
               ? "what is raised here is not clear; write \\sin^2 x, or brackets around it all"
               : "'" + next.text + "' is not expected here",
           at_);
    }
    if (next.is_digit() || next.is(".")) {
      fail(
          "a number stands directly behind a factor; write \\cdot, or braces around an index or "
          "a power of two digits",
          at_);
    }
    const bool derivative =
        is_fraction(next) && at_ + 2 < tokens_.size() && tokens_[at_ + 2].is("\\partial");
    const bool ends_argument = derivative || find_function(at_) != nullptr;
    if (left.kind == FactorKind::bare_function && !spaced && !ends_argument) {
      fail("does the function's argument go on here? write brackets, or \\, behind the argument",
           at_);
    }
    if (left.kind == FactorKind::symbol && opens(next) && !spaced && !reading_.brackets_multiply) {
      fail("a product or a function's argument? write \\cdot, or 'brackets multiply' in the map",
           at_);
    }
  }

  /// A power behind a factor, if there is one.
  Expression raised(Expression base) {
    if (at_ >= tokens_.size() || !tokens_[at_].is("^")) {
      return base;
    }
    const std::size_t mark = at_++;
    return powered(std::move(base), take_argument(tokens_, at_), mark);
  }

  Expression powered(Expression base, const Tokens& exponent, std::size_t at) {
    return binary("^", Operation::power, std::move(base), read(exponent, at), at);
  }

  Factor factor() {
    if (at_ >= tokens_.size()) {
      fail("a factor is missing", at_);
    }
    const Token& token = tokens_[at_];
    if (token.is_digit() || token.is(".")) {
      return {number(), FactorKind::number};
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

  [[noreturn]] void refuse(const Token& token) const {
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

  Expression number() {
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
      fail("a digit is missing behind the point", at_ - 1);
    }
    Expression tree = number_tree(digits, from);
    if (at_ + 1 < tokens_.size() && tokens_[at_].is("^")) {
      std::size_t behind = at_ + 1;
      const Tokens script = take_argument(tokens_, behind);
      if (script.size() == 1 && script[0].is("\\circ")) {
        at_ = behind;
        return binary("*", Operation::multiply, std::move(tree),
                      {Expression::Kind::number, 0, "deg", {}, Operation::other, column(from)},
                      from);
      }
    }
    return raised(std::move(tree));
  }

  /// The tree of a notation's formula, as if it stood at this place.
  Expression quantity(const Meaning& meaning) {
    const std::size_t at = at_;
    at_ = meaning.end;
    Expression tree = formula_of(meaning, at);
    if (meaning.dots > 0) {
      tree = call(meaning.dots == 1 ? "rate" : "rate2", Operation::other, {std::move(tree)}, at);
    }
    if (!meaning.power.empty()) {
      return powered(std::move(tree), meaning.power, at);
    }
    return tree;
  }

  Expression formula_of(const Meaning& meaning, std::size_t at) {
    if (meaning.formula.empty()) {
      return {Expression::Kind::name, 0,         printed_name(meaning.name), {},
              Operation::other,       column(at)};
    }
    try {
      Expression tree = text::parse_expression(meaning.formula, closures::formula_functions());
      move_to(tree, column(at));
      return tree;
    } catch (const text::ExpressionError& error) {
      fail("the map has '" + meaning.formula + "' for this, and " + error.what(), at);
    }
  }

  static void move_to(Expression& tree, std::size_t column) {
    tree.column = column;
    for (Expression& argument : tree.arguments) {
      move_to(argument, column);
    }
  }

  /// The function whose name stands at a place.
  [[nodiscard]] const Function* find_function(std::size_t at) const {
    std::string name = tokens_[at].text;
    if (tokens_[at].is("\\operatorname") || tokens_[at].is("\\mathrm") ||
        tokens_[at].is("\\text")) {
      std::size_t behind = at + 1;
      name = letters_of(take_argument(tokens_, behind));
      name = name == "arcsin" || name == "arccos" || name == "arctan" ? "\\" + name : name;
    } else if (!tokens_[at].is_command()) {
      return nullptr;
    }
    const auto found =
        std::find_if(functions.begin(), functions.end(),
                     [&](const Function& function) { return function.command == name; });
    return found == functions.end() ? nullptr : &*found;
  }

  /// `\cos^2\theta`, `\sin(a + b)`, `\operatorname{atan2}(y, x)`.
  Factor called(const Function& function) {
    const std::size_t at = at_;
    const bool word =
        tokens_[at].is("\\operatorname") || tokens_[at].is("\\mathrm") || tokens_[at].is("\\text");
    at_ = word ? end_of_argument(tokens_, at + 1) : at + 1;
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

  std::pair<std::vector<Expression>, bool> function_arguments(const Function& function,
                                                              std::size_t at) {
    if (at_ >= tokens_.size()) {
      fail("the function has no argument", at);
    }
    std::vector<Expression> list;
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
        fail(std::string(function.name) + " has another number of arguments", open);
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

  /// `\theta_1`, `2\theta_1`, `\frac{...}{...}`.
  Expression bare_argument() {
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

  Expression bare_symbol() {
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

  /// What stands between brackets; moves behind them.
  Tokens take_brackets() {
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

  Expression bracketed() {
    const std::size_t open = at_;
    return read(take_brackets(), open);
  }

  /// Braces are not printed: what is in them must be one factor, or a product at the end.
  Factor group() {
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
      fail("braces are not printed, so what is raised is not clear; write brackets", at_);
    }
    return {read(inside, open), FactorKind::symbol};
  }

  Expression root() {
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

  Expression fraction() {
    const std::size_t at = at_++;
    const Tokens above = take_argument(tokens_, at_);
    const Tokens below = take_argument(tokens_, at_);
    if (!above.empty() && !below.empty()) {
      if (above[0].is("\\partial") && below[0].is("\\partial")) {
        return derivative(slice(above, 1, above.size()), slice(below, 1, below.size()), at);
      }
      if (is_d(above, 0) && is_d(below, 0) && above.size() > 1) {
        return time_derivative(above, below, at);
      }
    }
    Expression numerator = read(above, at);
    return binary("/", Operation::divide, std::move(numerator), read(below, at), at);
  }

  Expression derivative(const Tokens& of, const Tokens& by, std::size_t at) {
    if (!of.empty() && of[0].is("^")) {
      fail("second partial derivatives are not read", at);
    }
    Expression first = read(of, at);
    return binary("derivative", Operation::other, std::move(first), read(by, at), at);
  }

  /// \partial a/\partial b
  Expression inline_derivative() {
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

  /// \frac{d x}{d t} and \frac{d^2 x}{d t^2}
  Expression time_derivative(const Tokens& above, const Tokens& below, std::size_t at) {
    if (reading_.notations.at(above, 0)) {
      fail("'d' is a quantity, so this may be a quotient; say in the map what it is", at);
    }
    const std::optional<Atom> d = read_atom(above, 0);
    const std::string time = letters_of(slice(below, read_atom(below, 0)->end, below.size()));
    const bool second = d->superscript == "2";
    if ((!second && !d->superscript.empty()) ||
        (second ? time != "t^2" && time != "t^{2}" : time != "t")) {
      fail("only derivatives by the time t are read so", at);
    }
    Expression of = read(slice(above, d->end, above.size()), at);
    return call(second ? "rate2" : "rate", Operation::other, {std::move(of)}, at);
  }

  Tokens tokens_;
  const Reading& reading_;
  std::vector<Place>& places_;
  Place place_;
  int depth_;
  std::size_t at_ = 0;
};

/// Tokens without layout and the brackets \left( ... \right) around a matrix.
bool is_matrix_name(const std::string& name) {
  return name == "pmatrix" || name == "bmatrix" || name == "matrix" || name == "Bmatrix" ||
         name == "smallmatrix" || name == "array";
}

/// (a, b, c)^T
std::optional<LatexMatrix> read_column(const Tokens& tokens) {
  const auto is_transposed = [](const std::string& text) {
    return text == "T" || text == "\\top" || text == "\\mathrm{T}" || text == "\\mathsf{T}" ||
           text == "\\intercal" || text == "\\mathrm T";
  };
  std::size_t close = tokens.size();
  while (close > 0 && !closes(tokens[close - 1])) {
    --close;
  }
  if (close == 0 || close + 1 >= tokens.size() || !tokens[close].is("^") || !opens(tokens[0])) {
    return std::nullopt;
  }
  std::size_t behind = close + 1;
  if (!is_transposed(letters_of(take_argument(tokens, behind))) || behind != tokens.size()) {
    return std::nullopt;
  }
  LatexMatrix matrix;
  matrix.place = tokens[0].place;
  matrix.cells.emplace_back(1);
  int depth = 0;
  for (std::size_t at = 1; at + 1 < close; ++at) {
    depth += tokens[at].is("{") || opens(tokens[at]) ? 1 : 0;
    depth -= tokens[at].is("}") || closes(tokens[at]) ? 1 : 0;
    if (depth == 0 && tokens[at].is(",")) {
      matrix.cells.emplace_back(1);
    } else {
      matrix.cells.back()[0].push_back(tokens[at]);
    }
  }
  return matrix;
}

}  // namespace

std::string printed_name(const std::string& notation) { return "printed " + notation; }

LatexFormula read_latex(const Tokens& tokens, const Reading& reading, Place place) {
  LatexFormula formula;
  formula.tree = Reader(tokens, reading, formula.places, place, 0).whole();
  return formula;
}

std::optional<LatexMatrix> read_matrix(const Tokens& given) {
  Tokens tokens = given;
  std::erase_if(tokens, [](const Token& token) { return is_layout(token); });
  const auto begin = std::find_if(tokens.begin(), tokens.end(),
                                  [](const Token& token) { return token.is("\\begin"); });
  if (begin == tokens.end()) {
    return read_column(tokens);
  }
  const auto place = static_cast<std::size_t>(begin - tokens.begin());
  std::size_t at = place + 1;
  const std::string name = letters_of(take_argument(tokens, at));
  if (name == "vmatrix" || name == "Vmatrix") {
    throw FormulaError("a determinant is not read; write it out", begin->place);
  }
  if (!is_matrix_name(name)) {
    throw FormulaError("\\begin{" + name + "} is not read here", begin->place);
  }
  std::size_t end = at;
  const Tokens inside = take_environment(tokens, end, name, *begin);
  const std::string before = letters_of(slice(tokens, 0, place));
  const std::string after = letters_of(slice(tokens, end, tokens.size()));
  const bool bracketed = (before == "(" && after == ")") || (before == "[" && after == "]");
  const bool bare = before.empty() && after.empty();
  if (before == "|" || before == "\\lvert") {
    throw FormulaError("a determinant is not read; write it out", begin->place);
  }
  if (!bracketed && !bare) {
    throw FormulaError("a matrix can be compared alone, without factors, terms and superscripts",
                       begin->place);
  }
  LatexMatrix matrix;
  matrix.place = begin->place;
  std::size_t first = 0;
  const std::string columns = name == "array" ? letters_of(take_argument(inside, first)) : "";
  const bool titled = columns.size() > 2 && columns[1] == '|';
  for (const Tokens& row : rows_of(slice(inside, first, inside.size()))) {
    matrix.cells.push_back(cells_of(row));
    if (matrix.cells.back().size() != matrix.cells[0].size()) {
      throw FormulaError("a row of " + std::to_string(matrix.cells.back().size()) +
                             " entries in a matrix of " + std::to_string(matrix.cells[0].size()),
                         row.empty() ? begin->place : row[0].place);
    }
  }
  if (matrix.cells.empty()) {
    throw FormulaError("a matrix without entries", begin->place);
  }
  if (titled) {
    matrix.column_titles.assign(matrix.cells[0].begin() + 1, matrix.cells[0].end());
    matrix.cells.erase(matrix.cells.begin());
    for (std::vector<Tokens>& row : matrix.cells) {
      matrix.row_titles.push_back(row[0]);
      row.erase(row.begin());
    }
  }
  return matrix;
}

Tokens with_index(const Tokens& tokens, const std::string& index, const std::string& value) {
  Tokens result;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    result.push_back(tokens[at]);
    if (!tokens[at].is("_") || at + 1 >= tokens.size()) {
      continue;
    }
    const std::size_t end = end_of_argument(tokens, at + 1);
    const bool group = tokens[at + 1].is("{");
    for (++at; at < end; ++at) {
      if (tokens[at].text != index) {
        result.push_back(tokens[at]);
        continue;
      }
      Token part = tokens[at];
      for (const char digit : (group ? value : "{" + value + "}")) {
        part.text = std::string(1, digit);
        result.push_back(part);
      }
    }
    --at;
  }
  return result;
}

bool has_index(const Tokens& tokens, const std::string& index) {
  for (std::size_t at = 0; at + 1 < tokens.size(); ++at) {
    if (!tokens[at].is("_")) {
      continue;
    }
    const std::size_t end = end_of_argument(tokens, at + 1);
    for (std::size_t inside = at + 1; inside < end; ++inside) {
      if (tokens[inside].text == index) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace assur::generator::latex
