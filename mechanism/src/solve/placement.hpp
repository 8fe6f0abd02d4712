// Placement of links from a choice of one configuration for each group.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "group_solver.hpp"
#include "turn_count.hpp"

namespace assur::mechanism::solve {

/// The links of a mechanism during a depth-first search over its groups: a placed link keeps its
/// frame while the groups behind it are solved, and the next configuration overwrites it.
class Placement {
 public:
  /// The values must outlive the placement, and stay where they are.
  explicit Placement(const Values& values);
  Placement(const Placement&) = delete;
  Placement& operator=(const Placement&) = delete;

  /// Resets the state of the last position. `forgets_unknown_rates`: see `PlacedLinks`.
  void begin(bool forgets_unknown_rates);
  /// Evaluates the laws of drivers that are determined once `groups` groups are placed, and moves
  /// the links that they carry. Returns false where a law has no value; `flaw` then says why.
  [[nodiscard]] bool move_carried_links(std::size_t groups);
  /// Does the same with some links unplaced. A link that an unplaced link carries, or whose law
  /// reads one, becomes unplaced.
  [[nodiscard]] bool move_carried_links(std::size_t groups, Table<LinkIndex, bool>& unplaced);
  [[nodiscard]] const std::string& flaw() const { return flaw_; }
  /// The whole turns of angles that laws read.
  [[nodiscard]] TurnCount& turns() { return turns_; }
  [[nodiscard]] const TurnCount& turns() const { return turns_; }
  /// Whether a group has a normal form and all links that hold or shape it are placed.
  [[nodiscard]] bool can_be_solved(GroupIndex group, const Table<LinkIndex, bool>& unplaced) const;
  /// Reads the frames of the group's neighbours. If the group is solved relative to a link, that
  /// link is put on the axes of the ground, with all that it carries, until it is placed itself.
  void hold(GroupIndex group);
  /// Finds the configurations of a group where it is held. Throws MechanismError after too many.
  [[nodiscard]] const models::GroupAssemblies& assemble(GroupIndex group);
  /// Sets the poses of a group's links in one of these configurations; `place` also sets their
  /// rates.
  void stand(GroupIndex group, std::size_t index);
  /// Places a group in one of the configurations found last. A group solved relative to a link is
  /// placed in that link's frame, and shapes the groups behind it.
  void place(GroupIndex group, std::size_t index);

  [[nodiscard]] const PlanData& plan() const { return *plan_; }
  [[nodiscard]] const std::shared_ptr<const PlanData>& shared_plan() const { return plan_; }
  [[nodiscard]] const Structure& structure() const { return structure_; }
  /// The values, with the laws evaluated that read placed links.
  [[nodiscard]] const Values& values() const { return values_; }
  [[nodiscard]] const GroupSolver& solver(GroupIndex group) const { return solvers_[group]; }
  /// The configuration in which a group was placed last.
  [[nodiscard]] std::size_t choice(GroupIndex group) const { return chosen_[group]; }

  [[nodiscard]] const PlacedLinks& placed() const { return placed_; }
  [[nodiscard]] PlacedLinks& placed() { return placed_; }

 private:
  void place_carried_link(std::size_t place);
  void set_motion(const JointMotion& motion, bool prismatic, double sense);
  void set_slide(const JointMotion& motion, JointIndex joint, SlideState& slide) const;
  [[nodiscard]] bool settle(const ReadingDriver& reading);

  std::shared_ptr<const PlanData> plan_;
  const Structure& structure_;
  const Values& given_;
  std::optional<Values> settled_;  ///< where laws read links, or groups shape others
  const Values& values_;           ///< `settled_` if there is one, else `given_`
  Table<GroupIndex, GroupSolver> solvers_;
  Table<GroupIndex, std::size_t> first_slide_;
  std::vector<std::size_t> driven_slide_;  ///< index of the slide of each driven link that slides
  /// For a group that is solved relative to a link, the carried links that this link carries.
  Table<GroupIndex, std::vector<std::size_t>> carried_by_base_;
  Table<GroupIndex, std::size_t> chosen_;
  PlacedLinks placed_;
  TurnCount turns_;
  Table<LinkIndex, bool> all_placed_;  ///< false for every link
  std::size_t placed_groups_ = 0;
  std::string flaw_;
  std::size_t steps_ = 0;
  Frame joint_, motion_, moved_;  ///< kept for their memory, for links that drivers move
};

}  // namespace assur::mechanism::solve
