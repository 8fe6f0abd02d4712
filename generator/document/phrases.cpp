#include "document/phrases.hpp"

#include <assur/text/names.hpp>
#include <cctype>

namespace assur::generator::document {

namespace {

/// `(re + i*im)*w^(-1)`, without the parts that are zero.
std::string term_text(const DerivedTerm& term, const std::string& base) {
  std::string text = term.re == "0" ? "" : term.re;
  if (term.im != "0") {
    const bool negative = term.im[0] == '-';
    text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
    text += "i*" + term.im.substr(negative ? 1 : 0);
  }
  const bool plain = text.find_first_of("+- ") == std::string::npos;
  const std::string exponent = std::to_string(term.power);
  const std::string power = term.power == 0   ? ""
                            : term.power == 1 ? "*" + base
                            : term.power < 0  ? "*" + base + "^(" + exponent + ")"
                                              : "*" + base + "^" + exponent;
  return (plain ? text : "(" + text + ")") + power;
}

}  // namespace

std::string series_text(const DerivedSeries& series) {
  const std::string sum = text::joined(
      series.terms, " + ", [&](const DerivedTerm& term) { return term_text(term, series.base); });
  return series.name + (series.formula == series.name ? "" : " = " + series.formula) + " = " +
         (sum.empty() ? "0" : sum);
}

std::string bracketed(const std::string& formula) {
  return formula.find(' ') == std::string::npos ? formula : "(" + formula + ")";
}

std::string sentence(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

}  // namespace assur::generator::document
