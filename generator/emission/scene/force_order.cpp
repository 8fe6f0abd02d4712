#include "emission/scene/force_order.hpp"

#include <algorithm>
#include <iterator>

#include "error.hpp"

namespace assur::generator::emission::scene {

namespace {

using mechanism::LinkIndex;

bool has(const std::vector<LinkIndex>& links, LinkIndex link) {
  return std::ranges::find(links, link) != links.end();
}

/// Takes each step as soon as all other loads on its links are known.
class ForceOrder {
 public:
  ForceOrder(const mechanism::Mechanism& mechanism, const mechanism::Structure& structure)
      : mechanism_(mechanism), structure_(structure) {
    is_known_.assign(structure.linkage.joints.size(), false);
    for (const mechanism::GroupIndex group : structure.groups.keys()) {
      waiting_.push_back({group, nullptr});
    }
    for (const mechanism::CarriedLink& link : structure.carried) {
      if (link.driver.exists()) {
        waiting_.push_back({{}, &link});
      }
    }
    std::ranges::reverse(waiting_);
  }

  [[nodiscard]] std::vector<ForceStep> run() {
    while (!waiting_.empty()) {
      const auto next =
          std::ranges::find_if(waiting_, [this](const ForceStep& step) { return is_ready(step); });
      if (next == waiting_.end()) {
        throw GeneratorError("forces", mechanism_.name(), "no group or driver can be next");
      }
      for (const mechanism::ElementaryJointIndex joint : joints_of(*next)) {
        is_known_[joint] = true;
      }
      taken_.push_back(*next);
      waiting_.erase(next);
    }
    return std::move(taken_);
  }

 private:
  [[nodiscard]] std::vector<mechanism::ElementaryJointIndex> joints_of(
      const ForceStep& step) const {
    return step.cut != nullptr ? std::vector{step.cut->joint}
                               : structure_.groups[step.group].assignments.front().joints;
  }
  /// The links whose equilibrium a step needs, as sets that count as one link each.
  [[nodiscard]] std::vector<std::vector<LinkIndex>> bodies_of(const ForceStep& step) const {
    if (step.cut != nullptr) {
      return {{step.cut->to}};
    }
    std::vector<std::vector<LinkIndex>> bodies;
    for (const LinkIndex link : structure_.groups[step.group].assignments.front().links) {
      bodies.push_back(links_carried_by(structure_, link));
    }
    return bodies;
  }
  [[nodiscard]] bool is_ready(const ForceStep& step) const {
    const std::vector<mechanism::ElementaryJointIndex> own = joints_of(step);
    for (const std::vector<LinkIndex>& body : bodies_of(step)) {
      for (const mechanism::ElementaryJointIndex index : structure_.linkage.joints.keys()) {
        const mechanism::ElementaryJoint& joint = structure_.linkage.joints[index];
        const int touched = static_cast<int>(has(body, joint.holder_first)) +
                            static_cast<int>(has(body, joint.holder_second));
        if (touched == 1 && !is_known_[index] && std::ranges::find(own, index) == own.end()) {
          return false;
        }
      }
      if (is_read(body, step)) {
        return false;
      }
    }
    return true;
  }
  /// Whether the law of a driver that is still to be cut reads a joint of one of the links. Within
  /// a body, the couples of such a law cancel.
  [[nodiscard]] bool is_read(const std::vector<LinkIndex>& body, const ForceStep& step) const {
    return std::ranges::any_of(waiting_, [&](const ForceStep& other) {
      if (other.cut == nullptr || other.cut == step.cut) {
        return false;
      }
      const mechanism::Driver& driver = mechanism_.drivers()[other.cut->driver];
      const auto joints = mechanism_.numbers()[driver.position].formula.joints();
      return std::ranges::any_of(joints, [&](mechanism::JointIndex joint) {
        const auto& between = mechanism_.joints()[joint].between;
        return has(body, mechanism_.features()[between[0]].link) !=
               has(body, mechanism_.features()[between[1]].link);
      });
    });
  }

  const mechanism::Mechanism& mechanism_;
  const mechanism::Structure& structure_;
  mechanism::Table<mechanism::ElementaryJointIndex, bool> is_known_;
  std::vector<ForceStep> waiting_, taken_;
};

}  // namespace

std::vector<LinkIndex> links_carried_by(const mechanism::Structure& structure, LinkIndex link) {
  std::vector<LinkIndex> links = {link};
  for (std::size_t place = 0; place < links.size(); ++place) {
    for (const mechanism::CarriedLink& carried : structure.carried) {
      if (carried.from == links[place]) {
        links.push_back(carried.to);
      }
    }
  }
  return links;
}

std::vector<ForceStep> force_order(const mechanism::Mechanism& mechanism,
                                   const mechanism::Structure& structure) {
  return ForceOrder(mechanism, structure).run();
}

}  // namespace assur::generator::emission::scene
