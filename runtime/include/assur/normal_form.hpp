// Turns a link's features, in any local frame, into the link's normal frame and its dimensions.
#pragma once

#include <array>
#include <assur/model.hpp>
#include <assur/status.hpp>
#include <assur/variables.hpp>
#include <cmath>

namespace assur {

/// A joint on a link, in a local frame: a point, or a directed line through the point.
template <typename Scalar>
struct LinkFeature {
  bool line = false;
  Scalar x{};
  Scalar y{};
  Direction<Scalar> along{};  ///< of a line; a unit vector
};

/// A dimension's value before it is put into a model's Dimensions.
template <typename Scalar>
struct DimensionValue {
  bool is_angle = false;
  Scalar length{};
  Direction<Scalar> angle{};
};

/// The normal form of a link of up to three joints: x-axis along its first line, or else from its
/// first point to its second; origin at its first point, or else where its first two lines cross.
template <typename Scalar>
struct NormalForm {
  Pose<Scalar> frame;  ///< the normal frame in the given frame
  /// The dimensions in the order of a model's Dimensions: for each joint, a line's angle and
  /// offset or a point's coordinates, as far as the frame does not fix them.
  std::array<DimensionValue<Scalar>, 3> dimensions;
  int dimension_count = 0;
  /// For each line: from the foot of the perpendicular from the origin to the given point, along
  /// the line. A slide's displacement between the given points is the displacement between the
  /// feet plus the second link's shift minus the first's.
  std::array<Scalar, 3> shift{};
};

/// Brings a link of two or three joints into its normal form. `singular` if the points or lines
/// that define the frame coincide or are parallel; then the group is degenerate or a relabelling is
/// needed.
template <typename Scalar>
[[nodiscard]] Status normal_form(const std::array<LinkFeature<Scalar>, 3>& features, int count,
                                 NormalForm<Scalar>& result) {
  using std::sqrt;
  std::array<const LinkFeature<Scalar>*, 3> points{};
  std::array<const LinkFeature<Scalar>*, 3> lines{};
  std::size_t point_count = 0;
  std::size_t line_count = 0;
  for (std::size_t index = 0; index < static_cast<std::size_t>(count); ++index) {
    const LinkFeature<Scalar>& feature = features[index];
    if (feature.line) {
      lines[line_count++] = &feature;
    } else {
      points[point_count++] = &feature;
    }
  }

  Direction<Scalar> axis;
  Scalar axis_length(0);
  if (line_count > 0) {
    axis = lines[0]->along;
  } else {
    const Scalar dx = points[1]->x - points[0]->x;
    const Scalar dy = points[1]->y - points[0]->y;
    axis_length = sqrt(dx * dx + dy * dy);
    if (!(axis_length > Scalar(0))) {  // the first two points coincide
      return Status::singular;
    }
    axis = {dx / axis_length, dy / axis_length};
  }
  result.frame.direction = axis;
  if (point_count > 0) {
    result.frame.x = points[0]->x;
    result.frame.y = points[0]->y;
  } else {
    const Direction<Scalar> turn = turned(lines[1]->along, reversed(axis));
    if (turn.sin == Scalar(0)) {  // the first two lines are parallel
      return Status::singular;
    }
    const Scalar dx = lines[1]->x - lines[0]->x;
    const Scalar dy = lines[1]->y - lines[0]->y;
    const Scalar along = (dx * lines[1]->along.sin - dy * lines[1]->along.cos) / turn.sin;
    result.frame.x = lines[0]->x + along * axis.cos;
    result.frame.y = lines[0]->y + along * axis.sin;
  }

  result.dimension_count = 0;
  const auto add_length = [&result](const Scalar& value) {
    result.dimensions[static_cast<std::size_t>(result.dimension_count++)] = {false, value, {}};
  };
  for (std::size_t index = 0; index < static_cast<std::size_t>(count); ++index) {
    const LinkFeature<Scalar>& feature = features[index];
    const Scalar dx = feature.x - result.frame.x;
    const Scalar dy = feature.y - result.frame.y;
    if (feature.line) {
      if (&feature != lines[0]) {
        result.dimensions[static_cast<std::size_t>(result.dimension_count++)] = {
            true, Scalar(0), turned(feature.along, reversed(axis))};
      }
      if (point_count > 0 || (&feature != lines[0] && &feature != lines[1])) {
        add_length(dy * feature.along.cos - dx * feature.along.sin);
      }
      result.shift[index] = dx * feature.along.cos + dy * feature.along.sin;
    } else if (&feature != points[0]) {
      if (line_count == 0 && &feature == points[1]) {
        add_length(axis_length);
      } else {
        add_length(dx * axis.cos + dy * axis.sin);
        add_length(dy * axis.cos - dx * axis.sin);
      }
    }
  }
  return Status::ok;
}

namespace detail {

template <typename Scalar>
void take_value(Scalar& member, const DimensionValue<Scalar>& value) {
  member = value.length;
}
template <typename Scalar>
void take_value(Direction<Scalar>& member, const DimensionValue<Scalar>& value) {
  member = value.angle;
}

}  // namespace detail

/// Fills a model's Dimensions from the normal forms of its links, in the order of Model::links.
template <typename Model, typename Scalar>
void fill_dimensions(
    const std::array<NormalForm<Scalar>, static_cast<std::size_t>(Model::link_count)>& links,
    typename Model::template Dimensions<Scalar>& dimensions) {
  std::array<DimensionValue<Scalar>, static_cast<std::size_t>(Model::dimension_count)> values;
  std::size_t filled = 0;
  for (const NormalForm<Scalar>& link : links) {
    for (std::size_t index = 0; index < static_cast<std::size_t>(link.dimension_count); ++index) {
      values[filled++] = link.dimensions[index];
    }
  }
  std::apply(
      [&values](auto&... member) {
        std::size_t index = 0;
        (detail::take_value(member, values[index++]), ...);
      },
      dimensions.members());
}

}  // namespace assur
