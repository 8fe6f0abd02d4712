#include "audit/code/tokens.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace assur::generator::audit::code {

namespace {

bool is_space(char letter) { return std::isspace(static_cast<unsigned char>(letter)) != 0; }
bool is_digit(char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; }
bool begins_name(char letter) {
  return std::isalpha(static_cast<unsigned char>(letter)) != 0 || letter == '_';
}
bool is_one_of(char letter, std::string_view letters) {
  return letters.find(letter) != std::string_view::npos;
}
bool in_name(char letter) { return begins_name(letter) || is_digit(letter); }

class Lexer {
 public:
  explicit Lexer(const std::string& code) : code_(code) {}

  std::vector<Token> run() {
    refuse_trigraphs();
    while (at_ < code_.size()) {
      const std::size_t before = at_;
      if (skip_blank() || skip_comment()) {
        continue;
      }
      read_token();
      line_begins_ = false;
      advance_place(before);
    }
    return std::move(tokens_);
  }

 private:
  [[nodiscard]] bool starts(std::string_view text) const {
    return std::string_view(code_).substr(at_).starts_with(text);
  }
  [[nodiscard]] char letter(std::size_t ahead = 0) const {
    return at_ + ahead < code_.size() ? code_[at_ + ahead] : '\0';
  }

  [[noreturn]] void fail(const std::string& what) const { throw CodeError(what, place_); }

  void refuse_trigraphs() {
    for (std::size_t at = code_.find("?\?"); at != std::string::npos;
         at = code_.find("?\?", at + 1)) {
      if (at + 2 < code_.size() && is_one_of(code_[at + 2], "=/'()!<>-")) {
        advance_place(0, at);
        fail("a trigraph means another letter to some compilers" + by_running);
      }
    }
  }

  void advance_place(std::size_t from) { advance_place(from, at_); }
  void advance_place(std::size_t from, std::size_t to) {
    for (; from < to; ++from) {
      place_ = code_[from] == '\n' ? closures::Place{place_.line + 1, 1}
                                   : closures::Place{place_.line, place_.column + 1};
    }
  }

  /// The length of the backslash and line end at `at`, which join two lines; zero if there is none.
  [[nodiscard]] std::size_t joint(std::size_t at) const {
    if (at >= code_.size() || code_[at] != '\\') {
      return 0;
    }
    std::size_t end = at + 1;
    while (end < code_.size() && code_[end] != '\n' && is_space(code_[end])) {
      ++end;  // compilers ignore white space after it
    }
    return end < code_.size() && code_[end] == '\n' ? end + 1 - at : 0;
  }

  bool skip_blank() {
    const std::size_t before = at_;
    if (const std::size_t joined = joint(at_); joined > 0) {
      // A name or an operator that continues on the next line would be another one.
      if (at_ > 0 && !is_space(code_[at_ - 1]) && at_ + joined < code_.size() &&
          !is_space(code_[at_ + joined])) {
        fail("a word that goes on in the next line cannot be read; write it in one line");
      }
      at_ += joined;
    } else if (is_space(letter())) {
      line_begins_ = line_begins_ || letter() == '\n';
      ++at_;
    }
    advance_place(before);
    return at_ > before;
  }

  bool skip_comment() {
    const std::size_t before = at_;
    if (starts("//")) {
      at_ = line_end();
    } else if (starts("/*")) {
      const std::size_t end = code_.find("*/", at_ + 2);
      if (end == std::string::npos) {
        fail("this comment does not end");
      }
      for (std::size_t star = code_.find('*', at_ + 2); star < end;
           star = code_.find('*', star + 1)) {
        const std::size_t joined = joint(star + 1);
        if (joined > 0 && star + 1 + joined < code_.size() && code_[star + 1 + joined] == '/') {
          fail("a comment that ends over two lines cannot be read; write its end in one line");
        }
      }
      at_ = end + 2;
    }
    advance_place(before);
    return at_ > before;
  }

  /// The end of the line for the preprocessor.
  [[nodiscard]] std::size_t line_end() const {
    std::size_t end = at_;
    while (end < code_.size() && code_[end] != '\n') {
      end += std::max<std::size_t>(joint(end), 1);
    }
    return std::min(end, code_.size());
  }

  void read_token() {
    if (line_begins_ && letter() == '#') {
      add(Token::Kind::directive, line_end());
    } else if (begins_name(letter())) {
      std::size_t end = at_;
      while (end < code_.size() && in_name(code_[end])) {
        ++end;
      }
      const std::string name = code_.substr(at_, end - at_);
      if (end < code_.size() && (code_[end] == '"' || code_[end] == '\'')) {
        name.ends_with('R') ? read_raw(end) : read_quoted(end);
      } else {
        add(Token::Kind::name, end);
      }
    } else if (is_digit(letter()) || (letter() == '.' && is_digit(letter(1)))) {
      read_number();
    } else if (letter() == '"' || letter() == '\'') {
      read_quoted(at_);
    } else {
      read_mark();
    }
  }

  void read_quoted(std::size_t open) {
    std::size_t end = open + 1;
    while (end < code_.size() && code_[end] != code_[open] && code_[end] != '\n') {
      end += code_[end] == '\\' ? 2 : 1;
    }
    if (end >= code_.size() || code_[end] != code_[open]) {
      fail("this text does not end");
    }
    add(Token::Kind::text, end + 1);
  }

  void read_raw(std::size_t open) {
    const std::size_t parenthesis = code_.find('(', open);
    const std::string closing = parenthesis == std::string::npos
                                    ? ""
                                    : ")" + code_.substr(open + 1, parenthesis - open - 1) + "\"";
    const std::size_t end = closing.empty() ? std::string::npos : code_.find(closing, parenthesis);
    if (end == std::string::npos) {
      fail("this text does not end");
    }
    add(Token::Kind::text, end + closing.size());
  }

  void read_number() {
    std::size_t end = at_;
    while (end < code_.size() &&
           (in_name(code_[end]) || code_[end] == '.' ||
            (code_[end] == '\'' && end + 1 < code_.size() && in_name(code_[end + 1])) ||
            ((code_[end] == '+' || code_[end] == '-') && is_one_of(code_[end - 1], "eEpP")))) {
      ++end;
    }
    add(Token::Kind::number, end);
  }

  void read_mark() {
    constexpr std::array digraphs = {"<:", ":>", "<%", "%>", "%:"};
    constexpr std::array marks = {"<<=", ">>=", "...", "->*", "<=>", "::", "->", "++", "--",
                                  "<<",  ">>",  "<=",  ">=",  "==",  "!=", "&&", "||", "+=",
                                  "-=",  "*=",  "/=",  "%=",  "^=",  "&=", "|=", ".*"};
    for (const char* digraph : digraphs) {
      if (starts(digraph) && !starts("<::") && !starts(":>>")) {
        fail("'" + std::string(digraph) + "' is another spelling of a bracket" + by_running);
      }
    }
    for (const char* mark : marks) {
      if (starts(mark)) {
        add(Token::Kind::mark, at_ + std::string_view(mark).size());
        return;
      }
    }
    if (!is_one_of(letter(), "{}[]()<>;:,.+-*/%^&|!~=?")) {
      fail("this character cannot be read" + by_running);
    }
    add(Token::Kind::mark, at_ + 1);
  }

  void add(Token::Kind kind, std::size_t end) {
    tokens_.push_back({kind, code_.substr(at_, end - at_), place_, at_});
    at_ = end;
  }

  const std::string& code_;
  std::size_t at_ = 0;
  closures::Place place_{1, 1};
  bool line_begins_ = true;
  std::vector<Token> tokens_;
};

bool opens(const Token& token) { return token.is("(") || token.is("[") || token.is("{"); }
bool closes(const Token& token) { return token.is(")") || token.is("]") || token.is("}"); }

}  // namespace

std::vector<Token> code_tokens(const std::string& code) { return Lexer(code).run(); }

std::size_t behind_closing(Tokens tokens, std::size_t open) {
  std::vector<std::string> expected;
  for (std::size_t at = open; at < tokens.size(); ++at) {
    if (opens(tokens[at])) {
      expected.emplace_back(tokens[at].is("(") ? ")" : tokens[at].is("[") ? "]" : "}");
    } else if (closes(tokens[at])) {
      if (expected.empty() || expected.back() != tokens[at].spelling) {
        throw CodeError("this bracket closes nothing", tokens[at].place);
      }
      expected.pop_back();
      if (expected.empty()) {
        return at + 1;
      }
    }
  }
  throw CodeError("this bracket is not closed", tokens[open].place);
}

std::vector<Tokens> comma_parts(Tokens tokens) {
  std::vector<Tokens> parts;
  std::size_t from = 0;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (opens(tokens[at])) {
      at = behind_closing(tokens, at) - 1;
    } else if (tokens[at].is(",")) {
      parts.push_back(tokens.subspan(from, at - from));
      from = at + 1;
    }
  }
  parts.push_back(tokens.subspan(from));
  return parts;
}

std::vector<Tokens> declared_parts(Tokens tokens) {
  std::vector<Tokens> parts;
  int depth = 0;
  std::size_t from = 0;
  for (const Tokens& part : comma_parts(tokens)) {
    for (const Token& token : part) {
      depth += token.is("<") ? 1 : token.is(">") ? -1 : token.is(">>") ? -2 : 0;
    }
    if (depth <= 0) {
      const auto end = static_cast<std::size_t>(part.data() + part.size() - tokens.data());
      parts.push_back(tokens.subspan(from, end - from));
      from = end + 1;
    }
  }
  if (from < tokens.size()) {
    parts.push_back(tokens.subspan(from));
  }
  return parts;
}

bool are(Tokens tokens, std::initializer_list<const char*> spelled) {
  return std::equal(tokens.begin(), tokens.end(), spelled.begin(), spelled.end(),
                    [](const Token& token, const char* expected) {
                      return std::string_view(expected) == "#"
                                 ? token.kind == Token::Kind::number &&
                                       (token.spelling[0] != '0' || token.spelling == "0") &&
                                       std::all_of(token.spelling.begin(), token.spelling.end(),
                                                   is_digit)
                                 : token.is(expected);
                    });
}

std::size_t whole_number(const Token& token) {
  return token.spelling.size() > 6 ? 999999 : std::stoul(token.spelling);
}

}  // namespace assur::generator::audit::code
