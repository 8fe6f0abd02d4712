// The variables of a C++ function, except its matrix, and what its statements set them to.
#pragma once

#include "audit/code/code_entries.hpp"

namespace assur::generator::audit::code {

class CppScope : public CodeReader {
 public:
  CppScope(const std::string& code, const AuditedMatrix& audited, closures::ClosureSystem& system)
      : CodeReader(code, audited, system, Language::cpp), array_(audited.array) {}

  [[nodiscard]] const std::string& array() const { return array_; }
  [[nodiscard]] const AuditedMatrix& audited() const { return audited_; }
  [[nodiscard]] Variables& variables() { return variables_; }
  [[nodiscard]] const TypeNames& types() const { return types_; }

  [[noreturn]] void refuse(const Token& at) const;
  [[noreturn]] void refuse_statement(Tokens statement) const;
  [[noreturn]] void refuse_mention(const Token& token, const std::string& where) const;
  /// Throws CodeError for a function that formulas have.
  void read_function_name(const Token& name);
  /// Comparisons of expressions.
  void read_condition(Tokens condition);
  /// A type, and a name behind it.
  [[nodiscard]] bool is_declaration(Tokens statement);
  /// `name = EXPR`, `name{EXPR}`, `name(EXPR)`, `name`, or a list without values that are read.
  void declare(const Declarator& declared);
  /// Values of a list are not read, and do no more than give values.
  void declare_list(Variable& variable, Tokens value, const Token& name);
  /// The values in nested braces, from left to right.
  [[nodiscard]] std::vector<Cell> leaves_of(Tokens value);
  /// A value, or that it reads what cannot be read.
  [[nodiscard]] Cell kept(Tokens value, std::vector<Spelled>* used = nullptr);
  /// What a variable of that sort keeps of a value.
  [[nodiscard]] static Cell stored(Cell cell, Sort sort);
  /// `TARGET = EXPR`; after `TARGET += EXPR` the target cannot be read. Throws CodeError where the
  /// target may be more than the function's own variable.
  void assign(Tokens part, Tokens statement);
  /// Throws CodeError where a value mentions the matrix and not one of its entries.
  void check_reading(Tokens value) const;
  /// How many tokens at the front are an entry of the matrix; zero if they are none.
  [[nodiscard]] std::size_t entry_length(Tokens tokens) const;

 protected:
  const std::string& array_;
  bool gives_values_ = false;  ///< it is the name of a function
};

/// Whether the first bracket closes at the end.
[[nodiscard]] inline bool is_enclosed(Tokens tokens, const char* open) {
  return !tokens.empty() && tokens[0].is(open) && behind_closing(tokens, 0) == tokens.size();
}
[[nodiscard]] inline Tokens inside_of(Tokens tokens) {
  return tokens.subspan(1, tokens.size() - 2);
}

}  // namespace assur::generator::audit::code
