// Turns the links of a mechanism, wherever they are placed, into what all its constraints say of
// them, those included that a plan leaves out.
#pragma once

#include <assur/mechanism/held_pairs.hpp>
#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <limits>
#include <vector>

namespace assur::mechanism::solve {

/// The poses of links.
[[nodiscard]] Table<LinkIndex, Pose<double>> poses_of(const Table<LinkIndex, Frame>& links);

/// The constraints f(q) = 0 of a whole mechanism, body by body: q has three rows for each link but
/// the ground, two for the shift of a joint on it, in parts of the mechanism's size, and its turn
/// about that joint. Of each joint f is where one of its features stands in the frame of the other,
/// lengths in parts of the size.
class AllConstraints {
 public:
  using Links = Table<LinkIndex, Frame>;
  using Poses = Table<LinkIndex, Pose<double>>;

  /// The values must outlive it.
  explicit AllConstraints(const Values& values);

  /// Takes the mechanism's size from where links are.
  void measure(const Poses& links);
  [[nodiscard]] double size() const { return size_; }
  /// How far the mechanism is from the origin, and one more, in parts of the size.
  [[nodiscard]] double reach() const { return reach_; }
  /// How much of the constraints rounding may leave open, in parts of the size.
  [[nodiscard]] double rounding() const {
    return 4 * std::numeric_limits<double>::epsilon() * reach_;
  }

  [[nodiscard]] Eigen::Index unknowns() const { return 3 * std::ssize(moving_); }
  /// The links that q moves, and the first of the three rows of one.
  [[nodiscard]] const std::vector<LinkIndex>& moving() const { return moving_; }
  [[nodiscard]] Eigen::Index column_of(LinkIndex link) const { return column_of_[link]; }
  /// f(q).
  [[nodiscard]] Eigen::VectorXd misses(const Poses& links) const;
  /// The derivative of f to q.
  [[nodiscard]] Eigen::MatrixXd jacobian(const Poses& links) const;
  /// Moves the links by a step of q.
  void move(const Eigen::VectorXd& step, Poses& links) const;
  /// The step of q from some links to others nearby.
  [[nodiscard]] Eigen::VectorXd step(const Poses& from, const Poses& to) const;

  /// f'(t), f''(t), f_a and f_ab with the links' rates and derivatives as they are: a column for
  /// time and one for each parameter; or for time and each pair of parameters, row by row.
  [[nodiscard]] Eigen::MatrixXd first_rates(const Links& links) const;
  [[nodiscard]] Eigen::MatrixXd second_rates(const Links& links) const;
  /// Adds columns for q to the links' rates and derivatives.
  void add_first(const Eigen::MatrixXd& rates, Links& links) const;
  void add_second(const Eigen::MatrixXd& rates, Links& links) const;

  /// Whether links may go on with the velocities that they have: all constraints hold to first
  /// order and, with some accelerations a, to second order, J a + f''(v, v) = 0. What rounding
  /// hides of J is no help.
  [[nodiscard]] bool let_on(Links links) const;

  /// Where links place the slides of some joints, and how these move.
  void set_slides(const Links& links, std::vector<SlideState>& slides) const;

 private:
  [[nodiscard]] Pose<double> placed(FeatureIndex feature, const Poses& links) const;
  [[nodiscard]] Eigen::Vector2d pivot(LinkIndex link, const Poses& links) const;
  /// How fast a link's origin moves, and the link turns, by rates of q.
  [[nodiscard]] Eigen::Vector3d moved(LinkIndex link, const Pose<double>& pose,
                                      const Eigen::VectorXd& rates) const;
  [[nodiscard]] Frame relative(const HeldPair& pair, const Links& links) const;
  /// The second feature of a slide in the frame of the line, which is the first one of a prismatic
  /// joint: its x is the displacement.
  [[nodiscard]] Frame along(JointIndex slide, const Links& links) const;
  [[nodiscard]] double unit(Eigen::Index coordinate) const { return coordinate == 2 ? 1 : size_; }
  /// Calls `visit(row, coordinate, pair)` for each row of f.
  template <typename Visit>
  void for_each_row(const Visit& visit) const;

  const Values& values_;
  const Mechanism& mechanism_;
  std::vector<HeldPair> pairs_;
  Eigen::Index rows_ = 0;
  std::vector<LinkIndex> moving_;
  Table<LinkIndex, Eigen::Index> column_of_;  ///< of each link; -1 of the ground
  Table<LinkIndex, FeatureIndex> pivot_on_;   ///< about which it turns
  double size_ = 1;
  double reach_ = 1;
};

}  // namespace assur::mechanism::solve
