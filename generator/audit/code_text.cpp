#include "audit/code_text.hpp"

#include <algorithm>
#include <assur/text/expression.hpp>
#include <cctype>
#include <functional>
#include <optional>

#include "audit/pattern.hpp"

namespace assur::generator::audit {

namespace {

bool is_space(char letter) { return std::isspace(static_cast<unsigned char>(letter)) != 0; }

/// Comments, lines for the preprocessor and the ends of lines become spaces, so that every
/// character keeps its index.
std::string on_one_line(std::string code) {
  const auto blank = [&](std::size_t from, std::size_t to) {
    const std::size_t count = std::min(to, code.size()) - from;
    code.replace(from, count, count, ' ');
  };
  bool line_begins = true;
  for (std::size_t at = 0; at < code.size(); ++at) {
    const bool directive = line_begins && code[at] == '#';
    line_begins = code[at] == '\n' || (line_begins && is_space(code[at]));
    if (directive || code.compare(at, 2, "//") == 0) {
      blank(at, std::min(code.find('\n', at), code.size()));
    } else if (code.compare(at, 2, "/*") == 0) {
      const std::size_t end = code.find("*/", at + 2);
      blank(at, end == std::string::npos ? code.size() : end + 2);
    }
  }
  std::replace_if(code.begin(), code.end(), is_space, ' ');
  return code;
}

/// Whether a block that follows these words may be left out or run again.
bool is_conditional(const std::string& head) {
  static const Pattern word(
      R"(^(\}?\s*else\b|if\b|for\b|while\b|switch\b|do\b|.*\)\s*(if|for)\b).*)");
  return word.match(head).has_value();
}

/// Replaces what matches by a text that is no longer, with spaces behind it.
void replace_padded(std::string& text, const Pattern& pattern,
                    const std::function<std::string(const PatternMatch&)>& replacement) {
  std::string result;
  std::size_t from = 0;
  while (const std::optional<PatternMatch> match = pattern.search(text, from)) {
    result += text.substr(from, match->parts[0].place - from);
    const std::string with = replacement(*match);
    result += with + std::string((*match)[0].size() - with.size(), ' ');
    from = match->end();
  }
  text = result + text.substr(from);
}

bool is_called(const std::string& name) { return text::is_reserved_name(name) || name == "pow"; }

void refuse(const std::string& code, const Pattern& pattern, const std::string& what) {
  if (const std::optional<PatternMatch> match = pattern.search(code)) {
    throw CodeError(what, match->parts[0].place + 1);
  }
}

void refuse_other_meanings(const std::string& code) {
  static const Pattern cast(
      R"(\b(static|dynamic|const|reinterpret)_cast\b|\(\s*(const\s+)?(double|float|int|long|unsigned|Scalar)\s*\)|\b(double|float|int|long|Scalar)\s*[({])");
  static const Pattern power(R"(\^)");
  static const Pattern whole_quotient(R"((^|[^\w.*/]|[^\w.\s]\s)\s*\d+\s*/\s*\d+(?![\w.]))");
  refuse(code, cast, "a cast cannot be read; leave it out, or give its value a name as double");
  refuse(code, power, "'^' is the exclusive or of C++; write std::pow(x, n)");
  refuse(code, whole_quotient, "a quotient of whole numbers is rounded in C++; write 1.0/2");
}

}  // namespace

std::vector<CodeStatement> code_statements(const std::string& code) {
  const std::string flat = on_one_line(code);
  std::vector<CodeStatement> list;
  std::vector<bool> blocks;
  std::size_t from = 0;
  int depth = 0;
  for (std::size_t at = 0; at < flat.size(); ++at) {
    const char letter = flat[at];
    depth += letter == '(' ? 1 : letter == ')' ? -1 : 0;
    // The semicolons in the head of a loop end no statement.
    if (letter == '{' || letter == '}' || (letter == ';' && depth <= 0)) {
      std::size_t start = flat.find_first_not_of(' ', from);
      start = std::min(start, at);
      closures::Place begin{1, 1};
      for (std::size_t index = 0; index < start; ++index) {
        begin = code[index] == '\n' ? closures::Place{begin.line + 1, 1}
                                    : closures::Place{begin.line, begin.column + 1};
      }
      const bool conditional = std::find(blocks.begin(), blocks.end(), true) != blocks.end();
      list.push_back(
          {closures::trimmed({flat.substr(start, at - start), begin}), letter, conditional});
      if (letter == '{') {
        blocks.push_back(is_conditional(list.back().text.text));
      } else if (letter == '}' && !blocks.empty()) {
        blocks.pop_back();
      }
      from = at + 1;
    }
  }
  return list;
}

closures::Place place_in_code(const std::string& code, closures::Place place) {
  std::size_t from = 0;
  for (std::size_t line = 1; line < place.line && from < code.size(); ++line) {
    from = code.find('\n', from) + 1;
  }
  while (true) {
    const std::size_t end = code.find('\n', from);
    if (end == std::string::npos || place.column <= end - from + 1) {
      return place;
    }
    place = {place.line + 1, place.column - (end - from + 1)};
    from = end + 1;
  }
}

std::string code_as_formula(const std::string& code) {
  static const Pattern suffix(R"((^|[^\w.])((?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)[fFlLuU]+\b)");
  static const Pattern circle(R"(\bM_PI\b|\b(?:std\s*::\s*)?numbers\s*::\s*pi(?:_v<\w+>)?)");
  static const Pattern standard(R"(\bstd\s*::)");
  static const Pattern member(R"(([A-Za-z_]\w*)\s*(?:\.|->)\s*([A-Za-z_]\w*))");
  static const Pattern entry(R"(([A-Za-z_]\w*)\s*\[\s*(\d+)\s*\])");
  static const Pattern called_entry(R"(([A-Za-z_]\w*)\s*\(\s*(\d+)\s*(?:,\s*(\d+)\s*)?\))");
  refuse_other_meanings(code);
  std::string text = code;
  replace_padded(text, suffix, [](const PatternMatch& m) { return m[1] + m[2]; });
  replace_padded(text, circle, [](const PatternMatch&) { return "pi"; });
  replace_padded(text, standard, [](const PatternMatch&) { return ""; });
  const auto joined = [](const PatternMatch& m) { return m[1] + "_" + m[2]; };
  // Each pass joins one more pair of a chain like p.link[1].length.
  for (std::string before; before != text;) {
    before = text;
    replace_padded(text, member, joined);
    replace_padded(text, entry, joined);
  }
  replace_padded(text, called_entry, [&](const PatternMatch& m) {
    const std::string column = m.parts[3].matched ? "_" + m[3] : "";
    return is_called(m[1]) ? m[0] : joined(m) + column;
  });
  return text;
}

}  // namespace assur::generator::audit
