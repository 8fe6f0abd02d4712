#include "derivation/latex_formula.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>
#include <vector>

namespace assur::generator {

namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_word(const std::string& part) {
  return !part.empty() && std::all_of(part.begin(), part.end(), [](unsigned char letter) {
    return std::isupper(letter) != 0;
  });
}

/// A name in two parts, between which an exponent goes: `\cos` and `\theta`, or all and nothing.
struct LatexName {
  std::string head;
  std::string tail;

  [[nodiscard]] std::string whole() const { return head + tail; }
};

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  for (std::size_t at = 0; (at = text.find(separator, start)) != std::string::npos;
       start = at + separator.size()) {
    parts.push_back(text.substr(start, at - start));
  }
  parts.push_back(text.substr(start));
  return parts;
}

std::string word(const std::string& letters) {
  return letters.size() == 1 ? letters : "\\mathit{" + letters + "}";
}

/// `{\mathit{BCG},x}` from the parts of a name behind its head.
std::string subscript(const std::vector<std::string>& parts, std::size_t from) {
  std::string text;
  for (std::size_t at = from; at < parts.size(); ++at) {
    const std::string& part = parts[at];
    const bool negative = part.size() > 1 && part[0] == 'm' && is_digit(part[1]);
    text += (text.empty() ? "" : ",") + (negative                       ? "-" + part.substr(1)
                                         : part == "re" || part == "im" ? "\\mathrm{" + part + "}"
                                         : is_word(part)                ? word(part)
                                                                        : part);
  }
  return text.empty() ? "" : "_{" + text + "}";
}

LatexName latex_name(const std::string& name);

/// The angle that a direction's name holds: `BCG_minus_CD`, `BCG_plus_psi_G_BCG`.
std::string angle_of(const std::string& letters) {
  std::string text;
  std::string rest = letters;
  bool minus = rest.starts_with("minus_");
  rest = minus ? rest.substr(6) : rest;
  while (!rest.empty()) {
    const std::size_t at = std::min(rest.find("_minus_"), rest.find("_plus_"));
    const std::string part = rest.substr(0, at);
    text += minus ? "-" : text.empty() ? "" : "+";
    text += is_word(part) ? "\\theta_{" + word(part) + "}" : latex_name(part).whole();
    minus = at != std::string::npos && rest.compare(at, 7, "_minus_") == 0;
    rest = at == std::string::npos ? "" : rest.substr(at + (minus ? 7 : 6));
  }
  return text;
}

LatexName direction_name(const std::string& function, const std::string& letters) {
  if (letters.starts_with("slide_")) {
    return {function, "\\sigma_{" + letters.substr(6) + "}"};
  }
  if (is_word(letters)) {
    return {function, "\\vartheta_{" + word(letters) + "}"};
  }
  return {function, "(" + angle_of(letters) + ")"};
}

/// `BCG_along_CD`: the component of a loop's vectors that turn with BCG along its closing vector.
LatexName component_name(const std::string& turning, const std::string& sign,
                         const std::string& frame) {
  const std::string seen =
      frame.starts_with("slide_") ? "s_{" + frame.substr(6) + "}" : word(frame);
  return {"v_{" + angle_of(turning) + "}" + "^{" + sign + seen + "}", ""};
}

LatexName latex_name(const std::string& name) {
  static const std::map<std::string, std::string> greek = {
      {"theta", "\\theta"}, {"psi", "\\psi"},     {"phi", "\\varphi"},
      {"omega", "\\omega"}, {"alpha", "\\alpha"}, {"determinant", "\\Delta"}};
  static const std::map<std::string, std::string> differentials = {
      {"dq", "\\mathrm{d}q"},      {"dd", "\\mathrm{d}d"}, {"du", "\\mathrm{d}u"},
      {"d2q", "\\mathrm{d}^{2}q"}, {"dt", "\\mathrm{d}t"}, {"dt2", "\\mathrm{d}t^{2}"}};
  if (const auto found = differentials.find(name); found != differentials.end()) {
    return {found->second, ""};
  }
  for (const std::string function : {"cos", "sin"}) {
    if (name.starts_with(function + "_")) {
      return direction_name("\\" + function, name.substr(4));
    }
  }
  for (const auto& [separator, sign] :
       {std::pair<std::string, std::string>{"_along_", "\\parallel "}, {"_across_", "\\perp "}}) {
    const std::vector<std::string> parts = split(name, separator);
    if (parts.size() == 2) {
      return component_name(parts[0], sign, parts[1]);
    }
  }
  const std::vector<std::string> parts = split(name, "_");
  const std::string& head = parts[0];
  if ((head == "v" || head == "a") && parts.size() > 2) {
    const std::string of = name.substr(2);
    return {(head == "v" ? "\\dot{" : "\\ddot{") + split(of, "_")[0] + "}" +
                subscript(split(of, "_"), 1),
            ""};
  }
  if (head == "slide") {
    return {"\\overline{s}" + subscript(parts, 1), ""};
  }
  if (const auto found = greek.find(head); found != greek.end()) {
    return {found->second + subscript(parts, 1), ""};
  }
  if ((head == "Tc" || head == "Ts") && parts.size() == 2) {
    return {"T_{\\mathrm{" + head.substr(1) + "}" + parts[1] + "}", ""};
  }
  if (is_word(head) && head.size() > 1) {
    return {
        (parts.size() > 1 ? "\\overline{" + word(head) + "}" : word(head)) + subscript(parts, 1),
        ""};
  }
  if (head.size() == 2 && is_digit(head[1])) {  // f1, P1_m1_re, f1_psi_C_BCG
    std::vector<std::string> rest = {head.substr(1)};
    if (parts.size() > 1 && greek.contains(parts[1])) {
      rest.push_back(latex_name(name.substr(3)).whole());
    } else {
      rest.insert(rest.end(), parts.begin() + 1, parts.end());
    }
    return {head.substr(0, 1) + subscript(rest, 0), ""};
  }
  if (head.size() > 1 && !is_word(head)) {
    return {"\\operatorname{" + head + "}" + subscript(parts, 1), ""};
  }
  return {head + subscript(parts, 1), ""};
}

/// Goes through a formula token by token.
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
      latex_ += "\\overline{" + word(letters) + "}";
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

  /// A function's argument stands without brackets where it is one name.
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

  /// `^{2}` if an exponent stands here, or nothing.
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
    width += 0.9 * static_cast<double>(split(formula, function).size() - 1);
  }
  bool low = false;  // behind an underscore letters are small
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

}  // namespace assur::generator
