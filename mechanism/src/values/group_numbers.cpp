#include "group_numbers.hpp"

#include "plan/plan_data.hpp"

namespace assur::mechanism::values {

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

namespace {

/// The derivatives of points across held axes with respect to the parameters.
std::vector<AcrossAxis> across_axes(const Values& values, const FoundGroup& group,
                                    const GroupGeometry<Dual>& geometry,
                                    const std::vector<bool>& is_angle) {
  std::vector<AcrossAxis> axes;
  for (const HeldAxis<Dual>& held : geometry.held_axes) {
    AcrossAxis axis;
    axis.dimension_row = static_cast<Eigen::Index>(held.dimension);
    axis.dimension =
        held.dimension + static_cast<std::size_t>(std::count(
                             is_angle.begin(), is_angle.begin() + axis.dimension_row, true));
    axis.angle = 0;
    axis.angle_row = 0;
    for (const ModelUnknown& unknown : group.model->unknowns) {
      if (unknown.is_angle && unknown.owner == held.link) {
        break;
      }
      axis.angle += unknown.is_angle ? 2 : 1;
      ++axis.angle_row;
    }
    const auto count = static_cast<Eigen::Index>(values.columns().size());
    axis.first = held.across.derivatives().size() > 0 ? held.across.derivatives()
                                                      : Eigen::VectorXd::Zero(count);
    if (values.second_order()) {
      axis.second =
          held.across.has_hessian() ? held.across.hessian() : Eigen::MatrixXd::Zero(count, count);
    }
    axes.push_back(std::move(axis));
  }
  return axes;
}

}  // namespace

Values::GroupNumbers group_numbers(const Values& values, GroupIndex index) {
  const Structure& structure = values.plan().structure;
  const FoundGroup& group = structure.groups[index];
  const GroupGeometry<Dual>& geometry = values.group(index);
  Values::GroupNumbers numbers;
  const std::vector<DimensionValue<Dual>> dimensions = geometry.dimensions();
  double* to = numbers.d.data();
  for (const DimensionValue<Dual>& value : dimensions) {
    numbers.is_angle.push_back(value.is_angle);
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
  numbers.across = across_axes(values, group, geometry, numbers.is_angle);
  numbers.links = geometry.roles->links;
  for (const LinkForm<Dual>& link : geometry.links) {
    numbers.own.push_back(Frame::at(inverse(link.frame)));
  }
  const auto played = [&](int joint) -> const ElementaryJoint& {
    return played_joint(structure, *geometry.roles, joint);
  };
  for (std::size_t unknown = 0; unknown < group.model->unknowns.size(); ++unknown) {
    const ModelUnknown& entry = group.model->unknowns[unknown];
    if (!entry.is_angle) {
      const SlideMeasure<Dual> measure = values.slide_measure(index, entry.owner);
      numbers.slides.push_back({static_cast<int>(unknown), played(entry.owner).joint, measure.sense,
                                measure.shift, 0, 0});
    }
  }
  int joint = 0;
  for (const ModelJoint& wanted : group.model->group->joints) {
    const ElementaryJoint& at = played(joint);
    const LinkIndex inner = played_link(*geometry.roles, wanted.second);
    numbers.rounding = numbers.rounding.worst_of(values.rounding(at, inner));
    if (wanted.first == base_link) {
      const LinkIndex base = at.other(inner);
      numbers.held.push_back(
          {at.holder(base), at.on(base), at.prismatic, geometry.offset_of(joint)});
    } else {
      const LinkIndex other = at.other(inner);
      numbers.rounding = numbers.rounding.worst_of(values.rounding(at, other));
    }
    if (at.first != at.holder_first || at.second != at.holder_second) {
      numbers.firmness = geometry.firmness;
    }
    ++joint;
  }
  return numbers;
}

}  // namespace assur::mechanism::values
