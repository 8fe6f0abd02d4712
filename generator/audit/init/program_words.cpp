#include "audit/init/program_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <string_view>

namespace assur::generator::audit::init {

namespace {

bool is_space(char letter) { return std::isspace(static_cast<unsigned char>(letter)) != 0; }
bool is_digit(char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; }
bool begins_name(char letter) {
  return std::isalpha(static_cast<unsigned char>(letter)) != 0 || letter == '_';
}

bool opens(const Word& word) { return word.is("(") || word.is("[") || word.is("{"); }
bool closes(const Word& word) { return word.is(")") || word.is("]") || word.is("}"); }
bool ends_value(const Word& word) {
  return word.is_name() || word.kind == Word::Kind::number || word.is(")") || word.is("]") ||
         word.is("'");
}

class WordReader {
 public:
  WordReader(const std::string& code, Language language) : code_(code), language_(language) {}

  std::vector<Word> run() {
    while (at_ < code_.size()) {
      if (!skip_blank() && !skip_comment() && !read_text()) {
        read_word();
      }
    }
    end_line();
    return std::move(words_);
  }

 private:
  [[nodiscard]] bool has_lines() const {
    return language_ == Language::python || language_ == Language::matlab;
  }
  [[nodiscard]] char letter(std::size_t ahead = 0) const {
    return at_ + ahead < code_.size() ? code_[at_ + ahead] : '\0';
  }
  [[nodiscard]] bool starts(std::string_view text) const {
    return std::string_view(code_).substr(at_).starts_with(text);
  }
  [[nodiscard]] std::size_t line_end() const {
    return std::min(code_.find('\n', at_), code_.size());
  }
  void pass(std::string_view closing, std::size_t from) {
    const std::size_t end = code_.find(closing, from);
    at_ = end == std::string::npos ? code_.size() : end + closing.size();
  }

  void end_line() {
    if (!has_lines() || words_.empty() || words_.back().ends_line()) {
      return;
    }
    if (brackets_.empty()) {
      add(Word::Kind::line_end, "");
    } else if (language_ == Language::matlab && brackets_.back() != "(" && !opens(words_.back()) &&
               !words_.back().is(";")) {
      add(Word::Kind::mark, ";");
    }
  }

  bool skip_blank() {
    if (letter() == '\n') {
      end_line();
      line_begins_ = true;
      ++at_;
      const std::size_t first = code_.find_first_not_of(" \t", at_);
      indent_ = (first == std::string::npos ? code_.size() : first) - at_;
      spaced_ = true;
      return true;
    }
    if (is_space(letter())) {
      ++at_;
      spaced_ = true;
      return true;
    }
    const bool joins = (language_ == Language::matlab && starts("...")) ||
                       (language_ != Language::matlab && letter() == '\\');
    if (joins) {
      at_ = std::min(line_end() + 1, code_.size());
      spaced_ = true;
    }
    return joins;
  }

  bool skip_comment() {
    const bool block = language_ == Language::matlab && (starts("%{\n") || starts("#{\n"));
    if (block) {
      pass(letter() == '%' ? "%}" : "#}", at_);
      return true;
    }
    if (has_lines() ? letter() == '#' || (language_ == Language::matlab && letter() == '%')
                    : starts("//") || (letter() == '#' && language_ != Language::javascript)) {
      at_ = line_end();
      return true;
    }
    if (!has_lines() && starts("/*")) {
      pass("*/", at_ + 2);
      return true;
    }
    return false;
  }

  bool read_text() {
    const char quote = letter();
    const bool is_transpose = language_ == Language::matlab && quote == '\'' && !spaced_ &&
                              !words_.empty() && ends_value(words_.back());
    if ((quote != '"' && quote != '\'' && (quote != '`' || language_ != Language::javascript)) ||
        is_transpose) {
      return false;
    }
    const std::size_t from = at_;
    const std::string three(3, quote);
    if (language_ == Language::python && starts(three)) {
      pass(three, at_ + 3);
    } else {
      for (++at_; at_ < code_.size() && letter() != quote && (letter() != '\n' || quote == '`');) {
        at_ += letter() == '\\' && language_ != Language::matlab ? 2 : 1;
      }
      at_ = std::min(at_ + 1, code_.size());
    }
    add(Word::Kind::text, code_.substr(from, at_ - from));
    return true;
  }

  void read_word() {
    const std::size_t from = at_;
    if (begins_name(letter())) {
      while (begins_name(letter()) || is_digit(letter())) {
        ++at_;
      }
      add(Word::Kind::name, code_.substr(from, at_ - from));
    } else if (is_digit(letter()) || (letter() == '.' && is_digit(letter(1)))) {
      while (begins_name(letter()) || is_digit(letter()) || is_decimal_point() ||
             ((letter() == '+' || letter() == '-') &&
              (code_[at_ - 1] == 'e' || code_[at_ - 1] == 'E'))) {
        ++at_;
      }
      add(Word::Kind::number, code_.substr(from, at_ - from));
    } else {
      read_mark();
    }
  }

  /// `2.*a` of MATLAB has no decimal point.
  [[nodiscard]] bool is_decimal_point() const {
    return letter() == '.' && letter(1) != '*' && letter(1) != '/' && letter(1) != '^';
  }

  void read_mark() {
    constexpr std::array marks = {
        "===", "!==", "**", "//", ".*", "./", ".^", "::", "->", "=>", "<<",
        "==",  "!=",  "~=", "<=", ">=", "&&", "||", "+=", "-=", "*=", "/="};
    for (const char* mark : marks) {
      if (starts(mark)) {
        at_ += std::string_view(mark).size();
        add(Word::Kind::mark, mark);
        return;
      }
    }
    ++at_;
    add(Word::Kind::mark, std::string(1, code_[at_ - 1]));
  }

  /// Whether a blank in front of a word of MATLAB separates two entries of a list.
  [[nodiscard]] bool separates(const Word& word) const {
    const bool in_list = language_ == Language::matlab && !brackets_.empty() &&
                         brackets_.back() != "(" && word.spaced && !words_.empty();
    if (!in_list || !ends_value(words_.back())) {
      return false;
    }
    const bool is_sign =
        (word.is("+") || word.is("-")) && at_ < code_.size() && !is_space(letter());
    return is_sign || word.is_name() || word.kind == Word::Kind::number || word.is("(");
  }

  void add(Word::Kind kind, const std::string& text) {
    const Word word{kind, text, indent_, spaced_};
    if (separates(word)) {
      words_.push_back({Word::Kind::mark, ",", indent_, false});
    }
    // JavaScript needs no semicolon where a line can end.
    if (language_ == Language::javascript && line_begins_ && word.is_name() && !words_.empty() &&
        ends_value(words_.back()) && (brackets_.empty() || brackets_.back() == "{")) {
      words_.push_back({Word::Kind::mark, ";", indent_, false});
    }
    line_begins_ = false;
    if (opens(word)) {
      brackets_.push_back(text);
    } else if (closes(word) && !brackets_.empty()) {
      brackets_.pop_back();
    }
    words_.push_back(word);
    spaced_ = false;
  }

  const std::string& code_;
  Language language_;
  std::size_t at_ = 0;
  std::size_t indent_ = 0;
  bool spaced_ = false;
  bool line_begins_ = false;
  std::vector<std::string> brackets_;
  std::vector<Word> words_;
};

}  // namespace

std::optional<Language> language_of_file(const std::string& file) {
  static const std::map<std::string, Language> endings = {
      {".cpp", Language::cpp},       {".cc", Language::cpp},         {".cxx", Language::cpp},
      {".hpp", Language::cpp},       {".h", Language::cpp},          {".c", Language::c},
      {".js", Language::javascript}, {".mjs", Language::javascript}, {".cjs", Language::javascript},
      {".py", Language::python},     {".m", Language::matlab}};
  const auto found = endings.find(std::filesystem::path(file).extension().string());
  return found == endings.end() ? std::nullopt : std::optional(found->second);
}

std::vector<Word> program_words(const std::string& code, Language language) {
  return WordReader(code, language).run();
}

std::size_t behind_bracket(Words words, std::size_t open) {
  std::size_t depth = 0;
  for (std::size_t at = open; at < words.size(); ++at) {
    depth += opens(words[at]) ? 1 : 0;
    if (closes(words[at]) && --depth == 0) {
      return at + 1;
    }
  }
  return words.size();
}

std::vector<Words> parts(Words words, const char* separator) {
  std::vector<Words> list;
  std::size_t from = 0;
  for (std::size_t at = 0; at < words.size(); ++at) {
    if (opens(words[at])) {
      at = behind_bracket(words, at) - 1;
    } else if (words[at].is(separator)) {
      list.push_back(words.subspan(from, at - from));
      from = at + 1;
    }
  }
  if (from < words.size()) {  // a comma after the last entry ends the list
    list.push_back(words.subspan(from));
  }
  return list;
}

std::string spelled(Words words) {
  std::string text;
  for (const Word& word : words) {
    const bool beside =
        !text.empty() && (std::isalnum(static_cast<unsigned char>(text.back())) != 0 ||
                          text.back() == '_' || text.back() == '>');
    text += beside && (word.is_name() || word.kind == Word::Kind::number) ? " " : "";
    text += word.text + (word.is(",") ? " " : "");
  }
  return text;
}

bool is_whole(const Word& word) {
  return word.kind == Word::Kind::number && word.text.size() < 4 &&
         word.text.find_first_not_of("0123456789") == std::string::npos;
}
std::size_t number_of(const Word& word) { return std::stoul(word.text); }

bool is_one_of(const Word& word, std::initializer_list<const char*> list) {
  return std::any_of(list.begin(), list.end(), [&](const char* each) { return word.is(each); });
}

/// The first of these marks outside brackets, or the end.
std::size_t find_mark(Words words, const char* mark) {
  for (std::size_t at = 0; at < words.size(); ++at) {
    if (words[at].is(mark)) {
      return at;
    }
    if (is_one_of(words[at], {"(", "[", "{"})) {
      at = behind_bracket(words, at) - 1;
    }
  }
  return words.size();
}

Words inside(Words words, std::size_t open) {
  const std::size_t end = behind_bracket(words, open);
  return words.subspan(open + 1, end > open + 1 ? end - open - 2 : 0);
}

bool is_whole_bracket(Words words) {
  return !words.empty() && is_one_of(words[0], {"(", "[", "{"}) &&
         behind_bracket(words, 0) == words.size();
}

}  // namespace assur::generator::audit::init
