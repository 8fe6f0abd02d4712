// Turns a group of a mechanism into the normal forms of its links, and these into plain numbers.
#include "group_geometry.hpp"

#include <algorithm>
#include <assur/text/names.hpp>
#include <assur/variables.hpp>
#include <optional>

#include "group_numbers.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::values {

namespace {

const std::vector<int>& joints_of(const GroupModel& model, std::size_t link) {
  return model.group->link_joints[link];
}

/// Which of a link's joints in order a joint is.
std::size_t slot_of(int joint, const std::vector<int>& joints) {
  return static_cast<std::size_t>(std::find(joints.begin(), joints.end(), joint) - joints.begin());
}

/// The joint and the link that play those of the model.
const ElementaryJoint& played_joint(const Structure& structure, const RoleAssignment& roles,
                                    int joint) {
  return structure.linkage.joints[roles.joints[static_cast<std::size_t>(joint)]];
}
LinkIndex played_link(const RoleAssignment& roles, int link) {
  return roles.links[static_cast<std::size_t>(link)];
}

/// Lines closer to parallel than this do not define a frame by where they cross.
constexpr double parallel = 1e-3;

double sine_between(const LinkFeature<Dual>& one, const LinkFeature<Dual>& other) {
  return turned(other.along, reversed(one.along)).sin.value();
}

/// Brings the links of a group into normal form under one assignment of roles.
///
/// A link whose features are lines alone has its origin where the first two cross. Where these are
/// parallel, the origin stands on one of them at will, and the other's offset from it is given to
/// the link that slides there: its line is moved back by as much. The closures do not change.
class NormalForms {
 public:
  NormalForms(const Values& values, const FoundGroup& group, const RoleAssignment& roles)
      : group_(group), structure_(values.plan().structure), roles_(roles) {
    for (std::size_t link = 0; link < roles.links.size(); ++link) {
      std::array<LinkFeature<Dual>, 3> features;
      std::size_t count = 0;
      for (const int joint : joints_of(*group.model, link)) {
        const ElementaryJoint& at = played_joint(structure_, roles_, joint);
        features[count++] = values.feature(at.on(roles.links[link]), at.prismatic);
      }
      features_.push_back(features);
      NormalForm<Dual> form;
      form.shift.fill(values.constant(0.0));
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
    add([&](std::size_t link) { return has_parallel_lines(link) && is_first(link); });
    add([&](std::size_t link) { return has_parallel_lines(link) && !is_first(link); });
    add([&](std::size_t link) { return !has_parallel_lines(link); });
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
  [[nodiscard]] std::vector<NormalForm<Dual>>& forms() { return forms_; }

  /// How well the features that define the frames do so, from zero to one: the sine between the
  /// first two of lines alone, the part of the first two points' distance in the link's size.
  [[nodiscard]] double firmness() const {
    double least = 1;
    for (std::size_t link = 0; link < forms_.size(); ++link) {
      const std::size_t count = joints_of(*group_.model, link).size();
      const auto lines = std::count_if(features_[link].begin(), features_[link].begin() + count,
                                       [](const auto& feature) { return feature.line; });
      if (lines == static_cast<std::ptrdiff_t>(count)) {
        least = std::min(least, std::abs(sine_between(features_[link][0], features_[link][1])));
      } else if (lines == 0 && count == 3) {
        const auto& dimensions = forms_[link].dimensions;
        const double length = dimensions[0].length.value();
        const double other = std::hypot(dimensions[1].length.value(), dimensions[2].length.value());
        least = other > length ? std::min(least, length / other) : least;
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

  [[nodiscard]] bool has_parallel_lines(std::size_t link) const {
    const auto& features = features_[link];
    const std::size_t count = joints_of(*group_.model, link).size();
    return std::all_of(features.begin(), features.begin() + count,
                       [](const auto& feature) { return feature.line; }) &&
           std::abs(sine_between(features[0], features[1])) < parallel;
  }

  bool bring(std::size_t link) {
    const std::vector<int>& joints = joints_of(*group_.model, link);
    const bool brought = has_parallel_lines(link)
                             ? bring_parallel(link)
                             : normal_form(features_[link], static_cast<int>(joints.size()),
                                           forms_[link]) == Status::ok;
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

  bool bring_parallel(std::size_t link) {
    const std::vector<int>& joints = joints_of(*group_.model, link);
    const auto& features = features_[link];
    for (const std::size_t moved : {std::size_t{1}, std::size_t{0}}) {
      const std::optional<std::size_t> neighbour = free_neighbour(link, joints[moved]);
      if (!neighbour) {
        continue;
      }
      const LinkFeature<Dual>& kept = features[1 - moved];
      NormalForm<Dual>& form = forms_[link];
      form.frame = {kept.x, kept.y, features[0].along};
      if (joints.size() == 3 && std::abs(sine_between(kept, features[2])) > parallel) {
        const Dual along = ((features[2].x - kept.x) * features[2].along.sin -
                            (features[2].y - kept.y) * features[2].along.cos) /
                           turned(features[2].along, reversed(kept.along)).sin;
        form.frame.x = kept.x + along * kept.along.cos;
        form.frame.y = kept.y + along * kept.along.sin;
      }
      if (measure_in_frame(features, joints.size(), form) != Status::ok) {
        continue;
      }
      const LinkFeature<Dual>& given = features[moved];
      const Dual offset =
          (given.y - form.frame.y) * given.along.cos - (given.x - form.frame.x) * given.along.sin;
      LinkFeature<Dual>& there = line_at(*neighbour, joints[moved]);
      there.x = there.x + offset * there.along.sin;
      there.y = there.y - offset * there.along.cos;
      return true;
    }
    return false;
  }

  [[nodiscard]] LinkFeature<Dual>& line_at(std::size_t link, int joint) {
    const std::vector<int>& joints = joints_of(*group_.model, link);
    return features_[link][slot_of(joint, joints)];
  }

  const FoundGroup& group_;
  const Structure& structure_;
  const RoleAssignment& roles_;
  std::vector<std::array<LinkFeature<Dual>, 3>> features_;
  std::vector<NormalForm<Dual>> forms_;
  std::vector<bool> is_done_;
  std::string obstacle_;
};

}  // namespace

GroupGeometry group_geometry(const Values& values, GroupIndex index) {
  const FoundGroup& group = values.plan().structure.groups[index];
  GroupGeometry geometry;
  // The first assignment that defines the frames well, or else the one that does so best.
  constexpr double well = 0.05;
  double firmest = -1;
  for (const RoleAssignment& roles : group.assignments) {
    for (const std::size_t first_size : {2U, 3U}) {
      NormalForms normal(values, group, roles);
      if (!normal.run(first_size)) {
        geometry.obstacle = normal.obstacle();
      } else if (normal.firmness() > firmest) {
        firmest = normal.firmness();
        geometry.roles = &roles;
        geometry.flaw = normal.flaw();
        geometry.links = std::move(normal.forms());
      }
      if (firmest > well) {
        return geometry;
      }
    }
  }
  return geometry;
}

models::SmallVector ParameterDerivatives::mixed(Eigen::Index i, Eigen::Index j) const {
  models::SmallVector column(first.rows());
  for (Eigen::Index row = 0; row < column.size(); ++row) {
    column(row) = second[static_cast<std::size_t>(row)](i, j);
  }
  return column;
}

ParameterDerivatives derivatives_of(const std::vector<DimensionValue<Dual>>& quantities,
                                    const Values& values) {
  const auto count = static_cast<Eigen::Index>(values.columns().size());
  ParameterDerivatives result{
      ParameterRows<Eigen::Dynamic>::Zero(static_cast<Eigen::Index>(quantities.size()), count), {}};
  Eigen::Index row = 0;
  for (const DimensionValue<Dual>& value : quantities) {
    const Dual quantity = value.is_angle ? angle_of(value.angle) : value.length;
    if (quantity.derivatives().size() > 0) {
      result.first.row(row) = quantity.derivatives().transpose();
    }
    ++row;
    if (values.second_order()) {
      result.second.push_back(quantity.has_hessian() ? quantity.hessian()
                                                     : Eigen::MatrixXd::Zero(count, count));
    }
  }
  return result;
}

Values::GroupNumbers group_numbers(const Values& values, GroupIndex index) {
  const Structure& structure = values.plan().structure;
  const FoundGroup& group = structure.groups[index];
  const GroupGeometry& geometry = values.group(index);
  Values::GroupNumbers numbers;
  const std::vector<DimensionValue<Dual>> dimensions = geometry.dimensions();
  double* to = numbers.d.data();
  for (const DimensionValue<Dual>& value : dimensions) {
    if (value.is_angle) {
      *to++ = value.angle.cos.value();
      *to++ = value.angle.sin.value();
    } else {
      *to++ = value.length.value();
    }
  }
  numbers.of_d = derivatives_of(dimensions, values);
  for (Eigen::Index dimension = 0; dimension < numbers.of_d.first.rows(); ++dimension) {
    for (Eigen::Index parameter = 0; parameter < numbers.of_d.first.cols(); ++parameter) {
      const double value = numbers.of_d.first(dimension, parameter);
      if (value != 0) {
        numbers.nonzero_of_d.push_back({dimension, parameter, value});
      }
    }
  }
  numbers.links = geometry.roles->links;
  for (const NormalForm<Dual>& link : geometry.links) {
    numbers.own.push_back(Frame::at(inverse(link.frame)));
  }
  const auto played = [&](int joint) -> const ElementaryJoint& {
    return played_joint(structure, *geometry.roles, joint);
  };
  for (std::size_t unknown = 0; unknown < group.model->unknowns.size(); ++unknown) {
    const ModelUnknown& entry = group.model->unknowns[unknown];
    if (!entry.is_angle) {
      const SlideMeasure measure = values.slide_measure(index, entry.owner);
      numbers.slides.push_back(
          {static_cast<int>(unknown), played(entry.owner).joint, measure.sense, measure.shift});
    }
  }
  int joint = 0;
  for (const ModelJoint& wanted : group.model->group->joints) {
    if (wanted.first == base_link) {
      const ElementaryJoint& at = played(joint);
      const LinkIndex inner = played_link(*geometry.roles, wanted.second);
      const LinkIndex base = at.other(inner);
      numbers.held.push_back({base, at.on(base), at.prismatic});
    }
    ++joint;
  }
  return numbers;
}

}  // namespace assur::mechanism::values

namespace assur::mechanism {

std::vector<DimensionValue<Dual>> GroupGeometry::dimensions() const {
  std::vector<DimensionValue<Dual>> values;
  for (const NormalForm<Dual>& link : links) {
    values.insert(values.end(), link.dimensions.begin(),
                  link.dimensions.begin() + link.dimension_count);
  }
  return values;
}

SlideMeasure Values::slide_measure(GroupIndex group, int model_joint) const {
  const FoundGroup& found = plan_->structure.groups[group];
  const GroupGeometry& geometry = groups_[group];
  const ModelJoint& wanted = found.model->group->joints[static_cast<std::size_t>(model_joint)];
  const ElementaryJoint& at = values::played_joint(plan_->structure, *geometry.roles, model_joint);
  const auto shift_on = [&](int link) -> Dual {
    if (link == base_link) {
      return constant(0.0);
    }
    const auto place = static_cast<std::size_t>(link);
    const std::vector<int>& joints = values::joints_of(*found.model, place);
    return geometry.links[place].shift[values::slot_of(model_joint, joints)];
  };
  const bool same_sense = at.second == values::played_link(*geometry.roles, wanted.second);
  return {same_sense ? 1.0 : -1.0, shift_on(wanted.second) - shift_on(wanted.first)};
}

}  // namespace assur::mechanism
