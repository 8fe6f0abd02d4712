#include <algorithm>
#include <array>
#include <assur/text/expression.hpp>
#include <assur/text/quoted.hpp>
#include <assur/text/suggestion.hpp>
#include <cctype>
#include <charconv>
#include <numbers>
#include <string_view>

namespace assur::text {

namespace {

constexpr std::array<ExpressionFunction, 8> functions = {{{"sqrt", 1, Operation::sqrt},
                                                          {"sin", 1, Operation::sin},
                                                          {"cos", 1, Operation::cos},
                                                          {"tan", 1, Operation::tan},
                                                          {"asin", 1, Operation::asin},
                                                          {"acos", 1, Operation::acos},
                                                          {"atan", 1, Operation::atan},
                                                          {"atan2", 2, Operation::atan2}}};
struct Constant {
  std::string_view name;
  double value;
};
constexpr std::array<Constant, 2> constants = {
    {{"pi", std::numbers::pi}, {"deg", std::numbers::pi / 180}}};

// Deeper nesting than anyone writes would exhaust the stack.
constexpr int max_depth = 200;
// A long sum makes a tree as deep as the number of its terms.
constexpr std::size_t max_length = 10000;

bool is_name_start(char letter) {
  return std::isalpha(static_cast<unsigned char>(letter)) != 0 || letter == '_';
}
bool is_name_part(char letter) {
  return is_name_start(letter) || std::isdigit(static_cast<unsigned char>(letter)) != 0;
}

/// sum = product {(+|-) product}; product = sign {(*|/) sign}; sign = -sign | power;
/// power = atom [^ sign]; atom = number | name | function(sum, ...) | (sum).
class Parser {
 public:
  Parser(const std::string& text, std::span<const ExpressionFunction> more)
      : text_(text), more_(more) {}

  Expression whole() {
    if (text_.size() > max_length) {
      fail("the expression is longer than " + std::to_string(max_length) +
           " characters; divide it");
    }
    Expression result = sum();
    if (at_ < text_.size()) {
      const bool is_factor =
          std::isalpha(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '(';
      const std::string found = character();
      fail("expected an operator, found " + in_quotes(found) +
           (is_factor           ? " (a product is written with '*')"
            : found == "\u00b0" ? " (write '*deg')"
                                : ""));
    }
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw ExpressionError(what, at_ + 1); }

  /// The character at the present position, one or more bytes of UTF-8.
  [[nodiscard]] std::string character() const {
    std::size_t end = at_ + 1;
    while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U) {
      ++end;
    }
    return text_.substr(at_, end - at_);
  }
  void skip_space() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
      ++at_;
    }
  }
  bool take(char letter) {
    skip_space();
    if (at_ < text_.size() && text_[at_] == letter) {
      ++at_;
      skip_space();
      return true;
    }
    return false;
  }
  [[nodiscard]] Expression call(std::string name, Operation operation,
                                std::vector<Expression> arguments) const {
    return {Expression::Kind::call, 0, std::move(name), std::move(arguments), operation, at_ + 1};
  }

  /// Moves its operands: an initialiser list would copy whole trees for every term.
  [[nodiscard]] Expression binary(std::string name, Operation operation, Expression left,
                                  Expression right) const {
    std::vector<Expression> arguments;
    arguments.push_back(std::move(left));
    arguments.push_back(std::move(right));
    return call(std::move(name), operation, std::move(arguments));
  }

  Expression sum() {
    if (++depth_ > max_depth) {
      fail("the expression is nested too deeply; divide it");
    }
    Expression left = product();
    while (true) {
      if (take('+')) {
        left = binary("+", Operation::add, std::move(left), product());
      } else if (take('-')) {
        left = binary("-", Operation::subtract, std::move(left), product());
      } else {
        --depth_;
        return left;
      }
    }
  }

  Expression product() {
    Expression left = sign();
    while (true) {
      if (take('*')) {
        left = binary("*", Operation::multiply, std::move(left), sign());
      } else if (take('/')) {
        left = binary("/", Operation::divide, std::move(left), sign());
      } else {
        return left;
      }
    }
  }

  Expression sign() {
    if (++depth_ > max_depth) {
      fail("the expression is nested too deeply; divide it");
    }
    Expression result;
    if (take('-')) {
      result = call("-", Operation::negate, {sign()});
    } else {
      result = take('+') ? sign() : power();
    }
    --depth_;
    return result;
  }

  Expression power() {
    Expression base = atom();
    if (!take('^')) {
      return base;
    }
    return binary("^", Operation::power, std::move(base), sign());
  }

  Expression atom() {
    skip_space();
    if (at_ >= text_.size()) {
      fail("the expression ends where a number, a name or '(' is expected");
    }
    const char letter = text_[at_];
    if (take('(')) {
      Expression inner = sum();
      if (!take(')')) {
        fail("expected ')'");
      }
      return inner;
    }
    if (std::isdigit(static_cast<unsigned char>(letter)) != 0 || letter == '.') {
      return number();
    }
    if (is_name_start(letter)) {
      return name_or_call();
    }
    fail("expected a number, a name or '(', found " + in_quotes(character()));
  }

  Expression number() {
    Expression result;
    const char* begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), result.number);
    if (error == std::errc::result_out_of_range) {
      fail("the number is outside the range of double precision");
    }
    if (error != std::errc()) {
      fail("'.' is not a number");
    }
    result.name = std::string(begin, end);
    result.column = at_ + 1;
    at_ += static_cast<std::size_t>(end - begin);
    skip_space();
    return result;
  }

  Expression name_or_call() {
    const std::size_t start = at_;
    while (at_ < text_.size() && is_name_part(text_[at_])) {
      ++at_;
    }
    const std::string name = text_.substr(start, at_ - start);
    skip_space();
    for (const Constant& constant : constants) {
      if (constant.name == name) {
        return {Expression::Kind::number, constant.value, name, {}, Operation::other, start + 1};
      }
    }
    const ExpressionFunction* const function = function_named(name);
    if (!take('(')) {
      if (function != nullptr && !function->may_be_name) {
        fail("expected '(' after the function " + name);
      }
      return {Expression::Kind::name, 0, name, {}, Operation::other, start + 1};
    }
    if (function == nullptr) {
      at_ = start;
      fail("no function named " + in_quotes(name) + suggestion(name, function_names()));
    }
    std::vector<Expression> arguments = {sum()};
    while (take(',')) {
      arguments.push_back(sum());
    }
    if (!take(')')) {
      fail("expected ')'");
    }
    if (arguments.size() != function->arguments) {
      at_ = start;
      fail(name + " takes " + (function->arguments == 1 ? "one argument" : "two arguments"));
    }
    Expression result = call(name, function->operation, std::move(arguments));
    result.column = start + 1;
    return result;
  }

  [[nodiscard]] std::vector<std::string> function_names() const {
    std::vector<std::string> names;
    for (const std::span<const ExpressionFunction> table :
         {std::span<const ExpressionFunction>(functions), more_}) {
      for (const ExpressionFunction& function : table) {
        names.emplace_back(function.name);
      }
    }
    return names;
  }

  [[nodiscard]] const ExpressionFunction* function_named(const std::string& name) const {
    for (const std::span<const ExpressionFunction> table :
         {std::span<const ExpressionFunction>(functions), more_}) {
      for (const ExpressionFunction& function : table) {
        if (function.name == name) {
          return &function;
        }
      }
    }
    return nullptr;
  }

  const std::string& text_;
  std::span<const ExpressionFunction> more_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

Expression parse_expression(const std::string& text, std::span<const ExpressionFunction> more) {
  return Parser(text, more).whole();
}

bool is_constant(const Expression& expression) {
  return expression.kind != Expression::Kind::name &&
         std::all_of(expression.arguments.begin(), expression.arguments.end(), is_constant);
}

double constant_value(const Expression& expression) {
  return evaluate<double>(expression, [](const std::string&) { return 0.0; });
}

bool is_reserved_name(const std::string& name) {
  const auto has_name = [&](const auto& entry) { return entry.name == name; };
  return std::any_of(functions.begin(), functions.end(), has_name) ||
         std::any_of(constants.begin(), constants.end(), has_name);
}

bool is_identifier(const std::string& text) {
  return !text.empty() && is_name_start(text[0]) &&
         std::all_of(text.begin(), text.end(), is_name_part);
}

}  // namespace assur::text
