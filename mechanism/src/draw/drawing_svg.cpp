// Drawings as SVG pictures.
#include <algorithm>
#include <assur/text/numbers.hpp>
#include <assur/text/xml.hpp>
#include <set>

#include "draw/drawing_text.hpp"
#include "draw/labels.hpp"
#include "draw/palette.hpp"
#include "draw/svg_parts.hpp"

namespace assur::mechanism::draw {

namespace {

using Eigen::Vector2d;

/// The part of the style that does not depend on the two sets of colours.
constexpr const char* style = R"(text{font:10px sans-serif}
.label{text-anchor:middle;font-style:italic}
path{fill:none;stroke-linecap:round;stroke-linejoin:round;stroke-width:1}
.plate{stroke-width:1.5;fill-opacity:.16}
.bar{stroke-width:2.6}
.rod{stroke-width:2.2}
.tube,.block{stroke-width:1.3}
.ground{stroke-width:1.3}
.slot{stroke-width:8.6}
.gap{stroke-width:6.4}
.hatch{stroke-width:.7}
.support,.pin,.scale path{stroke-width:1.1}
.trace{stroke-width:1}
.light{opacity:.5}
.light .trace{stroke-width:.8}
.mark{stroke-width:1.3}
)";

std::string colours_of_style(const char* Colour::*shade) {
  const std::string on_ink = std::string(ink.*shade);
  const std::string on_paper = std::string(paper.*shade);
  const std::string grey = std::string(muted.*shade);
  std::string text = ".paper,.tube,.block,.pin,.support{fill:" + on_paper +
                     "}\n.gap{stroke:" + on_paper + "}\ntext,.full{fill:" + on_ink +
                     "}\n.pin,.mark,.scale path{stroke:" + on_ink +
                     "}\n.ground,.hatch,.support,.c{stroke:" + grey + "}\n";
  for (std::size_t place = 0; place < colours.size(); ++place) {
    const std::string name = ".c" + std::to_string(place);
    const std::string colour = colours[place].*shade;
    text += name + "{stroke:" + colour + "}\n" + name + " .plate," + name +
            " .tracer{fill:" + colour + "}\n";
  }
  return text;
}

std::string style_of_forces(const char* Colour::*shade) {
  return std::string(".force{stroke-width:1.7;stroke:") + colours[colour_of_forces].*shade + "}\n";
}

std::string group_of(int configuration, const std::string& more, const std::string& inside) {
  const std::string colour = configuration < 1 ? "" : std::to_string(colour_of(configuration));
  return "<g class=\"c" + colour + more + "\">\n" + inside + "</g>\n";
}

/// A curve without points that are indistinguishably close.
std::string curve(const std::vector<Vector2d>& points, const Picture& picture) {
  constexpr double closest = 0.3;
  std::string text = "M";
  Vector2d last;
  for (std::size_t place = 0; place < points.size(); ++place) {
    const Vector2d at = picture.at(points[place]);
    if (place == 0 || place + 1 == points.size() || (at - last).norm() >= closest) {
      text += (place == 0 ? "" : " ") + pair(at);
      last = at;
    }
  }
  return text;
}

std::string traces(const Drawing& drawing, const Picture& picture, int configuration) {
  std::string text;
  for (const Trace& trace : drawing.traces) {
    if (trace.configuration == configuration && trace.points.size() > 1) {
      text += "<path class=\"trace\" d=\"" + curve(trace.points, picture) + "\"><title>" +
              text::escaped_for_xml(trace.output) + "</title></path>\n";
    }
  }
  return text;
}

std::string marks(const Drawing& drawing, const Picture& picture) {
  std::string text;
  for (const Mark& mark : drawing.marks) {
    for (const Vector2d& point : mark.points) {
      text +=
          mark_element(mark.event, picture.at(point),
                       " at " + drawing.parameter + " = " + text::short_number(mark.parameter, 6));
    }
  }
  return text;
}

std::string forces(const Drawing& drawing, const Picture& picture) {
  std::string text;
  for (const ForceArrow& force : drawing.forces) {
    text += arrow_element(
        picture.at(force.at), picture.at(force.at + drawing.length_of_force * force.force),
        force.joint + " on " + force.link + ": " + text::short_number(force.force.x(), 6) + ", " +
            text::short_number(force.force.y(), 6));
  }
  return text;
}

Box box_about(const Vector2d& centre, double wide, double up, double down) {
  return {centre - Vector2d(wide, up), centre + Vector2d(wide, down)};
}

void add_lines(const std::vector<Vector2d>& corners, bool closed, double weight,
               Obstacles& obstacles) {
  const std::size_t count = corners.size();
  for (std::size_t place = 0; place + (closed ? 0 : 1) < count; ++place) {
    obstacles.lines.push_back({corners[place], corners[(place + 1) % count], weight});
  }
}

/// The distances of a shape's edges, and of the ground's hatching, from its line.
std::vector<double> half_widths(const Shape& shape) {
  switch (shape.symbol) {
    case Symbol::tube:
      return {4};
    case Symbol::slot:
      return shape.fixed ? std::vector<double>{4, 8} : std::vector<double>{4};
    case Symbol::guide:
      return shape.fixed ? std::vector<double>{3} : std::vector<double>{};
    default:
      return {};
  }
}

Obstacles obstacles_of(const Drawing& drawing, const Picture& picture) {
  Obstacles obstacles;
  obstacles.inside = {Vector2d(1, 1),
                      Vector2d(Picture::width - 1, picture.height - legend_height(drawing))};
  const auto places = [&](const std::vector<Vector2d>& points) {
    std::vector<Vector2d> result;
    for (const Vector2d& point : points) {
      result.push_back(picture.at(point));
    }
    return result;
  };
  const Stance& emphasised = drawing.stances[drawing.emphasised];
  for (const Stance& stance : drawing.stances) {
    for (const Shape& shape : drawing.shapes) {
      std::vector<Vector2d> at;
      for (const std::size_t point : shape.points) {
        at.push_back(picture.at(stance.points[point]));
      }
      const double weight = &stance == &emphasised ? 4 : 0.4;
      add_lines(at, shape.symbol == Symbol::plate, weight, obstacles);
      for (const double half : half_widths(shape)) {
        const Vector2d along = (at[1] - at[0]).normalized();
        const Vector2d aside = half * Vector2d(-along.y(), along.x());
        add_lines({at[0] + aside, at[1] + aside}, false, weight, obstacles);
        add_lines({at[0] - aside, at[1] - aside}, false, weight, obstacles);
      }
      if (&stance != &emphasised) {
        continue;
      }
      if (shape.symbol == Symbol::pin) {
        obstacles.boxes.push_back(shape.fixed ? box_about(at[0], 8, 4, 14)
                                              : box_about(at[0], 3.6, 3.6, 3.6));
      } else if (shape.symbol == Symbol::block) {
        obstacles.boxes.push_back(box_about(at[0], 7, 6, 6));
      } else if (shape.symbol == Symbol::tracer) {
        obstacles.boxes.push_back(box_about(at[0], 2, 2, 2));
      }
    }
  }
  for (const Trace& trace : drawing.traces) {
    add_lines(places(trace.points), false,
              trace.configuration == emphasised.configuration ? 0.8 : 0.1, obstacles);
  }
  for (const ForceArrow& force : drawing.forces) {
    add_lines(places({force.at, force.at + drawing.length_of_force * force.force}), false, 4,
              obstacles);
  }
  for (const Mark& mark : drawing.marks) {
    for (const Vector2d& point : places(mark.points)) {
      obstacles.boxes.push_back(box_about(point, 4, 4, 4));
    }
  }
  return obstacles;
}

/// The emphasised stance, or all moments of its motion.
std::string links(const Drawing& drawing, const Picture& picture) {
  if (drawing.motion.empty()) {
    return written(stance_elements(drawing, drawing.stances[drawing.emphasised], picture));
  }
  std::vector<SvgElements> moments;
  for (const Stance& stance : drawing.motion) {
    moments.push_back(stance_elements(drawing, stance, picture));
  }
  return written_moving(moments, drawing.seconds);
}

/// The names of pins and outputs, each once at its place. In a moving picture only points at rest
/// have names.
std::string labels(const Drawing& drawing, const Picture& picture) {
  LabelPlacer placer(obstacles_of(drawing, picture));
  const Stance& stance = drawing.stances[drawing.emphasised];
  std::set<std::pair<std::size_t, std::string>> told;
  for (const Shape& shape : drawing.shapes) {
    if ((shape.symbol == Symbol::pin || shape.symbol == Symbol::tracer) &&
        (drawing.motion.empty() || shape.fixed) &&
        told.emplace(shape.points[0], shape.name).second) {
      placer.place(shape.name, picture.at(stance.points[shape.points[0]]));
    }
  }
  std::string text;
  for (const Label& label : placer.labels()) {
    text += "<text class=\"label\"" + attribute("x", label.at.x()) + attribute("y", label.at.y()) +
            ">" + text::escaped_for_xml(label.text) + "</text>\n";
  }
  return text;
}

}  // namespace

}  // namespace assur::mechanism::draw

namespace assur::mechanism {

std::string drawing_svg(const Drawing& drawing) {
  using namespace draw;
  const Picture picture = picture_of(drawing, legend_height(drawing));
  const std::string height = coordinate(picture.height);
  std::string text =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"80mm\" height=\"" +
      coordinate(picture.height / 4) + "mm\" viewBox=\"0 0 320 " + height + "\" data-x=\"" +
      exact(picture.x) + "\" data-y=\"" + exact(picture.y) + "\" data-scale=\"" +
      exact(picture.scale) + "\">\n<title>" + text::escaped_for_xml(drawing.title) +
      "</title>\n<style>\n" + style + colours_of_style(&Colour::light) +
      (drawing.forces.empty() ? "" : style_of_forces(&Colour::light)) +
      "@media (prefers-color-scheme:dark){\n" + colours_of_style(&Colour::dark) +
      (drawing.forces.empty() ? "" : style_of_forces(&Colour::dark)) +
      ".light{opacity:.65}\n}\n</style>\n<rect class=\"paper\" width=\"320\" height=\"" + height +
      "\"/>\n";
  text +=
      traces(drawing, picture, 0).empty() ? "" : group_of(0, " light", traces(drawing, picture, 0));
  const Stance& emphasised = drawing.stances[drawing.emphasised];
  for (const Stance& stance : drawing.stances) {
    if (&stance != &emphasised) {
      const std::string dash = dash_of(stance.configuration);
      text += group_of(stance.configuration,
                       " light" + (dash.empty() ? "" : "\" stroke-dasharray=\"" + dash),
                       traces(drawing, picture, stance.configuration) +
                           written(outline_elements(drawing, stance, picture)));
    }
  }
  text += written(ground_elements(drawing, picture));
  text += group_of(emphasised.configuration, "",
                   traces(drawing, picture, emphasised.configuration) + links(drawing, picture));
  text += marks(drawing, picture);
  text += forces(drawing, picture);
  text += labels(drawing, picture);
  text += legend_elements(drawing, picture);
  return text + "</svg>\n";
}

}  // namespace assur::mechanism
