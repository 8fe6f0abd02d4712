// Look-up of the models of a group, and Assur's class of a graph.
#include <algorithm>
#include <assur/mechanism/group_model.hpp>
#include <functional>

namespace assur::mechanism {

GroupModels::Served GroupModels::serving(const std::vector<bool>& prismatic) const {
  const auto spells = [&](const std::string& kind) {
    std::size_t place = 0;
    for (const char letter : kind) {
      if (letter == 'R' || letter == 'P') {
        if (place == prismatic.size() || prismatic[place++] != (letter == 'P')) {
          return false;
        }
      }
    }
    return place == prismatic.size();
  };
  for (const GroupModel& model : models) {
    const auto kind = std::find_if(model.kinds.begin(), model.kinds.end(), spells);
    if (kind != model.kinds.end()) {
      return {&model, *kind};
    }
  }
  return {nullptr, ""};  // unreachable: the models of a group cover all its kinds
}

int assur_class_of(int link_count, const std::vector<JointPair>& joints) {
  int largest = 2;
  const auto touches = [](const JointPair& joint, int link) {
    return joint.first == link || joint.second == link;
  };
  const auto other = [](const JointPair& joint, int link) {
    return joint.first == link ? joint.second : joint.first;
  };
  for (int link = 0; link < link_count; ++link) {
    int own = 0;
    // A link with a joint to the outside has two others, which belong to contours of several links.
    bool inner = true;
    for (const JointPair& joint : joints) {
      if (touches(joint, link)) {
        ++own;
        inner = inner && other(joint, link) != base_link;
      }
    }
    largest = inner ? std::max(largest, own) : largest;
  }
  // The longest closed walk over different links.
  std::vector<int> walk;
  const std::function<void(int)> extend = [&](int link) {
    walk.push_back(link);
    for (const JointPair& joint : joints) {
      if (!touches(joint, link)) {
        continue;
      }
      const int next = other(joint, link);
      if (next == walk.front() && walk.size() > 2) {
        largest = std::max(largest, static_cast<int>(walk.size()));
      } else if (next != base_link && std::find(walk.begin(), walk.end(), next) == walk.end()) {
        extend(next);
      }
    }
    walk.pop_back();
  };
  for (int link = 0; link < link_count; ++link) {
    extend(link);
  }
  return largest;
}

}  // namespace assur::mechanism
