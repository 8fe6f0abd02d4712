// Turns a name of a derivation, such as `theta_BCG` or `BC_x`, into LaTeX.
#pragma once

#include <string>

namespace assur::generator::document {

/// A name in two parts, between which an exponent goes: `\cos` and `\theta`; or the whole name and
/// an empty text.
struct LatexName {
  std::string head;
  std::string tail;

  [[nodiscard]] std::string whole() const { return head + tail; }
};

[[nodiscard]] LatexName latex_name(const std::string& name);
/// A word of several letters set as one.
[[nodiscard]] std::string latex_word(const std::string& letters);

}  // namespace assur::generator::document
