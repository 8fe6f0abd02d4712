// The declarations of a C++ file: functions, structures, statements and preprocessor lines.
#pragma once

#include "audit/code/tokens.hpp"

namespace assur::generator::audit::code {

struct CppItem {
  enum class Kind : unsigned char { statement, function, structure, enumeration };

  Kind kind;
  Tokens all;                   ///< of a statement, without its semicolon
  const Token* name = nullptr;  ///< of a function or a structure
  Tokens type{};                ///< the tokens before a function's name
  Tokens parameters{};
  Tokens inside{};         ///< between the braces
  bool templated = false;  ///< its types are given by a template
  bool odd = false;        ///< other tokens between a function's parameters and its braces
};

/// Throws CodeError for anything but a statement, a function, a structure with a list of members or
/// an enumeration; for macros and conditions of the preprocessor; and for operators.
[[nodiscard]] std::vector<CppItem> cpp_items(Tokens tokens);

/// The statements between braces. Throws CodeError for control flow, nested blocks and statements
/// after a `return`.
[[nodiscard]] std::vector<Tokens> statements_of(Tokens inside);
/// Throws CodeError that names the keyword of control flow or memory, if there is one.
void expect_plain_words(Tokens statement);

/// Whether a token names the variable, and not a member of something else.
[[nodiscard]] bool names_variable(Tokens tokens, std::size_t at, const std::string& name);
/// The first token that names the variable, or nullptr.
[[nodiscard]] const Token* mention_of(Tokens tokens, const std::string& name);

/// Throws CodeError unless no directive changes the code: known headers, `#pragma once`, `#define
/// _USE_MATH_DEFINES`, and an include guard are allowed.
void check_directives(Tokens tokens);

}  // namespace assur::generator::audit::code
