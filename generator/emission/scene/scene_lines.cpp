#include "emission/scene/scene_lines.hpp"

#include <algorithm>
#include <assur/text/identifiers.hpp>
#include <assur/variables.hpp>

#include "emission/cpp/cpp_text.hpp"

namespace assur::generator::emission::scene {

Eigen::VectorXd ModelledParameters::gradient(const mechanism::Dual& quantity) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(count());
  if (quantity.derivatives().size() > 0) {
    Eigen::Index place = 0;
    for (const Eigen::Index column : columns_) {
      result(place++) = quantity.derivatives()(column);
    }
  }
  return result;
}

std::string SceneLines::point(const std::string& name, const mechanism::Dual& x,
                              const mechanism::Dual& y) {
  const std::string values =
      emission::cpp::round_trip(x.value()) + ", " + emission::cpp::round_trip(y.value());
  if (!varies({x, y})) {
    const bool origin = x.value() == 0 && y.value() == 0;
    return origin ? "LinkPoint{}" : "LinkPoint{" + values + "}";
  }
  std::string point = declared(name);
  add("LinkPoint " + point + ";");
  add(point + ".x = " + emission::cpp::round_trip(x.value()) + ";");
  add(point + ".y = " + emission::cpp::round_trip(y.value()) + ";");
  add_gradients(point, {x, y});
  return point;
}

std::string SceneLines::frame(const std::string& name, const Pose<mechanism::Dual>& pose) {
  const mechanism::Dual angle = angle_of(pose.direction);
  const bool constant = !varies({pose.x, pose.y, angle});
  if (constant && pose.x.value() == 0 && pose.y.value() == 0 && angle.value() == 0) {
    return "";
  }
  std::string frame = declared(name);
  add("LinkFrame " + frame + ";");
  add(frame + ".pose = {" + emission::cpp::round_trip(pose.x.value()) + ", " +
      emission::cpp::round_trip(pose.y.value()) + ", {" +
      emission::cpp::round_trip(pose.direction.cos.value()) + ", " +
      emission::cpp::round_trip(pose.direction.sin.value()) + "}};");
  if (!constant) {
    add_gradients(frame, {pose.x, pose.y, angle});
  }
  return frame;
}

std::string SceneLines::gradient(const std::string& name, const mechanism::Dual& number) {
  if (!varies({number})) {
    return "";
  }
  std::string row = declared(name);
  add("ParameterRow " + row + " = ParameterRow::Zero();");
  add_gradient(row + "(", number);
  return row;
}

std::string SceneLines::declared(const std::string& name) {
  taken_.push_back(text::member_names({name}, taken_).front());
  return taken_.back();
}

void SceneLines::add_gradient(const std::string& target, const mechanism::Dual& quantity) {
  const Eigen::VectorXd gradient = parameters_.gradient(quantity);
  Eigen::Index place = 0;
  for (const std::string& parameter : parameters_.names()) {
    if (gradient(place) != 0) {
      add(target + std::to_string(place) + ") = " + emission::cpp::round_trip(gradient(place)) +
          ";  // " + parameter);
    }
    ++place;
  }
}

void SceneLines::add_gradients(const std::string& target,
                               const std::vector<mechanism::Dual>& rows) {
  for (std::size_t row = 0; row < rows.size(); ++row) {
    add_gradient(target + ".gradient(" + std::to_string(row) + ", ", rows[row]);
  }
}

bool SceneLines::varies(const std::vector<mechanism::Dual>& quantities) const {
  return std::any_of(quantities.begin(), quantities.end(), [&](const mechanism::Dual& quantity) {
    return !parameters_.gradient(quantity).isZero(0.0);
  });
}

std::string nested_frames(const std::vector<std::string>& frames) {
  std::string text;
  for (const std::string& frame : frames) {
    if (!frame.empty()) {
      text = text.empty() ? frame : "support::frame_in(" + text + ", " + frame + ")";
    }
  }
  return text.empty() ? "LinkFrame{}" : text;
}

}  // namespace assur::generator::emission::scene
