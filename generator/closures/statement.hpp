// Turns the text of an audit file into its statements, each with the place where it stands.
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

/// Something in an audit file that cannot be read: `FILE:LINE:COLUMN: what`, on one line.
class AuditSyntaxError : public text::InputError {
 public:
  AuditSyntaxError(const std::string& file, Place at, const std::string& what)
      : text::InputError(file + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) +
                         ": " + text::on_one_line(what)) {}
};

/// A piece of text and where it begins.
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

/// The first line and the rows in one; a place in it may lie behind the end of the first line.
[[nodiscard]] PlacedText joined(const Statement& statement);
/// Where a place of the joined text, or of one of the rows, stands in the file.
[[nodiscard]] Place place_in(const Statement& statement, Place joined);

/// Without white space at both ends.
[[nodiscard]] PlacedText trimmed(const PlacedText& text);
/// The parts between the separators that stand outside parentheses, trimmed.
[[nodiscard]] std::vector<PlacedText> split(const PlacedText& text, char separator);
/// The parts before and after the first separator outside parentheses; where there is none, the
/// second is empty and stands behind the text.
[[nodiscard]] std::pair<PlacedText, PlacedText> cut(const PlacedText& text, char separator);
/// The words between white space.
[[nodiscard]] std::vector<PlacedText> words(const PlacedText& text);
/// Takes the first word off a text; empty if there is none.
[[nodiscard]] PlacedText take_word(PlacedText& text);
/// Takes the name of a file off a text: the first word, or what stands between quotation marks.
[[nodiscard]] PlacedText take_file(PlacedText& text);
/// Whether a text begins with this word, which is then taken off.
[[nodiscard]] bool take_keyword(PlacedText& text, const std::string& keyword);
/// What stands behind the first `count` words.
[[nodiscard]] PlacedText after_words(PlacedText text, int count);

}  // namespace assur::generator::closures
