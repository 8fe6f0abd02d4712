#include "emission/scene/emit_scene.hpp"

#include <algorithm>
#include <array>
#include <assur/directions.hpp>
#include <assur/text/identifiers.hpp>
#include <assur/text/names.hpp>
#include <functional>
#include <iterator>
#include <set>

#include "emission/cpp/cpp_text.hpp"
#include "emission/cpp/statement_text.hpp"
#include "emission/model/model_view.hpp"
#include "emission/scene/c_interface.hpp"
#include "emission/scene/constraint_statements.hpp"
#include "emission/scene/equilibrium_statements.hpp"
#include "emission/scene/followed_angles.hpp"
#include "emission/scene/force_statements.hpp"
#include "emission/scene/limit_statements.hpp"
#include "emission/scene/link_loads.hpp"
#include "emission/scene/listing_statements.hpp"
#include "emission/scene/motion_statements.hpp"
#include "emission/scene/redundancy_tests.hpp"
#include "emission/scene/scene_statements.hpp"
#include "emission/scene/specialised_numbers.hpp"
#include "emission/scene/state_members.hpp"

namespace assur::generator::emission::scene {

namespace {

/// Whether an expression is a member of `placed`.
bool is_placed(const cpp::Expression& part, const std::string& member) {
  return part.form == cpp::Expression::Form::member && part.text == member &&
         part.parts[0].text == "placed";
}

/// Whether an expression is a row of rates that are assigned one by one, or contains a number as a
/// rate: then not all rates follow from arguments.
bool is_own_rate(const cpp::Expression& part) {
  const bool is_row = part.form == cpp::Expression::Form::member && part.text == "row" &&
                      part.parts[0].text == "rates";
  return is_row || is_placed(part, "given_rates") ||
         (part.name.text == "Rates" &&
          std::ranges::any_of(part.parts,
                              [](const cpp::Expression& rate) { return rate.is_number(); }));
}

/// Whether an expression is `placed.drivers`.
bool is_placed_drivers(const cpp::Expression& part) { return is_placed(part, "drivers"); }

/// Fills the view of templates/scene.hpp.mustache.
class SceneEmitter {
 public:
  explicit SceneEmitter(const mechanism::Scene& scene) : solver_(scene) {}

  std::vector<cpp::EmittedFile> run(const std::string& options, Interface interface) {
    view_.set("options", options);
    expect_listable(solver_.plan);
    show_drivers();
    show_variables();
    for (const mechanism::GroupIndex group : solver_.plan.structure().groups.keys()) {
      show_group(group);
    }
    show_results();
    show_order();
    show_reference();
    show_scene();
    show_parameters();
    show_aliases();
    const std::string stem = std::filesystem::path(solver_.file).stem().string();
    const std::string name = text::header_name(stem);
    const std::filesystem::path header =
        std::filesystem::path("assur") / "scenes" / (name + ".hpp");
    view_.set("header", name);
    std::vector<cpp::EmittedFile> files = {{header, cpp::page("scene.hpp", view_)}};
    if (interface != Interface::cpp) {
      const auto of_c = c_interface(header, view_, solver_.parameters.names(), branch_numbers_,
                                    interface == Interface::c ? "double" : "float");
      files.insert(files.end(), of_c.begin(), of_c.end());
    }
    return files;
  }

 private:
  /// Shows statements under a name, and whether there are any.
  void show(const std::string& name, const cpp::Block& block) {
    view_.set("has_" + name, !block.empty());
    view_.set(name, shown(block));
  }
  /// Statements of a function; kept to find what they use.
  [[nodiscard]] cpp::View::List shown(const cpp::Block& block) {
    statements_.insert(statements_.end(), block.begin(), block.end());
    return cpp::line_list(cpp::printed(block), "");
  }

  void show_drivers() {
    cpp::View::List drivers;
    std::vector<std::string> names;
    std::vector<std::string> turning;
    std::vector<std::string> sliding;
    for (const mechanism::CarriedLink& link : solver_.plan.structure().carried) {
      if (!link.driver.exists()) {
        continue;
      }
      const mechanism::ElementaryJoint& at = solver_.joint(link.joint);
      const mechanism::JointMotion& motion = solver_.values.motion(link.driver);
      std::vector<double> law = {motion.position.value(), motion.velocity, motion.acceleration};
      law.erase(law.begin() + 1 + solver_.derivative_order, law.end());
      steps_.push_back(solver_.link_name(link.to) + ", driven at " + at.name + " from " +
                       solver_.link_name(link.from));
      if (!solver_.is_argument(link.driver)) {
        continue;
      }
      cpp::View entry;
      names.push_back(solver_.members.drivers[link.driver]);
      (at.prismatic ? sliding : turning).push_back(names.back());
      entry.set("member", names.back());
      entry.set("law", text::joined(law, ", ", [](double value) {
                  return "Scalar(" + cpp::round_trip(value) + ")";
                }));
      entry.set("meaning", cpp::comment_text(at.name + ", from " + solver_.link_name(at.first) +
                                             " to " + solver_.link_name(at.second)));
      drivers.push_back(entry);
    }
    const PlacingStatements driving = driving_statements(solver_);
    slides_ = driving.slides;
    view_.set("driving", shown(driving.block));
    view_.set("drivers", drivers);
    view_.set("driver_list", text::joined(names, ", ", std::identity()));
    view_.set("driver_count", std::to_string(names.size()));
    branch_numbers_ += 1 + 2 * names.size();
    view_.set("turning_drivers", std::to_string(turning.size()));
    bool has_laws = false;
    for (const mechanism::DriverIndex driver : solver_.mechanism().drivers().keys()) {
      has_laws = has_laws || !solver_.is_argument(driver);
    }
    view_.set("has_laws", has_laws);
    turning.insert(turning.end(), sliding.begin(), sliding.end());
    view_.set("driver_positions", text::joined(turning, ", ", [](const std::string& name) {
                return "&" + name + ".position";
              }));
    std::vector<std::string> rates;
    for (const std::string& name : turning) {
      for (int order = 0; order < solver_.derivative_order; ++order) {
        rates.push_back("&" + name + (order == 0 ? ".velocity" : ".acceleration"));
      }
    }
    view_.set("rate_count", std::to_string(rates.size()));
    view_.set("driver_rates", text::joined(rates, ", "));
    view_.set("has_drivers", !names.empty());
    view_.set("drivers_name", names.empty() ? "" : " drivers");
    view_.set("driven_name", names.empty() && solver_.variable.empty() ? "" : " placed");
  }

  void show_variables() {
    cpp::View::List variables;
    for (const VariableParameter& parameter : solver_.variable) {
      cpp::View entry;
      entry.set("member", parameter.member);
      entry.set("value", cpp::round_trip(solver_.values.parameter(parameter.index)));
      variables.push_back(entry);
    }
    view_.set("variables", variables);
    view_.set("variable_count", std::to_string(variables.size()));
    branch_numbers_ += 2 * variables.size();
    view_.set("variable_list",
              text::joined(solver_.variable, ", ",
                           [](const VariableParameter& one) { return "&" + one.member; }));
    view_.set("variable_members",
              text::joined(solver_.variable, ", ",
                           [](const VariableParameter& one) { return one.member; }));
    view_.set("batch_values", variables.empty() ? "{}" : "values");
    view_.set("variable_option", variables.empty() ? "" : " --variable " + variable_names());
    view_.set("has_variables", !variables.empty());
    view_.set("call_given", variables.empty() ? "drivers" : "drivers, values");
    view_.set("given", variables.empty() ? "drivers" : "{drivers, values}");
    view_.set("given_list", variables.empty() ? "const Drivers<Scalar>& drivers"
                                              : "const Drivers<Scalar>& drivers, const "
                                                "Parameters<Scalar>& values");
  }

  /// The names in the syntax of the command's option.
  [[nodiscard]] std::string variable_names() const {
    return cpp::comment_text(
        text::joined(solver_.variable, ",", [this](const VariableParameter& one) {
          return solver_.mechanism().parameters()[one.index].name;
        }));
  }

  void show_group(mechanism::GroupIndex group) {
    const structure::Model& model = symbolic_model(solver_.group(group));
    SpecialisedGroup special = specialised_group_of(solver_, group);
    const PlacingStatements placing = placing_statements(solver_, group, special);
    slides_.insert(slides_.end(), placing.slides.begin(), placing.slides.end());
    const cpp::Block held = holding_statements(solver_, group);
    special.view.set("held", shown(held));
    special.view.set("base_name", cpp::reads(held, "placed") ? " placed" : "");
    special.view.set("held_name", held.empty() ? "" : " held");
    special.view.set("placing", shown(placing.block));
    first_key_ = order_key(group, special);
    groups_.push_back(special.view);
    structs_.push_back(solver_.group_struct(group));
    max_configurations_ *= special.max_configurations;
    branch_numbers_ += special.branch_numbers;
    steps_.push_back(text::listed(solver_.plan.structure().names_of(solver_.group(group).links)) +
                     relative_to(group) + ": " + model.group->name() + " " +
                     solver_.group(group).kind + ", at most " +
                     std::to_string(special.max_configurations) + " configurations");
  }

  /// Text after the links of a group.
  [[nodiscard]] std::string relative_to(mechanism::GroupIndex group) const {
    const mechanism::LinkIndex base = solver_.group(group).base;
    return base.exists() ? ", relative to " + solver_.link_name(base) : "";
  }

  /// Shows the contents of a state, and what the search places.
  void show_results() {
    std::vector<std::string> links;
    cpp::Block placed;
    const auto place = [&placed](const cpp::Name& type, const std::string& member) {
      placed.push_back(cpp::declared(type, cpp::variable(member)));
    };
    for (const mechanism::LinkIndex link : solver_.mechanism().links().keys()) {
      const std::string& member = solver_.members.links[link];
      if (solver_.reports(link)) {
        links.push_back(member);
      }
    }
    for (const mechanism::LinkIndex link : solver_.plan.structure().linkage.links.keys()) {
      const std::string& member = solver_.members.links[link];
      if (!solver_.is_ground(link) && solver_.needs[link] != FrameNeed::nothing) {
        const bool whole = solver_.needs[link] == FrameNeed::everything;
        place(whole ? cpp::alias("LinkFrame") : cpp::Name("Direction<Scalar>"), member);
      }
      if (const std::string& relative = solver_.members.relative[link]; !relative.empty()) {
        place(cpp::alias("LinkFrame"), relative);
      }
    }
    std::vector<std::string> reported;
    for (const mechanism::JointIndex joint : solver_.mechanism().joints().keys()) {
      const std::string& member = solver_.members.joints[joint];
      if (std::find(slides_.begin(), slides_.end(), member) != slides_.end() &&
          solver_.reports(joint)) {
        reported.push_back(member);
      }
    }
    for (const std::string& slide : slides_) {
      place(cpp::alias("LinkSlide"), "slide_" + slide);
    }
    if (solver_.keeps_groups()) {
      for (const mechanism::GroupIndex group : solver_.plan.structure().groups.keys()) {
        place("support::SolvedGroup<" + solver_.group_struct(group) + ", Scalar>",
              solver_.members.solved[group]);
      }
    }
    const cpp::Block forces = force_statements(solver_);
    show("force_finding", forces);
    view_.set("has_directed_springs", has_directed_springs(forces));
    view_.set("together_finding", shown(equilibrium_statements(solver_)));
    show_force_members(solver_, view_);
    const cpp::Block moving = show_motions(solver_, view_);
    statements_.insert(statements_.end(), moving.begin(), moving.end());
    view_.set("placed", shown(placed));
    view_.set("keeps_drivers",
              solver_.wants_coordinates() || cpp::any_part(statements_, is_placed_drivers));
    view_.set("links", member_list(links));
    view_.set("has_links", !links.empty());
    const cpp::Block limits = limit_statements(solver_);
    const auto& redundant = solver_.plan.redundant();
    view_.set("has_redundant", !redundant.empty());
    view_.set("redundant_list", cpp::comment_text(text::joined(
                                    redundant, ", ", [](const auto& one) { return one.name; })));
    view_.set("limited", limits.empty() ? "" : "Limited");
    show("limits", limits);
    show("redundant_gap", redundant_gap(solver_));
    show("settling", settling_statements(solver_, slides_));
    const std::size_t followed = followed_angles(solver_).size();
    branch_numbers_ += followed;
    view_.set("followed_count", std::to_string(followed));
    show("following", following_statements(solver_));
    view_.set("slides", member_list(reported));
    view_.set("has_slides", !reported.empty());
    view_.set("outputs", member_list(solver_.members.outputs.items()));
    view_.set("has_outputs", !solver_.mechanism().outputs().empty());
    view_.set("listing", shown(listing_statements(solver_, reported)));
    show_state_members(solver_, !links.empty(), !reported.empty(), view_);
    view_.set("has_own_rates", cpp::any_part(statements_, is_own_rate));
    const auto& groups = solver_.plan.structure().groups;
    const bool has_loop_groups = std::ranges::any_of(
        groups, [](const mechanism::FoundGroup& group) { return group.model->is_derived(); });
    view_.set("has_loop_groups", has_loop_groups);
    view_.set("in_packs", cpp::boolean(redundant.empty() && !solver_.wants_coordinates() &&
                                       !has_loop_groups && cpp::serves_packs(statements_)));
  }

  /// For each group the groups that hold it, directly or through others, as an integer with one bit
  /// for each.
  [[nodiscard]] std::vector<std::string> holders() const {
    const auto& groups = solver_.plan.structure().groups;
    std::vector<std::uint64_t> sets;
    for (const mechanism::GroupIndex group : groups.keys()) {
      std::uint64_t holders = 0;
      for (const mechanism::GroupIndex before : solver_.plan.structure().holders_of(group)) {
        holders |= sets[before.place()] | std::uint64_t{1} << before.place();
      }
      sets.push_back(holders);
    }
    std::vector<std::string> numbers;
    std::transform(sets.begin(), sets.end(), std::back_inserter(numbers),
                   [](std::uint64_t set) { return std::to_string(set) + "U"; });
    return numbers;
  }

  /// The index of the first entry of the solver's key that may differ. If the only group has two
  /// links, in frames parallel to their normal frames, and carries no other link, the cosine of
  /// their angle has the indices 0 to 2 and its sine 3.
  [[nodiscard]] std::size_t order_key(mechanism::GroupIndex group,
                                      const SpecialisedGroup& special) const {
    const auto& links = solver_.numbers.group(group).links;
    const bool in_line = std::all_of(links.begin(), links.end(), [](const auto& link) {
      const SceneNumber& sine = link.frame.direction.sin;
      return !may_change(sine) && sine.value() == 0;
    });
    const mechanism::Structure& structure = solver_.plan.structure();
    const bool is_alone = structure.groups.size() == 1 && links.size() == 2 &&
                          structure.named_parts(solver_.mechanism()).links.size() == 2;
    return is_alone && in_line && special.first_key == 1 ? 3 : 0;
  }

  /// Shows how configurations are distinguished.
  void show_order() {
    const mechanism::NamedParts parts = solver_.plan.structure().named_parts(solver_.mechanism());
    std::vector<std::string> moving;
    for (const mechanism::LinkIndex link : parts.links) {
      const bool whole = solver_.needs[link] == FrameNeed::everything;
      moving.push_back("placed." + solver_.members.links[link] + (whole ? ".pose.direction" : ""));
    }
    cpp::View::List keys;
    for (const mechanism::NamedSlide& slide : parts.slides) {
      cpp::View key;
      key.set("place", std::to_string(keys.size()));
      key.set("sign", slide.sense < 0 ? "-" : "");
      key.set("member", solver_.members.joints[slide.joint]);
      keys.push_back(key);
    }
    view_.set("first_key", std::to_string(first_key_));
    view_.set("moving_list", text::joined(moving, ", "));
    view_.set("first_moving", moving.empty() ? "Direction<Scalar>{}" : moving.front());
    view_.set("turning_name", moving.empty() ? "" : " placed");
    view_.set("moving_count", std::to_string(moving.size()));
    view_.set("keyed_name", moving.empty() && keys.empty() ? "" : " placed");
    view_.set("slide_keys", keys);
    view_.set("keyed_slides", std::to_string(parts.slides.size()));
  }

  void show_scene() {
    const mechanism::Want& want = solver_.plan.request().want;
    const std::string& name = solver_.mechanism().name();
    std::vector<std::string> steps;
    std::transform(steps_.begin(), steps_.end(), std::back_inserter(steps), cpp::comment_text);
    view_.set("groups", groups_);
    view_.set("group_list", text::joined(structs_, ", "));
    view_.set("group_count", std::to_string(structs_.size()));
    view_.set("holders", text::joined(holders(), ", "));
    view_.set("has_holders", structs_.size() > 1);
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

  /// Short names of the types that the statements use.
  void show_aliases() {
    const std::vector<std::pair<std::string, std::string>> aliases = {
        {"LinkCoordinate", "support::Coordinate<Scalar, order, parameter_count>"},
        {"LinkFrame", "support::Frame<Scalar, order, parameter_count>"},
        {"LinkLoad", "support::LinkLoad<Scalar>"},
        {"LinkPoint", "support::Point<Scalar, order, parameter_count>"},
        {"LinkSlide", "support::Slide<Scalar, order>"},
        {"ParameterRow", "Matrix<Scalar, 1, parameter_count>"},
        {"Rates", "Matrix<Scalar, 1, order>"}};
    const std::set<std::string> used = cpp::aliases_in(statements_);
    std::vector<std::string> lines;
    for (const auto& [name, type] : aliases) {
      if (used.contains(name)) {
        lines.push_back("using " + name + " = " + type + ";");
      }
    }
    view_.set("aliases", cpp::line_list(lines, ""));
  }

  /// Shows the angles that distinguish one configuration from the others, if their links are
  /// reported. A drawing gives the angles of all links; only the reported ones are available.
  void show_reference() {
    const mechanism::Request& request = solver_.plan.request();
    std::vector<std::string> names;
    std::vector<std::string> angles;
    for (const mechanism::ReferenceAngle& angle : request.reference) {
      if (request.want.position && request.drawn && !solver_.reports(angle.link)) {
        continue;
      }
      if (!request.want.position || !solver_.reports(angle.link)) {
        names.clear();
        break;
      }
      const Direction<double> wanted = direction_of(solver_.values.number(angle.theta).value());
      names.push_back(solver_.link_name(angle.link));
      angles.push_back("angle_of(turned(links." + solver_.members.links[angle.link] +
                       ".pose.direction, {Scalar(" + cpp::round_trip(wanted.cos) + "), Scalar(" +
                       cpp::round_trip(-wanted.sin) + ")}))");
    }
    view_.set("has_reference", !names.empty());
    view_.set("reference_list", cpp::comment_text(text::listed(names)));
    view_.set("reference_count", std::to_string(names.size()));
    view_.set("reference_angles", cpp::line_list(angles, ""));
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
    view_.set("tolerances", solver_.has_tolerances());
    view_.set("tolerance_list", text::joined(tolerances, ", ", cpp::round_trip));
  }

  SolverScene solver_;
  std::vector<std::string> slides_;   ///< members, in the order in which they are placed
  cpp::Block statements_;             ///< of all functions
  std::vector<std::string> structs_;  ///< of the groups
  std::vector<std::string> steps_;
  std::size_t max_configurations_ = 1;
  std::size_t branch_numbers_ = 0;
  std::size_t first_key_ = 0;
  cpp::View view_;
  cpp::View::List groups_;
};

}  // namespace

std::vector<cpp::EmittedFile> emit_scene(const mechanism::Scene& scene, const std::string& options,
                                         Interface interface) {
  return SceneEmitter(scene).run(options, interface);
}

}  // namespace assur::generator::emission::scene
