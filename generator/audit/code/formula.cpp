#include "audit/code/formula.hpp"

#include <algorithm>
#include <array>
#include <assur/text/expression.hpp>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <set>

namespace assur::generator::audit::code {

namespace {

constexpr std::array<text::ExpressionFunction, 1> functions = {{{"pow", 2}}};

const std::set<std::string>& types() {
  static const std::set<std::string> list = {
      "double",      "float", "int",    "long",        "short",      "unsigned",
      "char",        "bool",  "Scalar", "static_cast", "const_cast", "reinterpret_cast",
      "dynamic_cast"};
  return list;
}

Tokens behind(Tokens tokens, std::size_t count) { return tokens.subspan(count); }

/// How many tokens are `std::` or `this->`, which formulas leave out.
std::size_t prefix(Tokens tokens) {
  const Tokens two = tokens.first(std::min<std::size_t>(tokens.size(), 2));
  return are(two, {"std", "::"}) || are(two, {"this", "->"}) ? 2 : 0;
}

/// How many tokens spell pi.
std::size_t circle_number(Tokens tokens) {
  if (tokens[0].is("M_PI")) {
    return 1;
  }
  if (tokens.size() < 3 || !are(tokens.first(2), {"numbers", "::"})) {
    return 0;
  }
  if (tokens[2].is("pi")) {
    return 3;
  }
  const bool templated = tokens.size() >= 6 && tokens[2].is("pi_v") && tokens[3].is("<") &&
                         tokens[4].is_name() && !tokens[4].is("float") && tokens[5].is(">");
  return templated ? 6 : 0;
}

/// A number without its suffix.
std::string plain_number(const Token& token) {
  std::string text = token.spelling;
  if (text.find_first_of("fFuU") != std::string::npos &&
      text.find_first_of("xX") == std::string::npos) {
    throw CodeError(
        "a number of type float or unsigned makes the result round or wrap around; write it "
        "without its suffix",
        token.place);
  }
  const bool octal = text.size() > 1 && text[0] == '0' && text.find('.') == std::string::npos &&
                     text.find_first_of("eE") == std::string::npos;
  const std::size_t end = text.find_last_not_of("lL");
  text.resize(end + 1);
  if (octal || text.find_first_not_of("0123456789.eE+-") != std::string::npos) {
    throw CodeError("a number spelled '" + token.spelling + "' cannot be read; write a decimal one",
                    token.place);
  }
  return text;
}

class FormulaWriter {
 public:
  FormulaWriter(Tokens tokens, const Dialect& dialect) : tokens_(tokens), dialect_(dialect) {
    const Token& last = tokens.back();
    formula_.text = {std::string(last.offset + last.spelling.size() - tokens[0].offset, ' '),
                     tokens[0].place};
  }

  CodeFormula run() {
    while (at_ < tokens_.size()) {
      step();
    }
    return std::move(formula_);
  }

 private:
  void step() {
    const Tokens rest = behind(tokens_, at_);
    const Token& token = rest[0];
    if (const std::size_t skipped = prefix(rest); skipped > 0) {
      at_ += skipped;
    } else if (token.is_name()) {
      read_name(rest);
    } else if (token.kind == Token::Kind::number) {
      put(token, plain_number(token), 1);
    } else {
      read_mark(rest);
    }
  }

  void read_name(Tokens rest) {
    if (types().contains(rest[0].spelling)) {
      refuse_cast(rest[0]);
    }
    if (const std::size_t count = circle_number(rest); count > 0) {
      put(rest[0], "pi", count);
    } else if (const LeadingName found = leading_name(rest); found.tokens > 0) {
      const bool circle = dialect_.pi_is_known && found.name.name == "pi";
      if (!circle && text::is_reserved_name(found.name.name)) {
        throw CodeError("a variable named '" + found.name.name +
                            "' means something else in a formula; give it another name",
                        rest[0].place);
      }
      formula_.names.push_back(found.name);
      put(rest[0], found.name.name, found.tokens);
    } else {
      if (!is_known_function(rest[0].spelling)) {
        formula_.unknown_calls.push_back({rest[0].spelling, rest[0].spelling, rest[0].place});
      }
      put(rest[0], rest[0].spelling, 1);
    }
  }

  void read_mark(Tokens rest) {
    const Token& token = rest[0];
    const bool cast = token.is("(") && rest.size() > 2 &&
                      (types().contains(rest[1].spelling) || rest[1].is("const"));
    if (cast) {
      refuse_cast(token);
    }
    if (token.is("^") && !dialect_.caret_is_power) {
      throw CodeError("'^' is the exclusive or of C++; write std::pow(x, n)", token.place);
    }
    const bool changes = token.spelling.size() > 1 && token.spelling.back() == '=' &&
                         !token.is("==") && !token.is("!=") && !token.is("<=") && !token.is(">=");
    if (token.is("=") || token.is("++") || token.is("--") || changes || token.is("{") ||
        token.is("[") || token.is("&") || token.kind == Token::Kind::directive) {
      throw CodeError(
          "'" + token.spelling.substr(0, 20) + "' cannot be read inside an expression" + by_running,
          token.place);
    }
    if (token.is(">") && rest.size() > 1 && rest[1].is("(")) {
      throw CodeError("a call of a template's function cannot be followed" + by_running,
                      token.place);
    }
    put(token, token.spelling, 1);
  }

  [[noreturn]] static void refuse_cast(const Token& token) {
    throw CodeError("a cast cannot be read; leave it out, or give its value a name as double",
                    token.place);
  }

  void put(const Token& at, const std::string& spelled, std::size_t count) {
    std::string& text = formula_.text.text;
    text.replace(at.offset - tokens_[0].offset, spelled.size(), spelled);
    at_ += count;
  }

  Tokens tokens_;
  Dialect dialect_;
  std::size_t at_ = 0;
  CodeFormula formula_;
};

/// Whether a part of a formula is a whole number in C++, and its size, with variables as zero.
struct Whole {
  bool whole = false;
  double most = 0;
};

struct Wholeness {
  const CodeFormula& formula;
  const std::vector<CodeName>& whole;

  Whole operator()(const text::Expression& node) const {
    using Kind = text::Expression::Kind;
    if (node.kind == Kind::number) {
      return {node.name.find_first_not_of("0123456789") == std::string::npos,
              std::strtod(node.name.c_str(), nullptr)};
    }
    if (node.kind == Kind::name) {
      return {is_whole_name(node.name), 0};
    }
    std::vector<Whole> parts;
    for (const text::Expression& argument : node.arguments) {
      parts.push_back((*this)(argument));
    }
    const bool all =
        std::all_of(parts.begin(), parts.end(), [](const Whole& each) { return each.whole; });
    using text::Operation;
    if (all && node.operation == Operation::divide) {
      throw CodeError("a quotient of whole numbers is rounded in C++; write 1.0/2",
                      formula.text.at(node.column));
    }
    const bool product = node.operation == Operation::multiply;
    const bool sum = node.operation == Operation::add || node.operation == Operation::subtract;
    const bool stays = all && (product || sum || node.operation == Operation::negate);
    double most = stays ? parts[0].most : 0;
    for (std::size_t at = 1; stays && at < parts.size(); ++at) {
      most = product ? most * parts[at].most : most + parts[at].most;
    }
    if (stays && most > std::numeric_limits<std::int32_t>::max()) {
      throw CodeError("whole numbers beyond 2147483647 wrap round in C++; write a decimal point",
                      formula.text.at(node.column));
    }
    return {stays, most};
  }

  [[nodiscard]] bool is_whole_name(const std::string& name) const {
    const auto of_formula = std::find_if(formula.names.begin(), formula.names.end(),
                                         [&](const CodeName& each) { return each.name == name; });
    return of_formula != formula.names.end() &&
           std::any_of(whole.begin(), whole.end(),
                       [&](const CodeName& each) { return of_formula->is_part_of(each); });
  }
};

}  // namespace

bool CodeName::is_part_of(const CodeName& whole) const {
  return spelled.starts_with(whole.spelled) &&
         (spelled.size() == whole.spelled.size() || spelled[whole.spelled.size()] == '.' ||
          spelled[whole.spelled.size()] == '[');
}

bool is_known_function(const std::string& name) {
  return name == "pow" || (text::is_reserved_name(name) && name != "pi" && name != "deg");
}

LeadingName leading_name(Tokens tokens) {
  if (tokens.empty() || !tokens[0].is_name()) {
    return {};
  }
  LeadingName found{{tokens[0].spelling, tokens[0].spelling, tokens[0].place}, 1};
  while (true) {
    const Tokens rest = behind(tokens, found.tokens);
    const auto next = [&](std::size_t count) {
      return rest.first(std::min<std::size_t>(rest.size(), count));
    };
    if (rest.size() > 1 && (rest[0].is(".") || rest[0].is("->")) && rest[1].is_name()) {
      found.name.name += "_" + rest[1].spelling;
      found.name.spelled += "." + rest[1].spelling;
      found.tokens += 2;
    } else if (are(next(3), {"[", "#", "]"}) || are(next(3), {"(", "#", ")"})) {
      if (rest[0].is("(") && is_known_function(tokens[0].spelling)) {
        return {};
      }
      found.name.name += "_" + rest[1].spelling;
      found.name.spelled += "[" + rest[1].spelling + "]";
      found.name.called = found.name.called || rest[0].is("(");
      found.tokens += 3;
    } else if (are(next(5), {"(", "#", ",", "#", ")"})) {
      if (is_known_function(tokens[0].spelling)) {
        return {};
      }
      found.name.name += "_" + rest[1].spelling + "_" + rest[3].spelling;
      found.name.spelled += "[" + rest[1].spelling + "][" + rest[3].spelling + "]";
      found.name.called = true;
      found.tokens += 5;
    } else {
      const bool called = !rest.empty() && rest[0].is("(");
      return called ? LeadingName{} : found;
    }
  }
}

CodeFormula code_formula(Tokens tokens, const Dialect& dialect) {
  return FormulaWriter(tokens, dialect).run();
}

bool is_whole(const CodeFormula& formula, const std::vector<CodeName>& whole) {
  text::Expression tree;
  try {
    tree = text::parse_expression(formula.text.text, functions);
  } catch (const text::ExpressionError&) {
    return false;  // the reader of formulas reports it
  }
  return Wholeness{formula, whole}(tree).whole;
}

}  // namespace assur::generator::audit::code
