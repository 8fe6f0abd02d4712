// Legend below a picture: its scale, colours, marks and forces.
#include <algorithm>
#include <assur/text/numbers.hpp>
#include <assur/text/xml.hpp>
#include <cmath>

#include "draw/drawing_text.hpp"
#include "draw/labels.hpp"
#include "draw/palette.hpp"
#include "draw/svg_parts.hpp"

namespace assur::mechanism::draw {

namespace {

using Eigen::Vector2d;

constexpr double row_height = 15;
constexpr double legend_side = 8;
constexpr double longest_bar = 80;

/// The usual term for an event.
std::string words_for(const std::string& event) {
  return event == "fold" || event == "birth" ? "dead centre"
         : event == "crossing"               ? "change point"
                                             : event;
}

/// Entries one after the other, in as many rows as they need.
class Rows {
 public:
  explicit Rows(double top) : top_(top) {}

  /// Reserves room for an entry; returns the left end of its middle line.
  Vector2d take(double width) {
    if (at_ > legend_side && at_ + width > Picture::width - legend_side) {
      at_ = legend_side;
      ++row_;
    }
    Vector2d place(at_, top_ + row_height * (row_ + 0.5));
    at_ += width;
    return place;
  }
  [[nodiscard]] double height() const { return row_height * (row_ + 1) + 3; }

 private:
  double top_;
  double at_ = legend_side;
  int row_ = 0;
};

std::string text_at(const Vector2d& place, const std::string& text) {
  return "<text" + attribute("x", place.x()) + attribute("y", place.y() + 0.35 * text_height) +
         ">" + text::escaped_for_xml(text) + "</text>\n";
}

std::string line_between(const Vector2d& from, const Vector2d& to) {
  return " d=\"M" + pair(from) + " " + pair(to) + "\"/>\n";
}

std::string scale_bar(const Drawing& drawing, double scale, Rows& rows) {
  const double length = round_length(longest_bar / scale);
  const std::string words =
      text::short_number(length, 6) + (drawing.unit.empty() ? "" : " " + drawing.unit);
  const Vector2d from = rows.take(scale * length + text_width(words) + 14);
  const Vector2d to = from + Vector2d(scale * length, 0);
  const Vector2d up(0, 2.5);
  return "<g class=\"scale\"><path d=\"M" + pair(from - up) + " " + pair(from + up) + "M" +
         pair(from) + " " + pair(to) + "M" + pair(to - up) + " " + pair(to + up) + "\"/>" +
         text_at(to + Vector2d(4, 0), words) + "</g>\n";
}

std::string configurations(const Drawing& drawing, Rows& rows) {
  if (drawing.stances.size() < 2) {
    return "";
  }
  const std::string heading = "configuration";
  std::string text = text_at(rows.take(text_width(heading) + 5), heading);
  for (const Stance& stance : drawing.stances) {
    const bool strong = &stance == &drawing.stances[drawing.emphasised];
    const std::string number = std::to_string(stance.configuration);
    const Vector2d from = rows.take(15 + text_width(number) + 7);
    text += "<g class=\"c" + std::to_string(colour_of(stance.configuration)) + "\"><path class=\"" +
            (strong ? "bar" : "outline") + "\" stroke-dasharray=\"" +
            (strong ? "" : dash_of(stance.configuration)) + "\"" +
            line_between(from, from + Vector2d(12, 0)) + "</g>" +
            text_at(from + Vector2d(15, 0), number);
  }
  if (drawing.left_out > 0) {
    const std::string words = "and " + std::to_string(drawing.left_out) + " more";
    text += text_at(rows.take(text_width(words) + 7), words);
  }
  return text;
}

std::string legend_of_marks(const Drawing& drawing, Rows& rows) {
  std::string text;
  std::vector<std::string> told;
  for (const Mark& mark : drawing.marks) {
    const std::string words = words_for(mark.event);
    if (!mark.points.empty() && std::find(told.begin(), told.end(), words) == told.end()) {
      told.push_back(words);
      const Vector2d from = rows.take(13 + text_width(words) + 7);
      text += mark_element(mark.event, from + Vector2d(5, 0), "") +
              text_at(from + Vector2d(12, 0), words);
    }
  }
  return text;
}

/// The arrow of a force with a round number.
std::string scale_of_forces(const Drawing& drawing, double scale, Rows& rows) {
  const double pace = scale * drawing.length_of_force;
  if (drawing.forces.empty() || !(pace > 0)) {
    return "";
  }
  constexpr double longest_arrow = 60;
  const double force = round_length(longest_arrow / pace);
  const std::string words = "force " + text::short_number(force, 6);
  const Vector2d from = rows.take(pace * force + text_width(words) + 14);
  const Vector2d to = from + Vector2d(pace * force, 0);
  return arrow_element(from, to, "") + text_at(to + Vector2d(4, 0), words);
}

std::string entries(const Drawing& drawing, double scale, Rows& rows) {
  std::string text = scale_bar(drawing, scale, rows);
  text += configurations(drawing, rows);
  text += scale_of_forces(drawing, scale, rows);
  return text + legend_of_marks(drawing, rows);
}

}  // namespace

double legend_height(const Drawing& drawing) {
  Rows rows(0);
  (void)entries(drawing, picture_of(drawing, 0).scale, rows);
  return rows.height();
}

std::string legend_elements(const Drawing& drawing, const Picture& picture) {
  Rows rows(picture.height - legend_height(drawing));
  return entries(drawing, picture.scale, rows);
}

std::string mark_element(const std::string& event, const Vector2d& at, const std::string& title) {
  const std::string words = words_for(event);
  const Vector2d wide(3.6, 0);
  const Vector2d high(0, 3.6);
  const Vector2d slant(2.6, 2.6);
  const Vector2d back(2.6, -2.6);
  const bool is_crossing = event == "crossing";
  return std::string("<path class=\"") + (words == "dead centre" ? "mark full" : "mark") +
         "\" d=\"M" +
         (is_crossing ? pair(at - slant) + " " + pair(at + slant) + "M" + pair(at - back) + " " +
                            pair(at + back)
                      : pair(at - wide) + " " + pair(at - high) + " " + pair(at + wide) + " " +
                            pair(at + high) + "Z") +
         "\"" +
         (title.empty() ? "/>"
                        : "><title>" + text::escaped_for_xml(words + title) + "</title></path>") +
         "\n";
}

std::string arrow_element(const Vector2d& from, const Vector2d& to, const std::string& title) {
  constexpr double shortest = 1;
  constexpr double head = 6;
  const double length = (to - from).norm();
  if (!(length >= shortest)) {
    return "";
  }
  const Vector2d along = (to - from) / length * std::min(head, length);
  const Vector2d across = 0.35 * Vector2d(-along.y(), along.x());
  return "<path class=\"force\" d=\"M" + pair(from) + " " + pair(to) + "M" +
         pair(to - along + across) + " " + pair(to) + " " + pair(to - along - across) + "\"" +
         (title.empty() ? "/>" : "><title>" + text::escaped_for_xml(title) + "</title></path>") +
         "\n";
}

}  // namespace assur::mechanism::draw
