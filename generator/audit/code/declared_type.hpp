// Turns the type of a C++ declaration into what is known of its values; all other types are
// `other`.
#pragma once

#include <map>
#include <optional>
#include <set>

#include "audit/code/tokens.hpp"

namespace assur::generator::audit::code {

/// What numbers are to a formula: real ones, whole ones, those of type float, or numbers that are
/// rounded or wrapped round when they are stored.
enum class Sort : unsigned char { real, whole, single, rounded };

struct Type {
  enum class Kind : unsigned char { number, list, grid, structure, other };

  Kind kind = Kind::other;
  Sort sort = Sort::real;           ///< of its numbers
  std::optional<std::size_t> rows;  ///< of a list, its length
  std::optional<std::size_t> columns;
  bool round = false;       ///< elements are spelled `q(1)`, `J(1, 2)`
  bool square = false;      ///< elements are spelled `q[1]`, `J[1][2]`
  bool plain = false;       ///< an array of C
  bool reference = false;   ///< another name for something
  bool pointer = false;     ///< points to something
  bool constant = false;    ///< nothing is set through it
  bool outlives = false;    ///< `static`
  bool computed = false;    ///< `constexpr`
  bool deduced = false;     ///< `auto`
  bool undeclared = false;  ///< a name that the file does not declare
  std::vector<std::pair<std::string, Type>> members{};

  /// Whether what is set through it may belong to something else.
  [[nodiscard]] bool is_shared() const { return reference || pointer; }
  /// An array of so many values of this type.
  [[nodiscard]] Type array(std::optional<std::size_t> length) const;
};

/// A type, the name behind it, and what follows the name.
struct Declarator {
  Type type;
  const Token* name;
  Tokens rest;
};

/// The types that a file knows: those of its own and of the standard library and Eigen.
class TypeNames {
 public:
  /// Takes a type from the front of the tokens; nothing where they begin with none.
  [[nodiscard]] std::optional<Type> take(Tokens& tokens) const;
  /// Takes a name, in brackets where it must be, and the sizes behind it. Throws CodeError.
  [[nodiscard]] Declarator take_name(const Type& type, Tokens tokens) const;

  /// `using NAME = TYPE`, `typedef TYPE NAME`, `using std::NAME`, `using namespace std`, or a
  /// structure with a list of members. Throws CodeError for all else.
  void read_using(Tokens statement);
  void read_typedef(Tokens statement);
  void read_structure(const Token& name, Tokens members);
  /// Throws CodeError for a name that has a meaning.
  void define(const Token& name, Type type);
  [[nodiscard]] bool knows(const Token& name) const { return own_.contains(name.spelling); }
  /// Whether `NAME` alone is the one of the namespace.
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

/// Leaves out attributes that change nothing. Throws CodeError for others.
[[nodiscard]] Tokens without_attributes(Tokens tokens);
/// Whether a function of this name is the one of formulas.
[[nodiscard]] bool is_known_function(const std::string& name);
/// Whether code may not give this name another meaning.
[[nodiscard]] bool has_meaning(const std::string& name);
/// Throws CodeError if so.
void expect_new_meaning(const Token& name);

}  // namespace assur::generator::audit::code
