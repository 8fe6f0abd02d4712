#include "emission/scene/emit_scene.hpp"

#include <algorithm>
#include <assur/support/configuration_order.hpp>
#include <assur/text/identifiers.hpp>
#include <assur/text/names.hpp>
#include <iterator>

#include "emission/cpp/cpp_text.hpp"
#include "emission/model/model_view.hpp"
#include "emission/scene/group_numbers.hpp"
#include "emission/scene/scene_statements.hpp"

namespace assur::generator::emission::scene {

namespace {

cpp::View::List member_list(const std::vector<std::string>& members) {
  cpp::View::List list;
  for (const std::string& member : members) {
    list.push_back(cpp::View("member", member));
  }
  return list;
}

/// Fills the view that templates/scene.hpp.mustache shows.
class SceneEmitter {
 public:
  explicit SceneEmitter(const mechanism::Scene& scene) : solver_(scene) {}

  cpp::EmittedFile run() {
    show_drivers();
    for (const mechanism::GroupIndex group : solver_.plan.structure().groups.keys()) {
      show_group(group);
    }
    show_results();
    show_scene();
    show_parameters();
    const std::string stem = std::filesystem::path(solver_.file).stem().string();
    return {std::filesystem::path("assur") / "scenes" / (text::c_identifier(stem) + ".hpp"),
            cpp::page("scene.hpp", view_)};
  }

 private:
  void show_drivers() {
    cpp::View::List drivers;
    for (const mechanism::DrivenLink& link : solver_.plan.structure().driven) {
      const mechanism::ElementaryJoint& at = solver_.joint(link.joint);
      const mechanism::Driver& driver = solver_.mechanism().drivers()[link.driver];
      std::vector<double> law = {solver_.values.number(driver.position).value(),
                                 solver_.values.number(driver.velocity).value(),
                                 solver_.values.number(driver.acceleration).value()};
      law.erase(law.begin() + 1 + solver_.derivative_order, law.end());
      cpp::View entry;
      entry.set("member", solver_.members.drivers[link.driver]);
      entry.set("law", text::joined(law, ", ", [](double value) {
                  return "Scalar(" + cpp::round_trip(value) + ")";
                }));
      entry.set("meaning", cpp::comment_text(at.name + ", from " + solver_.link_name(at.first) +
                                             " to " + solver_.link_name(at.second)));
      drivers.push_back(entry);
      steps_.push_back(solver_.link_name(link.to) + ", driven at " + at.name + " from " +
                       solver_.link_name(link.from));
    }
    const PlacingStatements driving = driving_statements(solver_);
    slides_ = driving.slides;
    view_.set("driving", cpp::line_list(driving.lines, ""));
    view_.set("drivers", drivers);
    view_.set("has_drivers", !solver_.mechanism().drivers().empty());
    view_.set("drivers_name", solver_.mechanism().drivers().empty() ? "" : " drivers");
    view_.set("rates_name", solver_.derivative_order == 0 ? "" : " driver");
  }

  void show_group(mechanism::GroupIndex group) {
    const structure::Model& model = derived_model(solver_.group(group));
    SpecialisedGroup special = specialised_group_of(solver_, group);
    const std::size_t number = group.place() + 1;
    const bool last = number == solver_.plan.structure().groups.size();
    special.view.set("call", "solve_group_" + std::to_string(number));
    special.view.set("next_call",
                     last ? "list(next, search)"
                          : "solve_group_" + std::to_string(number + 1) + "(next, search)");
    const PlacingStatements placing = placing_statements(solver_, group);
    slides_.insert(slides_.end(), placing.slides.begin(), placing.slides.end());
    special.view.set("held", cpp::line_list(holding_statements(solver_, group), ""));
    special.view.set("placing", cpp::line_list(placing.lines, ""));
    special.view.set("operations", std::to_string(special.operations.multiplications) + ", " +
                                       std::to_string(special.operations.additions) + ", " +
                                       std::to_string(special.operations.divisions));
    groups_.push_back(special.view);
    max_configurations_ *= special.max_configurations;
    steps_.push_back(text::listed(solver_.plan.structure().names_of(solver_.group(group).links)) +
                     ": " + model.group->name() + " " + solver_.group(group).kind + ", at most " +
                     std::to_string(special.max_configurations) + " configurations");
  }

  void show_results() {
    std::vector<std::string> links;
    for (const mechanism::LinkIndex link : solver_.mechanism().links().keys()) {
      if (!solver_.is_ground(link)) {
        links.push_back(solver_.members.links[link]);
      }
    }
    const mechanism::NamedParts parts = solver_.plan.structure().named_parts(solver_.mechanism());
    std::vector<std::string> moving;
    for (const mechanism::LinkIndex link : parts.links) {
      moving.push_back(solver_.members.links[link]);
    }
    const std::size_t turning_key_size = support::turning_key_size(moving.size());
    cpp::View::List keys;
    for (const mechanism::NamedSlide& slide : parts.slides) {
      cpp::View key;
      key.set("place", std::to_string(turning_key_size + keys.size()));
      key.set("sign", slide.sense < 0 ? "-" : "");
      key.set("member", solver_.members.joints[slide.joint]);
      keys.push_back(key);
    }
    view_.set("links", member_list(links));
    view_.set("moving", member_list(moving));
    view_.set("moving_count", std::to_string(moving.size()));
    view_.set("slides", member_list(slides_));
    view_.set("has_slides", !slides_.empty());
    view_.set("slide_keys", keys);
    view_.set("turning_key_size", std::to_string(turning_key_size));
    view_.set("key_size", std::to_string(turning_key_size + parts.slides.size()));
    view_.set("outputs", member_list(solver_.members.outputs.items()));
    view_.set("has_outputs", !solver_.mechanism().outputs().empty());
    view_.set("listing", cpp::line_list(listing_statements(solver_, slides_), ""));
  }

  void show_scene() {
    const mechanism::Want& want = solver_.plan.request().want;
    const std::string& name = solver_.mechanism().name();
    std::vector<std::string> steps;
    std::transform(steps_.begin(), steps_.end(), std::back_inserter(steps), cpp::comment_text);
    view_.set("groups", groups_);
    view_.set("first_call", solver_.plan.structure().groups.empty()
                                ? "list(placed, search)"
                                : "solve_group_1(placed, search)");
    view_.set("steps", cpp::line_list(steps, ""));
    view_.set("max_configurations", std::to_string(max_configurations_));
    view_.set("file", cpp::comment_text(solver_.file));
    view_.set("name", cpp::comment_text(name.empty() ? solver_.file : name));
    view_.set("struct", solver_.structure);
    view_.set("order", std::to_string(solver_.derivative_order));
    view_.set("first_order", solver_.derivative_order > 0);
    view_.set("second_order", solver_.derivative_order > 1);
    view_.set("position", want.position);
    view_.set("velocity", want.velocity);
    view_.set("acceleration", want.acceleration);
  }

  void show_parameters() {
    const ModelledParameters& parameters = solver_.parameters;
    const Eigen::VectorXd& all_tolerances = solver_.values.spread().tolerances;
    std::vector<double> tolerances;
    for (const Eigen::Index column : parameters.columns()) {
      const mechanism::ParameterIndex parameter =
          *std::next(solver_.values.columns().begin(), column);
      tolerances.push_back(all_tolerances(parameter.row()));
    }
    view_.set("sensitivity", parameters.count() > 0);
    view_.set("parameter_count", std::to_string(parameters.count()));
    view_.set("parameter_list", text::listed(parameters.names()));
    view_.set("parameter_strings",
              text::joined(parameters.names(), ", ",
                           [](const std::string& name) { return "\"" + name + "\""; }));
    view_.set("tolerances", parameters.count() > 0 && !all_tolerances.isZero(0.0));
    view_.set("tolerance_list", text::joined(tolerances, ", ", cpp::round_trip));
  }

  SolverScene solver_;
  std::vector<std::string> slides_;  ///< members, in the order of `assur solve`
  std::vector<std::string> steps_;
  std::size_t max_configurations_ = 1;
  cpp::View view_;
  cpp::View::List groups_;
};

}  // namespace

cpp::EmittedFile emit_scene(const mechanism::Scene& scene) { return SceneEmitter(scene).run(); }

}  // namespace assur::generator::emission::scene
