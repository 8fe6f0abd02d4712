// Turns the poses of a mechanism's links into the residuals of all its constraints and their
// derivatives, including the constraints that a plan leaves out.
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
/// the ground: the shift of a joint on it, in parts of the mechanism's size, and the angle by which
/// it turns about that joint. A joint's rows of f are the coordinates of one of its features in the
/// frame of the other, lengths in parts of the size.
class AllConstraints {
 public:
  using Links = Table<LinkIndex, Frame>;
  using Poses = Table<LinkIndex, Pose<double>>;

  /// The values must outlive it.
  explicit AllConstraints(const Values& values);

  /// Sets `size` and `reach` from where the links are.
  void measure(const Poses& links);
  [[nodiscard]] double size() const { return size_; }
  /// One plus the distance of the mechanism from the origin, in parts of the size.
  [[nodiscard]] double reach() const { return reach_; }
  /// The residual of the constraints that rounding may cause, in parts of the size.
  [[nodiscard]] double rounding() const {
    return 4 * std::numeric_limits<double>::epsilon() * reach_;
  }

  [[nodiscard]] Eigen::Index unknowns() const { return 3 * std::ssize(moving_); }
  /// The links that q moves, and the first of the three rows of such a link.
  [[nodiscard]] const std::vector<LinkIndex>& moving() const { return moving_; }
  [[nodiscard]] Eigen::Index column_of(LinkIndex link) const { return column_of_[link]; }
  /// f(q).
  [[nodiscard]] Eigen::VectorXd misses(const Poses& links) const;
  /// The derivative of f with respect to q.
  [[nodiscard]] Eigen::MatrixXd jacobian(const Poses& links) const;
  /// Moves the links by a step of q.
  void move(const Eigen::VectorXd& step, Poses& links) const;
  /// The step of q from some links to others nearby.
  [[nodiscard]] Eigen::VectorXd step(const Poses& from, const Poses& to) const;

  /// The derivatives of f that follow from the links' rates and derivatives as they are. The first
  /// ones, f'(t) and f_a, have a column for time and one for each parameter; the second ones,
  /// f''(t) and f_ab, have one for time and one for each pair of parameters, row by row.
  [[nodiscard]] Eigen::MatrixXd first_rates(const Links& links) const;
  [[nodiscard]] Eigen::MatrixXd second_rates(const Links& links) const;
  /// Adds rates and derivatives of q, in the same columns, to those of the links.
  void add_first(const Eigen::MatrixXd& rates, Links& links) const;
  void add_second(const Eigen::MatrixXd& rates, Links& links) const;

  /// Whether the constraints allow the velocities v of the links: all of them hold to first order
  /// and, with some accelerations a, to second order, J a + f''(v, v) = 0. Directions of J below
  /// its rounding cannot provide a.
  [[nodiscard]] bool let_on(Links links) const;

  /// Sets the displacements, rates and derivatives of slides from those of the links.
  void set_slides(const Links& links, std::vector<SlideState>& slides) const;

 private:
  [[nodiscard]] Pose<double> placed(FeatureIndex feature, const Poses& links) const;
  [[nodiscard]] Eigen::Vector2d pivot(LinkIndex link, const Poses& links) const;
  /// The rates (x, y, theta) of a link's frame that rates of q cause.
  [[nodiscard]] Eigen::Vector3d moved(LinkIndex link, const Pose<double>& pose,
                                      const Eigen::VectorXd& rates) const;
  [[nodiscard]] Frame relative(const HeldPair& pair, const Links& links) const;
  /// The second feature of a slide in the frame of its line; of a prismatic joint the line is the
  /// first feature. The x-coordinate is the displacement.
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
  Table<LinkIndex, Eigen::Index> column_of_;  ///< of each link; -1 for the ground
  Table<LinkIndex, FeatureIndex> pivot_on_;   ///< of each link: the point about which q turns it
  double size_ = 1;
  double reach_ = 1;
};

}  // namespace assur::mechanism::solve
