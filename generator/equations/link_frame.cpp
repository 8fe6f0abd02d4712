#include "equations/link_frame.hpp"

#include <algorithm>
#include <string>

#include "error.hpp"

namespace assur::generator::equations {

const Feature& LinkFrame::feature_of(structure::JointIndex joint) const {
  const auto found = std::find_if(features.begin(), features.end(),
                                  [joint](const Feature& f) { return f.joint == joint; });
  if (found == features.end()) {
    throw GeneratorError("equations", "link frame", "the link has no such joint");
  }
  return *found;
}

namespace {

/// The frame of a link that keeps the axes of the scene, as in the library's `LinkForm`.
LinkFrame free_frame(const structure::Model& model, structure::LinkIndex link,
                     const DeclareDimension& new_dimension) {
  const structure::Group& group = *model.group;
  const std::string& word = group.links()[link];
  const std::vector<structure::JointIndex> joints = group.joints_of(link);
  const auto point = std::ranges::find_if(
      joints, [&](structure::JointIndex joint) { return !model.slides(joint); });
  const structure::JointIndex origin = point != joints.end() ? *point : joints.front();
  LinkFrame frame;
  frame.description = std::string("origin ") +
                      (point != joints.end() ? "at " : "on the slide at ") +
                      group.joints()[origin].name + ", x-axis that of the scene";
  for (const structure::JointIndex joint : joints) {
    const std::string name(1, group.joints()[joint].name);
    const auto dimension = [&](const std::string& letter, Variable::Quantity quantity,
                               const std::string& meaning) -> const Variable& {
      return new_dimension(letter + "_" + name + "_" + word, quantity,
                           meaning + name + " on link " + word);
    };
    Vector2 place{0, 0};
    AngleSum direction;
    if (model.slides(joint)) {
      direction = AngleSum(dimension("psi", Variable::Quantity::angle, "angle of the slide at "));
      if (joint != origin) {
        const GiNaC::ex offset =
            dimension("h", Variable::Quantity::length, "offset, to the left, of the slide at ")
                .value;
        const Vector2 along = direction.direction();
        place = {-offset * along.y, offset * along.x};
      }
    } else if (joint != origin) {
      const GiNaC::ex x = dimension("x", Variable::Quantity::length, "x-coordinate of ").value;
      place = {x, dimension("y", Variable::Quantity::length, "y-coordinate of ").value};
    }
    frame.features.push_back({joint, model.slides(joint), place, direction});
  }
  return frame;
}

LinkFrame normal_frame(const structure::Model& model, structure::LinkIndex link,
                       const DeclareDimension& new_dimension) {
  const structure::Group& group = *model.group;
  using Joints = std::vector<structure::JointIndex>;
  const std::string& word = group.links()[link];
  const Joints joints = group.joints_of(link);
  const auto is_line = [&](structure::JointIndex joint) {
    return model.representative[joint] == structure::JointType::prismatic;
  };
  Joints points;
  Joints lines;
  for (const structure::JointIndex joint : joints) {
    (is_line(joint) ? lines : points).push_back(joint);
  }
  const auto is_one_of_first_two = [](const Joints& list, structure::JointIndex joint) {
    return std::find(list.begin(), list.end(), joint) - list.begin() < 2;
  };
  const auto name_of = [&](structure::JointIndex joint) {
    return std::string(1, group.joints()[joint].name);
  };
  const std::string on_link = "_" + word;

  LinkFrame frame;
  frame.description = (points.empty() ? "origin where the slides at " + name_of(lines[0]) +
                                            " and " + name_of(lines[1]) + " cross"
                                      : "origin at " + name_of(points[0])) +
                      (lines.empty() ? ", x-axis toward " + name_of(points[1])
                                     : ", x-axis along the slide at " + name_of(lines[0]));
  for (const structure::JointIndex joint : joints) {
    const std::string name = name_of(joint);
    if (is_line(joint)) {
      AngleSum direction;
      if (joint != lines.front()) {
        direction = AngleSum(new_dimension(
            "psi_" + name + on_link, Variable::Quantity::angle,
            "angle of the slide at " + name + " on link " + word + " from the x-axis"));
      }
      const bool through_origin = points.empty() && is_one_of_first_two(lines, joint);
      Vector2 foot{0, 0};
      if (!through_origin) {
        const Variable& offset = new_dimension(
            "h_" + name + on_link, Variable::Quantity::length,
            "offset of the slide at " + name + " on link " + word + ", positive to the left");
        const Vector2 along = direction.direction();
        foot = {-offset.value * along.y, offset.value * along.x};
      }
      frame.features.push_back({joint, true, foot, direction});
      continue;
    }
    Vector2 point{0, 0};
    if (joint != points.front()) {
      const bool on_axis = lines.empty() && is_one_of_first_two(points, joint);
      if (on_axis) {
        const std::string origin = name_of(points.front());
        point = {new_dimension(origin + name, Variable::Quantity::length,
                               "distance from " + origin + " to " + name + " on link " + word)
                     .value,
                 0};
      } else {
        const Variable& x = new_dimension("x_" + name + on_link, Variable::Quantity::length,
                                          "x-coordinate of " + name + " on link " + word);
        const Variable& y = new_dimension("y_" + name + on_link, Variable::Quantity::length,
                                          "y-coordinate of " + name + " on link " + word);
        point = {x.value, y.value};
      }
    }
    frame.features.push_back({joint, false, point, AngleSum()});
  }
  return frame;
}

}  // namespace

LinkFrame link_frame(const structure::Model& model, structure::LinkIndex link,
                     const DeclareDimension& new_dimension) {
  return model.is_numbered() ? normal_frame(model, link, new_dimension)
                             : free_frame(model, link, new_dimension);
}

}  // namespace assur::generator::equations
