#include "emission/scene/solver_scene.hpp"

#include <algorithm>
#include <array>
#include <assur/text/identifiers.hpp>
#include <assur/text/names.hpp>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>

#include "emission/scene/variable_parameters.hpp"

namespace assur::generator::emission::scene {

namespace {

/// The largest number of states that a solver lists: their array is on the caller's stack.
constexpr double most_listed = 4096;
/// The largest number of groups: those that hold a group are the bits of one integer.
constexpr std::size_t most_groups = 64;

std::vector<VariableParameter> variable_parameters(const mechanism::Plan& plan) {
  std::vector<mechanism::ParameterIndex> indices = plan.request().variable;
  std::sort(indices.begin(), indices.end());
  expect_arguments(plan, indices);
  std::vector<std::string> names;
  for (const mechanism::ParameterIndex index : indices) {
    names.push_back(plan.mechanism().parameters()[index].name);
  }
  const std::vector<std::string> members = text::member_names(names, {"members", "values"});
  std::vector<VariableParameter> variable;
  for (std::size_t place = 0; place < indices.size(); ++place) {
    variable.push_back({indices[place], members[place]});
  }
  return variable;
}

/// The parameters that have a tolerance or are variable, or all if there are none of these; empty
/// if no output's sensitivity is wanted.
ModelledParameters modelled_parameters(const mechanism::Plan& plan, const mechanism::Values& values,
                                       const std::vector<VariableParameter>& variable) {
  const auto& parameters = plan.mechanism().parameters();
  const auto is_variable = [&](mechanism::ParameterIndex index) {
    return std::any_of(variable.begin(), variable.end(),
                       [&](const VariableParameter& one) { return one.index == index; });
  };
  const bool any = !variable.empty() || std::any_of(parameters.begin(), parameters.end(),
                                                    [](const mechanism::Parameter& one) {
                                                      return one.tolerance.exists();
                                                    });
  const bool wanted = plan.request().want.sensitivity && !plan.mechanism().outputs().empty();
  std::vector<Eigen::Index> columns;
  std::vector<std::string> names;
  Eigen::Index column = 0;
  for (const mechanism::ParameterIndex index : values.columns()) {
    const mechanism::Parameter& parameter = parameters[index];
    if (wanted && (parameter.tolerance.exists() || is_variable(index) || !any)) {
      columns.push_back(column);
      names.push_back(parameter.name);
    }
    ++column;
  }
  return {columns, names};
}

/// The variable parameters as expressions in the statements of a solver.
std::vector<std::pair<mechanism::ParameterIndex, cpp::Expression>> arguments(
    const std::vector<VariableParameter>& variable) {
  std::vector<std::pair<mechanism::ParameterIndex, cpp::Expression>> list;
  for (const VariableParameter& parameter : variable) {
    list.emplace_back(parameter.index, cpp::variable("p").member(parameter.member));
  }
  return list;
}

/// Members for the items of a table, by their names.
template <typename Key>
mechanism::Table<Key, std::string> members_of(const std::vector<std::string>& names,
                                              const std::vector<std::string>& taken) {
  mechanism::Table<Key, std::string> members;
  for (const std::string& member : text::member_names(names, taken)) {
    members.add(member);
  }
  return members;
}

/// `rod_on_crank`, for the links that a group places relative to another one.
mechanism::Table<mechanism::LinkIndex, std::string> relative_members(
    const mechanism::Structure& structure, const std::vector<std::string>& taken) {
  std::vector<std::string> names;
  for (const mechanism::CarriedLink& link : structure.carried) {
    if (link.group.exists()) {
      names.push_back(structure.linkage.links[link.to] + "_on_" +
                      structure.linkage.links[link.from]);
    }
  }
  const std::vector<std::string> spelled = text::member_names(names, taken);
  auto member = spelled.begin();
  mechanism::Table<mechanism::LinkIndex, std::string> members(structure.linkage.links.size());
  for (const mechanism::CarriedLink& link : structure.carried) {
    if (link.group.exists()) {
      members[link.to] = *member++;
    }
  }
  return members;
}

/// A block, which a driver may move, has a member besides those of the mechanism's own links.
SceneMembers scene_members(const mechanism::Mechanism& described,
                           const mechanism::Structure& structure, const mechanism::Want& want) {
  const mechanism::Linkage& linkage = structure.linkage;
  SceneMembers members;
  members.joints = members_of<mechanism::JointIndex>(names_of(described.joints()), {"members"});
  // In the emitted struct Placed, slides and other members stand beside the links.
  std::vector<std::string> taken = {"drivers", "members", "order", "parameters", "regularity"};
  if (want.coefficients || want.dynamics) {
    taken.emplace_back("given_rates");
  }
  for (const std::string& member : members.joints) {
    taken.push_back("slide_" + member);
  }
  members.links =
      members_of<mechanism::LinkIndex>({linkage.links.begin(), linkage.links.end()}, taken);
  taken.insert(taken.end(), members.links.begin(), members.links.end());
  members.relative = relative_members(structure, taken);
  taken.insert(taken.end(), members.relative.begin(), members.relative.end());
  std::vector<std::string> solved;
  for (const mechanism::GroupIndex group : structure.groups.keys()) {
    solved.push_back("solved_" + std::to_string(group.place() + 1));
  }
  members.solved = members_of<mechanism::GroupIndex>(solved, taken);
  std::vector<std::string> driven;
  for (const mechanism::Driver& driver : described.drivers()) {
    driven.push_back(described.joints()[driver.joint].name);
  }
  members.drivers = members_of<mechanism::DriverIndex>(driven, {"members", "positions", "rates"});
  members.outputs = members_of<mechanism::OutputIndex>(names_of(described.outputs()), {"members"});
  return members;
}

/// The placed links that hold a group's external joints.
std::vector<mechanism::LinkIndex> bases_of(const mechanism::Structure& structure,
                                           const mechanism::FoundGroup& group) {
  std::vector<mechanism::LinkIndex> bases;
  for (const mechanism::ElementaryJointIndex index : group.assignments.front().joints) {
    const mechanism::ElementaryJoint& joint = structure.linkage.joints[index];
    for (const mechanism::LinkIndex link : {joint.first, joint.second}) {
      if (link != group.base &&
          std::find(group.links.begin(), group.links.end(), link) == group.links.end()) {
        bases.push_back(link);
      }
    }
  }
  return bases;
}

mechanism::Table<mechanism::LinkIndex, FrameNeed> needs_of_links(const SolverScene& solver) {
  const mechanism::Mechanism& described = solver.mechanism();
  const mechanism::Structure& structure = solver.plan.structure();
  mechanism::Table<mechanism::LinkIndex, FrameNeed> needs(structure.linkage.links.size(),
                                                          FrameNeed::nothing);
  for (const mechanism::LinkIndex link : structure.named_parts(described).links) {
    needs[link] = FrameNeed::direction;
  }
  for (const mechanism::LinkIndex link : described.links().keys()) {
    if (solver.reports(link) || !solver.plan.redundant().empty()) {
      needs[link] = FrameNeed::everything;
    }
  }
  if (solver.keeps_groups()) {
    std::ranges::fill(needs, FrameNeed::everything);
  }
  for (const mechanism::Output& output : described.outputs()) {
    needs[described.features()[output.point].link] = FrameNeed::everything;
  }
  for (const mechanism::CarriedLink& link : structure.carried) {
    needs[link.to] = FrameNeed::everything;
    needs[link.from] = FrameNeed::everything;
  }
  for (const mechanism::ReadingDriver& reading : structure.reading) {
    for (const mechanism::LinkIndex link : reading.reads) {
      needs[link] = FrameNeed::everything;
    }
  }
  for (const mechanism::JointIndex pin : structure.linkage.second_pins) {
    for (const mechanism::FeatureIndex feature : described.joints()[pin].between) {
      needs[described.features()[feature].link] = FrameNeed::everything;
    }
  }
  for (const mechanism::FoundGroup& group : structure.groups) {
    for (const mechanism::LinkIndex base : bases_of(structure, group)) {
      needs[base] = FrameNeed::everything;
    }
  }
  return needs;
}

/// Loads depend on rates through inertia and dampers; second coefficients are accelerations.
int order_of(const mechanism::Want& want) {
  return want.acceleration || want.loaded() || want.coefficients ? 2 : want.velocity ? 1 : 0;
}

/// The model of a group of more than four links, whose joints are named B, C, ... in their order.
const structure::Model& derived_from_graph(const mechanism::GroupModel& model) {
  struct Derived {
    structure::Group group;
    structure::Model model;
  };
  static std::map<const mechanism::GroupModel*, std::unique_ptr<const Derived>> known;
  std::unique_ptr<const Derived>& place = known[&model];
  if (!place) {
    const auto letter = [](std::size_t joint) { return static_cast<char>('B' + joint); };
    std::vector<std::string> words;
    for (const std::vector<int>& joints : model.group->link_joints) {
      std::string& word = words.emplace_back();
      for (const int joint : joints) {
        word += letter(static_cast<std::size_t>(joint));
      }
    }
    std::string spelling;
    structure::Kind kind;
    for (const bool slides : model.prismatic) {
      spelling += letter(spelling.size());
      kind.add(slides ? structure::JointType::prismatic : structure::JointType::revolute);
    }
    auto derived = std::make_unique<Derived>(Derived{
        {model.group->name, model.group->assur_class, std::move(words), std::move(spelling)},
        {nullptr, 0, std::move(kind), {}}});
    derived->model.group = &derived->group;
    place = std::move(derived);
  }
  return place->model;
}

}  // namespace

SolverScene::SolverScene(const mechanism::Scene& described)
    : plan(described),
      values(plan.values()),
      variable(variable_parameters(plan)),
      parameters(modelled_parameters(plan, values, variable)),
      members(scene_members(plan.mechanism(), plan.structure(), plan.request().want)),
      numbers(plan, values, arguments(variable), parameters.columns(), members.drivers,
              members.joints, members.relative),
      needs(needs_of_links(*this)),
      derivative_order(order_of(described.request.want)),
      file(std::filesystem::path(described.file).filename().string()),
      structure(text::struct_name(std::filesystem::path(described.file).stem().string())) {}

const mechanism::ElementaryJoint& SolverScene::played_joint(mechanism::GroupIndex group,
                                                            int joint) const {
  const mechanism::RoleAssignment& roles = *numbers.group(group).roles;
  return this->joint(roles.joints[static_cast<std::size_t>(joint)]);
}

std::vector<std::string> SolverScene::pin_members(mechanism::JointIndex pin) const {
  std::vector<std::string> names;
  for (const mechanism::FeatureIndex feature : mechanism().joints()[pin].between) {
    names.push_back(link_name(mechanism().features()[feature].link));
  }
  return text::member_names(names, {"members"});
}

bool SolverScene::holds_groups(mechanism::GroupIndex group) const {
  bool holds = false;
  for (const mechanism::GroupIndex other : plan.structure().groups.keys()) {
    const std::vector<mechanism::GroupIndex> holders = plan.structure().holders_of(other);
    holds = holds || std::ranges::find(holders, group) != holders.end();
  }
  return holds;
}

const structure::Model& symbolic_model(const mechanism::FoundGroup& group) {
  if (group.model->is_derived()) {
    return derived_from_graph(*group.model);
  }
  const std::vector<structure::Model>& models =
      structure::models_of(structure::group_named(group.model->group->name));
  return *std::find_if(models.begin(), models.end(), [&](const structure::Model& model) {
    return model.number == group.model->number;
  });
}

void expect_listable(const mechanism::Plan& plan) {
  const double most = plan.most_configurations();
  if (most > most_listed) {
    std::array<char, 32> number{};
    (void)std::snprintf(number.data(), number.size(), most < 1e15 ? "%.0f" : "%.3g", most);
    throw mechanism::MechanismError(
        "",
        std::string("there may be ") + number.data() +
            " configurations, and an emitted solver lists 4096 at most; name fewer parts in the "
            "scene's 'report', or emit parts of the mechanism");
  }
  if (plan.structure().groups.size() > most_groups) {
    throw mechanism::MechanismError("", "there are " +
                                            std::to_string(plan.structure().groups.size()) +
                                            " groups, and an emitted solver has 64 at most; "
                                            "name fewer parts in the scene's 'report', or emit "
                                            "parts of the mechanism");
  }
}

}  // namespace assur::generator::emission::scene
