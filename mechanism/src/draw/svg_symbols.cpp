#include "draw/svg_symbols.hpp"

#include <array>
#include <cmath>
#include <initializer_list>

#include "draw/drawing_text.hpp"

namespace assur::mechanism::draw {

namespace {

using Eigen::Vector2d;

// In units of the picture, a quarter of a millimetre.
constexpr double pin_radius = 3;
constexpr double slot_width = 8.6;
constexpr double tube_width = 8;
constexpr double hatch_step = 5;
constexpr double hatch_length = 4.5;
const Vector2d block_half(7.5, 4.8);
const Vector2d support_half(6, 9);

std::string titled(const std::string& element, const std::string& attributes,
                   const std::string& title) {
  return "<" + element + attributes +
         (title.empty() ? "/>" : "><title>" + escaped(title) + "</title></" + element + ">") + "\n";
}

std::string path(std::initializer_list<Vector2d> points) {
  std::string text = "M";
  for (const Vector2d& point : points) {
    text += (text == "M" ? "" : " ") + pair(point);
  }
  return text;
}

std::string line(const char* kind, const Vector2d& from, const Vector2d& to,
                 const std::string& title = "") {
  return titled("path", " class=\"" + std::string(kind) + "\" d=\"" + path({from, to}) + "\"",
                title);
}

Vector2d direction(const Vector2d& from, const Vector2d& to) {
  const double length = (to - from).norm();
  return length > 0 ? Vector2d((to - from) / length) : Vector2d(1, 0);
}

Vector2d across(const Vector2d& along) { return {-along.y(), along.x()}; }

/// Short strokes on one side of a line, that which is farther down.
std::string hatching(const Vector2d& from, const Vector2d& to, double aside) {
  const Vector2d along = direction(from, to);
  Vector2d side = across(along);
  side *= side.y() < 0 || (side.y() == 0 && side.x() > 0) ? -1 : 1;
  std::string strokes;
  const double length = (to - from).norm();
  const int count = static_cast<int>(std::floor((length - 1) / hatch_step));
  const double first = (length - count * hatch_step) / 2;
  for (int stroke = 0; stroke <= count; ++stroke) {
    const Vector2d foot = from + (first + hatch_step * stroke) * along + aside * side;
    strokes += path({foot, foot + hatch_length * (0.8 * side - 0.6 * along)});
  }
  return "<path class=\"hatch\" d=\"" + strokes + "\"/>\n";
}

/// A rectangle about a line.
std::string rectangle(const char* kind, const Vector2d& from, const Vector2d& to, double half,
                      const std::string& title) {
  const Vector2d side = half * across(direction(from, to));
  return titled("path",
                " class=\"" + std::string(kind) + "\" d=\"" +
                    path({from + side, to + side, to - side, from - side}) + "Z\"",
                title);
}

std::string support(const Vector2d& pin) {
  const Vector2d left = pin + Vector2d(-support_half.x(), support_half.y());
  const Vector2d right = pin + support_half;
  const Vector2d more(2, 0);
  return "<path class=\"support\" d=\"" + path({pin, left, right}) + "Z\"/>\n" +
         line("ground", left - more, right + more) + hatching(left - more, right + more, 0);
}

/// The points of a shape in the picture.
std::vector<Vector2d> places(const Shape& shape, const Stance& stance, const Picture& picture) {
  std::vector<Vector2d> result;
  for (const std::size_t point : shape.points) {
    result.push_back(picture.at(stance.points[point]));
  }
  return result;
}

std::string outline(const std::vector<Vector2d>& corners) {
  std::string text = "M";
  for (const Vector2d& corner : corners) {
    text += (text == "M" ? "" : " ") + pair(corner);
  }
  return text + (corners.size() > 2 ? "Z" : "");
}

std::string slot(const std::vector<Vector2d>& at, bool fixed, const std::string& title) {
  const std::string d = " d=\"" + path({at[0], at[1]}) + "\"";
  return titled("path", std::string(" class=\"") + (fixed ? "ground " : "") + "slot\"" + d, title) +
         "<path class=\"gap\"" + d + "/>\n";
}

std::string element(const Shape& shape, const std::vector<Vector2d>& at) {
  const std::string title =
      shape.link + (shape.link.empty() || shape.name.empty() ? "" : ": ") + shape.name;
  switch (shape.symbol) {
    case Symbol::bar:
      return line("bar", at[0], at[1], title);
    case Symbol::plate:
      return titled("path", " class=\"plate\" d=\"" + outline(at) + "\"", title);
    case Symbol::slot:
      return slot(at, shape.fixed, title);
    case Symbol::guide:
      return line(shape.fixed ? "ground" : "guide", at[0], at[1], title);
    case Symbol::block: {
      const Vector2d half = block_half.x() * direction(at[0], at[1]);
      return rectangle("block", at[0] - half, at[0] + half, block_half.y(), title);
    }
    case Symbol::tube: {
      const Vector2d begin = at[0] + 5 * direction(at[0], at[1]);
      return line("bar", at[0], begin) + rectangle("tube", begin, at[1], tube_width / 2, title);
    }
    case Symbol::rod:
      return line("rod", at[0], at[1], title);
    case Symbol::pin:
      return titled("circle",
                    " class=\"pin\"" + attribute("cx", at[0].x()) + attribute("cy", at[0].y()) +
                        attribute("r", pin_radius),
                    title);
    case Symbol::tracer:
      return titled("circle",
                    " class=\"tracer\"" + attribute("cx", at[0].x()) + attribute("cy", at[0].y()) +
                        attribute("r", 1.6),
                    title);
  }
  return "";
}

/// Symbols from back to front.
constexpr std::array layers = {Symbol::plate, Symbol::bar,  Symbol::rod,  Symbol::tube,
                               Symbol::guide, Symbol::slot, Symbol::block};
constexpr std::array points = {Symbol::pin, Symbol::tracer};

template <typename Layers>
std::string in_layers(const Layers& symbols, const Drawing& drawing, const Stance& stance,
                      const Picture& picture) {
  std::string text;
  for (const Symbol symbol : symbols) {
    for (const Shape& shape : drawing.shapes) {
      const bool of_ground = shape.fixed && (symbol == Symbol::slot || symbol == Symbol::guide);
      if (shape.symbol == symbol && !of_ground) {
        text += element(shape, places(shape, stance, picture));
      }
    }
  }
  return text;
}

}  // namespace

std::string ground_elements(const Drawing& drawing, const Picture& picture) {
  std::string text;
  const Stance& stance = drawing.stances[drawing.emphasised];
  for (const Shape& shape : drawing.shapes) {
    if (!shape.fixed || shape.symbol == Symbol::tracer) {
      continue;
    }
    const std::vector<Vector2d> at = places(shape, stance, picture);
    if (shape.symbol == Symbol::pin) {
      text += support(at[0]);
    } else {
      const bool is_slot = shape.symbol == Symbol::slot;
      text += hatching(at[0], at[1], is_slot ? slot_width / 2 : 0) + element(shape, at);
    }
  }
  return text;
}

std::string stance_elements(const Drawing& drawing, const Stance& stance, const Picture& picture) {
  return in_layers(layers, drawing, stance, picture) + in_layers(points, drawing, stance, picture);
}

std::string outline_elements(const Drawing& drawing, const Stance& stance, const Picture& picture) {
  std::string lines;
  for (const Shape& shape : drawing.shapes) {
    const bool is_link = shape.symbol == Symbol::bar || shape.symbol == Symbol::plate ||
                         shape.symbol == Symbol::rod || shape.symbol == Symbol::tube;
    if (is_link) {
      lines += outline(places(shape, stance, picture));
    }
  }
  return "<path class=\"outline\" d=\"" + lines + "\"/>\n";
}

}  // namespace assur::mechanism::draw
