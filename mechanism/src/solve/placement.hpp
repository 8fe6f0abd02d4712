// Turns the choice of a configuration of each group, one group after another, into placed links.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <memory>
#include <optional>

#include "group_solver.hpp"

namespace assur::mechanism::solve {

/// For each link how many groups are placed before it is.
[[nodiscard]] Table<LinkIndex, std::size_t> groups_before(const Structure& structure);

/// The links of a mechanism while groups are placed depth first: what is placed stays placed while
/// the groups behind it are solved, and is overwritten by the next configuration.
class Placement {
 public:
  /// The values must outlive the placement, and stay where they are.
  explicit Placement(const Values& values);
  Placement(const Placement&) = delete;
  Placement& operator=(const Placement&) = delete;

  /// Forgets whatever the last position was left in.
  void begin();
  /// Moves what drivers say and move once the groups before one are placed, unless it is against
  /// links that are left unplaced, or by what those say; these are marked as unplaced then.
  /// False where a law has no value there, as `flaw` says.
  [[nodiscard]] bool move_carried_links(std::size_t groups,
                                        Table<LinkIndex, bool>* unplaced = nullptr);
  [[nodiscard]] const std::string& flaw() const { return flaw_; }
  /// Angles that laws read are counted on by whole turns from those of configurations nearby, until
  /// another call; null: they are in (-pi, pi].
  void count_from(const std::vector<Configuration>* nearby) { nearby_ = nearby; }
  /// Whether a group is held, and shaped, by links that are placed, and has configurations to find.
  [[nodiscard]] bool can_be_solved(GroupIndex group, const Table<LinkIndex, bool>& unplaced) const;
  /// Takes over where the group's neighbours are. The link relative to which a group is solved is
  /// put on the axes of the ground, with all that it carries, until it is placed itself.
  void hold(GroupIndex group);
  /// Finds the configurations of a group where it is held. Throws MechanismError after too many.
  [[nodiscard]] const models::GroupAssemblies& assemble(GroupIndex group);
  /// Places a group in one of the configurations that were found last; one that is solved relative
  /// to a link, in that link's frame, as a part of the shapes of the groups behind it.
  void place(GroupIndex group, std::size_t index);

  [[nodiscard]] const PlanData& plan() const { return *plan_; }
  [[nodiscard]] const std::shared_ptr<const PlanData>& shared_plan() const { return plan_; }
  [[nodiscard]] const Structure& structure() const { return structure_; }
  /// With the laws that read links evaluated, wherever these are placed.
  [[nodiscard]] const Values& values() const { return values_; }
  [[nodiscard]] const GroupSolver& solver(GroupIndex group) const { return solvers_[group]; }
  /// Which of its configurations a group was placed in last.
  [[nodiscard]] std::size_t choice(GroupIndex group) const { return chosen_[group]; }

  [[nodiscard]] const PlacedLinks& placed() const { return placed_; }
  [[nodiscard]] PlacedLinks& placed() { return placed_; }

 private:
  void place_carried_link(std::size_t place);
  void set_motion(const JointMotion& motion, bool prismatic, double sense);
  void set_slide(const JointMotion& motion, JointIndex joint, SlideState& slide) const;
  [[nodiscard]] bool settle(const ReadingDriver& reading);
  [[nodiscard]] JointMotion counted_coordinate(JointIndex joint);
  [[nodiscard]] double turns_of(JointIndex joint, double angle) const;

  std::shared_ptr<const PlanData> plan_;
  const Structure& structure_;
  const Values& given_;
  std::optional<Values> settled_;  ///< where laws read links, or groups shape others
  const Values& values_;           ///< one or the other
  Table<GroupIndex, GroupSolver> solvers_;
  Table<GroupIndex, std::size_t> first_slide_;
  std::vector<std::size_t> driven_slide_;  ///< of each driven link that slides
  /// Of a group that is solved relative to a link, the carried links that this one carries.
  Table<GroupIndex, std::vector<std::size_t>> carried_by_base_;
  Table<GroupIndex, std::size_t> chosen_;
  PlacedLinks placed_;
  const std::vector<Configuration>* nearby_ = nullptr;
  std::string flaw_;
  std::size_t steps_ = 0;
  Frame joint_, motion_, moved_;  ///< room for what drivers move
};

}  // namespace assur::mechanism::solve
