// Turns what was solved into configurations of links, slides and output points.
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

enum class SolutionStatus : unsigned char {
  ok,           ///< there are configurations; there may be families beside them
  no_assembly,  ///< the links cannot reach, as `reason` says: there are no configurations
  degenerate    ///< there are families only: a group moves freely or is inconsistent
};

/// The displacement of a slide, from the first feature to the second, and how it moves.
struct SlideState {
  JointIndex joint;
  double displacement = 0;
  double velocity = 0;
  double acceleration = 0;
  Derivatives<1> follows;
};

/// The angle of a joint that a law reads where groups place it, with the whole turns that are
/// counted along a branch.
struct CountedAngle {
  JointIndex joint;
  double angle;
};

/// One assembly configuration of the whole mechanism.
struct Configuration {
  Table<LinkIndex, Frame> links;  ///< of the mechanism's links, in the frame of the ground
  std::vector<SlideState> slides;
  std::vector<CountedAngle> counted;
  Table<OutputIndex, Point> outputs;
  Status regularity = Status::ok;  ///< ok or near_singular
  /// Whether derivatives to the parameters, and velocities and accelerations, are known to two
  /// digits. Reports leave out what is not; accelerations may be NaN where velocities are known.
  bool derivatives_known = true;
  bool rates_known = true;
  /// Whether derivatives, or those to the swept parameter where the request has a sweep, are known
  /// to one digit, so that the branch can be followed.
  bool path_known = true;
  /// At a crossing, which several motions go through: this configuration in each of them, with
  /// rates that are known.
  std::vector<Configuration> branches;
  double residual = 0;  ///< largest of the closures
  /// Whether constraints that are too many hold, and go on to as the mechanism moves.
  bool is_consistent = true;
  /// Whether every joint keeps its limits. Solving leaves out what does not; a sweep, which follows
  /// branches beyond the limits and back, tells no rows there.
  bool within_limits = true;
  /// Of the loop Jacobian of every group, without a unit, NaN where it has no inverse; only where
  /// the request has a sweep. Along a branch it changes its sign in singular configurations alone.
  Table<GroupIndex, double> determinants;

  /// By name; throws MechanismError for a name that the mechanism does not have.
  [[nodiscard]] const Frame& link(const std::string& name) const;
  [[nodiscard]] const Point& output(const std::string& name) const;

  std::shared_ptr<const PlanData> plan;

 private:
  void expect_solved() const;
};

/// A group that moves freely, or cannot be assembled for lack of independent closures, where the
/// groups that hold it stand in one of their configurations.
struct Family {
  GroupIndex group;
  int mobility = 0;                  ///< where it was found assembled, or zero if it was not
  std::string reason;                ///< which joints leave it free
  Table<LinkIndex, bool> is_placed;  ///< whether a link stands
  Table<LinkIndex, Frame> links;     ///< the frames of those that do
};

/// How many configurations are beyond the limits of a joint, and by how much at least: radians, or
/// the unit of length.
struct LimitBreach {
  JointIndex joint;
  std::size_t configurations;
  double least;
};

/// Adds a breach to those of other joints, and of the same.
void add_breach(const LimitBreach& breach, std::vector<LimitBreach>& breaches);
/// `B by 3.5 deg at least, S by 0.2 at least`.
[[nodiscard]] std::string breaches_text(const Mechanism& mechanism,
                                        const std::vector<LimitBreach>& breaches);

/// Every assembly configuration at one set of values.
struct Solution {
  SolutionStatus status = SolutionStatus::ok;
  int mobility = 0;    ///< if it is degenerate: of the freest family
  std::string reason;  ///< why there are no configurations
  /// In an order that depends on the mechanism alone.
  std::vector<Configuration> configurations;
  std::vector<Family> families;
  /// Configurations beyond the limits of joints; nothing where there are too many to be counted.
  std::optional<std::size_t> left_out = 0;
  /// Choices of configurations of earlier groups for which the law of a driver has no value, and
  /// what that says: nothing is placed behind them.
  std::size_t dropped = 0;
  std::string drop_reason;
  std::vector<LimitBreach> breaches;  ///< of limits, by what was left out or is not within them
};

/// The configuration whose links stand closest to the angles of a request's reference: with the
/// least root of the sum of the squares of their differences, in radians.
struct Nearest {
  std::size_t configuration;  ///< its place in the solution
  double distance;
  std::optional<double> runner_up;  ///< the distance of the next one; none if it is the only one
};

}  // namespace assur::mechanism
