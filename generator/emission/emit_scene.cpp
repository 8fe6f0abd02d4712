#include "emission/emit_scene.hpp"

#include <algorithm>
#include <iterator>

#include "emission/cpp_text.hpp"
#include "emission/group_numbers.hpp"
#include "emission/model_view.hpp"
#include "emission/scene_names.hpp"
#include "emission/scene_statements.hpp"
#include "emission/templates.hpp"
#include "scene/names.hpp"

namespace assur::generator {

namespace {

namespace mustache = kainjow::mustache;

mustache::data member_list(const std::vector<std::string>& members) {
  mustache::data list{mustache::data::type::list};
  for (const std::string& member : members) {
    list << mustache::data{"member", member};
  }
  return list;
}

/// Fills the view that templates/scene.hpp.mustache shows.
class SceneEmitter {
 public:
  explicit SceneEmitter(const Scene& scene) : solver_(scene) {}

  EmittedFile run() {
    show_drivers();
    for (std::size_t index = 0; index < solver_.order.groups.size(); ++index) {
      show_group(index);
    }
    show_results();
    show_scene();
    show_parameters();
    const std::string stem = std::filesystem::path(solver_.file).stem().string();
    return {std::filesystem::path("assur") / "scenes" / (c_identifier(stem) + ".hpp"),
            rendered(without_tag_lines(templates::scene_hpp), view_)};
  }

 private:
  void show_drivers() {
    mustache::data drivers{mustache::data::type::list};
    for (const DrivenLink& link : solver_.order.driven) {
      const MechanismJoint& at = solver_.joint(link.joint);
      const auto index = static_cast<std::size_t>(link.driver);
      const SceneDriver& driver = solver_.scene.drivers[index];
      std::vector<double> law = {solver_.values.value(driver.position).value(),
                                 solver_.values.value(driver.velocity).value(),
                                 solver_.values.value(driver.acceleration).value()};
      law.resize(1 + static_cast<std::size_t>(solver_.derivative_order));
      mustache::data entry;
      entry.set("member", solver_.members.drivers[index]);
      entry.set("law", joined(law, ", ",
                              [](double value) { return "Scalar(" + round_trip(value) + ")"; }));
      entry.set("meaning", comment_text(at.name + ", from " + solver_.link_name(at.first) + " to " +
                                        solver_.link_name(at.second)));
      drivers << entry;
      steps_.push_back(solver_.link_name(link.to) + ", driven at " + at.name + " from " +
                       solver_.link_name(link.from));
    }
    const PlacingStatements driving = driving_statements(solver_);
    slides_ = driving.slides;
    view_.set("driving", line_list(driving.lines, ""));
    view_.set("drivers", drivers);
    view_.set("has_drivers", !solver_.scene.drivers.empty());
    view_.set("drivers_name", solver_.scene.drivers.empty() ? "" : " drivers");
    view_.set("rates_name", solver_.derivative_order == 0 ? "" : " driver");
  }

  void show_group(std::size_t index) {
    const PosedGroup group = normal_group(solver_, index);
    const Model& model = *group.group->model;
    SpecialisedGroup special = specialised_group_of(solver_, group, index);
    const bool last = index + 1 == solver_.order.groups.size();
    special.view.set("call", "solve_group_" + std::to_string(index + 1));
    special.view.set("next_call",
                     last ? "list(next, search)"
                          : "solve_group_" + std::to_string(index + 2) + "(next, search)");
    const PlacingStatements placing = placing_statements(solver_, group);
    slides_.insert(slides_.end(), placing.slides.begin(), placing.slides.end());
    special.view.set("held", line_list(holding_statements(solver_, group), ""));
    special.view.set("placing", line_list(placing.lines, ""));
    special.view.set("operations", std::to_string(special.operations.multiplications) + ", " +
                                       std::to_string(special.operations.additions) + ", " +
                                       std::to_string(special.operations.divisions));
    groups_ << special.view;
    max_configurations_ *= special.max_configurations;
    steps_.push_back(listed(solver_.order.group_links[index]) + ": " + model.group->name() + " " +
                     spell(*model.group, group.group->kind) + ", at most " +
                     std::to_string(special.max_configurations) + " configurations");
  }

  void show_results() {
    std::vector<std::string> links;
    std::vector<std::string> moving;  // by a group
    const std::vector<bool> driven = solver_.order.placed_by_drivers();
    for (std::size_t link = 0; link < solver_.scene.links.size(); ++link) {
      const std::string& member = solver_.members.links[link];
      if (!solver_.is_ground(static_cast<int>(link))) {
        links.push_back(member);
      }
      if (!driven[link]) {
        moving.push_back(member);
      }
    }
    std::string keys;
    for (const std::string& slide : slides_) {
      keys += ", placed.slide_" + slide + ".displacement";
    }
    view_.set("links", member_list(links));
    view_.set("moving", member_list(moving));
    view_.set("moving_count", std::to_string(moving.size()));
    view_.set("slides", member_list(slides_));
    view_.set("has_slides", !slides_.empty());
    view_.set("slide_keys", keys);
    view_.set("key_size", std::to_string(4 + slides_.size()));
    view_.set("outputs", member_list(solver_.members.outputs));
    view_.set("has_outputs", !solver_.scene.outputs.empty());
    view_.set("listing", line_list(listing_statements(solver_, slides_), ""));
  }

  void show_scene() {
    const SceneWant& want = solver_.scene.want;
    const std::string& name = solver_.scene.name;
    std::vector<std::string> steps;
    std::transform(steps_.begin(), steps_.end(), std::back_inserter(steps), comment_text);
    show_partials(view_);
    view_.set("groups", groups_);
    view_.set("first_call", solver_.order.groups.empty() ? "list(placed, search)"
                                                         : "solve_group_1(placed, search)");
    view_.set("steps", line_list(steps, ""));
    view_.set("max_configurations", std::to_string(max_configurations_));
    view_.set("file", comment_text(solver_.file));
    view_.set("name", comment_text(name.empty() ? solver_.file : name));
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
    const Eigen::VectorXd& all_tolerances = solver_.values.tolerances();
    std::vector<double> tolerances;
    for (const int index : parameters.indices()) {
      tolerances.push_back(all_tolerances(index));
    }
    view_.set("sensitivity", parameters.count() > 0);
    view_.set("parameter_count", std::to_string(parameters.count()));
    view_.set("parameter_list", listed(parameters.names()));
    view_.set("parameter_strings", joined(parameters.names(), ", ", [](const std::string& name) {
                return "\"" + name + "\"";
              }));
    view_.set("tolerances", parameters.count() > 0 && !all_tolerances.isZero(0.0));
    view_.set("tolerance_list", joined(tolerances, ", ", round_trip));
  }

  SolverScene solver_;
  std::vector<std::string> slides_;  ///< members, in the order of `assur solve`
  std::vector<std::string> steps_;
  int max_configurations_ = 1;
  mustache::data view_;
  mustache::data groups_{mustache::data::type::list};
};

}  // namespace

EmittedFile emit_scene(const Scene& scene) { return SceneEmitter(scene).run(); }

}  // namespace assur::generator
