// Evaluates expressions of C++ and MATLAB.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "audit/code/variables.hpp"

namespace assur::generator::audit::code {

namespace {

using text::Expression;

constexpr std::int64_t largest_whole = std::numeric_limits<std::int32_t>::max();

/// The number of arguments of a function that means the same in formulas and in that language; zero
/// if there is none.
std::size_t argument_count(const std::string& name, Language language) {
  static const std::set<std::string> one = {"sqrt", "sin", "cos", "tan", "asin", "acos", "atan"};
  const bool two = name == "atan2" || (name == "pow" && language == Language::cpp);
  return one.contains(name) ? 1 : two ? 2 : 0;
}

/// A part of an expression; `whole` is its value if it is an integer.
struct Part {
  Expression tree;
  Sort sort = Sort::real;
  std::int64_t whole = 0;
};

class Reader {
 public:
  Reader(Tokens tokens, Variables& variables, const TypeNames* types, std::vector<Spelled>* used)
      : tokens_(tokens), variables_(variables), types_(types), used_(used) {}

  Cell run() {
    if (tokens_.empty()) {
      throw CodeError("a value is missing", closures::Place{1, 1});
    }
    const Part part = sum();
    if (at_ < tokens_.size()) {
      refuse(tokens_[at_]);
    }
    Cell cell{std::nullopt, part.sort, "", tokens_[0].place};
    try {
      cell.value = closures::expression_of(
          part.tree, [this](std::size_t column) { return tokens_[column - 1].place; },
          variables_.system(), meanings_);
    } catch (const closures::FormulaError& error) {
      cell.reason = error.what();
      cell.place = error.place;
    }
    return cell;
  }

 private:
  [[nodiscard]] bool is_cpp() const { return variables_.language() == Language::cpp; }
  [[nodiscard]] Tokens rest() const { return tokens_.subspan(at_); }
  [[nodiscard]] Tokens next(std::size_t count) const {
    return rest().first(std::min(rest().size(), count));
  }
  bool take(const char* mark) {
    const bool found = at_ < tokens_.size() && tokens_[at_].is(mark);
    at_ += found ? 1 : 0;
    return found;
  }

  [[noreturn]] void refuse(const Token& token) const {
    if (token.is("^")) {
      throw CodeError("'^' is the exclusive or of C++; write std::pow(x, n)", token.place);
    }
    throw CodeError(
        "'" + token.spelling.substr(0, 20) + "' cannot be read inside an expression" + by_running,
        token.place);
  }
  [[noreturn]] void refuse_end() const {
    throw CodeError("a value is missing", tokens_.back().place);
  }
  [[noreturn]] static void refuse_cast(const Token& token) {
    throw CodeError("a cast cannot be read; leave it out, or give its value a name as double",
                    token.place);
  }

  [[nodiscard]] Expression node(const std::string& name, std::size_t at) const {
    Expression tree;
    tree.name = name;
    tree.column = at + 1;
    return tree;
  }

  /// Limits how deeply brackets and signs are nested.
  struct Depth {
    explicit Depth(Reader& reader) : of(reader) {
      if (++of.depth_ > 200) {
        throw CodeError("too many brackets", of.tokens_[0].place);
      }
    }
    ~Depth() { --of.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    Reader& of;
  };

  Part sum() {
    Part left = product();
    while (at_ < tokens_.size() && (tokens_[at_].is("+") || tokens_[at_].is("-"))) {
      const std::size_t mark = at_++;
      left = combined(left, product(), mark);
    }
    return left;
  }

  Part product() {
    Part left = sign();
    while (at_ < tokens_.size() && (tokens_[at_].is("*") || tokens_[at_].is("/"))) {
      const std::size_t mark = at_++;
      left = combined(left, sign(), mark);
    }
    return left;
  }

  /// A sign before a power binds less than the power; in its exponent, more.
  Part sign() {
    const Depth depth(*this);
    const std::size_t mark = at_;
    if (take("+")) {
      return sign();
    }
    if (take("-")) {
      return negative(sign(), mark);
    }
    return is_cpp() ? primary() : powers();
  }

  Part negative(Part part, std::size_t mark) const {
    Expression tree = node("-", mark);
    tree.kind = Expression::Kind::call;
    tree.operation = text::Operation::negate;
    tree.arguments = {std::move(part.tree)};
    return {std::move(tree), part.sort, -part.whole};
  }

  /// MATLAB raises the left power first: 2^3^2 is 64.
  Part powers() {
    Part base = primary();
    while (at_ < tokens_.size() && tokens_[at_].is("^")) {
      const std::size_t mark = at_++;
      bool minus = false;
      while (at_ < tokens_.size() && (tokens_[at_].is("+") || tokens_[at_].is("-"))) {
        minus = minus != tokens_[at_++].is("-");
      }
      Part exponent = primary();
      base = call_of("^", text::Operation::power,
                     {base, minus ? negative(exponent, mark) : exponent}, mark);
    }
    return base;
  }

  Part call_of(const std::string& name, text::Operation operation, std::vector<Part> parts,
               std::size_t at) const {
    Expression tree = node(name, at);
    tree.kind = Expression::Kind::call;
    tree.operation = operation;
    for (Part& part : parts) {
      tree.arguments.push_back(std::move(part.tree));
    }
    return {std::move(tree)};
  }

  Part combined(const Part& left, const Part& right, std::size_t mark) const {
    const Token& token = tokens_[mark];
    const bool divides = token.is("/");
    const text::Operation operation = token.is("+")   ? text::Operation::add
                                      : token.is("-") ? text::Operation::subtract
                                      : divides       ? text::Operation::divide
                                                      : text::Operation::multiply;
    Part part = call_of(token.spelling, operation, {left, right}, mark);
    if (!is_cpp() || left.sort == Sort::real || right.sort == Sort::real) {
      return part;
    }
    if (left.sort == Sort::single || right.sort == Sort::single) {
      throw CodeError("the result of numbers of type float is rounded; write double" + by_running,
                      token.place);
    }
    if (divides) {
      throw CodeError("a quotient of whole numbers is rounded in C++; write 1.0/2", token.place);
    }
    part.sort = Sort::whole;
    part.whole = token.is("+")   ? left.whole + right.whole
                 : token.is("-") ? left.whole - right.whole
                                 : left.whole * right.whole;
    expect_held(part.whole, token);
    return part;
  }

  static void expect_held(std::int64_t whole, const Token& at) {
    if (std::abs(whole) > largest_whole) {
      throw CodeError("whole numbers beyond 2147483647 wrap round in C++; write a decimal point",
                      at.place);
    }
  }

  Part primary() {
    if (at_ == tokens_.size()) {
      refuse_end();
    }
    const Token& token = tokens_[at_];
    if (token.kind == Token::Kind::number) {
      return number();
    }
    if (is_cpp() && token.is("(") && at_ + 1 < tokens_.size() && is_type(tokens_[at_ + 1])) {
      refuse_cast(token);
    }
    if (take("(")) {
      Part part = sum();
      if (!take(")")) {
        at_ == tokens_.size() ? refuse_end() : refuse(tokens_[at_]);
      }
      return part;
    }
    if (!token.is_name() && !token.is("::")) {
      refuse(token);
    }
    if (const std::optional<Part> circle = circle_number()) {
      return *circle;
    }
    return named();
  }

  [[nodiscard]] bool is_type(const Token& token) const {
    static const std::set<std::string> words = {
        "double",           "float",        "int",  "long",        "short",      "unsigned",
        "signed",           "char",         "bool", "static_cast", "const_cast", "Scalar",
        "reinterpret_cast", "dynamic_cast", "const"};
    return words.contains(token.spelling) || (types_ != nullptr && types_->knows(token));
  }

  std::optional<Part> circle_number() {
    const std::size_t from = at_;
    const bool matlab = !is_cpp() && next(1)[0].is("pi") && variables_.find("pi") == nullptr;
    const bool macro = is_cpp() && next(1)[0].is("M_PI");
    const bool standard = is_cpp() && are(next(5), {"std", "::", "numbers", "::", "pi"});
    const bool opened = is_cpp() && are(next(3), {"numbers", "::", "pi"}) && types_ != nullptr &&
                        types_->opens("std", "numbers");
    const bool typed =
        is_cpp() && are(next(8), {"std", "::", "numbers", "::", "pi_v", "<", "double", ">"});
    const std::size_t count = matlab || macro ? 1 : standard ? 5 : opened ? 3 : typed ? 8 : 0;
    if (count == 0 || (from + count < tokens_.size() && tokens_[from + count].is("("))) {
      return std::nullopt;
    }
    at_ += count;
    return Part{node("pi", from)};
  }

  Part named() {
    const std::size_t from = at_;
    const bool standard = is_cpp() && (are(next(2), {"std", "::"}) || next(1)[0].is("::"));
    at_ += !standard ? 0 : next(1)[0].is("::") ? 1 : 2;
    if (at_ == tokens_.size() || !tokens_[at_].is_name()) {
      refuse_end();
    }
    const Token& name = tokens_[at_];
    if (const std::size_t count = argument_count(name.spelling, variables_.language());
        count > 0 && at_ + 1 < tokens_.size() && tokens_[at_ + 1].is("(")) {
      return call(name, count, from);
    }
    const bool called = at_ + 1 < tokens_.size() && tokens_[at_ + 1].is("(");
    if (is_cpp() && is_type(name)) {
      refuse_cast(tokens_[from]);
    }
    if (standard || (called && has_meaning(name.spelling))) {
      throw CodeError("the effect of '" + name.spelling + "' is not known" + by_running,
                      name.place);
    }
    if (at_ + 1 < tokens_.size() && tokens_[at_ + 1].is("<") && is_template_call()) {
      throw CodeError("a call of a template's function cannot be followed" + by_running,
                      tokens_[at_ + 1].place);
    }
    return variable();
  }

  [[nodiscard]] bool is_template_call() const {
    const auto closed = std::find_if(rest().begin(), rest().end(),
                                     [](const Token& token) { return token.is(">"); });
    return closed != rest().end() && closed + 1 != rest().end() && (closed + 1)->is("(");
  }

  Part call(const Token& name, std::size_t count, std::size_t from) {
    at_ += 2;
    std::vector<Part> arguments = {sum()};
    while (take(",")) {
      arguments.push_back(sum());
    }
    if (!take(")")) {
      at_ == tokens_.size() ? refuse_end() : refuse(tokens_[at_]);
    }
    if (arguments.size() != count) {
      throw CodeError("'" + name.spelling + "' takes " + std::to_string(count) +
                          (count == 1 ? " argument" : " arguments"),
                      name.place);
    }
    const bool rounds = std::any_of(arguments.begin(), arguments.end(),
                                    [](const Part& part) { return part.sort == Sort::single; });
    if (rounds) {
      throw CodeError("a function of numbers of type float is rounded; write double" + by_running,
                      name.place);
    }
    static const std::map<std::string, text::Operation> operations = {
        {"sqrt", text::Operation::sqrt}, {"sin", text::Operation::sin},
        {"cos", text::Operation::cos},   {"tan", text::Operation::tan},
        {"asin", text::Operation::asin}, {"acos", text::Operation::acos},
        {"atan", text::Operation::atan}, {"atan2", text::Operation::atan2},
        {"pow", text::Operation::power}};
    return call_of(name.spelling, operations.at(name.spelling), std::move(arguments), from);
  }

  Part variable() {
    const std::size_t from = at_;
    const Token& name = tokens_[from];
    if (is_cpp() && types_ != nullptr && types_->opens("Eigen", name.spelling) &&
        variables_.find(name.spelling) == nullptr) {
      throw CodeError("'" + name.spelling + "' may be one of Eigen's constants" + by_running,
                      name.place);
    }
    const Spelled number = variables_.spelled(rest());
    at_ += number.tokens;
    const Cell cell = variables_.read(number);
    if (used_ != nullptr) {
      used_->push_back(number);
    }
    Expression tree = node(cell.value ? "=" + number.text() : number.formula, from);
    tree.kind = Expression::Kind::name;
    if (!cell.value) {
      return {std::move(tree)};
    }
    meanings_.meanings[tree.name] = *cell.value;
    Part part{std::move(tree), cell.sort};
    if (cell.sort == Sort::whole) {
      part.whole = GiNaC::ex_to<GiNaC::numeric>(*cell.value).to_long();
    }
    return part;
  }

  /// Throws CodeError for a literal whose value in the language is not the decimal one, or with so
  /// many digits that it was rounded when written.
  Part number() {
    const Token& token = tokens_[at_];
    std::string text = token.spelling;
    const bool decimal = text.find_first_of(".eE") != std::string::npos;
    std::string suffix;
    while (is_cpp() && !text.empty() &&
           std::string("fFlLuU").find(text.back()) != std::string::npos) {
      suffix.insert(suffix.begin(), text.back());
      text.pop_back();
    }
    const bool octal = is_cpp() && text.size() > 1 && text[0] == '0' && !decimal;
    const bool single = suffix == "f" || suffix == "F";
    const bool plain = suffix.empty() || suffix == "l" || suffix == "L" ||
                       (!decimal && (suffix == "ll" || suffix == "LL"));
    if (suffix.find_first_of("uU") != std::string::npos) {
      throw CodeError(
          "a number of type unsigned makes the result wrap round; write it without its "
          "suffix",
          token.place);
    }
    if (octal || (single && !decimal) || !(single || plain) || text.empty() ||
        text.find_first_not_of("0123456789.eE+-") != std::string::npos) {
      throw CodeError(
          "a number spelled '" + token.spelling + "' cannot be read; write a decimal one",
          token.place);
    }
    constexpr std::ptrdiff_t kept_digits = std::numeric_limits<double>::digits10;
    const std::size_t mark = text.find_first_of("eE");
    const std::string digits = text.substr(0, mark);
    const auto first = digits.begin() + static_cast<std::ptrdiff_t>(std::min(
                                            digits.find_first_not_of(".0"), digits.size()));
    if (mark != std::string::npos && text.size() - mark > 5) {
      throw CodeError("the exponent of this number is too large", token.place);
    }
    if ((decimal || !is_cpp()) &&
        digits.end() - first - std::count(first, digits.end(), '.') >= kept_digits) {
      throw CodeError(
          "a number of so many digits is a rounded one; write what it stands for" + by_running,
          token.place);
    }
    Expression tree = node(text, at_);
    ++at_;
    if (single) {
      return single_number(token, text);
    }
    Part part{std::move(tree)};
    if (is_cpp() && !decimal) {
      part.sort = Sort::whole;
      part.whole = text.size() > 10 ? largest_whole + 1 : std::atoll(text.c_str());
      expect_held(part.whole, token);
    }
    return part;
  }

  /// A number of type float is the binary number nearest to its decimals.
  Part single_number(const Token& token, const std::string& text) {
    const float value = std::strtof(text.c_str(), nullptr);
    int exponent = 0;
    const double mantissa = std::frexp(static_cast<double>(value), &exponent);
    if (!std::isnormal(value) && value != 0) {
      throw CodeError(
          "a number spelled '" + token.spelling + "' cannot be read; write a decimal one",
          token.place);
    }
    constexpr int bits = std::numeric_limits<float>::digits;
    const GiNaC::numeric whole(static_cast<long>(std::ldexp(mantissa, bits)));
    Expression tree = node("=" + token.spelling, at_ - 1);
    tree.kind = Expression::Kind::name;
    meanings_.meanings[tree.name] =
        whole * GiNaC::pow(GiNaC::numeric(2), GiNaC::numeric(exponent - bits));
    return {std::move(tree), Sort::single};
  }

  Tokens tokens_;
  Variables& variables_;
  const TypeNames* types_;
  std::vector<Spelled>* used_;
  std::size_t at_ = 0;
  int depth_ = 0;
  closures::LocalNames meanings_;
};

}  // namespace

Cell read_expression(Tokens tokens, Variables& variables, const TypeNames* types,
                     std::vector<Spelled>* used) {
  return Reader(tokens, variables, types, used).run();
}

}  // namespace assur::generator::audit::code
