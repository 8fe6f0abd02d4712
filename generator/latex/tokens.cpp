#include "latex/tokens.hpp"

#include <algorithm>
#include <array>
#include <assur/text/error.hpp>
#include <assur/text/quoted.hpp>
#include <string_view>

namespace assur::generator::latex {

namespace {

constexpr int most_braces = 60;

constexpr std::array<std::string_view, 4> verbatim = {"verbatim", "verbatim*", "lstlisting",
                                                      "comment"};

bool is_ascii_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// The number of bytes of the character that begins with this byte; 0 if none does.
std::size_t length_of_character(unsigned char first) {
  return first < 0x80U                     ? 1U
         : first >= 0xC2U && first < 0xE0U ? 2U
         : first >= 0xE0U && first < 0xF0U ? 3U
         : first >= 0xF0U && first < 0xF5U ? 4U
                                           : 0U;
}

void expect_utf8(const std::string& text, const std::string& file) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = length_of_character(static_cast<unsigned char>(text[at]));
    bool good = length > 0 && at + length <= text.size();
    for (std::size_t next = 1; good && next < length; ++next) {
      good = continues_character(text[at + next]);
    }
    if (!good) {
      throw text::InputError(file + ": the byte at offset " + std::to_string(at) +
                             " is not UTF-8; save the file as UTF-8");
    }
    at += length;
  }
  if (const std::size_t at = text::first_control_character(text); at < text.size()) {
    throw text::InputError(file + ": the byte at offset " + std::to_string(at) +
                           " is a control character; remove it");
  }
}

class Tokenizer {
 public:
  Tokenizer(const std::string& text, Place begin) : text_(text), place_(begin) {}

  Tokens run() {
    bool spaced = false;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (is_space(c)) {
        advance(1);
        spaced = true;
      } else if (c == '%') {
        const std::size_t end = text_.find('\n', at_);
        advance(std::min(end, text_.size()) - at_);
      } else {
        take(c == '\\' ? length_of_command() : length_of_character(static_cast<unsigned char>(c)),
             spaced);
        spaced = false;
        skip_verbatim();
      }
    }
    return std::move(tokens_);
  }

 private:
  void advance(std::size_t bytes) {
    for (; bytes > 0; --bytes, ++at_) {
      if (text_[at_] == '\n') {
        ++place_.line;
        place_.column = 1;
      } else if (!continues_character(text_[at_])) {
        ++place_.column;
      }
    }
  }

  [[nodiscard]] std::size_t length_of_command() const {
    std::size_t end = at_ + 1;
    while (end < text_.size() && is_ascii_letter(text_[end])) {
      ++end;
    }
    if (end == at_ + 1) {
      if (end == text_.size()) {
        throw FormulaError("a backslash ends the file", place_);
      }
      end += length_of_character(static_cast<unsigned char>(text_[end]));
    }
    return end - at_;
  }

  void take(std::size_t length, bool spaced) {
    tokens_.push_back({text_.substr(at_, length), place_, at_, at_ + length, spaced});
    if (tokens_.back().text.size() == 2 && is_space(tokens_.back().text[1])) {
      tokens_.back().text = "\\ ";
    }
    advance(length);
  }

  /// Skips a verbatim environment, which contains no formulas.
  void skip_verbatim() {
    if (tokens_.back().text != "}") {
      return;
    }
    for (const std::string_view name : verbatim) {
      const std::string begin = "\\begin{" + std::string(name) + "}";
      if (at_ >= begin.size() && text_.compare(at_ - begin.size(), begin.size(), begin) == 0) {
        const std::size_t end = text_.find("\\end{" + std::string(name) + "}", at_);
        advance(std::min(end, text_.size()) - at_);
      }
    }
  }

  const std::string& text_;
  std::size_t at_ = 0;
  Place place_;
  Tokens tokens_;
};

}  // namespace

bool Token::is_letter() const { return text.size() == 1 && is_ascii_letter(text[0]); }
bool Token::is_digit() const { return text.size() == 1 && text[0] >= '0' && text[0] <= '9'; }

Tokens tokens_of(const std::string& text, const std::string& file, Place begin) {
  expect_utf8(text, file);
  return Tokenizer(text, begin).run();
}

void expect_readable_size(const Tokens& tokens) {
  int depth = 0;
  for (const Token& token : tokens) {
    depth += token.is("{") ? 1 : token.is("}") ? -1 : 0;
    if (depth > most_braces) {
      throw FormulaError("this is nested too deeply", token.place);
    }
  }
  if (tokens.size() > longest_equation) {
    throw FormulaError("this has more than " + std::to_string(longest_equation) + " tokens",
                       tokens[0].place);
  }
}

bool opens(const Token& token) { return token.is("(") || token.is("[") || token.is("\\{"); }
bool closes(const Token& token) { return token.is(")") || token.is("]") || token.is("\\}"); }

std::size_t end_of_argument(const Tokens& tokens, std::size_t at, std::size_t limit) {
  std::size_t depth = 0;
  for (std::size_t next = at; next < std::min(limit, tokens.size()); ++next) {
    if (tokens[next].is("{")) {
      ++depth;
    } else if (tokens[next].is("}")) {
      if (depth == 0) {
        throw FormulaError("an argument is missing", tokens[next].place);
      }
      --depth;
    }
    if (depth == 0) {
      return next + 1;
    }
  }
  const bool limited = limit < tokens.size();
  throw FormulaError(at >= tokens.size() ? "an argument is missing"
                     : limited           ? "this is not closed, or too long"
                                         : "this brace is not closed",
                     tokens.empty() ? Place{1, 1} : tokens[std::min(at, tokens.size() - 1)].place);
}

Tokens take_argument(const Tokens& tokens, std::size_t& at) {
  const std::size_t from = at;
  at = end_of_argument(tokens, from);
  const std::size_t braces = tokens[from].is("{") ? 1 : 0;
  return {tokens.begin() + static_cast<std::ptrdiff_t>(from + braces),
          tokens.begin() + static_cast<std::ptrdiff_t>(at - braces)};
}

std::string letters_of(const Tokens& tokens) {
  std::string text;
  for (const Token& token : tokens) {
    text += (token.spaced && !text.empty() ? " " : "") + token.text;
  }
  return text;
}

bool is_thin_space(const Token& token) {
  static constexpr std::array<std::string_view, 9> spaces = {
      "\\,", "\\;", "\\:", "\\>", "\\ ", "~", "\\thinspace", "\\medspace", "\\thickspace"};
  return std::find(spaces.begin(), spaces.end(), token.text) != spaces.end();
}

bool is_layout(const Token& token) {
  static constexpr std::array<std::string_view, 27> layout = {
      "\\displaystyle", "\\textstyle",   "\\scriptstyle", "\\allowbreak", "\\nobreak", "\\limits",
      "\\nolimits",     "\\left",        "\\right",       "\\big",        "\\Big",     "\\bigg",
      "\\Bigg",         "\\bigl",        "\\bigr",        "\\Bigl",       "\\Bigr",    "\\biggl",
      "\\biggr",        "\\Biggl",       "\\Biggr",       "\\nonumber",   "\\notag",   "\\!",
      "\\rm",           "\\raggedright", "\\small"};
  return std::find(layout.begin(), layout.end(), token.text) != layout.end();
}

}  // namespace assur::generator::latex
