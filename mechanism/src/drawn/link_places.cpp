#include "drawn/link_places.hpp"

#include <algorithm>
#include <assur/text/numbers.hpp>
#include <cmath>
#include <numbers>

#include "description/parameter_order.hpp"

namespace assur::mechanism::drawn {

OwnValues::OwnValues(const Mechanism& mechanism) : parameters_(mechanism.parameters().size()) {
  for (const ParameterIndex parameter : description::parameter_order(mechanism)) {
    const Number& value = mechanism.numbers()[mechanism.parameters()[parameter].value];
    parameters_[parameter] = of(value.formula, value.part);
  }
}

double OwnValues::of(const Formula& formula, const std::string& part) const {
  const auto value =
      formula.evaluate<double>([this](ParameterIndex parameter) { return parameters_[parameter]; });
  if (!std::isfinite(value)) {
    throw MechanismError(part, "the value is not a finite number");
  }
  return value;
}

namespace {

/// Points nearer than this part of the largest coordinate coincide: their difference is the
/// rounding of the formulas that place them.
constexpr double coinciding = 1e-12;
/// A triangle is flat if its height is below this part of its longest side: a drawing with six
/// digits does not determine the side of the point.
constexpr double flat = 1e-6;

const std::string no_axis = "its x-axis has no direction; list another point second";

}  // namespace

Formula angle_of(const DrawnParts& parts, DrawnLinkIndex link) {
  const DrawnLink& own = parts.links[link];
  if (own.name == "ground" || own.points.size() < 2) {
    return 0;
  }
  return angle(place_of(parts, own.points[1]) - place_of(parts, own.points[0]));
}

Formula angle_between(const DrawnParts& parts, DrawnLinkIndex first, DrawnLinkIndex second) {
  const Formula one = angle_of(parts, first);
  const Formula other = angle_of(parts, second);
  if (one.constant() && other.constant()) {
    const double turn = std::remainder(*other.constant() - *one.constant(), 2 * std::numbers::pi);
    return turn == -std::numbers::pi ? std::numbers::pi : turn;
  }
  if (one.constant() == 0) {
    return other;
  }
  const Formula difference = other - one;
  return angle({Formula::of(text::Operation::cos, difference),
                Formula::of(text::Operation::sin, difference)});
}

LinkPlaces::LinkPlaces(const DrawnParts& parts, const Mechanism& mechanism)
    : parts_(parts), mechanism_(mechanism), values_(mechanism) {
  for (const DrawnPoint& point : parts.points) {
    const std::string part = "points." + point.name;
    size_ = std::max({size_, std::abs(values_.of(point.x, part + "[0]")),
                      std::abs(values_.of(point.y, part + "[1]"))});
  }
}

Vector LinkPlaces::direction(const DrawnLine& line, const std::string& why) const {
  const Vector along = line.to - line.from;
  const Formula far = length(along);
  if (!(values_.of(far, line.part) > coinciding * size_)) {
    if (!line.second.exists()) {
      throw MechanismError(line.part + ".direction",
                           "[0, 0] has no direction; at least one of the numbers must not be zero");
    }
    throw MechanismError(line.part, "the points " + parts_.points[line.first].name + " and " +
                                        parts_.points[line.second].name +
                                        " coincide in the drawing, so that " + why);
  }
  return {along.x / far, along.y / far};
}

Vector LinkPlaces::from_line(const Vector& place, const DrawnLine& line) const {
  return turned_back(place - line.from, direction(line, "the line has no direction"));
}

LinkPlaces::Frame LinkPlaces::frame_along_points(DrawnLinkIndex link) const {
  const DrawnLink& own = parts_.links[link];
  const Vector origin = place_of(parts_, own.points[0]);
  if (own.points.size() < 2) {
    return {origin, {1, 0}};
  }
  const DrawnLine axis = {own.points[0], own.points[1], origin, place_of(parts_, own.points[1]),
                          "links." + own.name};
  return {origin, direction(axis, no_axis)};
}

LinkPlaces::Frame LinkPlaces::frame(DrawnLinkIndex link) const {
  return parts_.links[link].name == "ground" ? Frame{{0, 0}, {1, 0}} : frame_along_points(link);
}

Formula LinkPlaces::drawn_length(DrawnPointIndex one, DrawnPointIndex other) const {
  return length(place_of(parts_, other) - place_of(parts_, one));
}

Vector LinkPlaces::drawn_place(DrawnLinkIndex link, DrawnPointIndex point) const {
  const std::vector<DrawnPointIndex>& points = parts_.links[link].points;
  const Frame own = frame(link);
  if (parts_.links[link].name == "ground") {
    return place_of(parts_, point);
  }
  if (point == points[0]) {
    return {0, 0};
  }
  if (points.size() > 1 && point == points[1]) {  // on the x-axis, regardless of rounding
    return {drawn_length(points[0], point), 0};
  }
  return turned_back(place_of(parts_, point) - own.origin, own.axis);
}

Vector LinkPlaces::on_ray(DrawnLinkIndex link, DrawnPointIndex from, const Vector& begin,
                          const Vector& ray, ParameterIndex far) const {
  const Formula drawn = length(ray);
  if (!(values_.of(drawn, "links." + parts_.links[link].name) > coinciding * size_)) {
    throw MechanismError("parameters." + mechanism_.parameters()[far].name + ".drawn",
                         "a point of the link " + parts_.links[link].name + " coincides with " +
                             parts_.points[from].name +
                             " in the drawing, so that their distance has no direction");
  }
  return begin + (Formula::of(far) / drawn) * ray;
}

Vector LinkPlaces::apex(DrawnLinkIndex link, DrawnPointIndex point, const Vector& drawn,
                        const Formula& base, ParameterIndex by_first,
                        ParameterIndex by_second) const {
  const DrawnPointIndex first = parts_.links[link].points[0];
  const DrawnPointIndex second = parts_.links[link].points[1];
  const auto name = [this](DrawnPointIndex one) { return parts_.points[one].name; };
  const std::string parameter = "parameters." + mechanism_.parameters()[by_second].name;
  const double side = values_.of(drawn.y, parameter);
  double longest = 0;
  for (const Formula& edge :
       {drawn_length(first, second), drawn_length(first, point), drawn_length(second, point)}) {
    longest = std::max(longest, values_.of(edge, parameter));
  }
  if (std::abs(side) < flat * longest) {
    throw MechanismError(parameter + ".drawn",
                         name(first) + ", " + name(second) + " and " + name(point) +
                             " lie on one line in the link " + parts_.links[link].name +
                             ", so that two of their distances settle the third; let '" +
                             mechanism_.parameters()[by_second].name +
                             "' be a formula without 'drawn'");
  }
  const Formula a = Formula::of(by_first);
  const Formula b = Formula::of(by_second);
  const Formula x = (a * a + (base * base - b * b)) / (2 * base);
  const Formula square = a * a - x * x;
  if (!(values_.of(square, parameter) > 0)) {
    const auto distance = [&](DrawnPointIndex one, DrawnPointIndex other, const Formula& value) {
      return name(one) + name(other) + " = " + text::short_number(values_.of(value, parameter), 6);
    };
    throw MechanismError(parameter, "the distances " + distance(first, second, base) + ", " +
                                        distance(first, point, a) + " and " +
                                        distance(second, point, b) + " of the link " +
                                        parts_.links[link].name + " form no triangle");
  }
  return {x, side > 0 ? root(square) : negative(root(square))};
}

Vector LinkPlaces::place(DrawnLinkIndex link, DrawnPointIndex point) const {
  const std::vector<DrawnPointIndex>& points = parts_.links[link].points;
  if (points.size() < 2 || point == points[0] || !parts_.lists(link, point)) {
    return drawn_place(link, point);
  }
  const std::optional<ParameterIndex> by_first = parts_.length(link, points[0], point);
  const std::optional<ParameterIndex> by_second =
      point == points[1] ? std::nullopt : parts_.length(link, points[1], point);
  if (!by_first && !by_second) {
    return drawn_place(link, point);
  }
  // All vectors are in a frame along the first two points, also for the ground.
  const Frame along = frame_along_points(link);
  const Vector drawn = turned_back(place_of(parts_, point) - along.origin, along.axis);
  const std::optional<ParameterIndex> given = parts_.length(link, points[0], points[1]);
  const Formula drawn_base = drawn_length(points[0], points[1]);
  const Formula base = given ? Formula::of(*given) : drawn_base;
  Vector own;
  if (point == points[1]) {
    own = {Formula::of(*by_first), 0};
  } else if (by_first && by_second) {
    own = apex(link, point, drawn, base, *by_first, *by_second);
  } else if (by_first) {
    own = on_ray(link, points[0], {0, 0}, drawn, *by_first);
  } else {
    own = on_ray(link, points[1], {base, 0}, drawn - Vector{drawn_base, 0}, *by_second);
  }
  return parts_.links[link].name == "ground" ? along.origin + turned(own, along.axis) : own;
}

PlacedLine LinkPlaces::line(DrawnLinkIndex link, const DrawnLine& line) const {
  const Vector unit = turned_back(direction(line, "the line has no direction"), frame(link).axis);
  const bool lists_first = parts_.lists(link, line.first);
  const bool lists_second = line.second.exists() && parts_.lists(link, line.second);
  const Vector begin = place(link, line.first);
  if (lists_first && lists_second) {
    return {begin, place(link, line.second) - begin};
  }
  if (lists_second) {
    return {place(link, line.second) - length(line.to - line.from) * unit, unit};
  }
  return {begin, unit};
}

}  // namespace assur::mechanism::drawn
