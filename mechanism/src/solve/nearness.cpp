#include "nearness.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "plan/plan_data.hpp"
#include "reference.hpp"

namespace assur::mechanism::solve {

Nearness::Nearness(const Placement& placement)
    : placement_(placement),
      angles_(placement.structure().groups.size() + 1),
      links_(placement.structure().groups.size() + 1),
      own_angles_(placement.structure().groups.size()),
      own_links_(placement.structure().groups.size()) {
  const PlanData& plan = placement.plan();
  const Table<LinkIndex, std::size_t> groups = plan.structure.groups_before();
  for (const ReferenceAngle& angle : plan.request.reference) {
    angles_[groups[angle.link]].push_back(angle);
  }
  for (const LinkIndex link : plan.mechanism.links().keys()) {
    links_[groups[link]].push_back(link);
  }
  for (const GroupIndex group : plan.structure.groups.keys()) {
    for (const LinkIndex link : plan.structure.groups[group].links) {
      const auto is_of_link = [link](const ReferenceAngle& angle) { return angle.link == link; };
      std::ranges::copy_if(plan.request.reference, std::back_inserter(own_angles_[group]),
                           is_of_link);
      if (link.place() < plan.mechanism.links().size()) {  // not a block
        own_links_[group].push_back(link);
      }
    }
  }
}

void Nearness::seek_nothing() {
  is_sought_ = false;
  farthest_square_ = std::numeric_limits<double>::infinity();
}

void Nearness::seek_reference() {
  seek_nothing();
  is_sought_ = true;
  point_ = nullptr;
}

void Nearness::seek(const SoughtPoint& point) {
  is_sought_ = true;
  point_ = &point;
  farthest_square_ = point.farthest * point.farthest;
}

void Nearness::begin() {
  square_ = 0;
  least_square_ = std::numeric_limits<double>::infinity();
  next_square_ = farthest_square_;
}

double Nearness::enter(std::size_t groups) {
  const double before = square_;
  if (is_sought_) {
    square_ += square_of(angles_[groups], links_[groups]);
  }
  return before;
}

bool Nearness::is_nearest() {
  if (square_ >= least_square_) {
    next_square_ = square_;
    return false;
  }
  next_square_ = std::min(next_square_, least_square_);
  least_square_ = square_;
  return true;
}

Nearest Nearness::found() const {
  const bool has_runner_up = std::isfinite(next_square_);
  return {0, std::sqrt(least_square_),
          has_runner_up ? std::optional(std::sqrt(next_square_)) : std::nullopt};
}

double Nearness::square_of(const std::vector<ReferenceAngle>& angles,
                           const std::vector<LinkIndex>& described) const {
  const Table<LinkIndex, Frame>& links = placement_.placed().links;
  double square = 0;
  if (point_ == nullptr) {
    for (const ReferenceAngle& angle : angles) {
      const double difference = difference_from(placement_.values(), links[angle.link], angle);
      square += difference * difference;
    }
    return square;
  }
  for (const LinkIndex link : described) {
    const Pose<double>& pose = links[link].pose;
    const Eigen::Vector4d at(pose.x / point_->length, pose.y / point_->length, pose.direction.cos,
                             pose.direction.sin);
    square += (at - point_->at.segment<4>(4 * link.row())).squaredNorm();
  }
  return square;
}

}  // namespace assur::mechanism::solve
