#include "closures/statement.hpp"

#include <algorithm>
#include <assur/text/quoted.hpp>
#include <assur/text/utf8.hpp>
#include <cctype>
#include <sstream>
#include <string_view>
#include <utility>

namespace assur::generator::closures {

namespace {

bool is_space(char letter) { return std::isspace(static_cast<unsigned char>(letter)) != 0; }

PlacedText part(const PlacedText& text, std::size_t from, std::size_t to) {
  return {text.text.substr(from, to - from), text.at(from + 1)};
}

/// The first separator from `from` on outside parentheses.
std::size_t find_outside(const std::string& text, char separator, std::size_t from) {
  int depth = 0;
  for (std::size_t at = from; at < text.size(); ++at) {
    if (depth == 0 && text[at] == separator) {
      return at;
    }
    depth += text[at] == '(' ? 1 : 0;
    depth -= text[at] == ')' ? 1 : 0;
  }
  return std::string::npos;
}

}  // namespace

std::vector<Statement> parse_statements(const std::string& text, const std::string& file) {
  if (const std::size_t at = text::first_byte_outside_utf8(text); at < text.size()) {
    throw text::InputError(file + ": byte " + std::to_string(at) +
                           " is not UTF-8; save the file as UTF-8");
  }
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // some editors begin with it
  std::vector<Statement> statements;
  std::istringstream lines(
      text.substr(text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0));
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    if (const std::size_t at = text::first_control_character(line); at < line.size()) {
      throw AuditSyntaxError(file, {number, at + 1}, "a control character; remove it");
    }
    const bool indented = !line.empty() && is_space(line[0]);
    const PlacedText content = trimmed({line.substr(0, line.find('#')), {number, 1}});
    if (content.empty()) {
      continue;
    }
    if (!indented) {
      statements.push_back({content, {}});
    } else if (statements.empty()) {
      throw AuditSyntaxError(file, content.place, "this indented line continues no statement");
    } else {
      statements.back().rows.push_back(content);
    }
  }
  return statements;
}

PlacedText joined(const Statement& statement) {
  PlacedText text = statement.head;
  for (const PlacedText& row : statement.rows) {
    text.text += " " + row.text;
  }
  return text;
}

Place place_in(const Statement& statement, Place joined) {
  if (joined.line != statement.head.place.line) {
    return joined;
  }
  std::size_t offset = joined.column - statement.head.place.column;
  PlacedText line = statement.head;
  for (const PlacedText& row : statement.rows) {
    if (offset <= line.text.size()) {
      break;
    }
    offset -= line.text.size() + 1;
    line = row;
  }
  return line.at(offset + 1);
}

PlacedText trimmed(const PlacedText& text) {
  std::size_t from = 0;
  std::size_t to = text.text.size();
  while (from < to && is_space(text.text[from])) {
    ++from;
  }
  while (to > from && is_space(text.text[to - 1])) {
    --to;
  }
  return part(text, from, to);
}

std::vector<PlacedText> split(const PlacedText& text, char separator) {
  std::vector<PlacedText> parts;
  std::size_t from = 0;
  while (true) {
    const std::size_t at = find_outside(text.text, separator, from);
    const std::size_t to = at == std::string::npos ? text.text.size() : at;
    parts.push_back(trimmed(part(text, from, to)));
    if (at == std::string::npos) {
      return parts;
    }
    from = at + 1;
  }
}

std::pair<PlacedText, PlacedText> cut(const PlacedText& text, char separator) {
  const std::size_t at = find_outside(text.text, separator, 0);
  if (at == std::string::npos) {
    PlacedText whole = trimmed(text);
    const Place behind = whole.at(whole.text.size() + 1);
    return {std::move(whole), PlacedText{"", behind}};
  }
  return {trimmed(part(text, 0, at)), trimmed(part(text, at + 1, text.text.size()))};
}

std::vector<PlacedText> words(const PlacedText& text) {
  std::vector<PlacedText> list;
  PlacedText rest = text;
  for (PlacedText word = take_word(rest); !word.empty(); word = take_word(rest)) {
    list.push_back(word);
  }
  return list;
}

PlacedText take_word(PlacedText& text) {
  text = trimmed(text);
  std::size_t to = 0;
  while (to < text.text.size() && !is_space(text.text[to])) {
    ++to;
  }
  PlacedText word = part(text, 0, to);
  text = trimmed(part(text, to, text.text.size()));
  return word;
}

PlacedText take_file(PlacedText& text) {
  const std::size_t end = text.text.starts_with('"') ? text.text.find('"', 1) : std::string::npos;
  if (end == std::string::npos) {
    return take_word(text);
  }
  PlacedText name{text.text.substr(1, end - 1), text.at(2)};
  text = trimmed({text.text.substr(end + 1), text.at(end + 2)});
  return name;
}

bool take_keyword(PlacedText& text, const std::string& keyword) {
  PlacedText rest = text;
  if (take_word(rest).text != keyword) {
    return false;
  }
  text = rest;
  return true;
}

PlacedText after_words(PlacedText text, int count) {
  for (; count > 0; --count) {
    static_cast<void>(take_word(text));
  }
  return text;
}

}  // namespace assur::generator::closures
