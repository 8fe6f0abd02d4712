// Turns the choice of a configuration of each group, one group after another, into placed links.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "group_solver.hpp"
#include "nearby_configurations.hpp"

namespace assur::mechanism::solve {

/// The links of a mechanism while its groups are placed depth first: a placed link stays while the
/// groups behind it are solved, and the next configuration overwrites it.
class Placement {
 public:
  /// The values must outlive the placement, and stay where they are.
  explicit Placement(const Values& values);
  Placement(const Placement&) = delete;
  Placement& operator=(const Placement&) = delete;

  /// Resets what solving the last position has left.
  void begin();
  /// Evaluates the laws of drivers, and moves the links that they carry, that are due once `groups`
  /// groups are placed. Links carried by unplaced links, or moved by laws that read them, are
  /// marked as unplaced instead. Returns false where a law has no value; `flaw` then says why.
  [[nodiscard]] bool move_carried_links(std::size_t groups,
                                        Table<LinkIndex, bool>* unplaced = nullptr);
  [[nodiscard]] const std::string& flaw() const { return flaw_; }
  /// From now on, an angle that a law reads is continued from the same angle of the configuration
  /// nearby that leads to this one, so that whole turns are counted. Other angles are in (-pi, pi].
  void count_from(std::vector<NearbyConfigurations> nearby) { nearby_ = std::move(nearby); }
  /// Whether, since `begin`, two configurations nearby with different counts lead equally well to
  /// the same one that is listed here, as where branches meet.
  [[nodiscard]] bool is_count_ambiguous() const { return listed_.is_ambiguous; }
  /// Whether a count is ambiguous, or one of these holds: a continuation leads across a place where
  /// branches seem to meet; a configuration nearby has no continuation, although its branch should
  /// go on; a configuration listed here continues none. That is so where a step crosses a place at
  /// which branches meet, nearly meet, end or begin, or at which a link turns suddenly.
  [[nodiscard]] bool is_count_in_doubt() const;
  /// Notes that what is placed is a configuration of the mechanism.
  void note_listed();
  /// Whether a group has a normal form and all links that hold or shape it are placed, so that its
  /// configurations can be found.
  [[nodiscard]] bool can_be_solved(GroupIndex group, const Table<LinkIndex, bool>& unplaced) const;
  /// Reads where the group's neighbours are. If the group is solved relative to a link, that link
  /// is put on the axes of the ground, with all that it carries, until it is placed itself.
  void hold(GroupIndex group);
  /// Finds the configurations of a group where it is held. Throws MechanismError after too many.
  [[nodiscard]] const models::GroupAssemblies& assemble(GroupIndex group);
  /// Sets the poses of a group's links in one of these configurations; their rates are set only by
  /// `place`.
  void stand(GroupIndex group, std::size_t index);
  /// Places a group in one of the configurations that were found last. If it is solved relative to
  /// a link, it is placed in that link's frame, and shapes the groups behind it.
  void place(GroupIndex group, std::size_t index);

  [[nodiscard]] const PlanData& plan() const { return *plan_; }
  [[nodiscard]] const std::shared_ptr<const PlanData>& shared_plan() const { return plan_; }
  [[nodiscard]] const Structure& structure() const { return structure_; }
  /// The values, with all laws evaluated that read links placed so far.
  [[nodiscard]] const Values& values() const { return values_; }
  [[nodiscard]] const GroupSolver& solver(GroupIndex group) const { return solvers_[group]; }
  /// The index of the configuration in which a group was placed last.
  [[nodiscard]] std::size_t choice(GroupIndex group) const { return chosen_[group]; }

  [[nodiscard]] const PlacedLinks& placed() const { return placed_; }
  [[nodiscard]] PlacedLinks& placed() { return placed_; }

 private:
  void place_carried_link(std::size_t place);
  void set_motion(const JointMotion& motion, bool prismatic, double sense);
  void set_slide(const JointMotion& motion, JointIndex joint, SlideState& slide) const;
  [[nodiscard]] bool settle(const ReadingDriver& reading);
  /// What is doubtful in a count of whole turns.
  struct CountDoubts {
    bool is_ambiguous = false;
    bool leads_across = false;  ///< straight on where branches meet
    bool begins = false;        ///< whether some angle continues none nearby
  };
  /// How the angles that a law reads were counted from configurations nearby.
  struct Counting {
    CountDoubts doubts;
    /// The configurations nearby that may go on here, by their sets and their places in these.
    std::vector<std::pair<std::size_t, std::size_t>> continued = {};
  };
  void note_doubts(const CountDoubts& doubts);
  [[nodiscard]] JointMotion counted_coordinate(JointIndex joint, Counting& counting);
  /// The whole turns of a configuration nearby, with how well it goes on here and whether signs
  /// agree.
  struct Count {
    double error;
    double turns;
    bool has_signs;
  };
  [[nodiscard]] std::optional<double> turns_of(JointIndex joint, double angle, Counting& counting);
  [[nodiscard]] bool has_signs_of(const NearbyConfigurations& nearby,
                                  const Configuration& there) const;
  [[nodiscard]] double error_of_groups(const NearbyConfigurations& nearby,
                                       const Configuration& there) const;

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
  std::vector<NearbyConfigurations> nearby_;
  std::vector<Counting> countings_;              ///< of laws that read links, for what is placed
  CountDoubts listed_;                           ///< of what is listed, or lacks a law's value
  std::vector<std::vector<bool>> is_continued_;  ///< of those nearby, by one listed here
  std::vector<Count> counts_;                    ///< kept for its memory
  std::size_t placed_groups_ = 0;
  std::string flaw_;
  std::size_t steps_ = 0;
  Frame joint_, motion_, moved_;  ///< kept for their memory, for what drivers move
};

}  // namespace assur::mechanism::solve
