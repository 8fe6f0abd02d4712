// Expressions and statements of emitted functions as trees, with queries of what they read and
// call.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace assur::generator::emission::cpp {

/// The name of a function or of a type.
struct Name {
  // Names are mostly literals.
  Name(const char* spelled) : text(spelled) {}             // NOLINT
  Name(std::string spelled) : text(std::move(spelled)) {}  // NOLINT
  Name(std::string spelled, std::string short_name, bool serves_packs = true)
      : text(std::move(spelled)), alias(std::move(short_name)), in_packs(serves_packs) {}

  std::string text;
  std::string alias;     ///< the short name of a type that the text contains, if any
  bool in_packs = true;  ///< whether it serves several values at once
};

/// A short name of a type, such as `LinkFrame`.
[[nodiscard]] Name alias(const std::string& name);
/// A function or a type that serves only one value at a time, such as `std::sqrt`.
[[nodiscard]] Name scalar_only(const std::string& name);

/// An expression as a tree. The printer sets the parentheses that C++ needs.
struct Expression {
  enum class Form : unsigned char {
    number,       ///< a value of the solver's scalar
    word,         ///< a count, a place or `true`
    variable,     ///< of the function, by its name
    local,        ///< a variable whose name gets a suffix if others have the name
    member,       ///< part.text
    entry,        ///< part(parts), of a matrix, or a call of a member
    item,         ///< part[text]
    call,         ///< name(parts)
    braces,       ///< name{parts}
    address,      ///< &part
    parentheses,  ///< (part)
    negative,     ///< -part
    sum,          ///< parts, of which some are negative
    product,
    quotient,  ///< of two parts
    infix      ///< parts with the operator `text` between them
  };
  Form form = Form::word;
  double value = 0;  ///< of a number
  int local = 0;     ///< the number of a local
  std::string text;
  Name name{""};
  std::vector<Expression> parts;

  [[nodiscard]] Expression member(const std::string& of) const;
  /// `x.rates.row(0)` is `x.member("rates").member("row").at({word(0)})`.
  [[nodiscard]] Expression at(std::vector<Expression> places) const;
  [[nodiscard]] Expression item(std::size_t place) const;
  [[nodiscard]] bool is_number() const { return form == Form::number; }
  [[nodiscard]] bool is_number(double other) const { return is_number() && value == other; }
};

[[nodiscard]] Expression number(double value);
[[nodiscard]] Expression word(const std::string& text);
[[nodiscard]] Expression word(std::size_t count);
[[nodiscard]] Expression variable(const std::string& name);
[[nodiscard]] Expression call(Name function, std::vector<Expression> arguments = {});
/// A value of a type; with an empty name the context determines the type.
[[nodiscard]] Expression braces(Name type, std::vector<Expression> members = {});
/// `std::array<Type, 2>{{a, b}}`
[[nodiscard]] Expression array(const Name& type, std::vector<Expression> items);
[[nodiscard]] Expression address(Expression of);
[[nodiscard]] Expression parentheses(Expression inner);
/// The negative of a negative is the inner expression.
[[nodiscard]] Expression negative(Expression of);
[[nodiscard]] Expression sum(std::vector<Expression> terms);
[[nodiscard]] Expression product(std::vector<Expression> factors);
[[nodiscard]] Expression quotient(Expression above, Expression below);
[[nodiscard]] Expression infix(const std::string& operation, std::vector<Expression> parts);

/// A statement of a function.
struct Statement {
  std::optional<Name> type;          ///< of a declaration
  std::optional<Expression> target;  ///< declared or assigned; none for a call or a result
  std::optional<Expression> value;   ///< a declaration may have none
  std::string comment;
  bool is_result = false;
};
using Block = std::vector<Statement>;

[[nodiscard]] Statement declared(Name type, Expression target,
                                 std::optional<Expression> value = std::nullopt);
[[nodiscard]] Statement assigned(Expression target, Expression value,
                                 const std::string& comment = "");
[[nodiscard]] Statement called(Expression call);
[[nodiscard]] Statement returned(Expression value);

using Visit = std::function<void(const Expression&)>;
/// Visits an expression and all its parts, or all expressions of a statement.
void visit(const Expression& expression, const Visit& visitor);
void visit(const Statement& statement, const Visit& visitor);

/// Whether a part of one of the statements has a property.
[[nodiscard]] bool any_part(const Block& block,
                            const std::function<bool(const Expression&)>& has_property);
/// Whether a statement reads a variable; its own declaration does not count.
[[nodiscard]] bool reads(const Statement& statement, const std::string& variable);
[[nodiscard]] bool reads(const Block& block, const std::string& variable);
/// Whether one of the statements declares a variable; locals do not count.
[[nodiscard]] bool declares(const Block& block, const std::string& variable);
/// The short names of types that the statements use.
[[nodiscard]] std::set<std::string> aliases_in(const Block& block);
/// Whether the statements serve several values at once.
[[nodiscard]] bool serves_packs(const Block& block);

}  // namespace assur::generator::emission::cpp
