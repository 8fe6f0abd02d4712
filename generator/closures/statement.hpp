// Statements of an audit file with their places.
#pragma once

#include <assur/text/error.hpp>
#include <assur/text/quoted.hpp>
#include <string>
#include <vector>

namespace assur::generator::closures {

/// A place in an audit file; the first line and the first column are 1.
struct Place {
  std::size_t line = 0;
  std::size_t column = 0;
};

/// An error in an audit file, on one line: `FILE:LINE:COLUMN: message`.
class AuditSyntaxError : public text::InputError {
 public:
  AuditSyntaxError(const std::string& file, Place at, const std::string& what)
      : text::InputError(file + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) +
                         ": " + text::on_one_line(what)) {}
};

/// A piece of text and its start.
struct PlacedText {
  std::string text;
  Place place;

  [[nodiscard]] bool empty() const { return text.empty(); }
  /// The place of a column of the text, the first being 1.
  [[nodiscard]] Place at(std::size_t column) const {
    return {place.line, place.column + column - 1};
  }
};

/// One statement: its first line, and the indented lines below it.
struct Statement {
  PlacedText head;
  std::vector<PlacedText> rows;
};

/// Comments (from # to the end of a line) and empty lines are left out.
[[nodiscard]] std::vector<Statement> parse_statements(const std::string& text,
                                                      const std::string& file);

/// The first line and the rows as one text; a place in it may lie beyond the end of the first line.
[[nodiscard]] PlacedText joined(const Statement& statement);
/// The place in the file of a place in the joined text, or in one of the rows.
[[nodiscard]] Place place_in(const Statement& statement, Place joined);

/// Without white space at both ends.
[[nodiscard]] PlacedText trimmed(const PlacedText& text);
/// The parts between the separators outside parentheses, trimmed.
[[nodiscard]] std::vector<PlacedText> split(const PlacedText& text, char separator);
/// The parts before and after the first separator outside parentheses; if there is none, the second
/// is empty and lies at the end of the text.
[[nodiscard]] std::pair<PlacedText, PlacedText> cut(const PlacedText& text, char separator);
/// The words between white space.
[[nodiscard]] std::vector<PlacedText> words(const PlacedText& text);
/// Removes and returns the first word of a text; empty if there is none.
[[nodiscard]] PlacedText take_word(PlacedText& text);
/// Removes and returns a file name: the first word, or the text between quotation marks.
[[nodiscard]] PlacedText take_file(PlacedText& text);
/// Whether a text begins with this word, which is then removed.
[[nodiscard]] bool take_keyword(PlacedText& text, const std::string& keyword);
/// The text after the first `count` words.
[[nodiscard]] PlacedText after_words(PlacedText text, int count);

}  // namespace assur::generator::closures
