// Turns a group of a mechanism into the normal forms of its links, and these into plain numbers.
#include "group_geometry.hpp"

#include <algorithm>
#include <assur/text/names.hpp>
#include <assur/variables.hpp>

#include "group_numbers.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism {

namespace {

const std::vector<int>& joints_of(const GroupModel& model, std::size_t link) {
  return model.group->link_joints[link];
}

/// What stands in the way of the links' normal forms, or nothing.
std::string normal_forms(const Values& values, const FoundGroup& group, const RoleAssignment& roles,
                         std::vector<NormalForm<Dual>>& forms) {
  const Structure& structure = values.plan().structure;
  for (std::size_t link = 0; link < roles.links.size(); ++link) {
    std::array<LinkFeature<Dual>, 3> features;
    std::size_t count = 0;
    std::vector<std::string> names;
    for (const int joint : joints_of(*group.model, link)) {
      const ElementaryJoint& at =
          structure.linkage.joints[roles.joints[static_cast<std::size_t>(joint)]];
      features[count++] = values.feature(at.on(roles.links[link]), at.prismatic);
      names.push_back(at.name);
    }
    NormalForm<Dual> form;
    form.shift.fill(values.constant(0.0));
    if (normal_form(features, static_cast<int>(count), form) != Status::ok) {
      return "link " + structure.linkage.links[roles.links[link]] +
             ": its features at the joints " + text::listed(names) + " coincide or are parallel";
    }
    forms.push_back(form);
  }
  return "";
}

}  // namespace

std::vector<DimensionValue<Dual>> GroupGeometry::dimensions() const {
  std::vector<DimensionValue<Dual>> values;
  for (const NormalForm<Dual>& link : links) {
    values.insert(values.end(), link.dimensions.begin(),
                  link.dimensions.begin() + link.dimension_count);
  }
  return values;
}

GroupGeometry group_geometry(const Values& values, GroupIndex index) {
  const FoundGroup& group = values.plan().structure.groups[index];
  GroupGeometry geometry;
  for (const RoleAssignment& roles : group.assignments) {
    geometry.links.clear();
    geometry.obstacle = normal_forms(values, group, roles, geometry.links);
    if (geometry.obstacle.empty()) {
      geometry.roles = &roles;
      break;
    }
  }
  return geometry;
}

SlideMeasure Values::slide_measure(GroupIndex group, int model_joint) const {
  const FoundGroup& found = plan_->structure.groups[group];
  const GroupGeometry& geometry = groups_[group];
  const auto slot = static_cast<std::size_t>(model_joint);
  const ModelJoint& wanted = found.model->group->joints[slot];
  const ElementaryJoint& at = plan_->structure.linkage.joints[geometry.roles->joints[slot]];
  const auto shift_on = [&](int link) -> Dual {
    if (link == base_link) {
      return constant(0.0);
    }
    const auto place = static_cast<std::size_t>(link);
    const std::vector<int>& joints = joints_of(*found.model, place);
    const auto at_joint = std::find(joints.begin(), joints.end(), model_joint) - joints.begin();
    return geometry.links[place].shift[static_cast<std::size_t>(at_joint)];
  };
  const bool same_sense =
      at.second == geometry.roles->links[static_cast<std::size_t>(wanted.second)];
  return {same_sense ? 1.0 : -1.0, shift_on(wanted.second) - shift_on(wanted.first)};
}

SmallVector ParameterDerivatives::mixed(Eigen::Index i, Eigen::Index j) const {
  SmallVector column(first.rows());
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
    return structure.linkage.joints[geometry.roles->joints[static_cast<std::size_t>(joint)]];
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
      const LinkIndex inner = geometry.roles->links[static_cast<std::size_t>(wanted.second)];
      const LinkIndex base = at.other(inner);
      numbers.held.push_back({base, at.on(base), at.prismatic});
    }
    ++joint;
  }
  return numbers;
}

}  // namespace assur::mechanism
