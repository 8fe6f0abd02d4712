#include "longest_on_links.hpp"

#include <algorithm>
#include <vector>

#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

double longest_on_links(const Values& values) {
  const PlanData& plan = values.plan();
  Table<LinkIndex, std::vector<Eigen::Vector2d>> points(plan.mechanism.links().size());
  double longest = 0;
  double largest = 0;
  for (const FeatureIndex feature : plan.evaluation.features) {
    const Pose<double>& place = values.frame(feature).pose;
    const Eigen::Vector2d point(place.x, place.y);
    largest = std::max(largest, point.cwiseAbs().maxCoeff());
    std::vector<Eigen::Vector2d>& others = points[plan.mechanism.features()[feature].link];
    for (const Eigen::Vector2d& other : others) {
      longest = std::max(longest, (point - other).norm());
    }
    others.push_back(point);
  }
  return longest > 0 ? longest : largest > 0 ? largest : 1;
}

}  // namespace assur::mechanism::solve
