#include "moving_shape.hpp"

#include <algorithm>
#include <cmath>

#include "models/series_functions.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

namespace {

using models::Series;

class ShapeWriter {
 public:
  void add(const DimensionValue<Series>& dimension) {
    if (!dimension.is_angle) {
      shape_.d[place_++] = dimension.length;
      include_length(dimension.length);
      return;
    }
    shape_.d[place_++] = dimension.angle.cos;
    shape_.d[place_++] = dimension.angle.sin;
    include_turn(dimension.angle);
  }
  void add_frame(const LinkForm<Series>& form) {
    shape_.own.push_back(inverse(form.frame));
    include_turn(form.frame.direction);
    std::ranges::for_each(form.shift, [this](const Series& shift) { include_length(shift); });
  }
  void add_across(const Series& across) {
    shape_.across.push_back(across);
    include_length(across);
  }
  [[nodiscard]] MovingShape shape() { return std::move(shape_); }

 private:
  void include_length(const Series& length) {
    ShapeSpeed& speed = shape_.speed;
    speed.along = std::max(speed.along, std::abs(length.rate()));
    speed.along_twice = std::max(speed.along_twice, std::abs(length.second_rate()));
  }
  void include_turn(const Direction<Series>& direction) {
    ShapeSpeed& speed = shape_.speed;
    speed.turn = std::max(speed.turn, std::abs(models::turning_rate(direction)));
    speed.turn_twice = std::max(speed.turn_twice, std::abs(models::second_turning_rate(direction)));
  }

  MovingShape shape_;
  std::size_t place_ = 0;
};

bool is_finite(const Series& number) {
  return std::isfinite(number.c[1]) && std::isfinite(number.c[2]);
}

}  // namespace

bool MovingShape::is_known() const {
  return std::ranges::all_of(d, is_finite) && std::ranges::all_of(across, is_finite) &&
         std::ranges::all_of(own, [](const Pose<Series>& pose) {
           return is_finite(pose.x) && is_finite(pose.y) && is_finite(pose.direction.cos) &&
                  is_finite(pose.direction.sin);
         });
}

std::optional<MovingShape> moving_shape(const Values& values, GroupIndex index,
                                        const MovingFeatures& features) {
  const Structure& structure = values.plan().structure;
  const FoundGroup& group = structure.groups[index];
  const auto feature_of = [&](const ElementaryJoint& at, LinkIndex link) {
    return carried_feature<Series>(structure, at, link, features.own, features.carried);
  };
  const GroupGeometry<Series> geometry = group_geometry(structure, group, feature_of, Series(0));
  if (geometry.roles != values.group(index).roles) {
    return std::nullopt;
  }
  ShapeWriter writer;
  for (const DimensionValue<Series>& dimension : geometry.dimensions()) {
    writer.add(dimension);
  }
  for (const LinkForm<Series>& form : geometry.links) {
    writer.add_frame(form);
  }
  for (const HeldAxis<Series>& held : geometry.held_axes) {
    writer.add_across(held.across);
  }
  return writer.shape();
}

}  // namespace assur::mechanism::solve
