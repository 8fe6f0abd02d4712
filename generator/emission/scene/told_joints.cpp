#include "emission/scene/told_joints.hpp"

#include <algorithm>
#include <assur/text/identifiers.hpp>
#include <assur/text/index.hpp>

namespace assur::generator::emission::scene {

std::vector<ToldJoint> told_joints(const SolverScene& solver) {
  const mechanism::Mechanism& described = solver.mechanism();
  const auto held = mechanism::held_pairs(described, solver.plan.redundant());
  std::vector<ToldJoint> told;
  for (std::size_t pair = 0; pair < held.size(); ++pair) {
    const mechanism::JointIndex joint = text::index_of(described.joints(), held[pair].joint);
    if (joint.exists() && !solver.plan.request().reported.has(joint)) {
      continue;
    }
    auto at = std::ranges::find(told, held[pair].joint, &ToldJoint::name);
    if (at == told.end()) {
      at = told.insert(told.end(), {held[pair].joint, "", {}, {}, false, {}});
    }
    at->pairs.push_back(pair);
    const auto add = [&](mechanism::FeatureIndex feature) {
      const mechanism::LinkIndex link = described.features()[feature].link;
      if (std::ranges::find(at->links, link) == at->links.end()) {
        at->links.push_back(link);
      }
    };
    std::ranges::for_each(held[pair].between, add);
    at->has_moment = at->has_moment || (described.features()[held[pair].first].is_line &&
                                        described.features()[held[pair].second].is_line);
  }
  std::vector<std::string> taken = {"members"};
  taken.insert(taken.end(), solver.members.joints.begin(), solver.members.joints.end());
  for (ToldJoint& joint : told) {
    const mechanism::JointIndex own = text::index_of(described.joints(), joint.name);
    joint.member =
        own.exists() ? solver.members.joints[own] : text::member_names({joint.name}, taken).front();
    taken.push_back(joint.member);
    if (joint.is_pin()) {
      std::vector<std::string> links;
      for (const mechanism::LinkIndex link : joint.links) {
        links.push_back(solver.link_name(link));
      }
      joint.link_members = text::member_names(links, {"members"});
    }
  }
  return told;
}

}  // namespace assur::generator::emission::scene
