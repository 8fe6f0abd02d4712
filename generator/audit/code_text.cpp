#include "audit/code_text.hpp"

#include <algorithm>
#include <cctype>
#include <functional>
#include <regex>

#include "scene/expression.hpp"

namespace assur::generator {

namespace {

bool is_space(char letter) { return std::isspace(static_cast<unsigned char>(letter)) != 0; }

/// Comments, lines for the preprocessor and the ends of lines become spaces, so that every
/// character keeps its index.
std::string on_one_line(std::string code) {
  const auto blank = [&](std::size_t from, std::size_t to) {
    std::fill(code.begin() + static_cast<std::ptrdiff_t>(from),
              code.begin() + static_cast<std::ptrdiff_t>(std::min(to, code.size())), ' ');
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
  static const std::regex word(
      R"(^(\}?\s*else\b|if\b|for\b|while\b|switch\b|do\b|.*\)\s*(if|for)\b).*)");
  return std::regex_match(head, word);
}

/// Replaces what matches by a text that is no longer, with spaces behind it.
void replace_padded(std::string& text, const std::regex& pattern,
                    const std::function<std::string(const std::smatch&)>& replacement) {
  std::string result;
  std::string::const_iterator from = text.begin();
  std::smatch match;
  while (std::regex_search(from, text.cend(), match, pattern,
                           from == text.cbegin() ? std::regex_constants::match_default
                                                 : std::regex_constants::match_prev_avail)) {
    result.append(from, match[0].first);
    const std::string with = replacement(match);
    result += with + std::string(static_cast<std::size_t>(match.length()) - with.size(), ' ');
    from = match[0].second;
  }
  result.append(from, text.cend());
  text = result;
}

bool is_called(const std::string& name) { return is_reserved_name(name) || name == "pow"; }

void refuse(const std::string& code, const std::regex& pattern, const std::string& what) {
  std::smatch match;
  if (std::regex_search(code, match, pattern)) {
    throw CodeError(what, static_cast<std::size_t>(match.position()) + 1);
  }
}

void refuse_other_meanings(const std::string& code) {
  static const std::regex cast(
      R"(\b(static|dynamic|const|reinterpret)_cast\b|\(\s*(const\s+)?(double|float|int|long|unsigned|Scalar)\s*\)|\b(double|float|int|long|Scalar)\s*[({])");
  static const std::regex power(R"(\^)");
  static const std::regex whole_quotient(R"((^|[^\w.*/]|[^\w.\s]\s)\s*\d+\s*/\s*\d+(?![\w.]))");
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
      Place begin{1, 1};
      for (std::size_t index = 0; index < start; ++index) {
        begin =
            code[index] == '\n' ? Place{begin.line + 1, 1} : Place{begin.line, begin.column + 1};
      }
      const bool conditional = std::find(blocks.begin(), blocks.end(), true) != blocks.end();
      list.push_back({trimmed({flat.substr(start, at - start), begin}), letter, conditional});
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

Place place_in_code(const std::string& code, Place place) {
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
  static const std::regex suffix(R"((^|[^\w.])((?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)[fFlLuU]+\b)");
  static const std::regex circle(R"(\bM_PI\b|\b(?:std\s*::\s*)?numbers\s*::\s*pi(?:_v<\w+>)?)");
  static const std::regex standard(R"(\bstd\s*::)");
  static const std::regex member(R"(([A-Za-z_]\w*)\s*(?:\.|->)\s*([A-Za-z_]\w*))");
  static const std::regex entry(R"(([A-Za-z_]\w*)\s*\[\s*(\d+)\s*\])");
  static const std::regex called_entry(R"(([A-Za-z_]\w*)\s*\(\s*(\d+)\s*(?:,\s*(\d+)\s*)?\))");
  refuse_other_meanings(code);
  std::string text = code;
  replace_padded(text, suffix, [](const std::smatch& m) { return m.str(1) + m.str(2); });
  replace_padded(text, circle, [](const std::smatch&) { return "pi"; });
  replace_padded(text, standard, [](const std::smatch&) { return ""; });
  const auto joined = [](const std::smatch& m) { return m.str(1) + "_" + m.str(2); };
  // Each pass joins one more pair of a chain like p.link[1].length.
  for (std::string before; before != text;) {
    before = text;
    replace_padded(text, member, joined);
    replace_padded(text, entry, joined);
  }
  replace_padded(text, called_entry, [&](const std::smatch& m) {
    const std::string column = m[3].matched ? "_" + m.str(3) : "";
    return is_called(m.str(1)) ? m.str(0) : joined(m) + column;
  });
  return text;
}

}  // namespace assur::generator
