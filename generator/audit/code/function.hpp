// Turns the tokens of a C++ file into the statements of the one function that fills a matrix.
#pragma once

#include <optional>

#include "audit/code/tokens.hpp"

namespace assur::generator::audit::code {

struct FillingFunction {
  std::vector<Tokens> globals;     ///< statements outside functions, which run before
  std::vector<Tokens> statements;  ///< without the semicolons
  Tokens parameters;               ///< empty where the file is a list of statements
  std::vector<Tokens> templated;   ///< between the brackets of `template <...>`
  std::vector<Tokens> members;     ///< declarations inside the file's types
  std::vector<Token> constants;    ///< names in its enumerations
  std::vector<Token> functions;    ///< names of all functions of the file
  bool is_function = false;
};

/// Whether a token names the matrix, and not a member of something else.
[[nodiscard]] bool names_matrix(Tokens tokens, std::size_t at, const std::string& array);
/// The first token that names the matrix, or nullptr.
[[nodiscard]] const Token* mention_of(Tokens tokens, const std::string& array);

/// A file in which no function mentions the matrix counts as the body of one. Throws CodeError for
/// everything that may make the code do more than run its statements in turn: a second function
/// that mentions the matrix, control flow, nested blocks, macros and conditions of the
/// preprocessor, and definitions of functions that formulas know.
[[nodiscard]] FillingFunction filling_function(Tokens tokens, const std::string& array);

}  // namespace assur::generator::audit::code
