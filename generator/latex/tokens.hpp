// Tokens of LaTeX with their lines and columns.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "closures/read_formula.hpp"

namespace assur::generator::latex {

using closures::FormulaError;
using closures::Place;

/// A control sequence with its backslash, or one character. White space and comments are skipped.
struct Token {
  std::string text;
  Place place;
  std::size_t from = 0;  ///< position in the file, in bytes
  std::size_t to = 0;
  bool spaced = false;  ///< white space precedes it

  [[nodiscard]] bool is(const char* other) const { return text == other; }
  [[nodiscard]] bool is_letter() const;
  [[nodiscard]] bool is_digit() const;
  [[nodiscard]] bool is_command() const { return text.size() > 1 && text[0] == '\\'; }
};

using Tokens = std::vector<Token>;

template <typename List>
[[nodiscard]] bool contains(const List& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// The tokens of a file, or of a part of it that begins at some place, without verbatim text.
/// Throws InputError for a text that is not UTF-8, and FormulaError for a final backslash.
[[nodiscard]] Tokens tokens_of(const std::string& text, const std::string& file,
                               Place begin = {1, 1});

/// The largest number of tokens of an equation or a notation. More of them, or more nesting, than
/// any person writes would exhaust the stack or the time.
constexpr std::size_t longest_equation = 20'000;
/// Throws FormulaError if there are too many tokens, or too deeply nested braces.
void expect_readable_size(const Tokens& tokens);

/// Brackets that are printed.
[[nodiscard]] bool opens(const Token& token);
[[nodiscard]] bool closes(const Token& token);

/// The place after the group, or single token, that begins at `at`. Throws FormulaError if there is
/// none before `limit`.
[[nodiscard]] std::size_t end_of_argument(const Tokens& tokens, std::size_t at,
                                          std::size_t limit = std::string::npos);
/// Returns the argument that begins at `at`, without its braces, and moves `at` past it.
[[nodiscard]] Tokens take_argument(const Tokens& tokens, std::size_t& at);
/// The characters of tokens one after the other, as in the name of an environment.
[[nodiscard]] std::string letters_of(const Tokens& tokens);
/// Horizontal space that does not separate formulas: `\,` and the like.
[[nodiscard]] bool is_thin_space(const Token& token);
/// Tokens that only change the look of a formula: `\displaystyle`, `\allowbreak`, `\left`.
[[nodiscard]] bool is_layout(const Token& token);

}  // namespace assur::generator::latex
