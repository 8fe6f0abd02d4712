// The values that names in code, and expressions of them, have at that point.
#pragma once

#include <ginac/ginac.h>

#include "audit/code/declared_type.hpp"
#include "closures/read_formula.hpp"

namespace assur::generator::audit::code {

/// A value that the code computes but that the reader does not know: an error only where it is
/// read.
struct Unreadable : CodeError {
  using CodeError::CodeError;
};

enum class Language : unsigned char { cpp, matlab };

/// What is stored at one place: a value, or why it cannot be read.
struct Cell {
  std::optional<GiNaC::ex> value;
  Sort sort = Sort::real;
  std::string reason{};
  closures::Place place{};        ///< of what was assigned
  closures::PlacedText source{};  ///< what was assigned, as it stands in the code
};

/// A variable and its places: `` for a number, `.l`, `[1]` or `[1][2]` for parts.
struct Variable {
  enum class Origin : unsigned char {
    given,  ///< a parameter: what is never set is the symbol of its name
    own,    ///< what is never set has no value
    free    ///< the code does not declare it: separate real numbers, symbols where never set
  };

  Origin origin = Origin::free;
  closures::Place place{};
  std::optional<Type> type{};        ///< without one, its parts follow from how it is used
  std::string refused{};             ///< why nothing of it can be read
  std::vector<std::string> parts{};  ///< all that are spelled, one of each shape
  std::map<std::string, Cell> cells{};
  bool zero = false;  ///< what is never set is zero
};

/// A number that is spelled in the code: a variable or a part of one.
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
  bool shared = false;  ///< what is set here may belong to something else

  [[nodiscard]] std::string text() const { return name + part; }
};

class Variables {
 public:
  Variables(closures::ClosureSystem& system, Language language)
      : system_(system), language_(language) {}

  [[nodiscard]] closures::ClosureSystem& system() const { return system_; }
  [[nodiscard]] Language language() const { return language_; }

  /// Throws CodeError for a name that means something else already.
  Variable& declare(const Token& name, Variable::Origin origin, std::optional<Type> type);
  /// What is declared from now on hides what was declared before.
  void enter_function() {
    outer_ = std::move(inner_);
    inner_.clear();
    in_function_ = true;
  }
  /// Forgets what the function declared.
  void leave_function() {
    inner_ = std::move(outer_);
    in_function_ = false;
  }
  [[nodiscard]] bool in_function() const { return in_function_; }
  [[nodiscard]] bool is_of_function(const std::string& name) const {
    return in_function_ && inner_.contains(name);
  }
  /// Whatever is spelled `NAME(...)` is a call of a function of the file.
  void add_function(const std::string& name) { functions_.insert(name); }
  [[nodiscard]] bool is_function(const std::string& name) const {
    return functions_.contains(name);
  }
  /// The variable of that name, or nullptr.
  [[nodiscard]] Variable* find(const std::string& name);
  /// The variable of that name, which is one that nothing declares if there is no other.
  [[nodiscard]] Variable& found(const Token& name);

  /// The number with which the tokens begin. Throws CodeError for what is no number.
  [[nodiscard]] Spelled spelled(Tokens tokens);
  /// Its value now. Throws Unreadable.
  [[nodiscard]] Cell read(const Spelled& number);
  /// Throws CodeError where setting it may change something else.
  void set(const Spelled& number, Cell cell);
  /// A reference is held to it: it may not be set any more.
  void hold(const Spelled& number) { held_.emplace_back(number.variable, number.part); }
  /// Throws CodeError for what is held.
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
  std::map<std::string, std::string> symbols_;  ///< how those are spelled that were read
  std::vector<std::pair<const Variable*, std::string>> held_;
  bool in_function_ = false;
};

/// Sums, products, quotients, signs, brackets, calls of the functions that formulas have, numbers,
/// pi, and variables; in MATLAB powers as well. The cell has a reason in place of a value where
/// a formula could not be read either. Throws Unreadable for a variable that cannot be read, and
/// CodeError for everything else, since it may do more than give a value.
[[nodiscard]] Cell read_expression(Tokens tokens, Variables& variables, const TypeNames* types,
                                   std::vector<Spelled>* used = nullptr);

}  // namespace assur::generator::audit::code
