#include "document/latex_formula.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace assur::generator::document {

namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Reads a formula token by token.
class FormulaReader {
 public:
  FormulaReader(const std::string& text, bool vectors) : text_(text), vectors_(vectors) {}

  std::string run() {
    while (at_ < text_.size()) {
      token();
    }
    return std::move(latex_);
  }

 private:
  void token() {
    const char c = text_[at_];
    if (is_letter(c)) {
      name();
    } else if (is_digit(c)) {
      number();
    } else if (c == '*') {
      latex_ += "\\,";
      ++at_;
    } else if (c == '^') {
      latex_ += exponent();
    } else {
      const bool sign = at_ > 0 && text_[at_ - 1] == ' ' && (c == '+' || c == '-');
      latex_ += c == ',' ? ",\\allowbreak " : (sign ? "\\allowbreak" : "") + std::string(1, c);
      ++at_;
    }
  }

  std::string take(bool (*belongs)(char)) {
    const std::size_t start = at_;
    while (at_ < text_.size() && belongs(text_[at_])) {
      ++at_;
    }
    return text_.substr(start, at_ - start);
  }

  void name() {
    const std::string name = take([](char c) { return is_letter(c) || is_digit(c); });
    if (vectors_) {
      const std::string letters = name.starts_with("slide_") ? "s" : name;
      latex_ += "\\overline{" + latex_word(letters) + "}";
      latex_ += letters == name ? "" : "_{" + name.substr(6) + "}";
      return;
    }
    if (at_ < text_.size() && text_[at_] == '(') {
      const bool known =
          name == "cos" || name == "sin" || name == "tan" || name == "det" || name == "exp";
      function(known ? "\\" + name : "\\operatorname{" + name + "}");
      return;
    }
    const LatexName parts = latex_name(name);
    latex_ += parts.head + exponent() + parts.tail;
  }

  /// The argument of a function has no brackets if it is one name.
  void function(const std::string& latex) {
    const std::size_t close = text_.find(')', at_);
    const std::string argument = text_.substr(at_ + 1, close - at_ - 1);
    const bool simple = std::all_of(argument.begin(), argument.end(),
                                    [](char c) { return is_letter(c) || is_digit(c); });
    latex_ += latex;
    if (simple && argument.size() > 2) {
      at_ = close + 1;
      const std::string power = exponent();
      latex_ += power + latex_name(argument).whole();
    }
  }

  void number() {
    const std::string digits = take(is_digit);
    if (at_ + 1 < text_.size() && text_[at_] == '/' && is_digit(text_[at_ + 1])) {
      ++at_;
      latex_ += "\\tfrac{" + digits + "}{" + take(is_digit) + "}";
      return;
    }
    latex_ += digits;
  }

  /// `^{2}` if there is an exponent here, else empty.
  std::string exponent() {
    if (at_ >= text_.size() || text_[at_] != '^') {
      return "";
    }
    ++at_;
    if (text_[at_] == '(') {
      const std::size_t close = text_.find(')', at_);
      const std::string inside = text_.substr(at_ + 1, close - at_ - 1);
      at_ = close + 1;
      return "^{" + inside + "}";
    }
    return "^{" + take([](char c) { return is_letter(c) || is_digit(c); }) + "}";
  }

  const std::string& text_;
  bool vectors_;
  std::size_t at_ = 0;
  std::string latex_;
};

}  // namespace

std::string latex_formula(const std::string& formula) {
  return FormulaReader(formula, false).run();
}

std::string latex_vectors(const std::string& equation) {
  return FormulaReader(equation, true).run();
}

std::string latex_prose(const std::string& text) {
  std::string latex;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '`') {
      const std::size_t close = text.find('`', at + 1);
      latex += "$" + latex_formula(text.substr(at + 1, close - at - 1)) + "$";
      at = close + 1;
      continue;
    }
    if (!is_letter(text[at]) && !is_digit(text[at])) {
      latex += text[at++];
      continue;
    }
    const std::size_t start = at;
    while (at < text.size() && (is_letter(text[at]) || is_digit(text[at]))) {
      ++at;
    }
    if (at < text.size() && text[at] == '^') {
      at = text.find_first_not_of("0123456789", at + 1);
      at = std::min(at, text.size());
    }
    const std::string token = text.substr(start, at - start);
    latex +=
        token.find_first_of("_^") == std::string::npos ? token : "$" + latex_formula(token) + "$";
  }
  return latex;
}

double formula_width(const std::string& formula) {
  double width = 0;
  for (const std::string function : {"cos", "sin"}) {
    for (std::size_t at = 0; (at = formula.find(function, at)) != std::string::npos; ++at) {
      width += 0.9;
    }
  }
  bool low = false;  // letters after an underscore are small
  for (const char c : formula) {
    const bool part = is_letter(c) || is_digit(c);
    low = part && (low || c == '_');
    const bool upper = std::isupper(static_cast<unsigned char>(c)) != 0;
    const bool mark = c == '_' || c == '*' || c == '(' || c == ')';
    // Names in lower case are mostly those of one Greek letter.
    width += mark ? 0.1 : upper ? (low ? 0.5 : 0.75) : is_letter(c) ? 0.25 : 0.5;
  }
  return width;
}

}  // namespace assur::generator::document
