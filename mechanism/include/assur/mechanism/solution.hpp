// Configurations of links, slides and output points, as the results of solving.
#pragma once

#include <assur/mechanism/frame.hpp>
#include <assur/mechanism/structure.hpp>
#include <assur/status.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace assur::mechanism {

struct PlanData;

/// The result of solving at one set of values.
enum class SolutionStatus : unsigned char {
  ok,           ///< there are configurations; there may be families beside them
  no_assembly,  ///< the links cannot reach, as `reason` says: there are no configurations
  degenerate    ///< there are families only: a group moves freely or is inconsistent
};

/// The displacement of a slide, from the first feature to the second, with its rates in time and
/// its derivatives with respect to the parameters.
struct SlideState {
  JointIndex joint;
  double displacement = 0;
  double velocity = 0;
  double acceleration = 0;
  Derivatives<1> follows;
};

/// The angle of a joint that groups place and a driver's law reads, with the whole turns counted
/// along a branch.
struct CountedAngle {
  JointIndex joint;
  double angle;
};

/// The angle of one link relative to another, less the rest angle of a spring, which does not exist
/// for an angle that a load reads. Where a branch begins it is in (-pi, pi]; from there on it goes
/// on with its turns.
struct FollowedAngle {
  LinkIndex one, other;
  NumberIndex rest;
  double angle = 0;
};

/// One assembly configuration of the whole mechanism.
struct Configuration {
  Table<LinkIndex, Frame> links;  ///< of the mechanism's links, in the frame of the ground
  std::vector<SlideState> slides;
  std::vector<CountedAngle> counted;
  std::vector<FollowedAngle> followed;  ///< only in the records of sweeps
  Table<OutputIndex, Point> outputs;
  Status regularity = Status::ok;  ///< ok or near_singular
  /// Whether derivatives with respect to the parameters, and the velocities and accelerations of
  /// all links, are known to two digits. Unknown rates are NaN, and those of other links may be
  /// known; reports leave out unknown derivatives.
  bool derivatives_known = true;
  bool rates_known = true;
  /// Whether derivatives (with a sweep, those with respect to the swept parameter) are known to one
  /// digit, so that the branch can be followed.
  bool path_known = true;
  /// At a crossing, where several motions pass: this configuration once for each motion, with its
  /// rates.
  std::vector<Configuration> branches;
  double residual = 0;  ///< the largest of the closures
  /// Whether the redundant constraints hold, and continue to hold as the mechanism moves.
  bool is_consistent = true;
  /// Whether every joint keeps its limits. Solving omits configurations beyond them. A sweep
  /// follows branches beyond the limits and back, but has no rows there.
  bool within_limits = true;
  /// The determinant of each group's loop Jacobian, without a unit; NaN if it has no inverse. Set
  /// only if the request has a sweep. Along a branch it changes its sign in singular configurations
  /// only.
  Table<GroupIndex, double> determinants;
  Table<GroupIndex, GroupProof> proofs;  ///< set only if the request asks for them

  /// Finds a part by its name. Throws MechanismError for a name that the mechanism does not have.
  [[nodiscard]] const Frame& link(const std::string& name) const;
  [[nodiscard]] const Point& output(const std::string& name) const;

  std::shared_ptr<const PlanData> plan;

 private:
  void expect_solved() const;
};

/// A group that moves freely, or cannot be assembled for lack of independent closures, for one
/// choice of configurations of the groups that hold it.
struct Family {
  GroupIndex group;
  int mobility = 0;    ///< in the position in which it was assembled; zero if it was not
  std::string reason;  ///< the joints that leave it free
  Table<LinkIndex, bool> is_placed;  ///< whether a link is placed
  Table<LinkIndex, Frame> links;     ///< the frames of placed links
};

/// The configuration that comes nearest to the limits of joints, if all are beyond them: the root
/// of the sum of its squared excesses, lengths relative to the mechanism's size, is the least.
struct NearestToLimits {
  /// The excess of a joint beyond its limits, in radians or the unit of length.
  struct Excess {
    JointIndex joint;
    double by;
  };
  Configuration configuration;
  std::vector<Excess> excesses;
};

/// The number of configurations beyond the limits of a joint, and the least excess, in radians or
/// the unit of length.
struct LimitBreach {
  JointIndex joint;
  std::size_t configurations;
  double least;
};

/// Adds a breach to a list, or merges it with the breach of the same joint there.
void add_breach(const LimitBreach& breach, std::vector<LimitBreach>& breaches);
/// The text of excesses: `B by 3.5 deg, S by 0.2`.
[[nodiscard]] std::string excesses_text(const Mechanism& mechanism,
                                        const std::vector<NearestToLimits::Excess>& excesses);
/// The text of breaches: `B by 3.5 deg at least, S by 0.2 at least`.
[[nodiscard]] std::string breaches_text(const Mechanism& mechanism,
                                        const std::vector<LimitBreach>& breaches);

/// Every assembly configuration at one set of values.
struct Solution {
  SolutionStatus status = SolutionStatus::ok;
  int mobility = 0;    ///< of the freest family, if the solution is degenerate
  std::string reason;  ///< why there are no configurations
  /// Why configurations may be missing from the list; empty if none can be.
  std::string incomplete;
  /// The configurations, in an order that depends on the mechanism alone.
  std::vector<Configuration> configurations;
  std::vector<Family> families;
  /// The number of configurations beyond the limits of joints; nothing if there are too many to
  /// count.
  std::optional<std::size_t> left_out = 0;
  /// The number of choices of earlier groups' configurations at which the law of a driver has no
  /// value, and the reason; no link is placed after such a choice.
  std::size_t dropped = 0;
  std::string drop_reason;
  std::vector<LimitBreach> breaches;  ///< by configurations that were left out or are beyond limits
  /// Set by `Plan::nearest_to_limits` only.
  std::optional<NearestToLimits> nearest_to_limits;
};

/// The configuration whose links are closest to the angles of a request's reference. The distance
/// is the root of the sum of the squared differences, in radians.
struct Nearest {
  std::size_t configuration;  ///< its index in the solution
  double distance;
  std::optional<double> runner_up;  ///< the distance of the second nearest; nothing if none
};

}  // namespace assur::mechanism
