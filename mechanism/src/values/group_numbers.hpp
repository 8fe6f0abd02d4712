// Plain numbers of a group, read by its model's kernel.
#pragma once

#include <algorithm>
#include <assur/mechanism/values.hpp>

#include "models/model_kernel.hpp"

namespace assur::mechanism::values {

/// First and second derivatives of some quantities with respect to the parameters.
struct ParameterDerivatives {
  ParameterRows<Eigen::Dynamic> first;  ///< a row per quantity
  std::vector<Eigen::MatrixXd> second;  ///< one per quantity; empty where not carried

  /// The second derivatives of all quantities along parameters i and j.
  [[nodiscard]] models::SmallVector mixed(Eigen::Index i, Eigen::Index j) const;
};

/// A slide of a group as the mechanism measures it.
struct MeasuredSlide {
  int unknown;  ///< of the model
  JointIndex joint;
  double sense;
  Dual shift;
  double shift_rate = 0, shift_second_rate = 0;  ///< with respect to time
};

/// The place where a placed link holds an external joint of the group. If the group is solved
/// relative to a link, that link or one that it carries holds it.
struct HeldJoint {
  LinkIndex base;
  FeatureIndex feature;
  bool prismatic;
  double offset;  ///< of a line: its displacement back across itself (`GroupGeometry`)
};

/// One nonzero derivative of a dimension. Most dimensions depend on one parameter or none.
struct DimensionDerivative {
  Eigen::Index dimension, parameter;
  double value;
};

/// A held axis of a link, and the motion of the link's second point across it.
struct AcrossAxis {
  std::size_t dimension;  ///< index of the point's place along the axis, in the flat dimensions
  std::size_t angle;      ///< index of the link's direction, in the flat unknowns
  Eigen::Index dimension_row, angle_row;  ///< indices of the same two among dimensions and unknowns
  Eigen::VectorXd first;                  ///< derivatives with respect to the parameters
  Eigen::MatrixXd second;                 ///< empty if not carried
  double rate = 0, second_rate = 0;       ///< with respect to time

  [[nodiscard]] bool moves() const { return rate != 0 || second_rate != 0; }
  [[nodiscard]] bool follows_parameters() const {
    return !first.isZero(0) || (second.size() > 0 && !second.isZero(0));
  }
};

}  // namespace assur::mechanism::values

namespace assur::mechanism {

struct Values::GroupNumbers {
  models::FlatVariables d;
  std::vector<bool> is_angle;  ///< of each dimension
  values::ParameterDerivatives of_d;
  std::vector<values::DimensionDerivative> nonzero_of_d;
  models::SmallVector d_rate, d_second_rate;  ///< in time; empty if the shapes are constant
  std::vector<LinkIndex> links;               ///< in the roles of the model's links
  std::vector<Frame> own;                     ///< their own frames, each in its normal frame
  std::vector<values::AcrossAxis> across;
  std::vector<values::MeasuredSlide> slides;
  std::vector<values::HeldJoint> held;
  support::Displacement rounding;  ///< of features on its links, beyond that of their coordinates
  /// How well features that drivers carry define the frames of their links, from zero to one. If
  /// they nearly meet, rounding turns the frame, and its rates even more.
  double firmness = 1;

  /// Whether one of these links holds the group.
  [[nodiscard]] bool is_held_by(const Table<LinkIndex, bool>& links_in_question) const {
    return std::any_of(held.begin(), held.end(), [&](const values::HeldJoint& joint) {
      return bool(links_in_question[joint.base]);
    });
  }
};

}  // namespace assur::mechanism

namespace assur::mechanism::values {

/// Derivatives of lengths, and of angles in radians.
[[nodiscard]] ParameterDerivatives derivatives_of(
    const std::vector<DimensionValue<Dual>>& quantities, const Values& values);

[[nodiscard]] Values::GroupNumbers group_numbers(const Values& values, GroupIndex index);

}  // namespace assur::mechanism::values
