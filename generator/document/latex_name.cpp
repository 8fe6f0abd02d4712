// LaTeX for names such as `theta_BCG` or `BC_x`.
#include <algorithm>
#include <cctype>
#include <map>
#include <utility>
#include <vector>

#include "document/latex_formula.hpp"

namespace assur::generator::document {

namespace {

bool is_word(const std::string& part) {
  return !part.empty() && std::all_of(part.begin(), part.end(), [](unsigned char letter) {
    return std::isupper(letter) != 0;
  });
}

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

/// `{\mathit{BCG},x}` from the parts of a name after the first.
std::string subscript(const std::vector<std::string>& parts, std::size_t from) {
  std::string text;
  for (std::size_t at = from; at < parts.size(); ++at) {
    const std::string& part = parts[at];
    const bool negative =
        part.size() > 1 && part[0] == 'm' && std::isdigit(static_cast<unsigned char>(part[1])) != 0;
    text += (text.empty() ? "" : ",") + (negative ? "-" + part.substr(1)
                                         : part == "re" || part == "im" || part == "moment"
                                             ? "\\mathrm{" + part + "}"
                                         : is_word(part) ? latex_word(part)
                                                         : part);
  }
  return text.empty() ? "" : "_{" + text + "}";
}

/// The angle in the name of a direction: `BCG_minus_CD`, `BCG_plus_psi_G_BCG`.
std::string angle_of(const std::string& letters) {
  std::string text;
  std::string rest = letters;
  bool minus = rest.starts_with("minus_");
  rest = minus ? rest.substr(6) : rest;
  while (!rest.empty()) {
    const std::size_t at = std::min(rest.find("_minus_"), rest.find("_plus_"));
    const std::string part = rest.substr(0, at);
    text += minus ? "-" : text.empty() ? "" : "+";
    text += is_word(part) ? "\\theta_{" + latex_word(part) + "}" : latex_name(part).whole();
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
    return {function, "\\vartheta_{" + latex_word(letters) + "}"};
  }
  return {function, "(" + angle_of(letters) + ")"};
}

/// `BCG_along_CD`: of a loop's vectors that turn with BCG, the component along its closing vector.
LatexName component_name(const std::string& turning, const std::string& sign,
                         const std::string& frame) {
  const std::string seen =
      frame.starts_with("slide_") ? "s_{" + frame.substr(6) + "}" : latex_word(frame);
  return {"v_{" + angle_of(turning) + "}" + "^{" + sign + seen + "}", ""};
}

/// `force_along_CD` and `F_along_CD_x`: a part of the force in the joint that closes a loop, and
/// one of its components.
LatexName force_part(const std::string& head, const std::string& sign, const std::string& frame) {
  const bool is_component = head == "F";
  const std::string of = is_component ? frame.substr(0, frame.size() - 2) : frame;
  const std::string seen = of.starts_with("slide_") ? "s_{" + of.substr(6) + "}" : latex_word(of);
  return {(is_component ? "F_{" + frame.substr(frame.size() - 1) + "}" : "\\lambda") + "^{" + sign +
              seen + "}",
          ""};
}

}  // namespace

std::string latex_word(const std::string& letters) {
  return letters.size() == 1 ? letters : "\\mathit{" + letters + "}";
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
  if (name.starts_with("inverse_")) {
    return {"\\bigl(" + latex_name(name.substr(8)).whole() + "\\bigr)^{-1}", ""};
  }
  for (const auto& [separator, sign] :
       {std::pair<std::string, std::string>{"_along_", "\\parallel "}, {"_across_", "\\perp "}}) {
    const std::vector<std::string> parts = split(name, separator);
    if (parts.size() == 2 && (parts[0] == "force" || parts[0] == "F")) {
      return force_part(parts[0], sign, parts[1]);
    }
    if (parts.size() == 2) {
      return component_name(parts[0], sign, parts[1]);
    }
  }
  if (name == "pivot_product") {
    return {"\\Pi", ""};
  }
  const std::vector<std::string> parts = split(name, "_");
  const std::string& head = parts[0];
  if (head == "load" && parts.size() > 1) {
    return {greek.contains(parts[1]) ? "Q_{" + latex_name(name.substr(5)).whole() + "}"
                                     : "Q" + subscript(parts, 1),
            ""};
  }
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
    return {(parts.size() > 1 ? "\\overline{" + latex_word(head) + "}" : latex_word(head)) +
                subscript(parts, 1),
            ""};
  }
  if (head.size() == 2 &&
      std::isdigit(static_cast<unsigned char>(head[1])) != 0) {  // f1, P1_m1_re, f1_psi_C_BCG
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

}  // namespace assur::generator::document
