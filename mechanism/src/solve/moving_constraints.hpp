// All constraints of a mechanism as power series, along a motion of its drivers and of the features
// of its links.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "all_constraints.hpp"
#include "models/series.hpp"

namespace assur::mechanism::solve {

/// The constraints F(q, t) = 0 (see AllConstraints), where laws may read joints. q is zero at the
/// configuration. A motion is q(t) = parts.col(0) + parts.col(1) t + ... + parts.col(4) t^4. The
/// unit of t is chosen so that drivers and features move by about the mechanism's size or one
/// radian.
class MovingConstraints {
 public:
  using Parts = Eigen::MatrixXd;
  using Links = Table<LinkIndex, Pose<models::Series>>;
  static constexpr auto highest_order = static_cast<Eigen::Index>(models::Series::order);

  /// The constraints of the plan's own mechanism, with some of those that the plan leaves out, at a
  /// configuration, as functions of time. `motions` holds the displacement of each driver; drivers
  /// whose laws read joints of moving links are left out, since they follow these joints. The
  /// values and the configuration must outlive the object.
  MovingConstraints(const Values& values, const std::vector<RedundantJoint>& left_out,
                    const Configuration& configuration,
                    const Table<DriverIndex, models::Series>& motions);

  [[nodiscard]] Eigen::Index rows() const { return std::ssize(rows_); }
  [[nodiscard]] Eigen::Index unknowns() const { return constraints_.unknowns(); }
  /// The change of F that rounding of places and features causes.
  [[nodiscard]] double rounding() const { return constraints_.rounding(); }

  /// The coefficient of F at an order of t, for a motion with these parts.
  [[nodiscard]] Eigen::VectorXd coefficient(Eigen::Index order, const Parts& parts) const;
  /// F'(q), the derivative with respect to q.
  [[nodiscard]] Eigen::MatrixXd jacobian(const Eigen::VectorXd& q) const;
  /// F''(q)(., v).
  [[nodiscard]] Eigen::MatrixXd bends(const Eigen::VectorXd& q, const Eigen::VectorXd& v) const;
  /// A constant motion at a place.
  [[nodiscard]] Parts at_rest(const Eigen::VectorXd& q) const;

  /// The links, slides without drivers and outputs along a motion, in the original unit of time.
  [[nodiscard]] Links links(const Parts& parts) const;
  [[nodiscard]] models::Series coordinate(JointIndex joint, const Links& links) const;
  [[nodiscard]] Pose<models::Series> placed(FeatureIndex feature, const Links& links) const;

  [[nodiscard]] const AllConstraints::Blocks& blocks() const { return blocks_; }

 private:
  struct Row {
    std::size_t pair;
    int coordinate;
  };

  void add_rows();
  void choose_unit_of_time();
  [[nodiscard]] Pose<models::Series> moved(std::size_t place, const Parts& parts) const;
  [[nodiscard]] double coefficient(const Row& row, Eigen::Index order, const Links& links) const;
  [[nodiscard]] models::Series law(DriverIndex driver, const Links& links) const;

  const Values& values_;
  const Mechanism& mechanism_;
  const Configuration& configuration_;
  AllConstraints constraints_;
  Table<DriverIndex, std::optional<models::Series>> laws_;  ///< of those that read no moving joint
  Table<FeatureIndex, Pose<models::Series>> features_;      ///< as they move on their links
  AllConstraints::Poses poses_;
  std::vector<Row> rows_;
  std::vector<std::vector<Eigen::Index>> rows_of_;  ///< that change with a link that moves
  std::vector<Eigen::Index> reading_;  ///< rows of drivers whose laws read moving joints
  AllConstraints::Blocks blocks_;
  double unit_ = 1;  ///< of t
};

}  // namespace assur::mechanism::solve
