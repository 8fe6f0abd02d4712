#include "closures/read_formula.hpp"

#include <algorithm>
#include <array>
#include <assur/text/expression.hpp>
#include <assur/text/suggestion.hpp>
#include <cmath>
#include <stdexcept>

#include "closures/extent.hpp"

namespace assur::generator::closures {

namespace {

// Lengths are often named d or D.
constexpr std::array<text::ExpressionFunction, 7> functions = {
    {{"d", 2, text::Operation::other, true},
     {"D", 2, text::Operation::other, true},
     {"rate", 1},
     {"rate2", 1},
     {"pow", 2},
     {"point", 2},
     {"polar", 2}}};

/// The decimal number that a text spells, exactly.
GiNaC::numeric exact_number(const std::string& text) {
  const std::size_t mark = text.find_first_of("eE");
  const std::string digits = text.substr(0, mark);
  if (digits.find_first_not_of(".0") == std::string::npos) {
    return 0;  // for any exponent, which is limited nowhere else
  }
  long exponent = mark == std::string::npos ? 0 : std::stol(text.substr(mark + 1));
  std::string whole;
  bool fraction = false;
  for (const char digit : digits) {
    if (digit == '.') {
      fraction = true;
    } else {
      whole += digit;
      exponent -= fraction ? 1 : 0;
    }
  }
  whole.erase(0, std::min(whole.find_first_not_of('0'), whole.size() - 1));
  const GiNaC::numeric value(whole.c_str());
  return value * GiNaC::pow(GiNaC::numeric(10), GiNaC::numeric(exponent));
}

/// The tree of a text. Throws FormulaError.
text::Expression tree_of(const PlacedText& text) {
  if (text.empty()) {
    throw FormulaError("a formula is missing", text.place);
  }
  try {
    return text::parse_expression(text.text, functions);
  } catch (const text::ExpressionError& error) {
    throw FormulaError(error.what(), text.at(error.column));
  }
}

/// Whether a power of a number may have more than 65536 binary digits.
bool is_too_long(const GiNaC::ex& base, const GiNaC::ex& exponent) {
  constexpr double most_bits = 1 << 16;
  if (!GiNaC::is_a<GiNaC::numeric>(base)) {
    return false;
  }
  const auto& number = GiNaC::ex_to<GiNaC::numeric>(base);
  const int bits = number.numer().int_length() + number.denom().int_length();
  const bool is_one = GiNaC::abs(number).is_equal(1);
  return !is_one && std::abs(GiNaC::ex_to<GiNaC::numeric>(exponent).to_double()) * bits > most_bits;
}

/// Evaluates the nodes of a tree to expressions and vectors.
class Reader {
 public:
  using PlaceOf = std::function<Place(std::size_t)>;

  Reader(const PlaceOf& place_of, ClosureSystem& system, const LocalNames& locals)
      : place_of_(place_of), system_(system), locals_(locals) {}

  /// A scalar small enough to be compared, even with its abbreviations expanded.
  GiNaC::ex formula(const text::Expression& node) {
    GiNaC::ex expression = scalar(node);
    expect_few_parts(parts_of(expression, node), node);
    return expression;
  }

  equations::Vector2 formula_of_vector(const text::Expression& node) {
    equations::Vector2 result = vector(node);
    expect_few_parts(parts_of(result.x, node) + parts_of(result.y, node), node);
    return result;
  }

 private:
  /// Throws FormulaError, also for a node without a value, such as tan(pi/2).
  GiNaC::ex scalar(const text::Expression& node) {
    try {
      return evaluated(node);
    } catch (const std::domain_error&) {  // from GiNaC, at poles
      fail("the expression has no value here", node);
    }
  }

  equations::Vector2 vector(const text::Expression& node) {
    const std::string& called = node.name;
    if (node.kind == text::Expression::Kind::call && called == "point") {
      return {scalar(node.arguments[0]), scalar(node.arguments[1])};
    }
    if (node.kind == text::Expression::Kind::call && called == "polar") {
      const GiNaC::ex length = scalar(node.arguments[0]);
      const GiNaC::ex angle = scalar(node.arguments[1]);
      return {length * GiNaC::cos(angle), length * GiNaC::sin(angle)};
    }
    const bool sum = node.kind == text::Expression::Kind::call && (called == "+" || called == "-");
    if (!sum) {
      fail("expected a sum of point(x, y) and polar(length, angle)", node);
    }
    const equations::Vector2 first = vector(node.arguments[0]);
    if (node.arguments.size() == 1) {
      return {-first.x, -first.y};
    }
    const equations::Vector2 second = vector(node.arguments[1]);
    return called == "+" ? equations::Vector2{first.x + second.x, first.y + second.y}
                         : equations::Vector2{first.x - second.x, first.y - second.y};
  }

  GiNaC::ex evaluated(const text::Expression& node) {
    if (node.kind == text::Expression::Kind::number) {
      return number(node);
    }
    if (node.kind == text::Expression::Kind::name) {
      return name(node);
    }
    const std::string& called = node.name;
    if (called == "point" || called == "polar") {
      fail("a vector stands where a number is expected", node);
    }
    using text::Operation;
    const GiNaC::ex first = scalar(node.arguments[0]);
    if (node.arguments.size() == 1) {
      if (node.operation != Operation::other) {
        return text::applied<GiNaC::ex>(node.operation, first);
      }
      const GiNaC::ex rate = system_.rate(first);
      return called == "rate" ? rate : system_.rate(rate);
    }
    if (called == "d") return system_.partial(first, symbol(node.arguments[1]));
    if (called == "D") return total(first, node);
    if (called == "derivative") return derivative(node, first);
    if (called == "total") {
      if (holds_closure(node.arguments[0])) {
        fail("a closure stays zero along the solutions; write a partial derivative", node);
      }
      return total(first, node);
    }
    const GiNaC::ex second = scalar(node.arguments[1]);
    if (node.operation == Operation::divide) return quotient(first, second, node);
    if (node.operation == Operation::multiply) expect_readable_product(first, second, node);
    if (node.operation == Operation::power || node.operation == Operation::other) {  // pow(e, n)
      return power(first, second, node);
    }
    return text::applied<GiNaC::ex>(node.operation, first, second);
  }

  [[noreturn]] void fail(const std::string& what, const text::Expression& at) const {
    throw FormulaError(what, place_of_(at.column));
  }

  [[nodiscard]] static GiNaC::ex number(const text::Expression& node) {
    if (node.name == "pi" || node.name == "deg") {
      return node.name == "pi" ? GiNaC::ex(GiNaC::Pi) : GiNaC::Pi / 180;
    }
    return exact_number(node.name);
  }

  [[nodiscard]] const std::string& resolved(const std::string& name) const {
    const auto other = locals_.stands_for.find(name);
    return other == locals_.stands_for.end() ? name : other->second;
  }

  [[nodiscard]] GiNaC::ex name(const text::Expression& node) const {
    if (const auto local = locals_.meanings.find(node.name); local != locals_.meanings.end()) {
      return local->second;
    }
    if (const std::optional<GiNaC::ex> meaning = system_.meaning_of(resolved(node.name))) {
      return *meaning;
    }
    fail("no symbol named '" + node.name + "'" +
             text::suggestion_or_choice(node.name, system_.names()),
         node);
  }

  [[nodiscard]] const AuditSymbol& symbol(const text::Expression& node) const {
    const AuditSymbol* found = node.kind == text::Expression::Kind::name
                                   ? system_.symbol_named(resolved(node.name))
                                   : nullptr;
    if (found == nullptr) {
      fail("expected a declared symbol to differentiate by", node);
    }
    return *found;
  }

  /// Degrees multiply in powers of powers or abbreviations, so that reading a short text might
  /// never end.
  void expect_few_parts(std::size_t parts, const text::Expression& at) const {
    if (parts > max_parts) {
      fail("written out, this has more than " + std::to_string(max_parts) + " parts", at);
    }
    if (system_.part_count() + parts > max_parts_in_all) {
      fail("written out, this and all abbreviations have more than " +
               std::to_string(max_parts_in_all) + " parts",
           at);
    }
  }

  /// Throws FormulaError if an abbreviation's definition leaves no value: `1/(v - a)` for v = a.
  [[nodiscard]] std::size_t parts_of(const GiNaC::ex& expression,
                                     const text::Expression& at) const {
    try {
      return part_count(system_.expanded(expression));
    } catch (const std::domain_error&) {  // from GiNaC, at poles
      fail("the expression has no value here", at);
    }
  }

  void expect_readable_extent(double degree, double words, const text::Expression& at) const {
    if (!(degree <= max_degree)) {
      fail("the degree of this, of numerator and denominator together, is higher than " +
               std::to_string(max_degree) + ", the highest that is read",
           at);
    }
    if (!(words <= max_words)) {
      fail("the numbers in this have too many digits when it is multiplied out", at);
    }
  }

  void expect_readable_product(const GiNaC::ex& first, const GiNaC::ex& second,
                               const text::Expression& at) {
    const Extent one = meter_.of(first);
    const Extent other = meter_.of(second);
    expect_readable_extent(one.degree + other.degree, one.words + other.words, at);
  }

  [[nodiscard]] GiNaC::ex quotient(const GiNaC::ex& above, const GiNaC::ex& below,
                                   const text::Expression& at) {
    if (below.is_zero()) {
      fail("division by zero", at);
    }
    expect_readable_product(above, below, at);
    return above / below;
  }

  /// Whether this contains a closure, which is then differentiated as a function: along the
  /// solutions it is zero.
  [[nodiscard]] bool holds_closure(const text::Expression& node) const {
    return (node.kind == text::Expression::Kind::name &&
            system_.closure_named(resolved(node.name)) != nullptr) ||
           std::ranges::any_of(node.arguments, [this](const text::Expression& argument) {
             return holds_closure(argument);
           });
  }

  GiNaC::ex derivative(const text::Expression& node, const GiNaC::ex& of) {
    if (holds_closure(node.arguments[0])) {
      return system_.slope(of, symbol(node.arguments[1]).symbol);
    }
    return total(of, node);
  }

  /// The derivative with respect to the parameter, or rate, in the node's second argument.
  GiNaC::ex total(const GiNaC::ex& expression, const text::Expression& node) {
    const text::Expression* by = &node.arguments[1];
    int order = 0;
    for (; by->kind == text::Expression::Kind::call && by->name.starts_with("rate");
         by = &by->arguments[0]) {
      order += by->name == "rate" ? 1 : 2;
    }
    const AuditSymbol& parameter = symbol(*by);
    if (parameter.unknown) {
      const std::string what = node.name == "D" ? "D differentiates"
                               : node.name == "total"
                                   ? "a total derivative is taken"
                                   : "what follows the closures is differentiated";
      fail(what + " by a parameter, and '" + parameter.name + "' is an unknown", node);
    }
    if (order == 0) {
      return system_.total(expression, parameter);
    }
    if (!parameter.moving) {
      fail("'" + parameter.name + "' has no rate; declare 'moving " + parameter.name + "'", *by);
    }
    const std::optional<GiNaC::ex> derivative = system_.by_rate(expression, parameter, order);
    if (!derivative) {
      fail("a partial derivative of a derivative is not differentiated by a rate", node);
    }
    return *derivative;
  }

  [[nodiscard]] GiNaC::ex power(const GiNaC::ex& base, const GiNaC::ex& exponent,
                                const text::Expression& at) {
    if (!(2 * exponent).info(GiNaC::info_flags::integer)) {
      fail("only whole and half powers can be compared", at);
    }
    if (base.is_zero() && exponent.info(GiNaC::info_flags::negative)) {
      fail("division by zero", at);
    }
    if (base.is_zero() && exponent.is_zero()) {  // GiNaC would throw, and leak memory
      fail("zero to the power of zero has no value", at);
    }
    if (is_too_long(base, exponent)) {
      fail("the power of a number has too many digits", at);
    }
    if (!GiNaC::is_a<GiNaC::numeric>(base)) {
      const Extent extent = meter_.of(base);
      const double times = std::abs(GiNaC::ex_to<GiNaC::numeric>(exponent).to_double());
      expect_readable_extent(extent.degree * times, extent.words * times, at);
    }
    return GiNaC::pow(base, exponent);
  }

  const PlaceOf& place_of_;
  ClosureSystem& system_;
  const LocalNames& locals_;
  ExtentMeter meter_{&system_.extents()};
};

}  // namespace

GiNaC::ex read_formula(const PlacedText& text, ClosureSystem& system, const LocalNames& locals) {
  const Reader::PlaceOf place_of = [&](std::size_t column) { return text.at(column); };
  return Reader(place_of, system, locals).formula(tree_of(text));
}

GiNaC::ex expression_of(const text::Expression& tree,
                        const std::function<Place(std::size_t)>& place_of, ClosureSystem& system,
                        const LocalNames& locals) {
  return Reader(place_of, system, locals).formula(tree);
}

std::span<const text::ExpressionFunction> formula_functions() { return functions; }

equations::Vector2 read_vector(const PlacedText& text, ClosureSystem& system) {
  const LocalNames none;
  const Reader::PlaceOf place_of = [&](std::size_t column) { return text.at(column); };
  return Reader(place_of, system, none).formula_of_vector(tree_of(text));
}

}  // namespace assur::generator::closures
