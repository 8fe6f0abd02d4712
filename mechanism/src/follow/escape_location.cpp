#include "escape_location.hpp"

namespace assur::mechanism::follow {

double distance_to_escape(const ConfigurationPoint& point) {
  const Eigen::VectorXd outward = point.at.normalized();
  return outward.dot(point.at) / outward.dot(point.slope);
}

std::optional<EventLocation> locate_escape(SnapshotSolver& solver, const SnapshotPointer& near,
                                           PointIndex index) {
  constexpr int most = 12;
  SnapshotPointer set = near;
  double parameter = near->parameter;
  for (int iteration = 0; iteration < most; ++iteration) {
    const ConfigurationPoint& point = set->points[index];
    const double distance = distance_to_escape(point);
    parameter = set->parameter + distance;
    const SnapshotPointer next = solver.at(set->parameter + distance * 15 / 16);
    const Eigen::VectorXd predicted = 16 * point.at;
    const PointIndex followed = nearest(*next, predicted);
    if (!next->separable || !followed.exists() ||
        !((next->points[followed].at - predicted).norm() < 0.3 * predicted.norm())) {
      break;
    }
    set = next;
    index = followed;
  }
  return EventLocation{parameter, unknown_configuration(solver.plan())};
}

}  // namespace assur::mechanism::follow
