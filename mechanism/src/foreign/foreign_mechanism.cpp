#include "foreign/foreign_mechanism.hpp"

#include <algorithm>
#include <assur/text/names.hpp>
#include <assur/text/quoted.hpp>
#include <charconv>
#include <cmath>
#include <utility>

namespace assur::mechanism::foreign {

std::string number_text(double number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number + 0.0);
  return {text.data(), end.ptr};
}

std::string term_text(double number) {
  return (number < 0 ? " - " : " + ") + number_text(std::abs(number));
}

void ForeignMechanism::list(ForeignLinkIndex link, ForeignPointIndex point) {
  if (!lists(link, point)) {
    links[link].points.push_back(point);
  }
}

bool ForeignMechanism::lists(ForeignLinkIndex link, ForeignPointIndex point) const {
  return std::ranges::find(links[link].points, point) != links[link].points.end();
}

std::vector<ForeignLinkIndex> ForeignMechanism::pinned_at(ForeignPointIndex point) const {
  std::vector<ForeignLinkIndex> found;
  for (const ForeignLinkIndex link : links.keys()) {
    if (!links[link].is_left_out && lists(link, point) &&
        std::ranges::none_of(joints, [&](const ForeignJoint& joint) {
          return joint.type == JointType::pin_in_slot && joint.at == point && joint.second == link;
        })) {
      found.push_back(link);
    }
  }
  return found;
}

bool ForeignMechanism::is_moved(ForeignPointIndex point) const {
  for (const ForeignLinkIndex link : links.keys()) {
    if (link != ground_ && !links[link].is_left_out && lists(link, point)) {
      return true;
    }
  }
  return false;
}

ForeignJointIndex ForeignMechanism::pin(ForeignLinkIndex first, ForeignLinkIndex second,
                                        ForeignPointIndex point) {
  for (const ForeignJointIndex joint : joints.keys()) {
    const ForeignJoint& known = joints[joint];
    const bool joins_both = (known.first == first && known.second == second) ||
                            (known.first == second && known.second == first);
    if (known.type == JointType::revolute && known.at == point && joins_both) {
      return joint;
    }
  }
  if (second == ground_) {
    std::swap(first, second);
  }
  return joints.add({JointType::revolute, first, second, point});
}

const ForeignDrive* ForeignMechanism::drive_of(ForeignJointIndex joint) const {
  const auto found = std::ranges::find(drives, joint, &ForeignDrive::joint);
  return found == drives.end() ? nullptr : &*found;
}

bool ForeignMechanism::moves_in_time() const {
  return std::ranges::any_of(drives, [](const ForeignDrive& drive) {
    return drive.motion.find("*t") != std::string::npos;
  });
}

double ForeignMechanism::distance(ForeignPointIndex one, ForeignPointIndex other) const {
  return std::hypot(points[other].x - points[one].x, points[other].y - points[one].y);
}

void ForeignMechanism::remark(const std::string& line) { remarks_.push_back(line); }

void ForeignMechanism::miss(const std::string& line) {
  remarks_.push_back(line);
  is_complete_ = false;
}

int ForeignMechanism::joints_of(ForeignLinkIndex link) const {
  int count = 0;
  for (const ForeignPointIndex point : links[link].points) {
    const std::vector<ForeignLinkIndex> pinned = pinned_at(point);
    count += pinned.size() > 1 && std::ranges::find(pinned, link) != pinned.end() ? 1 : 0;
  }
  for (const ForeignJoint& joint : joints) {
    const bool has_both = !links[joint.first].is_left_out && !links[joint.second].is_left_out;
    count += has_both && joint.type != JointType::revolute &&
                     (joint.first == link || joint.second == link)
                 ? 1
                 : 0;
  }
  return count;
}

bool ForeignMechanism::is_driven(ForeignLinkIndex link) const {
  const auto moves = [&](ForeignJointIndex joint) {
    return joint.exists() && (joints[joint].first == link || joints[joint].second == link);
  };
  return std::ranges::any_of(
      drives, [&](const ForeignDrive& drive) { return moves(drive.joint) || moves(drive.leader); });
}

void ForeignMechanism::leave_out(ForeignLinkIndex link) {
  links[link].is_left_out = true;
  std::erase_if(outputs, [&](ForeignPointIndex point) { return !is_moved(point); });
  std::erase_if(masses, [&](const ForeignMass& mass) { return mass.link == link; });
  std::erase_if(forces, [&](const ForeignForce& force) { return force.link == link; });
}

void ForeignMechanism::finish() {
  for (bool changes = true; changes;) {
    changes = false;
    for (const ForeignLinkIndex link : links.keys()) {
      if (link == ground_ || links[link].is_left_out || is_driven(link)) {
        continue;
      }
      const int count = links[link].points.empty() ? 0 : joints_of(link);
      if (count < 2) {
        remark("the link " + text::in_quotes(links[link].id) +
               " is left out: nothing drives it, and " +
               (count == 0 ? "nothing holds it" : "only one joint holds it"));
        leave_out(link);
        changes = true;
      }
    }
  }
  if (drives.empty()) {
    miss("nothing drives the mechanism; add drivers to the scene");
  }
  if (!looks_.empty()) {
    remark("how the drawing looks is left out: " +
           text::listed(std::vector<std::string>(looks_.begin(), looks_.end())));
  }
}

}  // namespace assur::mechanism::foreign
