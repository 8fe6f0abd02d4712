// Normal forms of a group's links, from their features, in any scalar.
#pragma once

#include <algorithm>
#include <array>
#include <assur/mechanism/dual.hpp>
#include <assur/mechanism/structure.hpp>
#include <assur/normal_form.hpp>
#include <assur/text/names.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace assur::mechanism {

/// A link with points alone, the first two of which coincide or nearly do, so that the line through
/// them has no direction, or one that turns too fast to be differentiated. The x-axis of the link's
/// normal frame is then held at a fixed angle on the link. The second point may move across this
/// axis, for which the model has no dimension.
template <typename Scalar>
struct HeldAxis {
  int link;               ///< of the model
  std::size_t dimension;  ///< of the model: the second point's coordinate along the axis
  Scalar across;          ///< its coordinate across the axis: zero, with derivatives
};

namespace values {

[[nodiscard]] inline const std::vector<int>& joints_of(const GroupModel& model, std::size_t link) {
  return model.group->link_joints[link];
}

/// The place of a joint in the order of a link's joints.
[[nodiscard]] inline std::size_t slot_of(int joint, const std::vector<int>& joints) {
  return static_cast<std::size_t>(std::find(joints.begin(), joints.end(), joint) - joints.begin());
}

/// The mechanism's joint, or link, in the role of the model's.
[[nodiscard]] inline const ElementaryJoint& played_joint(const Structure& structure,
                                                         const RoleAssignment& roles, int joint) {
  return structure.linkage.joints[roles.joints[static_cast<std::size_t>(joint)]];
}
[[nodiscard]] inline LinkIndex played_link(const RoleAssignment& roles, int link) {
  return roles.links[static_cast<std::size_t>(link)];
}

/// Lines closer to parallel than this do not define a frame by their intersection.
inline constexpr double parallel = 1e-3;
inline constexpr double well = 0.05;  ///< above this firmness, frames are well defined

/// If two points are closer than this fraction of their distance from the third, they do not define
/// an axis, which is held instead. With formulas as scalars it is held only if the square of the
/// fraction is negligible, too, since an emitted solver does not follow points across an axis.
template <typename Scalar>
inline constexpr double close = 1e-150;
template <>
inline constexpr double close<Dual> = 1e-3;

/// The sine of the angle from one line to another.
template <typename Scalar>
[[nodiscard]] Scalar sine_between(const LinkFeature<Scalar>& one,
                                  const LinkFeature<Scalar>& other) {
  return turned(other.along, reversed(one.along)).sin;
}

/// Whether two lines are parallel, or may be for other values that a scalar represents.
template <typename Scalar>
[[nodiscard]] bool may_be_parallel(const LinkFeature<Scalar>& one,
                                   const LinkFeature<Scalar>& other) {
  const Scalar sine = sine_between(one, other);
  return std::abs(sine.value()) < parallel || may_change(sine);
}

/// Transforms the links of a group to normal form under one assignment of roles.
///
/// The origin of a link whose features are lines alone is the intersection of the first two. If
/// these may be parallel, the origin is any point on one of them, and the other's offset from it is
/// passed to the link that slides there: that link's line is moved back by the offset. The closures
/// do not change. If all slides of a degenerate model are parallel, the base takes the last
/// offsets.
template <typename Scalar>
class NormalForms {
 public:
  template <typename FeatureOf>
  NormalForms(const Structure& structure, const FoundGroup& group, const RoleAssignment& roles,
              const FeatureOf& feature_of, const Scalar& zero)
      : group_(group), structure_(structure), roles_(roles) {
    for (std::size_t link = 0; link < roles.links.size(); ++link) {
      std::array<LinkFeature<Scalar>, 3> features;
      std::size_t count = 0;
      for (const int joint : joints_of(*group.model, link)) {
        features[count++] = feature_of(played_joint(structure_, roles_, joint), roles.links[link]);
      }
      features_.push_back(features);
      NormalForm<Scalar> form;
      form.shift.fill(zero);
      forms_.push_back(form);
      across_.push_back(std::nullopt);
      is_done_.push_back(false);
    }
  }

  /// Links of parallel lines come first, and among these the ones with `first_size` joints, as each
  /// passes an offset to a later one. Returns false if a link, named in `obstacle`, has no form.
  bool run(std::size_t first_size) {
    std::vector<std::size_t> links;
    const auto add = [&](auto belongs) {
      for (std::size_t link = 0; link < forms_.size(); ++link) {
        if (belongs(link)) {
          links.push_back(link);
        }
      }
    };
    const auto is_first = [&](std::size_t link) {
      return joints_of(*group_.model, link).size() == first_size;
    };
    add([&](std::size_t link) { return may_have_parallel_lines(link) && is_first(link); });
    add([&](std::size_t link) { return may_have_parallel_lines(link) && !is_first(link); });
    add([&](std::size_t link) { return !may_have_parallel_lines(link); });
    return std::all_of(links.begin(), links.end(),
                       [this](std::size_t link) { return bring(link); });
  }

  [[nodiscard]] const std::string& obstacle() const { return obstacle_; }

  /// Names the link that has no length; empty if there is none.
  [[nodiscard]] std::string flaw() const {
    for (std::size_t link = 0; link < forms_.size(); ++link) {
      const std::size_t count = joints_of(*group_.model, link).size();
      const auto& features = features_[link];
      const bool is_a_point =
          std::all_of(features.begin(), features.begin() + count, [&](const auto& feature) {
            return !feature.line && feature.x.value() == features[0].x.value() &&
                   feature.y.value() == features[0].y.value();
          });
      if (is_a_point) {
        return "the features of the link " + structure_.linkage.links[roles_.links[link]] +
               " at the joints " + text::listed(joint_names(link)) + " coincide";
      }
    }
    return "";
  }
  [[nodiscard]] std::vector<NormalForm<Scalar>>& forms() { return forms_; }
  [[nodiscard]] std::vector<HeldAxis<Scalar>> held_axes() const {
    std::vector<HeldAxis<Scalar>> axes;
    std::size_t dimension = 0;
    for (std::size_t link = 0; link < forms_.size(); ++link) {
      if (across_[link]) {
        axes.push_back({static_cast<int>(link), dimension, *across_[link]});
      }
      dimension += static_cast<std::size_t>(forms_[link].dimension_count);
    }
    return axes;
  }
  [[nodiscard]] std::vector<std::pair<int, Scalar>>& held_offsets() { return held_offsets_; }

  /// How well features define the frames, from zero to one: the sine between two lines, or the
  /// distance of two points relative to the link's size, but at most `well` if that may vary. A
  /// held axis counts as one unless `with_held_axes` is set.
  [[nodiscard]] double firmness(bool with_held_axes) const {
    double least = 1;
    for (std::size_t link = 0; link < forms_.size(); ++link) {
      const std::size_t count = joints_of(*group_.model, link).size();
      const auto lines = std::count_if(features_[link].begin(), features_[link].begin() + count,
                                       [](const auto& feature) { return feature.line; });
      if (lines == static_cast<std::ptrdiff_t>(count)) {
        least =
            std::min(least, std::abs(sine_between(features_[link][0], features_[link][1]).value()));
      } else if (lines == 0 && count == 3 && (with_held_axes || !across_[link])) {
        const auto& dimensions = forms_[link].dimensions;
        const double length = dimensions[0].length.value();
        const double other = std::hypot(dimensions[1].length.value(), dimensions[2].length.value());
        least = other > length ? std::min(least, length / other) : least;
        least = may_change(dimensions[0].length) ? std::min(least, well) : least;
      }
    }
    return least;
  }

 private:
  [[nodiscard]] std::vector<std::string> joint_names(std::size_t link) const {
    std::vector<std::string> names;
    for (const int joint : joints_of(*group_.model, link)) {
      names.push_back(played_joint(structure_, roles_, joint).name);
    }
    return names;
  }

  /// Whether a link has lines alone, of which the first two are parallel or may be.
  [[nodiscard]] bool may_have_parallel_lines(std::size_t link) const {
    const auto& features = features_[link];
    const std::size_t count = joints_of(*group_.model, link).size();
    return std::all_of(features.begin(), features.begin() + count,
                       [](const auto& feature) { return feature.line; }) &&
           may_be_parallel(features[0], features[1]);
  }

  bool bring(std::size_t link) {
    const std::vector<int>& joints = joints_of(*group_.model, link);
    const auto& features = features_[link];
    const bool is_apart = !may_have_parallel_lines(link) ||
                          std::abs(sine_between(features[0], features[1]).value()) >= parallel;
    const bool brought =
        (may_have_parallel_lines(link) && bring_parallel(link)) || hold_axis(link) ||
        (is_apart &&
         normal_form(features, static_cast<int>(joints.size()), forms_[link]) == Status::ok);
    is_done_[link] = true;
    if (!brought) {
      obstacle_ = "the lines of the link " + structure_.linkage.links[roles_.links[link]] +
                  " at the joints " + text::listed(joint_names(link)) + " are parallel";
    }
    return brought;
  }

  /// Transforms a link of three points, the first two of which nearly coincide and do not vary, to
  /// a form with an axis at a fixed angle on it. Returns false for any other link.
  bool hold_axis(std::size_t link) {
    const auto& features = features_[link];
    const bool has_three_points =
        joints_of(*group_.model, link).size() == 3 &&
        std::ranges::none_of(features, [](const auto& feature) { return feature.line; });
    const auto apart = [&](std::size_t point) {
      return std::hypot(features[point].x.value() - features[0].x.value(),
                        features[point].y.value() - features[0].y.value());
    };
    const double length = apart(1);
    if (!has_three_points || !(length <= close<Scalar> * apart(2))) {
      return false;
    }
    const Scalar dx = features[1].x - features[0].x;
    const Scalar dy = features[1].y - features[0].y;
    if (may_change(dx) || may_change(dy)) {
      return false;
    }
    NormalForm<Scalar>& form = forms_[link];
    form.frame = {features[0].x, features[0].y, {Scalar(1.0), Scalar(0.0)}};
    Direction<Scalar>& axis = form.frame.direction;
    if (length > 0) {
      axis = {Scalar(dx.value() / length), Scalar(dy.value() / length)};
    }
    if (measure_in_frame(features, 3, form) != Status::ok) {
      return false;
    }
    form.dimensions[0].length = dx * axis.cos + dy * axis.sin;
    across_[link] = dy * axis.cos - dx * axis.sin;
    return true;
  }

  /// The link of the group that slides on another's line at a joint, if it has no form yet.
  [[nodiscard]] std::optional<std::size_t> free_neighbour(std::size_t link, int joint) const {
    const ModelJoint& at = group_.model->group->joints[static_cast<std::size_t>(joint)];
    const int other = at.first == static_cast<int>(link) ? at.second : at.first;
    if (other == base_link || is_done_[static_cast<std::size_t>(other)]) {
      return std::nullopt;
    }
    return static_cast<std::size_t>(other);
  }

  /// Whether the base can take an offset at a joint: it must be an external joint of a degenerate
  /// group, for which no derivatives are computed.
  [[nodiscard]] bool is_held_at(int joint) const {
    const ModelJoint& at = group_.model->group->joints[static_cast<std::size_t>(joint)];
    return !group_.model->rigid && (at.first == base_link || at.second == base_link);
  }

  bool bring_parallel(std::size_t link) {
    const std::vector<int>& joints = joints_of(*group_.model, link);
    const auto& features = features_[link];
    for (const std::size_t moved : {std::size_t{1}, std::size_t{0}}) {
      const std::optional<std::size_t> neighbour = free_neighbour(link, joints[moved]);
      if (!neighbour && !is_held_at(joints[moved])) {
        continue;
      }
      const LinkFeature<Scalar>& kept = features[1 - moved];
      NormalForm<Scalar>& form = forms_[link];
      form.frame = {kept.x, kept.y, features[0].along};
      if (joints.size() == 3 && !may_be_parallel(kept, features[2])) {
        const Scalar along = ((features[2].x - kept.x) * features[2].along.sin -
                              (features[2].y - kept.y) * features[2].along.cos) /
                             turned(features[2].along, reversed(kept.along)).sin;
        form.frame.x = kept.x + along * kept.along.cos;
        form.frame.y = kept.y + along * kept.along.sin;
      }
      if (measure_in_frame(features, joints.size(), form) != Status::ok) {
        continue;
      }
      const LinkFeature<Scalar>& given = features[moved];
      const Scalar offset =
          (given.y - form.frame.y) * given.along.cos - (given.x - form.frame.x) * given.along.sin;
      if (!neighbour) {
        held_offsets_.emplace_back(joints[moved], offset);
        return true;
      }
      LinkFeature<Scalar>& there = line_at(*neighbour, joints[moved]);
      there.x = there.x + offset * there.along.sin;
      there.y = there.y - offset * there.along.cos;
      return true;
    }
    return false;
  }

  [[nodiscard]] LinkFeature<Scalar>& line_at(std::size_t link, int joint) {
    const std::vector<int>& joints = joints_of(*group_.model, link);
    return features_[link][slot_of(joint, joints)];
  }

  const FoundGroup& group_;
  const Structure& structure_;
  const RoleAssignment& roles_;
  std::vector<std::array<LinkFeature<Scalar>, 3>> features_;
  std::vector<NormalForm<Scalar>> forms_;
  std::vector<std::optional<Scalar>> across_;  ///< where an axis is held
  std::vector<bool> is_done_;
  std::vector<std::pair<int, Scalar>> held_offsets_;
  std::string obstacle_;
};

}  // namespace values

}  // namespace assur::mechanism
