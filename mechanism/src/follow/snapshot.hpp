// Turns one value of the swept parameter into every configuration, as points of one space.
#pragma once

#include <assur/mechanism/sweep.hpp>
#include <memory>
#include <vector>

#include "solve/solver.hpp"

namespace assur::mechanism::follow {

/// One configuration as a point: (x / L, y / L, cos theta, sin theta) of every link, with L a
/// length of the mechanism, and the derivative of that with respect to the swept parameter.
struct ConfigurationPoint {
  Eigen::VectorXd at;
  Eigen::VectorXd slope;
};
/// The index of a configuration in its set.
using PointIndex = Index<ConfigurationPoint>;

/// Every configuration at one value of the swept parameter.
struct Snapshot {
  double parameter = 0;
  Spread spread;
  Solution solution;
  /// The roles that the links of every group played: determinants are compared where they agree.
  Table<GroupIndex, const RoleAssignment*> roles;
  Table<PointIndex, ConfigurationPoint> points;  ///< in the order of the solution's configurations
  /// Whether every configuration is known, regular and apart from all others, so that each can be
  /// followed.
  bool separable = true;
  double closest = 0;  ///< the least distance of two points; infinite for fewer than two
  /// Whether something moves freely at this value alone, so that branches have no configuration
  /// here.
  bool has_own_family = false;

  /// Whether infinitely many configurations replace some that can be followed elsewhere.
  [[nodiscard]] bool is_degenerate() const {
    return solution.status == SolutionStatus::degenerate || has_own_family;
  }
  [[nodiscard]] std::size_t count() const { return points.size(); }
  [[nodiscard]] const Configuration& configuration(PointIndex point) const {
    return solution.configurations[point.place()];
  }
};
using SnapshotPointer = std::shared_ptr<const Snapshot>;

/// Sets a configuration's place as a point, with the unit `length`, and its slope: `slope_of(link)`
/// is the derivative of a link's pose (x, y, theta) along the way.
template <typename SlopeOf>
void set_point(const Configuration& configuration, double length, const SlopeOf& slope_of,
               ConfigurationPoint& point) {
  const auto size = 4 * static_cast<Eigen::Index>(configuration.links.size());
  point.at.resize(size);
  point.slope.resize(size);
  Eigen::Index row = 0;
  for (const Frame& link : configuration.links) {
    const Direction<double>& direction = link.pose.direction;
    const Eigen::Vector3d slope = slope_of(link);
    point.at.segment<4>(row) << link.pose.x / length, link.pose.y / length, direction.cos,
        direction.sin;
    point.slope.segment<4>(row) << slope(0) / length, slope(1) / length, -slope(2) * direction.sin,
        slope(2) * direction.cos;
    row += 4;
  }
}
/// The least distance of two points; infinite for fewer than two.
[[nodiscard]] double least_distance(const Table<PointIndex, ConfigurationPoint>& points);
/// Whether every configuration has its derivatives, so that it can be followed.
[[nodiscard]] bool is_regular(const Snapshot& snapshot);

/// Solves a mechanism anywhere within its sweep, with one set of values that it changes.
class SnapshotSolver {
 public:
  /// The plan's request must have a sweep, and the plan must outlive the solver. All parameters but
  /// the swept one are as in `values`.
  SnapshotSolver(const Plan& plan, Values values);

  /// The set at a step of the sweep. Throws MechanismError where it cannot be solved in doubles.
  [[nodiscard]] SnapshotPointer at_step(double parameter);
  /// The set at any value. Where `at_step` would throw, the set is degenerate, with the error as
  /// its reason. Throws MechanismError after too many calls between two steps.
  [[nodiscard]] SnapshotPointer at(double parameter);
  /// The set of one configuration: the one with a number, or for zero the one nearest to the
  /// reference. The set is empty if there is none. Throws as `at_step` does.
  [[nodiscard]] SnapshotPointer one_at(double parameter, std::size_t number);
  /// The set of the one configuration that is nearest to a point, if it is within a distance of it;
  /// all others are at least `closest` away. Throws as `at` does.
  [[nodiscard]] SnapshotPointer near(double parameter, const Eigen::VectorXd& point,
                                     double farthest);
  /// From now on, angles that laws read are counted by whole turns from those of a set. Sets that
  /// `at_step` and `at` solve are counted from the last step, or from nearer sets between.
  void count_from(const SnapshotPointer& set);
  /// While it lives, sets can be followed even if their slopes are known only from all constraints
  /// together, not group by group. That takes longer, and crossings are located less precisely.
  class CloseLook {
   public:
    explicit CloseLook(SnapshotSolver& solver) : solver_(solver) { solver_.closely_ = true; }
    CloseLook(const CloseLook&) = delete;
    CloseLook& operator=(const CloseLook&) = delete;
    ~CloseLook() { solver_.closely_ = false; }

   private:
    SnapshotSolver& solver_;
  };
  [[nodiscard]] bool looks_closely() const { return closely_; }
  /// Resets the count of calls between two steps; `at_step` does so, too.
  void begin_step() { between_steps_ = 0; }
  /// The mechanism's values at a value of the swept parameter. They change with the next call.
  [[nodiscard]] Values& values_at(double parameter);
  /// Whether the law of a driver reads joints, so that it depends on where links are.
  [[nodiscard]] bool do_laws_read_joints() const { return reads_joints_; }
  /// Where a configuration is as a point.
  [[nodiscard]] Eigen::VectorXd place_of(const Configuration& configuration) const;

  [[nodiscard]] const Plan& plan() const { return plan_; }
  [[nodiscard]] const Sweep& sweep() const { return *plan_.request().sweep; }
  [[nodiscard]] double from() const { return from_; }
  [[nodiscard]] double to() const { return to_; }
  /// A length of the mechanism, the unit of the points.
  [[nodiscard]] double length() const { return sought_.length; }
  /// How far the parameter goes while it moves driven links, driven joints, or features on their
  /// links by the mechanism's size. If it moves none, the parameter's own size; zero for an empty
  /// set.
  [[nodiscard]] double way_of_size(const Snapshot& set);

 private:
  using Spares = std::vector<std::unique_ptr<Snapshot>>;

  /// The largest speed at which the parameter moves features on their own links, and at which
  /// drivers move one link on another, in units of the points.
  [[nodiscard]] double speed_on_links(double parameter);
  [[nodiscard]] SnapshotPointer solved(double parameter);
  [[nodiscard]] SnapshotPointer solved_here(double parameter);
  [[nodiscard]] const SnapshotPointer& nearest_counted(double parameter) const;
  void note_counted(const SnapshotPointer& set);
  void count_turns_at(double parameter, double from);
  /// Whether a set has fewer configurations than one beside it, because it has families that the
  /// other lacks, or because several configurations of the mechanism without its redundant
  /// constraints meet in one that all constraints determine.
  [[nodiscard]] bool has_less_than_beside(const Snapshot& set);
  /// A snapshot to be solved at a value, to which `values_` are set.
  [[nodiscard]] std::unique_ptr<Snapshot> begun(double parameter);
  void count_between_steps();
  /// A snapshot to be overwritten: whatever it holds belongs to another value.
  [[nodiscard]] std::unique_ptr<Snapshot> spare() const;
  /// The snapshot with its configurations' points, and with whether these can be told apart.
  [[nodiscard]] std::shared_ptr<Snapshot> completed(std::unique_ptr<Snapshot> snapshot) const;
  /// Marks the configurations of a solution at the present values whose paths are known from all
  /// constraints together.
  void mark_known_paths(Solution& solution) const;
  void find_point(const Configuration& configuration, ConfigurationPoint& point) const;

  const Plan& plan_;
  Values values_;
  solve::MechanismSolver solver_;
  /// Snapshots that nobody holds any more, for their memory. Snapshots may outlive the solver.
  std::shared_ptr<Spares> spares_ = std::make_shared<Spares>();
  Eigen::Index column_;  ///< of the derivatives with respect to the swept parameter
  std::vector<FeatureIndex> moved_features_;  ///< by the swept parameter, on their links
  bool reads_joints_ = false;
  bool reads_angles_ = false;  ///< whether laws read angles, whose turns are counted
  double from_ = 0;
  double to_ = 0;
  solve::SoughtPoint sought_;  ///< its length is that of the mechanism
  /// Sets from whose angles turns are counted: that of the last step, and those between steps on
  /// the way to other sets. There are none where laws read no angles. `solver_` refers to the sets
  /// that it was told to count from, and is told anew before it solves again.
  std::vector<SnapshotPointer> counted_;
  bool is_count_in_doubt_ = false;   ///< in the last set
  bool is_count_ambiguous_ = false;  ///< in the last set, too
  std::size_t families_ = 0;         ///< in the last set, or in one beside it that has fewer
  int between_steps_ = 0;            ///< how many sets were asked for since the last step
  bool closely_ = false;
};

}  // namespace assur::mechanism::follow
