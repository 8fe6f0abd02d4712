// Models of larger groups, each derived on its first use.
#include "groups/derived_model.hpp"

#include <algorithm>
#include <assur/mechanism/group_model.hpp>
#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

namespace assur::mechanism::groups {

namespace {

/// A model with all data to which it refers.
struct DerivedModel {
  GroupStructure structure;
  DerivedKernel kernel;
  GroupModel model;
};

/// The joints of a group in comparable form.
using Graph = std::vector<std::tuple<int, int, bool>>;

std::unique_ptr<DerivedModel> derived(int link_count, const std::vector<ModelJoint>& joints,
                                      std::string& obstacle) {
  std::optional<Loops> loops = loops_of(link_count, joints);
  if (!loops) {
    obstacle = "slides tie its links to one another in a circle";
    return nullptr;
  }
  GroupStructure structure{"group of " + std::to_string(link_count) + " links", 0, joints, {}};
  structure.link_joints.resize(static_cast<std::size_t>(link_count));
  std::vector<JointPair> pairs;
  std::string kind;
  std::vector<bool> prismatic;
  for (std::size_t index = 0; index < joints.size(); ++index) {
    const ModelJoint& joint = joints[index];
    for (const int link : {joint.first, joint.second}) {
      if (link != base_link) {
        structure.link_joints[static_cast<std::size_t>(link)].push_back(static_cast<int>(index));
      }
    }
    pairs.push_back({joint.first, joint.second});
    kind += joint.prismatic ? 'P' : 'R';
    prismatic.push_back(joint.prismatic);
  }
  structure.assur_class = assur_class_of(link_count, pairs);
  DerivedKernel kernel(*std::move(loops), structure.link_joints);
  if (kernel.dimension_is_angle().size() > models::most_columns ||
      kernel.dimension_is_angle().size() + kernel.input_is_angle().size() + models::most_unknowns >
          most_variables) {
    obstacle = "its links have more joints than there is room for";
    return nullptr;
  }
  if (kernel.complex_count() == 0) {
    obstacle = "it moves in general position";
    return nullptr;
  }
  std::vector<ModelUnknown> unknowns;
  for (const int link : kernel.loops().free_turned) {
    unknowns.push_back({"theta", true, link});
  }
  for (std::size_t joint = 0; joint < joints.size(); ++joint) {
    if (joints[joint].prismatic) {
      unknowns.push_back({"s", false, static_cast<int>(joint)});
    }
  }
  GroupModel model{nullptr,
                   0,
                   true,
                   0,
                   kernel.complex_count(),
                   std::move(prismatic),
                   {kind},
                   std::move(unknowns),
                   kernel.dimension_is_angle().size(),
                   kernel.input_is_angle().size(),
                   kernel.dimension_is_angle(),
                   kernel.input_is_angle(),
                   nullptr,
                   kernel.eliminations().list(),
                   kernel.starts().list(),
                   slide_angles_of(kernel.loops())};
  auto result = std::make_unique<DerivedModel>(
      DerivedModel{std::move(structure), std::move(kernel), std::move(model)});
  result->model.group = &result->structure;
  result->model.kernel = &result->kernel;
  return result;
}

/// Mutual exclusion of threads. The standard library of a program without threads has no mutex.
class Gate {
 public:
  explicit Gate(std::atomic_flag& flag) : flag_(flag) {
    while (flag_.test_and_set(std::memory_order_acquire)) {
    }
  }
  Gate(const Gate&) = delete;
  Gate& operator=(const Gate&) = delete;
  ~Gate() { flag_.clear(std::memory_order_release); }

 private:
  std::atomic_flag& flag_;
};

struct Known {
  std::unique_ptr<DerivedModel> model;
  std::string obstacle;
};

/// The model of a graph, derived once.
const Known& known(int link_count, const std::vector<ModelJoint>& joints) {
  // It is not destroyed, since threads may still solve when the process ends.
  static auto& models = *new std::map<Graph, Known>;
  static std::atomic_flag is_busy;
  Graph graph;
  for (const ModelJoint& joint : joints) {
    graph.emplace_back(joint.first, joint.second, joint.prismatic);
  }
  const Gate gate(is_busy);
  const auto [place, is_new] = models.try_emplace(std::move(graph));
  if (is_new) {
    place->second.model = derived(link_count, joints, place->second.obstacle);
  }
  return place->second;
}

}  // namespace

GroupProof proof_of(const std::vector<ModelJoint>& joints,
                    const std::vector<JointFeatures<double>>& features,
                    const std::vector<Direction<double>>& directions) {
  const Known& model = known(static_cast<int>(directions.size()), joints);
  if (!model.model) {
    return {0, 0, 0, model.obstacle};
  }
  return model.model->kernel.proof(features, directions);
}

}  // namespace assur::mechanism::groups

namespace assur::mechanism {

const GroupModel* derived_model(int link_count, const std::vector<ModelJoint>& joints,
                                std::string& obstacle) {
  const groups::Known& model = groups::known(link_count, joints);
  obstacle = model.obstacle;
  return model.model ? &model.model->model : nullptr;
}

}  // namespace assur::mechanism
