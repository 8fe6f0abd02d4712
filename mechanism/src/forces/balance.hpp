// Equilibrium of all links of a mechanism; its columns are unit joint forces and unit efforts of
// drivers.
#pragma once

#include <Eigen/Core>
#include <assur/mechanism/forces.hpp>
#include <assur/mechanism/held_pairs.hpp>
#include <vector>

#include "determined.hpp"
#include "moving_links.hpp"

namespace assur::mechanism::forces {

/// The moment of a force with an arm.
[[nodiscard]] inline double moment_of(const Eigen::Vector2d& arm, const Eigen::Vector2d& force) {
  return arm.x() * force.y() - arm.y() * force.x();
}

/// One unknown of the equilibrium: the reaction that holds a coordinate of a pair of features.
struct HeldCoordinate {
  std::size_t pair;
  int coordinate;      ///< 0 or 1: along the x- or y-axis of the first feature; 2: the angle
  DriverIndex driver;  ///< that prescribes the coordinate; does not exist if a bearing holds it
};

/// The equilibrium of links that depend on a parameter.
struct Equilibrium {
  std::vector<Reaction> units;  ///< of each unknown
  Eigen::MatrixXd matrix;
  Eigen::MatrixXd derivative;  ///< with respect to the parameter
};

/// A x + w = 0: three rows for each moving link, the force and, divided by the size, the moment
/// about the link's pivot; couples among the unknowns are in units of the size. A driver whose law
/// reads joints acts at these, too, by the law's derivatives. The transposed matrix maps the rates
/// of the links to those of the coordinates.
class Balance {
 public:
  /// Both must outlive it.
  Balance(const Values& values, const Configuration& configuration);

  [[nodiscard]] const Eigen::MatrixXd& matrix() const { return here_.matrix; }
  /// The same with columns for further reactions after the others.
  [[nodiscard]] Eigen::MatrixXd matrix_with(const std::vector<Reaction>& further) const;
  /// The unit of each unknown.
  [[nodiscard]] const std::vector<Reaction>& units() const { return here_.units; }
  [[nodiscard]] const std::vector<HeldPair>& pairs() const { return pairs_; }
  [[nodiscard]] const std::vector<HeldCoordinate>& held() const { return held_; }
  [[nodiscard]] const MovingLinks& links() const { return links_; }
  [[nodiscard]] const JointCoordinates& coordinates() const { return links_.coordinates(); }
  [[nodiscard]] double size() const { return size_; }
  /// Directions that A shortens to less than this part of its largest pivot count as null.
  [[nodiscard]] double threshold() const;
  /// The place in the ground's frame about which a link's moment is taken.
  [[nodiscard]] const Table<LinkIndex, Eigen::Vector2d>& pivots() const { return pivots_; }
  /// The first of the three rows of a link; -1 for the ground.
  [[nodiscard]] Eigen::Index row_of(LinkIndex link) const { return row_of_[link]; }
  /// The unit of an unknown: the size for couples.
  [[nodiscard]] double unit_of(int coordinate) const { return coordinate == 2 ? size_ : 1; }
  /// The equilibrium of these links; without laws, drivers act at their own joints alone.
  [[nodiscard]] Equilibrium equilibrium(const MovingLinks& links, bool with_laws) const;
  /// The rows of wrenches on all links, each about the link's pivot.
  [[nodiscard]] Eigen::VectorXd rows_of(const Table<LinkIndex, Wrench>& wrenches) const;
  /// The reason why an unknown is not determined.
  [[nodiscard]] std::string reason() const;

 private:
  void find_pivots();
  /// Adds a reaction, times a factor, to a column of an equilibrium.
  void add(const Reaction& reaction, const MovingNumber& factor, Eigen::Index column,
           Equilibrium& to) const;

  const Values& values_;
  const Mechanism& mechanism_;
  MovingLinks links_;
  std::vector<HeldPair> pairs_;
  std::vector<HeldCoordinate> held_;
  Table<LinkIndex, Eigen::Vector2d> pivots_;
  Table<LinkIndex, Eigen::Index> row_of_;
  Eigen::Index rows_ = 0;
  double size_ = 1;
  Equilibrium here_;
};

}  // namespace assur::mechanism::forces
