// Turns placed links into their distance from where a configuration is sought, and into whether
// they may belong to the nearest one.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <limits>
#include <vector>

#include "placement.hpp"
#include "search.hpp"

namespace assur::mechanism::solve {

/// The distance of a configuration from the place near which one is sought: the angles of a
/// request's reference, or a point. Its square is a sum over links, so that a part of it is known
/// before all links are placed. While nothing is sought, all distances are zero.
class Nearness {
 public:
  /// The placement must outlive it.
  explicit Nearness(const Placement& placement);

  void seek_nothing();
  void seek_reference();
  void seek(const SoughtPoint& point);
  /// Forgets what was found.
  void begin();

  [[nodiscard]] bool is_sought() const { return is_sought_; }
  /// Adds the links that are placed once `groups` groups are, and not before. Returns what `leave`
  /// takes before they are placed elsewhere.
  [[nodiscard]] double enter(std::size_t groups);
  void leave(double before) { square_ = before; }
  /// The part of the squared distance that belongs to the links of one group.
  [[nodiscard]] double square_of(GroupIndex group) const {
    return square_of(own_angles_[group], own_links_[group]);
  }
  /// Whether what is placed, with `more` added to its squared distance, may be the nearest
  /// configuration or the next one.
  [[nodiscard]] bool may_count(double more = 0) const { return square_ + more < next_square_; }
  /// Takes what is placed as a configuration. False where another one is as near.
  [[nodiscard]] bool is_nearest();
  /// The distances of the nearest configuration and of the next one, where one was found.
  [[nodiscard]] Nearest found() const;

 private:
  [[nodiscard]] double square_of(const std::vector<ReferenceAngle>& angles,
                                 const std::vector<LinkIndex>& links) const;

  const Placement& placement_;
  bool is_sought_ = false;
  double farthest_square_ = std::numeric_limits<double>::infinity();  ///< within which it is sought
  double square_ = 0;                                                 ///< of what is placed
  double least_square_ = 0, next_square_ = 0;  ///< of the nearest configuration, and the next one
  const SoughtPoint* point_ = nullptr;         ///< null where the reference is sought
  std::vector<std::vector<ReferenceAngle>> angles_;            ///< by the groups before them
  std::vector<std::vector<LinkIndex>> links_;                  ///< by the groups before them
  Table<GroupIndex, std::vector<ReferenceAngle>> own_angles_;  ///< of the links of each group
  Table<GroupIndex, std::vector<LinkIndex>> own_links_;
};

}  // namespace assur::mechanism::solve
