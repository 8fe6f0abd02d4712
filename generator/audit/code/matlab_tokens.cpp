// Rewrites MATLAB so that the tokens of C++ apply: comments, line ends and lists.
#include <algorithm>

#include "audit/code/tokens.hpp"

namespace assur::generator::audit::code {

namespace {

bool ends_operand(const Token& token) {
  return token.is_name() || token.kind == Token::Kind::number || token.is(")") || token.is("]");
}

/// Whether white space between two tokens inside brackets separates two elements.
bool separates(const Token& one, const Token& next, const Token* behind) {
  const auto spaced = [](const Token& left, const Token& right) {
    return right.offset > left.offset + left.spelling.size();
  };
  if (!ends_operand(one) || !spaced(one, next)) {
    return false;
  }
  const bool sign = (next.is("+") || next.is("-")) && behind != nullptr && !spaced(next, *behind);
  return sign || next.is_name() || next.kind == Token::Kind::number || next.is("(");
}

}  // namespace

PlainMatlab plain_matlab(const std::string& code) {
  PlainMatlab result{code, {}};
  std::string& text = result.text;
  closures::Place place{1, 1};
  int blocks = 0;  // block comments may be nested
  for (std::size_t from = 0; from < text.size(); ++place.line) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string line = closures::trimmed({text.substr(from, end - from), {}}).text;
    const bool opens = line == "%{" || line == "#{";
    const bool closes = line == "%}" || line == "#}";
    std::size_t comment = blocks > 0 || opens ? from : text.find_first_of("%#", from);
    blocks += opens ? 1 : closes && blocks > 0 ? -1 : 0;
    const std::size_t joint = text.find("...", from);
    if (joint < std::min(comment, end)) {
      result.joined_lines.insert(place.line);
      comment = joint;
    }
    const std::size_t code_end = std::min(comment, end);
    if (const std::size_t quote = text.find_first_of("'\"\\", from); quote < code_end) {
      throw CodeError("a transpose, a text or a left division cannot be read" + by_running,
                      {place.line, quote - from + 1});
    }
    for (const char* other : {"//", "/*"}) {
      if (const std::size_t mark = text.find(other, from); mark < code_end) {
        throw CodeError("'" + std::string(other) + "' begins no comment in MATLAB",
                        {place.line, mark - from + 1});
      }
    }
    if (const std::size_t ends = code.find('\r', from); ends < end && ends + 1 < end) {
      throw CodeError(
          "a line that ends with a carriage return alone may be two; end lines with "
          "line feeds",
          {place.line, ends - from + 1});
    }
    std::fill(text.begin() + static_cast<std::ptrdiff_t>(code_end),
              text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    from = end + 1;
  }
  for (const char* operation : {".*", "./", ".^"}) {
    for (std::size_t at = text.find(operation); at != std::string::npos;
         at = text.find(operation, at)) {
      text[at] = ' ';
    }
  }
  return result;
}

std::vector<std::vector<Tokens>> matlab_rows(Tokens inside,
                                             const std::set<std::size_t>& joined_lines) {
  std::vector<std::vector<Tokens>> rows(1);
  std::size_t from = 0;
  const auto finish = [&](std::size_t to, std::size_t next) {
    if (to > from) {
      rows.back().push_back(inside.subspan(from, to - from));
    }
    from = next;
  };
  for (std::size_t at = 0; at < inside.size(); ++at) {
    const bool new_line = at > 0 && inside[at].place.line != inside[at - 1].place.line &&
                          !joined_lines.contains(inside[at - 1].place.line);
    if (at > from && (new_line || separates(inside[at - 1], inside[at],
                                            at + 1 < inside.size() ? &inside[at + 1] : nullptr))) {
      finish(at, at);
    }
    if (inside[at].is(",") || inside[at].is(";")) {
      finish(at, at + 1);
    }
    if ((new_line || inside[at].is(";")) && !rows.back().empty()) {
      rows.emplace_back();
    }
    if (inside[at].is("(") || inside[at].is("[")) {
      at = behind_closing(inside, at) - 1;
    }
  }
  finish(inside.size(), inside.size());
  if (rows.back().empty()) {
    rows.pop_back();
  }
  return rows;
}

}  // namespace assur::generator::audit::code
