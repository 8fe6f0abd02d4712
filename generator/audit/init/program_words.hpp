// The words of a program in any language that audits run, without comments.
#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace assur::generator::audit::init {

enum class Language : unsigned char { cpp, c, javascript, python, matlab };

/// By the ending of the file's name; empty for a language that audits do not run.
[[nodiscard]] std::optional<Language> language_of_file(const std::string& file);
[[nodiscard]] inline bool is_c_or_cpp(Language language) {
  return language == Language::c || language == Language::cpp;
}
/// The first index of a list.
[[nodiscard]] inline std::size_t first_index(Language language) {
  return language == Language::matlab ? 1 : 0;
}

struct Word {
  /// A `line_end` ends a statement; only Python and MATLAB have them.
  enum class Kind : unsigned char { name, number, text, mark, line_end };

  Kind kind;
  std::string text;
  std::size_t indent = 0;  ///< of its line
  bool spaced = false;     ///< white space precedes it

  [[nodiscard]] bool is(const char* other) const { return kind != Kind::text && text == other; }
  [[nodiscard]] bool is_name() const { return kind == Kind::name; }
  [[nodiscard]] bool ends_line() const { return kind == Kind::line_end; }
};

using Words = std::span<const Word>;

/// Line ends inside the brackets of Python are left out; inside those of MATLAB they are
/// semicolons, and blanks between entries are commas. Characters that cannot be read are left out.
[[nodiscard]] std::vector<Word> program_words(const std::string& code, Language language);

/// The index after the bracket that closes the one at `open`, or the end.
[[nodiscard]] std::size_t behind_bracket(Words words, std::size_t open);
/// The parts between the separators outside brackets; an empty list has none.
[[nodiscard]] std::vector<Words> parts(Words words, const char* separator);
/// The words one after the other, with a blank between two names.
[[nodiscard]] std::string spelled(Words words);

/// A number of at most three digits, such as an index.
[[nodiscard]] bool is_whole(const Word& word);
[[nodiscard]] std::size_t number_of(const Word& word);
[[nodiscard]] bool is_one_of(const Word& word, std::initializer_list<const char*> list);
/// The first of these marks outside brackets, or the end.
[[nodiscard]] std::size_t find_mark(Words words, const char* mark);
/// The words inside the bracket that opens at a place.
[[nodiscard]] Words inside(Words words, std::size_t open);
/// Whether one bracket encloses all of the words.
[[nodiscard]] bool is_whole_bracket(Words words);

}  // namespace assur::generator::audit::init
