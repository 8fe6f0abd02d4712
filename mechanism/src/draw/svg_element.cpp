// Elements of a picture, at rest and moving, as SVG.
#include <algorithm>
#include <assur/text/numbers.hpp>
#include <assur/text/xml.hpp>

#include "draw/drawing_text.hpp"
#include "draw/svg_parts.hpp"

namespace assur::mechanism::draw {

namespace {

/// The text of an element with the text `inside`, which animates it.
std::string element_with(const SvgElement& element, const std::string& inside) {
  const std::string name = element.places.front().first == "d" ? "path" : "circle";
  std::string text = "<" + name + " class=\"" + element.kind + "\"";
  for (const auto& [attribute, value] : element.places) {
    text += " " + attribute + "=\"" + value + "\"";
  }
  text += element.more;
  const std::string title =
      element.title.empty() ? "" : "<title>" + text::escaped_for_xml(element.title) + "</title>";
  return text +
         (title.empty() && inside.empty() ? "/>\n" : ">" + title + inside + "</" + name + ">\n");
}

}  // namespace

std::string written(const SvgElements& elements) {
  std::string text;
  for (const SvgElement& element : elements) {
    text += element_with(element, "");
  }
  return text;
}

std::string written_moving(const std::vector<SvgElements>& moments, double seconds) {
  std::string text;
  for (std::size_t place = 0; place < moments.front().size(); ++place) {
    const SvgElement& first = moments.front()[place];
    std::string motion;
    // NOLINTNEXTLINE(modernize-loop-convert): the other moments are read at the same index
    for (std::size_t attribute = 0; attribute < first.places.size(); ++attribute) {
      const auto& [name, value] = first.places[attribute];
      const auto value_at = [&, which = attribute](const SvgElements& moment) {
        return moment[place].places[which].second;
      };
      if (std::all_of(moments.begin(), moments.end(), [&, &still = value](const SvgElements& one) {
            return value_at(one) == still;
          })) {
        continue;
      }
      motion += "<animate attributeName=\"" + name + "\" dur=\"" + text::short_number(seconds, 6) +
                "s\" repeatCount=\"indefinite\" values=\"";
      for (const SvgElements& moment : moments) {
        motion += (&moment == &moments.front() ? "" : ";") + value_at(moment);
      }
      motion += "\"/>";
    }
    text += element_with(first, motion);
  }
  return text;
}

}  // namespace assur::mechanism::draw
