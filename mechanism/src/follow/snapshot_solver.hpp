// Solver for every configuration at one value of a sweep's parameter.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <memory>
#include <vector>

#include "counted_sets.hpp"
#include "snapshot.hpp"
#include "solve/solver.hpp"

namespace assur::mechanism::follow {

/// Solves a mechanism anywhere within its sweep, with one set of values that it overwrites.
class SnapshotSolver {
 public:
  /// The plan's request must have a sweep, and the plan must outlive the solver. All parameters
  /// except the swept one are as in `values`.
  SnapshotSolver(const Plan& plan, Values values);

  /// The set at a step of the sweep. Throws MechanismError where it cannot be solved in doubles.
  [[nodiscard]] SnapshotPointer at_step(double parameter);
  /// The set at any value, without the motions where several meet. Where `at_step` would throw, the
  /// set is degenerate, with the error as its reason. Throws MechanismError after too many calls
  /// between two steps.
  [[nodiscard]] SnapshotPointer at(double parameter);
  /// The set of one configuration: that with a number, or, for the number zero, the one nearest to
  /// the reference. The set is empty if there is none. Throws as `at_step` does.
  [[nodiscard]] SnapshotPointer one_at(double parameter, std::size_t number);
  /// The set of the one configuration nearest to a point, if it is within a distance of it; all
  /// others are at least `closest` away. Throws as `at` does.
  [[nodiscard]] SnapshotPointer near(double parameter, const Eigen::VectorXd& point,
                                     double farthest);
  /// From now on, the whole turns of angles that laws read are counted from those of a set. Sets
  /// that `at_step` and `at` solve are counted from the last step, or from nearer sets in between.
  void count_from(const SnapshotPointer& set) { counted_.count_from(set); }
  /// Resets the count of calls between two steps; `at_step` does so, too.
  void begin_step() { between_steps_ = 0; }
  /// Throws MechanismError if a formula has no value at some step.
  void expect_values_at_steps();
  /// The mechanism's values at a value of the swept parameter. The next call changes them.
  [[nodiscard]] Values& values_at(double parameter);
  /// Whether the law of a driver reads joints, and so depends on the links' poses.
  [[nodiscard]] bool do_laws_read_joints() const { return !read_.empty(); }
  /// A configuration as a point.
  [[nodiscard]] Eigen::VectorXd place_of(const Configuration& configuration) const;

  [[nodiscard]] const Plan& plan() const { return plan_; }
  [[nodiscard]] const Sweep& sweep() const { return *plan_.request().sweep; }
  [[nodiscard]] double from() const { return from_; }
  [[nodiscard]] double to() const { return to_; }
  /// A length of the mechanism, the unit of the points.
  [[nodiscard]] double length() const { return sought_.length; }
  /// The change of the parameter that moves driven links, driven joints, or features on their links
  /// by the mechanism's size. If it moves none of these, the parameter's own size; zero for an
  /// empty set.
  [[nodiscard]] double way_of_size(const Snapshot& set);

 private:
  using Spares = std::vector<std::unique_ptr<Snapshot>>;

  /// The largest speed at which the parameter moves features on their own links, and at which
  /// drivers move one link on another, in units of the points.
  [[nodiscard]] double speed_on_links(double parameter);
  [[nodiscard]] SnapshotPointer solved(double parameter, bool finds_motions);
  [[nodiscard]] SnapshotPointer solved_here(double parameter, bool finds_motions);
  /// Whether a set has fewer configurations than one beside it, because it has families that the
  /// other lacks, or because several configurations of the mechanism without its redundant
  /// constraints meet in one that all constraints determine.
  [[nodiscard]] bool has_less_than_beside(const Snapshot& set);
  /// A snapshot to be solved at a value, which `values_` then hold.
  [[nodiscard]] std::unique_ptr<Snapshot> begun(double parameter);
  void count_between_steps();
  /// A snapshot whose old contents are to be overwritten.
  [[nodiscard]] std::unique_ptr<Snapshot> spare() const;
  /// The snapshot with its configurations' points, and with whether these can be distinguished.
  [[nodiscard]] std::shared_ptr<Snapshot> completed(std::unique_ptr<Snapshot> snapshot) const;
  void find_point(const Configuration& configuration, ConfigurationPoint& point) const;

  const Plan& plan_;
  Values values_;
  solve::MechanismSolver solver_;
  /// Unused snapshots, kept for their memory. Snapshots may outlive the solver.
  std::shared_ptr<Spares> spares_ = std::make_shared<Spares>();
  Eigen::Index column_;  ///< of the derivatives with respect to the swept parameter
  std::vector<FeatureIndex> moved_features_;  ///< by the swept parameter, on their links
  std::vector<JointIndex> read_;              ///< the joints that laws read
  double from_ = 0;
  double to_ = 0;
  solve::SoughtPoint sought_;  ///< its length is that of the mechanism
  /// `solver_` refers to the sets from which it counts, and gets them anew before it solves again.
  CountedSets counted_;
  bool is_count_in_doubt_ = false;   ///< in the last set
  bool is_count_ambiguous_ = false;  ///< in the last set, too
  std::size_t families_ = 0;         ///< in the last set, or in one beside it that has fewer
  int between_steps_ = 0;            ///< the number of sets requested since the last step
};

}  // namespace assur::mechanism::follow
