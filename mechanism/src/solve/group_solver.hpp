// Turns a group whose neighbours are placed into the frames of its links, one configuration at a
// time.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <assur/support/displaced_frame.hpp>

#include "models/model_kernel.hpp"
#include "values/group_numbers.hpp"

namespace assur::mechanism::solve {

/// A configuration of a group, how far rounding may have moved its neighbours, in parts of the
/// group's size, and whether its rates and those of all groups before it are known.
struct PlacedGroup {
  models::FlatVariables q;
  double displaced;
  bool rates_known;
};

/// What is placed so far of one configuration.
struct PlacedLinks {
  Table<LinkIndex, Frame> links;                      ///< blocks behind the mechanism's links
  Table<LinkIndex, support::Displacement> displaced;  ///< of each, by rounding
  std::vector<SlideState> slides;
  std::vector<CountedAngle> counted;
  Table<GroupIndex, PlacedGroup> groups;
  Status regularity = Status::ok;
  bool derivatives_known = true;
  bool path_known = true;
  bool rates_known = true;
  /// Whether several motions may go through it, where its rates are not known.
  bool is_crossing = true;
  double residual = 0;
  Table<GroupIndex, double> determinants;  ///< filled in for sweeps
};

/// The configurations of one group among placed neighbours, wherever its values are set. What it
/// holds memory for is as large at each of them.
class GroupSolver {
 public:
  /// The values must outlive the solver. It can be used where the group has a normal form.
  GroupSolver(const Values& values, GroupIndex group);

  /// Takes over where `placed` holds the group's external joints.
  void hold(const PlacedLinks& placed);
  /// Finds all configurations of the group where it is held.
  [[nodiscard]] const models::GroupAssemblies& assemble();
  /// One of those that were found last.
  [[nodiscard]] const models::FlatVariables& configuration(std::size_t index) const {
    return found_.configurations[index];
  }
  /// How far rounding may have moved what holds the group where it was placed last, in parts of the
  /// group's size.
  [[nodiscard]] double displaced() const { return query_.displaced.moved / motion_.size; }
  /// By how much the closures fail at least where it is held, if there are no configurations. Set
  /// where the status is ok; not_finite.
  [[nodiscard]] Status gap(double& result) const;
  /// Places the group's links and slides in one of its configurations; its slides stand in
  /// `placed.slides` from `first_slide` on.
  void place(std::size_t configuration, std::size_t first_slide, PlacedLinks& placed);
  /// Of the loop Jacobian where the group was placed last; NaN where it has no inverse.
  [[nodiscard]] double determinant() const;
  /// Of a degenerate model: whether its angles are compatible where it is held.
  [[nodiscard]] bool is_compatible() const;

  [[nodiscard]] bool has_normal_form() const { return values_.group(group_).roles != nullptr; }

 private:
  [[nodiscard]] const Values::GroupNumbers& numbers() const { return values_.numbers_of(group_); }
  void add_rates_of_links(const models::FlatVariables& q);
  void follow();
  void follow_twice(const models::FlatVariables& q);
  void place_links(PlacedLinks& placed);
  void place_slides(const models::FlatVariables& q, std::size_t first_slide,
                    PlacedLinks& placed) const;

  const Values& values_;
  GroupIndex group_;
  const GroupModel& model_;
  models::FlatVariables u_{};
  values::ParameterDerivatives of_u_;  ///< how the inputs follow the parameters
  models::MotionQuery query_;
  models::GroupAssemblies found_;
  models::GroupMotion motion_;
  values::ParameterDerivatives of_q_, of_p_;  ///< how the unknowns and the link poses follow them
  Point point_;                               ///< room for the points that hold the group
  Frame line_, frame_;
};

}  // namespace assur::mechanism::solve
