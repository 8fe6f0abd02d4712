// Distance of placed links from a target, and the nearest configuration so far.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <limits>
#include <vector>

#include "placement.hpp"
#include "search_options.hpp"

namespace assur::mechanism::solve {

/// The distance of a configuration from the target of a search: the angles of a request's
/// reference, or a point. Its square is a sum over links, so that a part of it is known before all
/// links are placed. Without a target, all distances are zero.
class Nearness {
 public:
  /// The placement must outlive it.
  explicit Nearness(const Placement& placement);

  void seek_nothing();
  void seek_reference();
  void seek(const SoughtPoint& point);
  /// Discards earlier results.
  void begin();

  [[nodiscard]] bool is_sought() const { return is_sought_; }
  /// Adds the links that are placed after exactly `groups` groups. Returns the value to pass to
  /// `leave` before they are placed elsewhere.
  [[nodiscard]] double enter(std::size_t groups);
  void leave(double before) { square_ = before; }
  /// The contribution of one group's links to the squared distance.
  [[nodiscard]] double square_of(GroupIndex group) const {
    return square_of(own_angles_[group], own_links_[group]);
  }
  /// Whether the placed links, with `more` added to their squared distance, may belong to the
  /// nearest configuration or the second nearest.
  [[nodiscard]] bool may_count(double more = 0) const { return square_ + more < next_square_; }
  /// Takes the placed links as a configuration. Returns false where another one is as near.
  [[nodiscard]] bool is_nearest();
  /// The distances of the nearest and second nearest configurations found.
  [[nodiscard]] Nearest found() const;

 private:
  [[nodiscard]] double square_of(const std::vector<ReferenceAngle>& angles,
                                 const std::vector<LinkIndex>& links) const;

  const Placement& placement_;
  bool is_sought_ = false;
  double farthest_square_ = std::numeric_limits<double>::infinity();  ///< the limit of the search
  double square_ = 0;                                                 ///< of the placed links
  double least_square_ = 0, next_square_ = 0;  ///< of the nearest and second nearest configurations
  const SoughtPoint* point_ = nullptr;         ///< null where the reference is sought
  std::vector<std::vector<ReferenceAngle>> angles_;  ///< by the number of groups before them
  std::vector<std::vector<LinkIndex>> links_;        ///< by the number of groups before them
  Table<GroupIndex, std::vector<ReferenceAngle>> own_angles_;  ///< of the links of each group
  Table<GroupIndex, std::vector<LinkIndex>> own_links_;
};

}  // namespace assur::mechanism::solve
