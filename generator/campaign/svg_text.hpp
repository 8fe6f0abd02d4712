// Elements of an SVG document from numbers and texts.
#pragma once

#include <array>
#include <assur/text/xml.hpp>
#include <cstdio>
#include <string>

namespace assur::generator::campaign {

/// A coordinate of the paper, to a hundredth.
[[nodiscard]] inline std::string at(double number) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.2f", number);
  return text.data();
}

[[nodiscard]] inline std::string words(double x, double y, const std::string& anchor,
                                       const std::string& text,
                                       const std::string& colour = "black") {
  return "<text x=\"" + at(x) + "\" y=\"" + at(y) + "\" text-anchor=\"" + anchor + "\" fill=\"" +
         colour + "\">" + text::escaped_for_xml(text) + "</text>\n";
}

[[nodiscard]] inline std::string line(double x1, double y1, double x2, double y2,
                                      const std::string& style) {
  return "<line x1=\"" + at(x1) + "\" y1=\"" + at(y1) + "\" x2=\"" + at(x2) + "\" y2=\"" + at(y2) +
         "\" " + style + "/>\n";
}

[[nodiscard]] inline std::string rectangle(double x, double y, double width, double height,
                                           const std::string& fill) {
  return "<rect x=\"" + at(x) + "\" y=\"" + at(y) + "\" width=\"" + at(width) + "\" height=\"" +
         at(height) + "\" fill=\"" + fill + "\"/>\n";
}

[[nodiscard]] inline std::string document(double width, double height, const std::string& body) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + at(width) + " " + at(height) +
         "\" width=\"" + at(width) + "\" height=\"" + at(height) +
         "\" font-family=\"sans-serif\" font-size=\"12\">\n" +
         rectangle(0, 0, width, height, "white") + body + "</svg>\n";
}

}  // namespace assur::generator::campaign
