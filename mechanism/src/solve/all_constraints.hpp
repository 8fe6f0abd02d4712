// All constraints of a mechanism, including those that a plan leaves out, with their residuals and
// derivatives.
#pragma once

#include <assur/local/body_constraints.hpp>
#include <assur/mechanism/held_pairs.hpp>
#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <vector>

namespace assur::mechanism::solve {

/// The poses of links.
[[nodiscard]] Table<LinkIndex, Pose<double>> poses_of(const Table<LinkIndex, Frame>& links);

/// All constraints f(q) = 0 of a mechanism, in which every link but the ground moves:
/// BodyConstraints with the mechanism's tables, rates and derivatives.
class AllConstraints {
 public:
  using Links = Table<LinkIndex, Frame>;
  using Poses = Table<LinkIndex, Pose<double>>;

  /// The number of groups placed before the link of an unknown, or before both links of a row.
  struct Blocks {
    std::vector<std::size_t> of_unknowns, of_rows;
  };

  using Body = local::BodyConstraints<Eigen::Dynamic, Eigen::Dynamic,
                                      std::vector<local::HeldFeatures<double>>>;

  /// The values must outlive it.
  explicit AllConstraints(const Values& values);
  /// The constraints of the plan's own mechanism, with some of those that the plan leaves out.
  AllConstraints(const Values& values, const std::vector<RedundantJoint>& left_out);

  /// Reads the present values, and measures size and reach at the links' poses.
  void measure(const Poses& links);
  /// Reads the present values, and keeps size and reach.
  void read() { body_.hold(held()); }
  /// The constraints at the values that were read.
  [[nodiscard]] const Body& body() const { return body_; }
  [[nodiscard]] double size() const { return body_.size(); }
  [[nodiscard]] double reach() const { return body_.reach(); }
  [[nodiscard]] double rounding() const { return body_.rounding(); }
  /// The constraints on the links that are not placed, at the present values, with the placed ones
  /// at rest.
  [[nodiscard]] Body of_loose(const Table<LinkIndex, bool>& is_placed, const Poses& links) const;
  /// The links that constraints do not join to some, directly or through others that are not
  /// placed; placed ones are among them.
  [[nodiscard]] Table<LinkIndex, bool> without_joined(const Table<LinkIndex, bool>& is_placed,
                                                      const std::vector<LinkIndex>& links) const;
  /// The poses of the moving links, in the order of q.
  [[nodiscard]] Body::Poses moving_poses(const Poses& links) const;
  void place(const Body::Poses& moved, Poses& links) const;

  [[nodiscard]] Eigen::Index unknowns() const { return 3 * std::ssize(moving_); }
  /// The joints as pairs of features, in the order of the rows of f.
  [[nodiscard]] const std::vector<HeldPair>& pairs() const { return pairs_; }
  [[nodiscard]] Blocks blocks() const;
  /// The links that q moves, and the first of the three rows of such a link.
  [[nodiscard]] const std::vector<LinkIndex>& moving() const { return moving_; }
  [[nodiscard]] Eigen::Index column_of(LinkIndex link) const { return column_of_[link]; }
  /// The residuals f(q).
  [[nodiscard]] Eigen::VectorXd misses(const Poses& links) const;
  /// The derivative of f with respect to q.
  [[nodiscard]] Eigen::MatrixXd jacobian(const Poses& links) const;
  /// The derivative of f with respect to a parameter that moves drivers alone.
  [[nodiscard]] Eigen::VectorXd along_laws(Eigen::Index parameter) const;
  /// Moves the links by a step of q.
  void move(const Eigen::VectorXd& step, Poses& links) const;
  /// The step of q from some links to others nearby.
  [[nodiscard]] Eigen::VectorXd step(const Poses& from, const Poses& to) const;

  /// The derivatives of f at the links' present rates and derivatives. The first ones, f'(t) and
  /// f_a, have a column for time and one for each parameter; the second ones, f''(t) and f_ab, have
  /// one for time and one for each pair of parameters, row by row.
  [[nodiscard]] Eigen::MatrixXd first_rates(const Links& links) const;
  [[nodiscard]] Eigen::MatrixXd second_rates(const Links& links) const;
  /// The derivatives of q that belong to those of the links with respect to one parameter.
  [[nodiscard]] Eigen::VectorXd unknown_rates(const Links& links, Eigen::Index parameter) const;
  /// Adds rates and derivatives of q, in the same columns, to those of the links.
  void add_first(const Eigen::MatrixXd& rates, Links& links) const;
  void add_second(const Eigen::MatrixXd& rates, Links& links) const;

 private:
  [[nodiscard]] Body::Pairs held() const;
  [[nodiscard]] Frame relative(const HeldPair& pair, const Links& links) const;
  [[nodiscard]] double unit(Eigen::Index coordinate) const { return coordinate == 2 ? 1 : size(); }
  const Values& values_;
  const Mechanism& mechanism_;
  std::vector<HeldPair> pairs_;
  std::vector<LinkIndex> moving_;
  Table<LinkIndex, Eigen::Index> column_of_;  ///< of each link; -1 for the ground
  Body body_;
};

}  // namespace assur::mechanism::solve
