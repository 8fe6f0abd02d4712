// Turns a group of a mechanism into the normal forms of its links, in any scalar.
#pragma once

#include <algorithm>
#include <array>
#include <assur/mechanism/link_features.hpp>
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

/// The links of a group in normal form, under the first assignment of roles that has one.
template <typename Scalar>
struct GroupGeometry {
  const RoleAssignment* roles = nullptr;  ///< null where no assignment has a normal form
  std::string obstacle;                   ///< then: which link has none, and why
  std::string flaw;                       ///< which link has no length, if one has none
  std::vector<NormalForm<Scalar>> links;  ///< of each link of the model
  double firmness = 0;  ///< how well the links' features define their frames, from zero to one
  /// Of some external slides of a degenerate model: by how much the line that holds one is to be
  /// moved back across itself.
  std::vector<std::pair<int, Scalar>> held_offsets;

  /// By how much that of an external joint of the model is.
  [[nodiscard]] double offset_of(int joint) const {
    for (const auto& [own, offset] : held_offsets) {
      if (own == joint) {
        return offset.value();
      }
    }
    return 0;
  }

  /// The dimensions of the model, in its order.
  [[nodiscard]] std::vector<DimensionValue<Scalar>> dimensions() const {
    std::vector<DimensionValue<Scalar>> values;
    for (const NormalForm<Scalar>& link : links) {
      values.insert(values.end(), link.dimensions.begin(),
                    link.dimensions.begin() + link.dimension_count);
    }
    return values;
  }
};

/// How a mechanism measures a slide of a group: sense * (displacement + shift).
template <typename Scalar>
struct SlideMeasure {
  double sense;
  Scalar shift;
};

namespace values {

[[nodiscard]] inline const std::vector<int>& joints_of(const GroupModel& model, std::size_t link) {
  return model.group->link_joints[link];
}

/// The place of a joint in the order of a link's joints.
[[nodiscard]] inline std::size_t slot_of(int joint, const std::vector<int>& joints) {
  return static_cast<std::size_t>(std::find(joints.begin(), joints.end(), joint) - joints.begin());
}

/// The joint, and the link, that play those of the model.
[[nodiscard]] inline const ElementaryJoint& played_joint(const Structure& structure,
                                                         const RoleAssignment& roles, int joint) {
  return structure.linkage.joints[roles.joints[static_cast<std::size_t>(joint)]];
}
[[nodiscard]] inline LinkIndex played_link(const RoleAssignment& roles, int link) {
  return roles.links[static_cast<std::size_t>(link)];
}

/// Lines closer to parallel than this do not define a frame by where they cross.
inline constexpr double parallel = 1e-3;
inline constexpr double well = 0.05;  ///< above this firmness, frames are well defined

/// The sine of the angle from one line to another.
template <typename Scalar>
[[nodiscard]] Scalar sine_between(const LinkFeature<Scalar>& one,
                                  const LinkFeature<Scalar>& other) {
  return turned(other.along, reversed(one.along)).sin;
}

/// Whether two lines are parallel, or a scalar that stands for other values too may make them so.
template <typename Scalar>
[[nodiscard]] bool may_be_parallel(const LinkFeature<Scalar>& one,
                                   const LinkFeature<Scalar>& other) {
  const Scalar sine = sine_between(one, other);
  return std::abs(sine.value()) < parallel || may_change(sine);
}

/// Brings the links of a group into normal form under one assignment of roles.
///
/// A link whose features are lines alone has its origin where the first two cross. Where these may
/// be parallel, the origin is anywhere on one of them, and the other's offset from it is given to
/// the link that slides there: its line is moved back by as much. The closures do not change. Where
/// all slides of a degenerate model are parallel, what holds the group takes the last offsets.
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
      is_done_.push_back(false);
    }
  }

  /// Links of parallel lines come first, and of these the ones with so many joints, as each gives
  /// an offset to one that comes later. False if a link has no form: then `obstacle` says which.
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

  /// Which link has no length, if one has none.
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
        return "link " + structure_.linkage.links[roles_.links[link]] +
               ": its features at the joints " + text::listed(joint_names(link)) + " coincide";
      }
    }
    return "";
  }
  [[nodiscard]] std::vector<NormalForm<Scalar>>& forms() { return forms_; }
  [[nodiscard]] std::vector<std::pair<int, Scalar>>& held_offsets() { return held_offsets_; }

  /// How well features define the frames, from zero to one: the sine between two lines, or the
  /// distance of two points in parts of the link's size; not well if that may vary.
  [[nodiscard]] double firmness() const {
    double least = 1;
    for (std::size_t link = 0; link < forms_.size(); ++link) {
      const std::size_t count = joints_of(*group_.model, link).size();
      const auto lines = std::count_if(features_[link].begin(), features_[link].begin() + count,
                                       [](const auto& feature) { return feature.line; });
      if (lines == static_cast<std::ptrdiff_t>(count)) {
        least =
            std::min(least, std::abs(sine_between(features_[link][0], features_[link][1]).value()));
      } else if (lines == 0 && count == 3) {
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
    const bool brought = (may_have_parallel_lines(link) && bring_parallel(link)) ||
                         (is_apart && normal_form(features, static_cast<int>(joints.size()),
                                                  forms_[link]) == Status::ok);
    is_done_[link] = true;
    if (!brought) {
      obstacle_ = "link " + structure_.linkage.links[roles_.links[link]] +
                  ": its lines at the joints " + text::listed(joint_names(link)) + " are parallel";
    }
    return brought;
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

  /// Nothing follows the neighbours of a degenerate group, so that these can take an offset.
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
  std::vector<bool> is_done_;
  std::vector<std::pair<int, Scalar>> held_offsets_;
  std::string obstacle_;
};

}  // namespace values

/// The group in normal form under the first assignment of roles that defines its links' frames
/// well, or else the best. `feature_of(joint, link)` is a joint's feature in the frame of a link
/// (`carried_feature`), `zero` depends on nothing. The value of a number is `value()`.
template <typename Scalar, typename FeatureOf>
[[nodiscard]] GroupGeometry<Scalar> group_geometry(const Structure& structure,
                                                   const FoundGroup& group,
                                                   const FeatureOf& feature_of,
                                                   const Scalar& zero) {
  GroupGeometry<Scalar> geometry;
  double& firmest = geometry.firmness;
  firmest = -1;
  for (const RoleAssignment& roles : group.assignments) {
    for (const std::size_t first_size : {2U, 3U}) {
      values::NormalForms<Scalar> normal(structure, group, roles, feature_of, zero);
      if (!normal.run(first_size)) {
        geometry.obstacle = normal.obstacle();
      } else if (normal.firmness() > firmest) {
        firmest = normal.firmness();
        geometry.roles = &roles;
        geometry.flaw = normal.flaw();
        geometry.links = std::move(normal.forms());
        geometry.held_offsets = std::move(normal.held_offsets());
      }
      if (firmest > values::well) {
        return geometry;
      }
    }
  }
  return geometry;
}

/// How the slide at a joint of the model is measured.
template <typename Scalar>
[[nodiscard]] SlideMeasure<Scalar> slide_measure(const Structure& structure,
                                                 const FoundGroup& group,
                                                 const GroupGeometry<Scalar>& geometry,
                                                 int model_joint, const Scalar& zero) {
  const ModelJoint& wanted = group.model->group->joints[static_cast<std::size_t>(model_joint)];
  const ElementaryJoint& at = values::played_joint(structure, *geometry.roles, model_joint);
  const auto shift_on = [&](int link) -> Scalar {
    if (link == base_link) {
      return zero;
    }
    const auto place = static_cast<std::size_t>(link);
    const std::vector<int>& joints = values::joints_of(*group.model, place);
    return geometry.links[place].shift[values::slot_of(model_joint, joints)];
  };
  const bool same_sense = at.second == values::played_link(*geometry.roles, wanted.second);
  return {same_sense ? 1.0 : -1.0, shift_on(wanted.second) - shift_on(wanted.first)};
}

}  // namespace assur::mechanism
