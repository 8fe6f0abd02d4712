// Normal frame and dimensions of a link from its features in any local frame.
#pragma once

#include <array>
#include <assur/detail/index.hpp>
#include <assur/detail/members.hpp>
#include <assur/directions.hpp>
#include <assur/model.hpp>
#include <assur/status.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <cstddef>

namespace assur {

/// A joint on a link, in a local frame: a point, or a directed line through the point.
template <typename Scalar>
struct LinkFeature {
  bool line = false;
  Scalar x{};
  Scalar y{};
  Direction<Scalar> along{};  ///< of a line; a unit vector
};

/// The value of a dimension, before assignment to a model's Dimensions.
template <typename Scalar>
struct DimensionValue {
  bool is_angle = false;
  Scalar length{};
  Direction<Scalar> angle{};

  /// Assigns the value to a variable of a model, a length or an angle.
  void put_into(Scalar& member) const { member = length; }
  void put_into(Direction<Scalar>& member) const { member = angle; }
};

/// The normal form of a link of up to three joints: x-axis along its first line, or else from its
/// first point to its second; origin at its first point, or else where its first two lines cross.
template <typename Scalar>
struct NormalForm {
  Pose<Scalar> frame;  ///< the normal frame in the given frame
  /// The dimensions in the order of a model's Dimensions: for each joint, a line's angle and offset
  /// or a point's coordinates, except those that the frame fixes.
  std::array<DimensionValue<Scalar>, 3> dimensions;
  int dimension_count = 0;
  /// For each line: from the foot of the perpendicular from the origin to the given point, along
  /// the line. A slide's displacement between the given points is the displacement between the
  /// feet plus the second link's shift minus the first's.
  std::array<Scalar, 3> shift{};
};

/// The dimensions and shifts of a link in a given normal frame. The quantities that the frame fixes
/// are left out: the first line's angle and offset or the first point's coordinates and, on a link
/// without lines or without points, the second point's direction or the second line's offset. The
/// status is singular, and nothing is set, unless there are two or three joints.
template <typename Scalar>
[[nodiscard]] Status measure_in_frame(const std::array<LinkFeature<Scalar>, 3>& features,
                                      std::size_t joints, NormalForm<Scalar>& result) {
  if (joints < 2 || joints > 3) {
    return Status::singular;
  }
  const Direction<Scalar>& axis = result.frame.direction;
  std::array<std::size_t, 3> points{joints, joints, joints};
  std::array<std::size_t, 3> lines{joints, joints, joints};
  std::size_t point_count = 0;
  std::size_t line_count = 0;
  for (std::size_t index = 0; index < joints; ++index) {
    (features[index].line ? lines[line_count++] : points[point_count++]) = index;
  }
  result.dimension_count = 0;
  using std::sqrt;
  const auto add = [&result](const DimensionValue<Scalar>& value) {
    detail::entry(result.dimensions, result.dimension_count++) = value;
  };
  const auto add_length = [&add](const Scalar& value) { add({false, value, {}}); };
  for (std::size_t index = 0; index < joints; ++index) {
    const LinkFeature<Scalar>& feature = features[index];
    const Scalar dx = feature.x - result.frame.x;
    const Scalar dy = feature.y - result.frame.y;
    if (feature.line) {
      if (index != lines[0]) {
        add({true, Scalar(0), turned(feature.along, reversed(axis))});
      }
      if (point_count > 0 || (index != lines[0] && index != lines[1])) {
        add_length(dy * feature.along.cos - dx * feature.along.sin);
      }
      result.shift[index] = dx * feature.along.cos + dy * feature.along.sin;
    } else if (index != points[0]) {
      if (line_count == 0 && index == points[1]) {
        add_length(sqrt(dx * dx + dy * dy));
      } else {
        add_length(dx * axis.cos + dy * axis.sin);
        add_length(dy * axis.cos - dx * axis.sin);
      }
    }
  }
  return Status::ok;
}

/// The normal form of a link with `count` joints, two or three; all features, and the normal frame,
/// are given in one frame. Set if the status is ok. singular: the link has only lines, of which the
/// first two are parallel, so that the group is degenerate or must be relabelled; or there are not
/// two or three features. not_finite: a feature is not finite, or the link has only points, and the
/// square of the distance of the first two overflows or underflows.
template <typename Scalar>
[[nodiscard]] Status normal_form(const std::array<LinkFeature<Scalar>, 3>& features, int count,
                                 NormalForm<Scalar>& result) {
  using std::sqrt;
  result.dimension_count = 0;
  if (count < 2 || count > 3) {
    return Status::singular;
  }
  const auto joints = static_cast<std::size_t>(count);
  std::array<const LinkFeature<Scalar>*, 3> points{};
  std::array<const LinkFeature<Scalar>*, 3> lines{};
  std::size_t point_count = 0;
  std::size_t line_count = 0;
  for (std::size_t index = 0; index < joints; ++index) {
    const LinkFeature<Scalar>& feature = features[index];
    if (!detail::is_number(feature.x) || !detail::is_number(feature.y) ||
        !detail::is_number(feature.along.cos) || !detail::is_number(feature.along.sin)) {
      return Status::not_finite;
    }
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
    if (!detail::is_number(axis_length)) {
      return Status::not_finite;
    }
    // If the first two points coincide, any axis will do.
    if (axis_length > Scalar(0)) {
      axis = {dx / axis_length, dy / axis_length};
    } else if (!(dx == Scalar(0) && dy == Scalar(0))) {
      return Status::not_finite;
    }
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

  return measure_in_frame(features, joints, result);
}

/// Fills a model's Dimensions from the normal forms of its links, in the order of Model::links. The
/// dimensions are set if the status is ok. singular: the forms do not have as many dimensions as
/// the model, because a link has no normal form or belongs to another model.
template <typename Model, typename Scalar>
[[nodiscard]] Status fill_dimensions(
    const std::array<NormalForm<Scalar>, detail::size(Model::link_count)>& links,
    typename Model::template Dimensions<Scalar>& dimensions) {
  constexpr std::size_t count = detail::size(Model::dimension_count);
  std::array<DimensionValue<Scalar>, count> values;
  std::size_t filled = 0;
  for (const NormalForm<Scalar>& link : links) {
    for (int index = 0; index < link.dimension_count; ++index) {
      if (filled == count) {
        return Status::singular;
      }
      values[filled++] = detail::entry(link.dimensions, index);
    }
  }
  if (filled != count) {
    return Status::singular;
  }
  for_each_member(dimensions,
                  [&values](auto& member, std::size_t index) { values[index].put_into(member); });
  return Status::ok;
}

}  // namespace assur
