// Frames of a group's links in each of its configurations, from its placed neighbours.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <assur/support/displaced_frame.hpp>
#include <cmath>

#include "across_axis.hpp"
#include "models/model_kernel.hpp"
#include "values/group_numbers.hpp"

namespace assur::mechanism::solve {

/// A configuration q of a group; the displacement of its neighbours that rounding may cause, as a
/// fraction of the group's size; and whether its rates and those of all groups before it are known.
struct PlacedGroup {
  models::FlatVariables q;
  double displaced;
  bool rates_known;
};

/// The part of one configuration that has been placed so far.
struct PlacedLinks {
  Table<LinkIndex, Frame> links;                      ///< the mechanism's links, then blocks
  Table<LinkIndex, support::Displacement> displaced;  ///< bounds by rounding
  std::vector<SlideState> slides;
  std::vector<CountedAngle> counted;
  Table<GroupIndex, PlacedGroup> groups;
  Status regularity = Status::ok;
  bool derivatives_known = true;
  bool path_known = true;
  bool rates_known = true;
  /// Whether velocities and accelerations that are not known to two digits are NaN. Sets between
  /// the steps of a sweep keep them, to compare branches.
  bool forgets_unknown_rates = true;
  /// Whether several motions may go through the configuration where its rates are not known.
  bool is_crossing = true;
  double residual = 0;
  Table<GroupIndex, double> determinants;  ///< of the loop Jacobians; set for sweeps only
};

/// Finds the configurations of one group among placed neighbours. It allocates its memory once and
/// uses it for all values of the parameters.
class GroupSolver {
 public:
  /// The values must outlive the solver. The group must have a normal form.
  GroupSolver(const Values& values, GroupIndex group);

  /// Reads the frames of the links that hold the group's external joints from `placed`.
  void hold(const PlacedLinks& placed);
  /// Finds all configurations of the group where it is held.
  [[nodiscard]] const models::GroupAssemblies& assemble();
  /// One of the configurations that were found last.
  [[nodiscard]] const models::FlatVariables& configuration(std::size_t index) const {
    return found_.configurations[index];
  }
  /// The bound on the displacement by rounding of the links that hold the group, when it was placed
  /// last, as a fraction of the group's size.
  [[nodiscard]] double displaced() const { return query_.displaced.moved / motion_.size; }
  /// Whether that displacement has no bound, as where two configurations of an earlier group
  /// coincide.
  [[nodiscard]] bool is_held_loosely() const {
    return !std::isfinite(query_.displaced.moved) || !std::isfinite(query_.displaced.turned);
  }
  /// The least residual of the closures for a held group without a configuration. `result` is set
  /// where the status is `ok`; the other status is `not_finite`.
  [[nodiscard]] Status gap(double& result) const;
  /// Sets the poses alone of the group's links in one of its configurations.
  void stand(std::size_t configuration, Table<LinkIndex, Frame>& links) const;
  /// Places the group's links and slides in one of its configurations; the slides are written to
  /// `placed.slides` from `first_slide` on.
  void place(std::size_t configuration, std::size_t first_slide, PlacedLinks& placed);
  /// The proof that no configuration of the group is missing at its last placement; `links` has its
  /// links.
  [[nodiscard]] GroupProof proof(const Table<LinkIndex, Frame>& links) const;
  /// The determinant of the loop Jacobian at the group's last placement; NaN where it has no
  /// inverse.
  [[nodiscard]] double determinant() const;

  [[nodiscard]] bool has_normal_form() const { return values_.group(group_).roles != nullptr; }

 private:
  [[nodiscard]] const Values::GroupNumbers& numbers() const { return values_.numbers_of(group_); }
  void find_across(const models::FlatVariables& q);
  template <typename ValueOf, typename Add>
  void across(const ValueOf& value_of, const Add& add) const;
  void add_rates_of_links(const models::FlatVariables& q);
  [[nodiscard]] bool is_at_rest() const;
  void scale_rates(double of_first, double of_second);
  void follow();
  void follow_twice(const models::FlatVariables& q);
  void place_links(PlacedLinks& placed);
  void place_slides(const models::FlatVariables& q, std::size_t first_slide,
                    PlacedLinks& placed) const;

  const Values& values_;
  GroupIndex group_;
  const GroupModel& model_;
  models::FlatVariables u_{};
  values::ParameterDerivatives of_u_;  ///< derivatives of the inputs
  models::MotionQuery query_;
  double held_rates_ = 1, held_second_rates_ = 1;  ///< NaN where those of the inputs are not known
  models::GroupAssemblies found_;
  models::GroupMotion motion_;
  std::vector<AcrossColumns> across_;  ///< of each held axis; empty where nothing moves across it
  values::ParameterDerivatives of_q_, of_p_;  ///< of the unknowns, and of the link poses
  Point point_;  ///< of the links that hold the group; kept for its memory
  Frame line_, frame_;
};

}  // namespace assur::mechanism::solve
