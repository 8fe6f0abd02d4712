#include "emission/scene/state_members.hpp"

#include <assur/text/names.hpp>
#include <functional>
#include <utility>

namespace assur::generator::emission::scene {

namespace {

/// The names of the members that a state has, as a list.
std::string listed(const std::vector<std::pair<std::string, bool>>& names) {
  std::vector<std::string> there;
  for (const auto& [name, is_there] : names) {
    if (is_there) {
      there.push_back(name);
    }
  }
  return text::joined(there, ", ", std::identity());
}

bool stands(const cpp::View& view, const std::string& section) {
  return std::get<bool>(view.values().at(section));
}

}  // namespace

cpp::View::List member_list(const std::vector<std::string>& members) {
  cpp::View::List list;
  for (const std::string& member : members) {
    list.push_back(cpp::View("member", member));
    list.back().set("comma", list.size() < members.size() ? ", " : "");
  }
  return list;
}

void show_state_members(const SolverScene& solver, bool has_links, bool has_slides,
                        cpp::View& view) {
  const mechanism::Want& want = solver.plan.request().want;
  const auto moving = [&](const char* place) {
    return std::vector<std::pair<std::string, bool>>{
        {place, want.position}, {"velocity", want.velocity}, {"acceleration", want.acceleration}};
  };
  auto of_output = moving("position");
  of_output.insert(of_output.end(), {{"sensitivity", solver.parameters.count() > 0},
                                     {"worst_case", solver.has_tolerances()},
                                     {"rss", solver.has_tolerances()}});
  view.set("motion_members", listed(moving("pose")));
  view.set("slide_members", listed(moving("displacement")));
  view.set("output_members", listed(of_output));
  if (stands(view, "has_coefficients")) {
    view.set("coefficient_members", listed({{"links", stands(view, "has_coefficient_links")},
                                            {"outputs", stands(view, "has_coefficient_outputs")},
                                            {"joints", stands(view, "has_coefficient_joints")}}));
  }
  view.set("state_members", listed({{"links", has_links},
                                    {"slides", has_slides},
                                    {"outputs", !solver.mechanism().outputs().empty()},
                                    {"efforts", stands(view, "has_efforts")},
                                    {"forces", stands(view, "has_joint_forces")},
                                    {"ground", stands(view, "has_forces")},
                                    {"coefficients", stands(view, "has_coefficients")},
                                    {"dynamics", stands(view, "has_dynamics")}}));
}

}  // namespace assur::generator::emission::scene
