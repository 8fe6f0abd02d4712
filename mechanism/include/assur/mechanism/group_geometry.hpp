// Links of a group in the frames in which its model measures them, in any scalar.
#pragma once

#include <algorithm>
#include <assur/mechanism/carried_features.hpp>
#include <assur/mechanism/normal_forms.hpp>
#include <assur/mechanism/structure.hpp>
#include <assur/normal_form.hpp>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace assur::mechanism {

/// The frame of a link in its group's model, the dimensions in this frame, and for each joint the
/// offset of the origin of the model's displacement (`NormalForm`).
template <typename Scalar>
struct LinkForm {
  Pose<Scalar> frame;
  std::vector<DimensionValue<Scalar>> dimensions;
  std::vector<Scalar> shift;
};

/// The links of a group in the frames of its model, under the first assignment of roles that has
/// such frames.
template <typename Scalar>
struct GroupGeometry {
  const RoleAssignment* roles = nullptr;  ///< null where no assignment has a normal form
  std::string obstacle;                   ///< if null: the link without one, and why
  std::string flaw;                       ///< the link without length, if there is one
  std::vector<LinkForm<Scalar>> links;    ///< of each link of the model
  std::vector<HeldAxis<Scalar>> held_axes;
  /// How well the features define the links' frames, from zero to one. A held axis counts as one.
  double firmness = 0;
  /// Some external slides of a degenerate model, each with the length by which the base's line must
  /// be moved back across itself.
  std::vector<std::pair<int, Scalar>> held_offsets;

  /// That length for an external joint of the model; zero if it has none.
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
    for (const LinkForm<Scalar>& link : links) {
      values.insert(values.end(), link.dimensions.begin(), link.dimensions.end());
    }
    return values;
  }
};

/// The mechanism's measure of a slide of a group: sense * (displacement + shift).
template <typename Scalar>
struct SlideMeasure {
  double sense;
  Scalar shift;
};

namespace values {

template <typename Scalar>
[[nodiscard]] LinkForm<Scalar> link_form(const NormalForm<Scalar>& normal) {
  return {normal.frame,
          {normal.dimensions.begin(), normal.dimensions.begin() + normal.dimension_count},
          {normal.shift.begin(), normal.shift.end()}};
}

/// The form of a link with any number of joints, whose axes keep their directions: the origin is
/// its first point, or a point of its first line if it has no point. The model has the coordinates
/// of each other point, and of each line the angle and, unless the origin is on it, the offset.
template <typename Scalar>
[[nodiscard]] LinkForm<Scalar> link_form(const std::vector<LinkFeature<Scalar>>& features,
                                         const Scalar& zero) {
  const auto point = std::ranges::find(features, false, &LinkFeature<Scalar>::line);
  const LinkFeature<Scalar>& origin = point != features.end() ? *point : features.front();
  LinkForm<Scalar> form{{origin.x, origin.y, {Scalar(1.0), Scalar(0.0)}}, {}, {}};
  for (const LinkFeature<Scalar>& feature : features) {
    const Scalar dx = feature.x - origin.x;
    const Scalar dy = feature.y - origin.y;
    const bool is_origin = &feature == &origin;
    if (feature.line) {
      form.dimensions.push_back({true, zero, feature.along});
    }
    if (!is_origin && feature.line) {
      form.dimensions.push_back({false, dy * feature.along.cos - dx * feature.along.sin, {}});
    } else if (!is_origin) {
      form.dimensions.push_back({false, dx, {}});
      form.dimensions.push_back({false, dy, {}});
    }
    form.shift.push_back(
        feature.line && !is_origin ? dx * feature.along.cos + dy * feature.along.sin : zero);
  }
  return form;
}

}  // namespace values

/// The group in normal form under the first assignment of roles that defines its links' frames
/// well, or else the best one; a derived model needs no such choice. `feature_of(joint, link)` is a
/// joint's feature in the frame of a link (`carried_feature`); `zero` depends on no parameter. A
/// `Scalar` gives its plain value by `value()`.
template <typename Scalar, typename FeatureOf>
[[nodiscard]] GroupGeometry<Scalar> group_geometry(const Structure& structure,
                                                   const FoundGroup& group,
                                                   const FeatureOf& feature_of,
                                                   const Scalar& zero) {
  GroupGeometry<Scalar> geometry;
  if (group.model->is_derived()) {
    geometry.roles = &group.assignments.front();
    geometry.firmness = 1;
    for (std::size_t link = 0; link < geometry.roles->links.size(); ++link) {
      std::vector<LinkFeature<Scalar>> features;
      for (const int joint : values::joints_of(*group.model, link)) {
        features.push_back(feature_of(values::played_joint(structure, *geometry.roles, joint),
                                      geometry.roles->links[link]));
      }
      geometry.links.push_back(values::link_form(features, zero));
    }
    return geometry;
  }
  double firmest = -1;
  for (const RoleAssignment& roles : group.assignments) {
    for (const std::size_t first_size : {2U, 3U}) {
      values::NormalForms<Scalar> normal(structure, group, roles, feature_of, zero);
      if (!normal.run(first_size)) {
        geometry.obstacle = normal.obstacle();
      } else if (const double firmness = normal.firmness(true); firmness > firmest) {
        firmest = firmness;
        geometry.firmness = normal.firmness(false);
        geometry.held_axes = normal.held_axes();
        geometry.roles = &roles;
        geometry.flaw = normal.flaw();
        geometry.links.clear();
        for (const NormalForm<Scalar>& form : normal.forms()) {
          geometry.links.push_back(values::link_form(form));
        }
        geometry.held_offsets = std::move(normal.held_offsets());
      }
      if (firmest > values::well) {
        return geometry;
      }
    }
  }
  return geometry;
}

/// The measure of the slide at a joint of the model.
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
