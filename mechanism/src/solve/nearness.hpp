// Turns placed links into their distance from where a configuration is sought.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "placement.hpp"

namespace assur::mechanism::solve {

/// Where the links of a mechanism should be: (x / L, y / L, cos theta, sin theta) of every link
/// that was described, with L = `length`.
struct SoughtPoint {
  Eigen::VectorXd at;
  double length = 1;
  double farthest =
      std::numeric_limits<double>::infinity();  ///< configurations beyond do not count
};

/// The distance of a configuration from the place near which one is sought: the angles of a
/// request's reference, or a point. Its square is a sum over links, so that a part of it is known
/// before all links are placed.
class Nearness {
 public:
  /// The placement must outlive it.
  explicit Nearness(const Placement& placement);

  void seek_nothing() { is_sought_ = false; }
  void seek_reference();
  void seek(const SoughtPoint& point);

  [[nodiscard]] bool is_sought() const { return is_sought_; }
  /// The part of the squared distance that belongs to the links which are placed once `groups`
  /// groups are, and not before.
  [[nodiscard]] double square_at(std::size_t groups) const {
    return square_of(angles_[groups], links_[groups]);
  }
  /// The part of it that belongs to the links of one group.
  [[nodiscard]] double square_of(GroupIndex group) const {
    return square_of(own_angles_[group], own_links_[group]);
  }

 private:
  [[nodiscard]] double square_of(const std::vector<ReferenceAngle>& angles,
                                 const std::vector<LinkIndex>& links) const;

  const Placement& placement_;
  bool is_sought_ = false;
  const SoughtPoint* point_ = nullptr;               ///< null where the reference is sought
  std::vector<std::vector<ReferenceAngle>> angles_;  ///< by the groups before them
  std::vector<std::vector<LinkIndex>> links_;        ///< by the groups before them
  Table<GroupIndex, std::vector<ReferenceAngle>> own_angles_;  ///< of the links of each group
  Table<GroupIndex, std::vector<LinkIndex>> own_links_;
};

}  // namespace assur::mechanism::solve
