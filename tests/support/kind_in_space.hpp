// A random assembled group of rigid bodies of a given kind, and the model's variables for it.
#pragma once

#include <assur/normal_form.hpp>
#include <map>
#include <random>
#include <span>
#include <string>

#include "rigid_body.hpp"

namespace assur::test {

/// The part of a KindInSpace that every model shares: its tables are those of the model.
struct KindBodies {
  std::span<const ModelJoint> model_joints;
  std::span<const ModelLink> model_links;
  std::vector<int> role;  ///< of the kind's joints
  RigidBodies bodies;

  KindBodies(std::span<const ModelJoint> joints, std::span<const ModelLink> links,
             std::span<const int> kind_role, const char* kind, unsigned seed)
      : model_joints(joints), model_links(links), role(kind_role.begin(), kind_role.end()) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> length(-1.5, 1.5);
    std::uniform_real_distribution<double> angle(-3.1, 3.1);
    for (std::size_t link = 0; link < model_links.size(); ++link) {
      bodies.poses.push_back({length(engine), length(engine), angle(engine)});
    }
    std::string letters;
    for (const char* at = kind; *at != '\0'; ++at) {
      letters += *at == 'R' || *at == 'P' ? std::string(1, *at) : "";
    }
    for (std::size_t joint = 0; joint < model_joints.size(); ++joint) {
      // The kind has the same graph as the model, so its joints join the links of the same index.
      const ModelJoint& graph = model_joints[joint];
      BodyJoint made;
      made.prismatic = letters[joint] == 'P';
      made.first = graph.first;
      made.second = graph.second;
      const BodyFeature place{length(engine), length(engine), angle(engine)};
      BodyFeature other = place;
      if (made.prismatic) {
        const Real displacement = length(engine);
        other.x += displacement * std::cos(place.angle);
        other.y += displacement * std::sin(place.angle);
      }
      made.on_first =
          made.first < 0 ? place : bodies.poses[static_cast<std::size_t>(made.first)].local(place);
      made.on_second = bodies.poses[static_cast<std::size_t>(made.second)].local(other);
      bodies.joints.push_back(made);
    }
  }

  /// The kind's joint that plays a joint of the model.
  [[nodiscard]] std::size_t player(int model_joint) const {
    std::size_t joint = 0;
    while (role[joint] != model_joint) {
      ++joint;
    }
    return joint;
  }
  /// The kind's link that corresponds to a link of the model: the one with the corresponding
  /// joints.
  [[nodiscard]] int playing_link(int model_link) const {
    const ModelLink& link = model_links[static_cast<std::size_t>(model_link)];
    for (int candidate = 0; candidate < link_count(); ++candidate) {
      bool has_all = true;
      for (const int joint : link.joints) {
        if (joint >= 0) {
          const BodyJoint& played = bodies.joints[player(joint)];
          has_all = has_all && (played.first == candidate || played.second == candidate);
        }
      }
      if (has_all) {
        return candidate;
      }
    }
    return -1;
  }
  [[nodiscard]] const BodyFeature& feature(std::size_t joint, int link) const {
    const BodyJoint& at = bodies.joints[joint];
    return at.first == link ? at.on_first : at.on_second;
  }
  /// The frame of a model's link in the bodies' present poses.
  [[nodiscard]] BodyPose frame(int link, const NormalForm<Real>& form) const {
    const BodyFeature place = bodies.poses[static_cast<std::size_t>(playing_link(link))].world(
        {form.frame.x, form.frame.y, angle_of(form.frame.direction)});
    return {place.x, place.y, place.angle};
  }

  /// Normal forms of the model's links; the status of the first that has none.
  [[nodiscard]] Status normal_forms(std::span<NormalForm<Real>> forms) const {
    for (int link = 0; link < link_count(); ++link) {
      const int body = playing_link(link);
      std::array<LinkFeature<Real>, 3> features;
      int count = 0;
      for (const int joint : model_links[static_cast<std::size_t>(link)].joints) {
        if (joint < 0) {
          continue;
        }
        const BodyFeature& local = feature(player(joint), body);
        features[static_cast<std::size_t>(count++)] = {bodies.joints[player(joint)].prismatic,
                                                       local.x, local.y, direction_of(local.angle)};
      }
      const Status status = normal_form(features, count, forms[static_cast<std::size_t>(link)]);
      if (status != Status::ok) {
        return status;
      }
    }
    return Status::ok;
  }

  /// Displacement between the feet on both links of a model's joint.
  [[nodiscard]] Real foot_displacement(int joint, std::span<const NormalForm<Real>> forms) const {
    const ModelJoint& at = model_joints[static_cast<std::size_t>(joint)];
    const auto shift_on = [&](int link) -> Real {
      if (link == base_link) {
        return 0;
      }
      const auto slot = static_cast<std::size_t>(link);
      std::size_t place = 0;
      while (model_links[slot].joints[place] != joint) {
        ++place;
      }
      return forms[slot].shift[place];
    };
    // A relabelling may exchange the two links of a joint, and with them the slide's sense.
    const BodyJoint& played = bodies.joints[player(joint)];
    const Real sense = played.second == playing_link(at.second) ? 1 : -1;
    return sense * bodies.displacement(played) - shift_on(at.second) + shift_on(at.first);
  }

  /// The base's features in the order of a model's inputs.
  [[nodiscard]] std::vector<DimensionValue<Real>> input_values() const {
    std::vector<DimensionValue<Real>> values;
    for (int joint = 0; joint < static_cast<int>(model_joints.size()); ++joint) {
      if (model_joints[static_cast<std::size_t>(joint)].first != base_link) {
        continue;
      }
      const BodyJoint& at = bodies.joints[player(joint)];
      values.push_back({false, at.on_first.x, {}});
      values.push_back({false, at.on_first.y, {}});
      if (at.prismatic) {
        values.push_back({true, 0, direction_of(at.on_first.angle)});
      }
    }
    return values;
  }

  /// The present configuration of the bodies, in the order of a model's unknowns.
  [[nodiscard]] std::vector<DimensionValue<Real>> unknown_values(
      std::span<const ModelUnknown> unknowns, std::span<const NormalForm<Real>> forms) const {
    std::vector<DimensionValue<Real>> values;
    for (const ModelUnknown& unknown : unknowns) {
      if (unknown.is_angle) {
        const NormalForm<Real>& form = forms[static_cast<std::size_t>(unknown.owner)];
        values.push_back({true, 0, direction_of(frame(unknown.owner, form).theta)});
      } else {
        values.push_back({false, foot_displacement(unknown.owner, forms), {}});
      }
    }
    return values;
  }

 private:
  [[nodiscard]] int link_count() const { return static_cast<int>(model_links.size()); }
};

/// A random group of one kind, assembled, in the labels of the kind, with arbitrary frames of
/// links.
template <typename Model>
struct KindInSpace : KindBodies {
  using Roles = KindRoles<Model::joint_count>;
  static constexpr auto link_count = static_cast<std::size_t>(Model::link_count);
  static constexpr auto joint_count = static_cast<std::size_t>(Model::joint_count);

  KindInSpace(const Roles& roles, unsigned seed)
      : KindBodies(Model::joints, Model::links, roles.role, roles.kind, seed) {}

  /// The base's features as a model's inputs.
  [[nodiscard]] typename Model::template Inputs<Real> inputs() const {
    return made_of<typename Model::template Inputs<Real>>(input_values());
  }
  /// Where the bodies stand, as a model's unknowns.
  [[nodiscard]] typename Model::template Configuration<Real> configuration(
      const std::array<NormalForm<Real>, link_count>& forms) const {
    return made_of<typename Model::template Configuration<Real>>(
        unknown_values(Model::unknowns, forms));
  }

 private:
  template <typename Variables>
  static Variables made_of(const std::vector<DimensionValue<Real>>& values) {
    Variables result;
    for_each_member(result,
                    [&](auto& member, std::size_t index) { values[index].put_into(member); });
    return result;
  }
};

}  // namespace assur::test
