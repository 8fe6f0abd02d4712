// Shapes of a stance as elements of a picture.
#include <array>
#include <cmath>
#include <initializer_list>

#include "draw/drawing_text.hpp"
#include "draw/svg_parts.hpp"

namespace assur::mechanism::draw {

namespace {

using Eigen::Vector2d;

// In units of the picture, a quarter of a millimetre.
constexpr double pin_radius = 3;
constexpr double tracer_radius = 1.6;
constexpr double slot_width = 8.6;
constexpr double tube_width = 8;
constexpr double hatch_step = 5;
constexpr double hatch_length = 4.5;
const Vector2d block_half(7.5, 4.8);
const Vector2d support_half(6, 9);

std::string path(std::initializer_list<Vector2d> points) {
  std::string text = "M";
  for (const Vector2d& point : points) {
    text += (text == "M" ? "" : " ") + pair(point);
  }
  return text;
}

SvgElement line(const char* kind, const Vector2d& from, const Vector2d& to,
                const std::string& title = "") {
  return {kind, {{"d", path({from, to})}}, "", title};
}

Vector2d direction(const Vector2d& from, const Vector2d& to) {
  const double length = (to - from).norm();
  return length > 0 ? Vector2d((to - from) / length) : Vector2d(1, 0);
}

Vector2d across(const Vector2d& along) { return {-along.y(), along.x()}; }

/// Short strokes on the lower side of a line.
SvgElement hatching(const Vector2d& from, const Vector2d& to, double aside) {
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
  return {"hatch", {{"d", strokes}}};
}

/// A rectangle about a line.
SvgElement rectangle(const char* kind, const Vector2d& from, const Vector2d& to, double half,
                     const std::string& title) {
  const Vector2d side = half * across(direction(from, to));
  return {kind, {{"d", path({from + side, to + side, to - side, from - side}) + "Z"}}, "", title};
}

SvgElement circle(const char* kind, const Vector2d& centre, double radius,
                  const std::string& title) {
  return {kind,
          {{"cx", coordinate(centre.x())}, {"cy", coordinate(centre.y())}},
          attribute("r", radius),
          title};
}

SvgElements support(const Vector2d& pin) {
  const Vector2d left = pin + Vector2d(-support_half.x(), support_half.y());
  const Vector2d right = pin + support_half;
  const Vector2d more(2, 0);
  return {{"support", {{"d", path({pin, left, right}) + "Z"}}},
          line("ground", left - more, right + more),
          hatching(left - more, right + more, 0)};
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

SvgElements elements_of(const Shape& shape, const std::vector<Vector2d>& at) {
  const std::string title =
      shape.link + (shape.link.empty() || shape.name.empty() ? "" : ": ") + shape.name;
  switch (shape.symbol) {
    case Symbol::bar:
      return {line("bar", at[0], at[1], title)};
    case Symbol::plate:
      return {{"plate", {{"d", outline(at)}}, "", title}};
    case Symbol::slot:
      return {line(shape.fixed ? "ground slot" : "slot", at[0], at[1], title),
              line("gap", at[0], at[1])};
    case Symbol::guide:
      return {line(shape.fixed ? "ground" : "guide", at[0], at[1], title)};
    case Symbol::block: {
      const Vector2d half = block_half.x() * direction(at[0], at[1]);
      return {rectangle("block", at[0] - half, at[0] + half, block_half.y(), title)};
    }
    case Symbol::tube: {
      const Vector2d begin = at[0] + 5 * direction(at[0], at[1]);
      return {line("bar", at[0], begin), rectangle("tube", begin, at[1], tube_width / 2, title)};
    }
    case Symbol::rod:
      return {line("rod", at[0], at[1], title)};
    case Symbol::pin:
      return {circle("pin", at[0], pin_radius, title)};
    case Symbol::tracer:
      return {circle("tracer", at[0], tracer_radius, title)};
  }
  return {};
}

void append(const SvgElements& more, SvgElements& elements) {
  elements.insert(elements.end(), more.begin(), more.end());
}

/// The symbols in the order of drawing, from back to front.
constexpr std::array layers = {Symbol::plate, Symbol::bar,   Symbol::rod,
                               Symbol::tube,  Symbol::guide, Symbol::slot,
                               Symbol::block, Symbol::pin,   Symbol::tracer};

}  // namespace

SvgElements ground_elements(const Drawing& drawing, const Picture& picture) {
  SvgElements elements;
  const Stance& stance = drawing.stances[drawing.emphasised];
  for (const Shape& shape : drawing.shapes) {
    if (!shape.fixed || shape.symbol == Symbol::tracer) {
      continue;
    }
    const std::vector<Vector2d> at = places(shape, stance, picture);
    if (shape.symbol == Symbol::pin) {
      append(support(at[0]), elements);
    } else {
      const bool is_slot = shape.symbol == Symbol::slot;
      elements.push_back(hatching(at[0], at[1], is_slot ? slot_width / 2 : 0));
      append(elements_of(shape, at), elements);
    }
  }
  return elements;
}

SvgElements stance_elements(const Drawing& drawing, const Stance& stance, const Picture& picture) {
  SvgElements elements;
  for (const Symbol symbol : layers) {
    for (const Shape& shape : drawing.shapes) {
      const bool of_ground = shape.fixed && (symbol == Symbol::slot || symbol == Symbol::guide);
      if (shape.symbol == symbol && !of_ground) {
        append(elements_of(shape, places(shape, stance, picture)), elements);
      }
    }
  }
  return elements;
}

SvgElements outline_elements(const Drawing& drawing, const Stance& stance, const Picture& picture) {
  std::string lines;
  for (const Shape& shape : drawing.shapes) {
    const bool is_link = shape.symbol == Symbol::bar || shape.symbol == Symbol::plate ||
                         shape.symbol == Symbol::rod || shape.symbol == Symbol::tube;
    if (is_link) {
      lines += outline(places(shape, stance, picture));
    }
  }
  return {{"outline", {{"d", lines}}}};
}

}  // namespace assur::mechanism::draw
