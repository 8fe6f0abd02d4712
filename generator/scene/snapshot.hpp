// Turns a scene and one value of its swept parameter into every configuration, as points of one
// space.
#pragma once

#include <memory>
#include <vector>

#include "scene/solve.hpp"

namespace assur::generator {

/// One configuration as a point: (x / L, y / L, cos theta, sin theta) of every link, with L a
/// length of the mechanism, and the derivative of that with respect to the swept parameter.
struct ConfigurationPoint {
  Eigen::VectorXd at;
  Eigen::VectorXd slope;
};

/// Every configuration at one value of the swept parameter.
struct Snapshot {
  double parameter;
  ParameterValues values;
  Solution solution;
  std::vector<ConfigurationPoint> points;  ///< in the order of the solution's configurations
  /// Every configuration is known, regular and apart from all others, so that each can be followed.
  bool separable = true;

  [[nodiscard]] std::size_t count() const { return points.size(); }
};
using SnapshotPointer = std::shared_ptr<const Snapshot>;

/// Solves a scene anywhere within its sweep.
class SnapshotSolver {
 public:
  /// `scene` must have a sweep and outlive the solver.
  explicit SnapshotSolver(const Scene& scene);

  [[nodiscard]] SnapshotPointer at(double parameter) const;
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] double from() const { return from_; }
  [[nodiscard]] double to() const { return to_; }
  /// A length of the mechanism, the unit of the points.
  [[nodiscard]] double length() const { return length_; }
  /// Whether a value lies between the sweep's ends.
  [[nodiscard]] bool covers(double parameter) const {
    return (parameter - from_) * (parameter - to_) <= 0;
  }

 private:
  const Scene& scene_;
  double from_ = 0;
  double to_ = 0;
  double length_ = 1;
};

}  // namespace assur::generator
