// The current values of the variables of code, and of expressions in them.
#pragma once

#include <ginac/ginac.h>

#include "audit/code/declared_type.hpp"
#include "closures/read_formula.hpp"

namespace assur::generator::audit::code {

/// A value that is computed by code that cannot be read: an error only if it is used.
struct Unreadable : CodeError {
  using CodeError::CodeError;
};

enum class Language : unsigned char { cpp, matlab };

/// The content of one storage place: a value, or the reason why it cannot be read.
struct Cell {
  std::optional<GiNaC::ex> value;
  Sort sort = Sort::real;
  std::string reason{};
  closures::Place place{};        ///< of what was assigned
  closures::PlacedText source{};  ///< the assigned expression, as written in the code
};

/// A variable and its parts: `` for a number, `.l`, `[1]` or `[1][2]` for parts.
struct Variable {
  enum class Origin : unsigned char {
    given,  ///< a parameter: a part that is never set is the symbol of its name
    own,    ///< a part that is never set has no value
    free    ///< undeclared: independent real numbers, symbols where never set
  };

  Origin origin = Origin::free;
  closures::Place place{};
  std::optional<Type> type{};        ///< if absent, the parts follow from their use
  std::string refused{};             ///< why no part can be read
  std::vector<std::string> parts{};  ///< all parts that occur, one of each shape
  std::map<std::string, Cell> cells{};
  bool zero = false;  ///< parts that are never set are zero
};

/// A number as written in the code: a variable or a part of one.
struct Spelled {
  Variable* variable;
  std::string name;
  std::string part;
  std::string formula;  ///< its symbol: `p_l`, `q_1`, `J_1_2`
  std::vector<std::size_t> indices;
  Sort sort = Sort::real;
  closures::Place place;
  std::size_t tokens;
  bool round = false;
  bool shared = false;  ///< an assignment here may change another variable

  [[nodiscard]] std::string text() const { return name + part; }
};

class Variables {
 public:
  Variables(closures::ClosureSystem& system, Language language)
      : system_(system), language_(language) {}

  [[nodiscard]] closures::ClosureSystem& system() const { return system_; }
  [[nodiscard]] Language language() const { return language_; }

  /// Throws CodeError for a name that has another meaning already.
  Variable& declare(const Token& name, Variable::Origin origin, std::optional<Type> type);
  /// Declarations from now on hide earlier ones.
  void enter_function() {
    outer_ = std::move(inner_);
    inner_.clear();
    in_function_ = true;
  }
  /// Removes the declarations of the function.
  void leave_function() {
    inner_ = std::move(outer_);
    in_function_ = false;
  }
  [[nodiscard]] bool in_function() const { return in_function_; }
  [[nodiscard]] bool is_of_function(const std::string& name) const {
    return in_function_ && inner_.contains(name);
  }
  /// From now on `NAME(...)` is a call of a function of the file.
  void add_function(const std::string& name) { functions_.insert(name); }
  [[nodiscard]] bool is_function(const std::string& name) const {
    return functions_.contains(name);
  }
  /// The variable of that name, or nullptr.
  [[nodiscard]] Variable* find(const std::string& name);
  /// The variable of that name; an undeclared one is added if there is none.
  [[nodiscard]] Variable& found(const Token& name);

  /// The number with which the tokens begin. Throws CodeError if they begin with something else.
  [[nodiscard]] Spelled spelled(Tokens tokens);
  /// The current value. Throws Unreadable.
  [[nodiscard]] Cell read(const Spelled& number);
  /// Throws CodeError if the assignment may change another variable.
  void set(const Spelled& number, Cell cell);
  /// Notes that a reference to it exists: it may not be set any more.
  void hold(const Spelled& number) { held_.emplace_back(number.variable, number.part); }
  /// Throws CodeError if a reference to it exists.
  void expect_free(const Variable& variable, const std::string& part, const std::string& text,
                   closures::Place place) const;

 private:
  void take_parts(Tokens rest, Spelled& number) const;
  void take_inferred(Tokens rest, Spelled& number) const;
  static void expect_one_shape(Spelled& number);

  closures::ClosureSystem& system_;
  Language language_;
  std::map<std::string, Variable> outer_;
  std::map<std::string, Variable> inner_;
  std::set<std::string> functions_;
  std::map<std::string, std::string> symbols_;  ///< the spelling of each symbol that was read
  std::vector<std::pair<const Variable*, std::string>> held_;
  bool in_function_ = false;
};

/// Sums, products, quotients, signs, brackets, calls of the functions of formulas, numbers, pi, and
/// variables; in MATLAB also powers. The cell has a reason in place of a value where a formula
/// would be unreadable, too. Throws Unreadable for a variable that cannot be read, and CodeError
/// for anything else, since it may have side effects.
[[nodiscard]] Cell read_expression(Tokens tokens, Variables& variables, const TypeNames* types,
                                   std::vector<Spelled>* used = nullptr);

}  // namespace assur::generator::audit::code
