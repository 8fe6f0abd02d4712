// Tokens of C++ and MATLAB with their places, and the error of code that cannot be read.
#pragma once

#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "closures/statement.hpp"

namespace assur::generator::audit::code {

struct CodeError : std::runtime_error {
  CodeError(const std::string& what, closures::Place at) : std::runtime_error(what), place(at) {}
  closures::Place place;
};

/// The advice for code other than plain assignments.
inline const std::string by_running = "; audit it by running: 'printed run' with --run";

struct Token {
  /// A `text` is a string or a character, a `directive` a whole line for the preprocessor.
  enum class Kind : unsigned char { name, number, text, mark, directive };

  Kind kind;
  std::string spelling;
  closures::Place place;
  std::size_t offset;  ///< of its first character in the code

  [[nodiscard]] bool is(const char* spelled) const {
    return kind != Kind::text && spelling == spelled;
  }
  [[nodiscard]] bool is_name() const { return kind == Kind::name; }
};

using Tokens = std::span<const Token>;

/// The tokens without comments. Throws CodeError for digraphs, trigraphs, universal character
/// names, and characters that are not part of C++.
[[nodiscard]] std::vector<Token> code_tokens(const std::string& code);

/// The index after the bracket that closes the one at `open`. Throws CodeError if there is none.
[[nodiscard]] std::size_t behind_closing(Tokens tokens, std::size_t open);
/// The parts between the commas that stand outside brackets.
[[nodiscard]] std::vector<Tokens> comma_parts(Tokens tokens);
/// The parts of a list of declarations: commas between `<` and `>` are part of a type.
[[nodiscard]] std::vector<Tokens> declared_parts(Tokens tokens);
/// At most `count` tokens from the front.
[[nodiscard]] inline Tokens first_of(Tokens tokens, std::size_t count) {
  return tokens.first(count < tokens.size() ? count : tokens.size());
}
/// Whether the tokens are these, one after the other; `#` matches any integer.
[[nodiscard]] bool are(Tokens tokens, std::initializer_list<const char*> spelled);
/// The value of an integer token; 999999 for more than six digits, which no index has.
[[nodiscard]] std::size_t whole_number(const Token& token);

/// MATLAB with comments and line continuations blanked and `.*` as ` *`, so that every character
/// keeps its place and the tokens are those of C++. Throws CodeError.
struct PlainMatlab {
  std::string text;
  std::set<std::size_t> joined_lines;  ///< lines that continue on the next one
};
[[nodiscard]] PlainMatlab plain_matlab(const std::string& code);
/// The elements of `[a, b; c d]` without its brackets, row by row.
[[nodiscard]] std::vector<std::vector<Tokens>> matlab_rows(
    Tokens inside, const std::set<std::size_t>& joined_lines);

}  // namespace assur::generator::audit::code
