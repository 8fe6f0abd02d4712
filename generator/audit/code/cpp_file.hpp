// What a C++ file declares: functions, structures, statements, and lines for the preprocessor.
#pragma once

#include "audit/code/tokens.hpp"

namespace assur::generator::audit::code {

struct CppItem {
  enum class Kind : unsigned char { statement, function, structure, enumeration };

  Kind kind;
  Tokens all;                   ///< of a statement, without its semicolon
  const Token* name = nullptr;  ///< of a function or a structure
  Tokens type{};                ///< what stands before a function's name
  Tokens parameters{};
  Tokens inside{};         ///< between the braces
  bool templated = false;  ///< its types are given by a template
  bool odd = false;        ///< more than parameters stands before a function's braces
};

/// Throws CodeError for what is neither a statement, nor a function, nor a structure with a list of
/// members, nor an enumeration; for macros and conditions of the preprocessor; and for operators.
[[nodiscard]] std::vector<CppItem> cpp_items(Tokens tokens);

/// The statements between braces. Throws CodeError for control flow, nested blocks and what stands
/// behind a `return`.
[[nodiscard]] std::vector<Tokens> statements_of(Tokens inside);
/// Throws CodeError for a word of control flow or memory, and says which.
void expect_plain_words(Tokens statement);

/// Whether a token names the variable, and not a member of something else.
[[nodiscard]] bool names_variable(Tokens tokens, std::size_t at, const std::string& name);
/// The first token that names the variable, or nullptr.
[[nodiscard]] const Token* mention_of(Tokens tokens, const std::string& name);

/// Throws CodeError unless all directives change nothing: known headers, `#pragma once`, `#define
/// _USE_MATH_DEFINES`, and a guard around the file.
void check_directives(Tokens tokens);

}  // namespace assur::generator::audit::code
