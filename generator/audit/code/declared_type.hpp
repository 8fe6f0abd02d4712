// The types of C++ declarations, as far as the audit reads their values.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "audit/code/tokens.hpp"

namespace assur::generator::audit::code {

/// The sort of numbers: real, whole, of type float, or rounded or wrapped when they are stored.
enum class Sort : unsigned char { real, whole, single, rounded };

struct Type {
  enum class Kind : unsigned char { number, list, grid, structure, other };

  Kind kind = Kind::other;
  Sort sort = Sort::real;           ///< of its numbers
  std::optional<std::size_t> rows;  ///< for a list, its length
  std::optional<std::size_t> columns;
  bool round = false;       ///< elements are spelled `q(1)`, `J(1, 2)`
  bool square = false;      ///< elements are spelled `q[1]`, `J[1][2]`
  bool plain = false;       ///< a C array
  bool reference = false;   ///< another name for something
  bool pointer = false;     ///< points to something
  bool constant = false;    ///< nothing may be set through it
  bool outlives = false;    ///< `static`
  bool computed = false;    ///< `constexpr`
  bool deduced = false;     ///< `auto`
  bool undeclared = false;  ///< a name that the file does not declare
  std::vector<std::pair<std::string, Type>> members{};

  /// Whether an assignment may change another variable.
  [[nodiscard]] bool is_shared() const { return reference || pointer; }
  /// An array of `length` values of this type.
  [[nodiscard]] Type array(std::optional<std::size_t> length) const;
};

/// A type, the name after it, and the tokens that follow the name.
struct Declarator {
  Type type;
  const Token* name;
  Tokens rest;
};

/// The types that a file may use: its own and those of the standard library and Eigen.
class TypeNames {
 public:
  /// Takes a type from the front of the tokens; empty if they do not begin with one.
  [[nodiscard]] std::optional<Type> take(Tokens& tokens) const;
  /// Takes a name, in brackets where C++ requires them, and the sizes after it. Throws CodeError.
  [[nodiscard]] Declarator take_name(const Type& type, Tokens tokens) const;

  /// `using NAME = TYPE`, `typedef TYPE NAME`, `using std::NAME`, `using namespace std`, or a
  /// structure with a list of members. Throws CodeError for anything else.
  void read_using(Tokens statement);
  void read_typedef(Tokens statement);
  void read_structure(const Token& name, Tokens members);
  /// Throws CodeError if the name has a meaning already.
  void define(const Token& name, Type type);
  [[nodiscard]] bool knows(const Token& name) const { return own_.contains(name.spelling); }
  /// Whether `NAME` without qualification means the one of the namespace.
  [[nodiscard]] bool opens(const std::string& space, const std::string& name) const {
    return opened_.contains(space) || opened_.contains(space + "::" + name);
  }

 private:
  [[nodiscard]] std::optional<Type> take_base(Tokens& tokens) const;
  [[nodiscard]] Type take_named(Tokens& tokens) const;
  [[nodiscard]] Type made_of(const std::string& space, const std::string& name,
                             const std::vector<Tokens>& arguments) const;

  std::map<std::string, Type> own_;
  std::set<std::string> opened_;  ///< `std`, `Eigen::Matrix2d`
};

/// Removes attributes that change nothing. Throws CodeError for others.
[[nodiscard]] Tokens without_attributes(Tokens tokens);
/// Whether formulas have a function of this name with the same meaning.
[[nodiscard]] bool is_known_function(const std::string& name);
/// Whether code may not redefine this name.
[[nodiscard]] bool has_meaning(const std::string& name);
/// Throws CodeError if has_meaning(name).
void expect_new_meaning(const Token& name);

}  // namespace assur::generator::audit::code
