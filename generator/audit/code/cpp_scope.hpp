// The variables of a C++ function, except its matrix, and the values that its statements assign.
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
  /// A comparison of expressions.
  void read_condition(Tokens condition);
  /// Whether a statement begins with a type and a name.
  [[nodiscard]] bool is_declaration(Tokens statement);
  /// `name = EXPR`, `name{EXPR}`, `name(EXPR)`, `name`, or a list whose values are not read.
  void declare(const Declarator& declared);
  /// Checks that the values of a list, which are not read, have no side effects.
  void declare_list(Variable& variable, Tokens value, const Token& name);
  /// The values in nested braces, from left to right.
  [[nodiscard]] std::vector<Cell> leaves_of(Tokens value);
  /// The value of an expression, or an unreadable cell if it reads unreadable variables.
  [[nodiscard]] Cell kept(Tokens value, std::vector<Spelled>* used = nullptr);
  /// The value after conversion to that sort.
  [[nodiscard]] static Cell stored(Cell cell, Sort sort);
  /// `TARGET = EXPR`; after `TARGET += EXPR` the target is unreadable. Throws CodeError where the
  /// target may be shared with other variables.
  void assign(Tokens part, Tokens statement);
  /// Throws CodeError where a value mentions the matrix other than by an entry.
  void check_reading(Tokens value) const;
  /// The number of tokens at the front that spell an entry of the matrix; zero if none.
  [[nodiscard]] std::size_t entry_length(Tokens tokens) const;

 protected:
  const std::string& array_;
  bool gives_values_ = false;  ///< the audited name is that of a function
};

/// Whether the bracket that opens first closes last.
[[nodiscard]] inline bool is_enclosed(Tokens tokens, const char* open) {
  return !tokens.empty() && tokens[0].is(open) && behind_closing(tokens, 0) == tokens.size();
}
[[nodiscard]] inline Tokens inside_of(Tokens tokens) {
  return tokens.subspan(1, tokens.size() - 2);
}

}  // namespace assur::generator::audit::code
