#include "nearness.hpp"

#include "plan/plan_data.hpp"
#include "reference.hpp"

namespace assur::mechanism::solve {

Nearness::Nearness(const Placement& placement)
    : placement_(placement),
      angles_(placement.structure().groups.size() + 1),
      links_(placement.structure().groups.size() + 1) {
  const PlanData& plan = placement.plan();
  const Table<LinkIndex, std::size_t> groups = plan.structure.groups_before();
  for (const ReferenceAngle& angle : plan.request.reference) {
    angles_[groups[angle.link]].push_back(angle);
  }
  for (const LinkIndex link : plan.mechanism.links().keys()) {
    links_[groups[link]].push_back(link);
  }
}

void Nearness::seek_reference() {
  is_sought_ = true;
  point_ = nullptr;
}

void Nearness::seek(const SoughtPoint& point) {
  is_sought_ = true;
  point_ = &point;
}

double Nearness::square_at(std::size_t groups) const {
  const Table<LinkIndex, Frame>& links = placement_.placed().links;
  double square = 0;
  if (point_ == nullptr) {
    for (const ReferenceAngle& angle : angles_[groups]) {
      const double difference = difference_from(placement_.values(), links[angle.link], angle);
      square += difference * difference;
    }
    return square;
  }
  for (const LinkIndex link : links_[groups]) {
    const Pose<double>& pose = links[link].pose;
    const Eigen::Vector4d at(pose.x / point_->length, pose.y / point_->length, pose.direction.cos,
                             pose.direction.sin);
    square += (at - point_->at.segment<4>(4 * link.row())).squaredNorm();
  }
  return square;
}

}  // namespace assur::mechanism::solve
