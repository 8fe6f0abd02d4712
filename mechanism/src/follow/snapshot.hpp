// Every configuration at one value of the swept parameter, as points of one space.
#pragma once

#include <algorithm>
#include <assur/directions.hpp>
#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/structure.hpp>
#include <assur/mechanism/values.hpp>
#include <memory>
#include <ranges>
#include <vector>

namespace assur::mechanism::follow {

/// One configuration as a point: (x / L, y / L, cos theta, sin theta) of every link, with L a
/// length of the mechanism, and its derivative with respect to the swept parameter.
struct ConfigurationPoint {
  Eigen::VectorXd at;
  Eigen::VectorXd slope;
};
/// The index of a configuration in its set.
using PointIndex = Index<ConfigurationPoint>;

/// Every configuration at one value of the swept parameter.
struct Snapshot {
  double parameter = 0;
  Spread spread;
  Solution solution;
  /// The roles of every group's links: determinants are compared where they agree.
  Table<GroupIndex, const RoleAssignment*> roles;
  Table<PointIndex, ConfigurationPoint> points;  ///< in the order of the solution's configurations
  /// Whether every configuration is known, regular and apart from all others, so that each can be
  /// followed.
  bool separable = true;
  double closest = 0;  ///< the least distance of two points; infinite for fewer than two
  /// Whether some links move freely at this value alone, so that branches have no configuration
  /// here.
  bool has_own_family = false;

  /// Whether infinitely many configurations replace some that are isolated elsewhere.
  [[nodiscard]] bool is_degenerate() const {
    return solution.status == SolutionStatus::degenerate || has_own_family;
  }
  [[nodiscard]] std::size_t count() const { return points.size(); }
  [[nodiscard]] const Configuration& configuration(PointIndex point) const {
    return solution.configurations[point.place()];
  }
};
using SnapshotPointer = std::shared_ptr<const Snapshot>;

/// Sets a configuration's place as a point, with the unit `length`, and its slope: `slope_of(link)`
/// is the derivative of a link's pose (x, y, theta) along the way.
template <typename SlopeOf>
void set_point(const Configuration& configuration, double length, const SlopeOf& slope_of,
               ConfigurationPoint& point) {
  const auto size = 4 * static_cast<Eigen::Index>(configuration.links.size());
  point.at.resize(size);
  point.slope.resize(size);
  Eigen::Index row = 0;
  for (const Frame& link : configuration.links) {
    const Direction<double>& direction = link.pose.direction;
    const Eigen::Vector3d slope = slope_of(link);
    point.at.segment<4>(row) << link.pose.x / length, link.pose.y / length, direction.cos,
        direction.sin;
    point.slope.segment<4>(row) << slope(0) / length, slope(1) / length, -slope(2) * direction.sin,
        slope(2) * direction.cos;
    row += 4;
  }
}
/// Points in the order of their places along one fixed line. Two points are at least as far apart
/// as their places, so that only near ones in this order can be near.
class OrderOnLine {
 public:
  struct Place {
    double place;
    PointIndex point;
  };

  /// `at(point)` is where the point with an index is.
  template <typename At>
  OrderOnLine(std::size_t count, const At& at) {
    for (std::size_t index = 0; index < count; ++index) {
      places_.push_back({place_of(at(PointIndex(index))), PointIndex(index)});
    }
    std::ranges::sort(places_, {}, &Place::place);
  }

  /// The place of a point on the line.
  [[nodiscard]] static double place_of(const Eigen::VectorXd& point);
  [[nodiscard]] const std::vector<Place>& places() const { return places_; }
  /// The points whose places are within a distance from one.
  [[nodiscard]] auto within(double distance, double place) const {
    return std::ranges::subrange(
        std::ranges::lower_bound(places_, place - distance, {}, &Place::place),
        std::ranges::upper_bound(places_, place + distance, {}, &Place::place));
  }

 private:
  std::vector<Place> places_;
};

/// The least distance of two points; infinite for fewer than two.
[[nodiscard]] double least_distance(const Table<PointIndex, ConfigurationPoint>& points);
/// Whether every configuration has its derivatives, so that it can be followed.
[[nodiscard]] bool is_regular(const Snapshot& snapshot);

}  // namespace assur::mechanism::follow
