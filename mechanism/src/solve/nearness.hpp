// Turns links that are placed into how far they are from where a configuration is sought.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "placement.hpp"

namespace assur::mechanism::solve {

/// Where the links of a mechanism should be: (x / L, y / L, cos theta, sin theta) of every link of
/// its own, with L a length.
struct SoughtPoint {
  Eigen::VectorXd at;
  double length = 1;
};

/// What configurations are sought near to: the angles of a request's reference, or a point. The
/// square of the distance is a sum over links, so that a part of it is known before all is placed.
class Nearness {
 public:
  /// The placement must outlive it.
  explicit Nearness(const Placement& placement);

  void seek_nothing() { is_sought_ = false; }
  void seek_reference();
  void seek(const SoughtPoint& point);

  [[nodiscard]] bool is_sought() const { return is_sought_; }
  /// Of the links that are placed by a group and not by those before it, where so many groups are.
  [[nodiscard]] double square_at(std::size_t groups) const;

 private:
  const Placement& placement_;
  bool is_sought_ = false;
  const SoughtPoint* point_ = nullptr;               ///< null where the reference is sought
  std::vector<std::vector<ReferenceAngle>> angles_;  ///< by the groups before them
  std::vector<std::vector<LinkIndex>> links_;        ///< likewise
};

}  // namespace assur::mechanism::solve
