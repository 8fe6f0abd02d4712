// Points and lines of a drawing in the frames of the links.
#pragma once

#include <assur/mechanism/drawn_mechanism.hpp>
#include <assur/mechanism/mechanism.hpp>

#include "drawn/planar_formula.hpp"

namespace assur::mechanism::drawn {

/// The values of a mechanism's parameters.
class OwnValues {
 public:
  /// Throws MechanismError for a parameter that has no value or that depends on itself.
  explicit OwnValues(const Mechanism& mechanism);

  /// Throws MechanismError for a value that is not a finite number.
  [[nodiscard]] double of(const Formula& formula, const std::string& part) const;

 private:
  Table<ParameterIndex, double> parameters_;
};

/// A line of the drawing, between two ends. Each end is a point of the drawing, or a place without
/// a name, whose index does not exist.
struct DrawnLine {
  DrawnPointIndex first, second;
  Vector from, to;
  std::string part;  ///< for messages
};

/// A line in the frame of a link.
struct PlacedLine {
  Vector through, along;
};

/// The drawn place of a point.
[[nodiscard]] inline Vector place_of(const DrawnParts& parts, DrawnPointIndex point) {
  return {parts.points[point].x, parts.points[point].y};
}
/// The angle of a link as drawn; zero for the ground and for a link of one point.
[[nodiscard]] Formula angle_of(const DrawnParts& parts, DrawnLinkIndex link);
/// The drawn angle of the second link less that of the first, in (-pi, pi].
[[nodiscard]] Formula angle_between(const DrawnParts& parts, DrawnLinkIndex first,
                                    DrawnLinkIndex second);

/// The places of points in links, with decisions by the parameters' own values.
class LinkPlaces {
 public:
  /// Both must outlive it. Throws MechanismError for a parameter that cannot be evaluated, and for
  /// a point without a possible place.
  LinkPlaces(const DrawnParts& parts, const Mechanism& mechanism);

  /// A point in the frame of a link. The second point lies on the x-axis at its distance from the
  /// first. A further point keeps its drawn place; with a parameter for its distance from the first
  /// or the second point, it lies on the drawn ray from there; with parameters for both, at the
  /// intersection of the two circles on the drawn side. The link need not list the point.
  [[nodiscard]] Vector place(DrawnLinkIndex link, DrawnPointIndex point) const;
  /// A line in the frame of a link: through both ends if the link lists both, through the listed
  /// one in the drawn direction if it lists one, and at its drawn place if it lists none.
  [[nodiscard]] PlacedLine line(DrawnLinkIndex link, const DrawnLine& line) const;
  /// The unit vector along a line. Throws MechanismError, with `why` at its end, if the line's ends
  /// coincide.
  [[nodiscard]] Vector direction(const DrawnLine& line, const std::string& why) const;
  /// The signed distances of a place from the first end of a line: along it, and to its left.
  [[nodiscard]] Vector from_line(const Vector& place, const DrawnLine& line) const;
  [[nodiscard]] double value(const Formula& formula, const std::string& part) const {
    return values_.of(formula, part);
  }
  /// The largest coordinate of all points, the size of the drawing.
  [[nodiscard]] double size() const { return size_; }

 private:
  struct Frame {
    Vector origin, axis;
  };
  /// The frame from the first point of a link to the second; with one point, parallel to the
  /// ground.
  [[nodiscard]] Frame frame_along_points(DrawnLinkIndex link) const;
  [[nodiscard]] Frame frame(DrawnLinkIndex link) const;
  [[nodiscard]] Vector drawn_place(DrawnLinkIndex link, DrawnPointIndex point) const;
  [[nodiscard]] Formula drawn_length(DrawnPointIndex one, DrawnPointIndex other) const;
  [[nodiscard]] Vector on_ray(DrawnLinkIndex link, DrawnPointIndex from, const Vector& begin,
                              const Vector& ray, ParameterIndex far) const;
  [[nodiscard]] Vector apex(DrawnLinkIndex link, DrawnPointIndex point, const Vector& drawn,
                            const Formula& base, ParameterIndex by_first,
                            ParameterIndex by_second) const;

  const DrawnParts& parts_;
  const Mechanism& mechanism_;
  OwnValues values_;
  double size_ = 0;
};

}  // namespace assur::mechanism::drawn
