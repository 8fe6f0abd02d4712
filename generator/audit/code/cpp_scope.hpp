// Turns what a C++ file and its function declare, except the matrix, into names for formulas.
#pragma once

#include "audit/code/declared_type.hpp"
#include "audit/code/function.hpp"
#include "audit/code/local_values.hpp"

namespace assur::generator::audit::code {

/// Whether one of the tokens has this spelling.
[[nodiscard]] bool has(Tokens tokens, const char* spelled);

class CppScope {
 public:
  CppScope(const std::string& array, closures::ClosureSystem& system)
      : array_(array), locals_(system, {}) {}

  [[nodiscard]] LocalValues& locals() { return locals_; }
  [[nodiscard]] TypeNames& types() { return types_; }

  /// Reads what the file has beside its statements: types, constants, functions and templates.
  void read_file(const FillingFunction& file);
  /// Reads a parameter of the function; `shared` if something else may be changed through it.
  void take_parameter(Tokens parameter, bool shared);
  /// `name = EXPR`, `name{EXPR}`, `name(EXPR)` or `name` behind a type. Throws CodeError.
  void declare(Tokens part, Tokens statement, Tokens type);
  /// `name = EXPR` without a type; after `name += EXPR` the name is unreadable. Throws CodeError.
  void assign(Tokens part, Tokens statement);
  /// Throws CodeError where a value mentions the matrix and not one of its entries.
  void check_reading(Tokens value) const;

  /// Throws CodeError for the name of a function of formulas.
  static void expect_no_function(const CodeName& name);
  /// Throw CodeError for a use of the matrix, and for a statement, that cannot be read.
  [[noreturn]] void refuse(const Token& at) const;
  [[noreturn]] void refuse_statement(Tokens statement) const;

 private:
  void check_list(Tokens values) const;
  void read_template(Tokens parameter);
  [[nodiscard]] bool is_whole_value(Tokens value) const;

  /// What the function may set, and how.
  struct Declared {
    CodeName name;
    ValueSort sort = ValueSort::real;
    bool shared = false;        ///< something else may be set through it
    bool shared_parts = false;  ///< something else may be set through its parts
  };
  /// The last declaration of that name, or of a variable that it is a part of; nullptr if none.
  [[nodiscard]] const Declared* declared(const CodeName& name) const;
  void read_member(Tokens member);

  const std::string& array_;
  LocalValues locals_;
  TypeNames types_;
  std::vector<Declared> declared_;
  bool in_function_ = false;
};

}  // namespace assur::generator::audit::code
