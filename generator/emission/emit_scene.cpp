#include "emission/emit_scene.hpp"

#include <algorithm>
#include <cmath>

#include "emission/cpp_text.hpp"
#include "emission/model_view.hpp"
#include "emission/scene_lines.hpp"
#include "emission/scene_names.hpp"
#include "emission/specialised_group.hpp"
#include "emission/templates.hpp"
#include "error.hpp"
#include "scene/group_pose.hpp"
#include "scene/names.hpp"
#include "scene/placement.hpp"

namespace assur::generator {

namespace {

namespace mustache = kainjow::mustache;

/// Those that have a tolerance, all if none has, and none if no sensitivity is wanted.
ModelledParameters modelled_parameters(const Scene& scene) {
  const bool any =
      std::any_of(scene.parameters.begin(), scene.parameters.end(),
                  [](const SceneParameter& parameter) { return parameter.tolerance.has_value(); });
  std::vector<int> indices;
  std::vector<std::string> names;
  for (std::size_t index = 0; index < scene.parameters.size(); ++index) {
    const SceneParameter& parameter = scene.parameters[index];
    if (scene.want.sensitivity && (parameter.tolerance.has_value() || !any)) {
      indices.push_back(static_cast<int>(index));
      names.push_back(parameter.name);
    }
  }
  return {indices, names};
}

class SceneEmitter {
 public:
  explicit SceneEmitter(const Scene& scene)
      : scene_(scene),
        values_(scene),
        order_(placement_order(scene, values_)),
        parameters_(modelled_parameters(scene)),
        derivative_order_(scene.want.acceleration ? 2
                          : scene.want.velocity   ? 1
                                                  : 0),
        file_(std::filesystem::path(scene.file).filename().string()),
        struct_(pascal_case(std::filesystem::path(scene.file).stem().string())) {
    name_members();
  }

  EmittedFile run() {
    drive_links();
    for (std::size_t index = 0; index < order_.groups.size(); ++index) {
      add_group(index);
    }
    list_results();
    show_scene();
    const std::string stem = std::filesystem::path(file_).stem().string();
    return {std::filesystem::path("assur") / "scenes" / (c_identifier(stem) + ".hpp"),
            rendered(without_tag_lines(templates::scene_hpp), view_)};
  }

 private:
  [[nodiscard]] const MechanismJoint& joint(int index) const {
    return order_.mechanism.joints[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] const std::string& link_name(int link) const {
    return order_.mechanism.links[static_cast<std::size_t>(link)];
  }
  /// `placed.crank`, or nothing for the ground, which is the frame of all.
  [[nodiscard]] std::string placed(int link) const {
    return link == order_.mechanism.ground
               ? ""
               : "placed." + link_members_[static_cast<std::size_t>(link)];
  }
  [[nodiscard]] bool is_of_scene(int link) const {
    return link < static_cast<int>(scene_.links.size());
  }
  [[nodiscard]] std::string on(const std::string& feature, int link) const {
    return feature + "_on_" + link_name(link);
  }

  /// The words of the templates, which the scene's names must not hide.
  void name_members() {
    const std::vector<std::string> taken = {"Scalar",      "LinkState",   "SlideState",
                                            "OutputState", "DriverState", "regularity",
                                            "residual"};
    std::vector<std::string> names;
    for (const SceneLink& link : scene_.links) {
      names.push_back(link.name);
    }
    link_members_ = member_names(names, taken);
    names.clear();
    for (const SceneDriver& driver : scene_.drivers) {
      names.push_back(scene_.joints[static_cast<std::size_t>(driver.joint)].name);
    }
    driver_members_ = member_names(names, taken);
    names.clear();
    for (const SceneJoint& at : scene_.joints) {
      names.push_back(at.name);
    }
    joint_members_ = member_names(names, taken);
    names.clear();
    for (const SceneOutput& output : scene_.outputs) {
      names.push_back(output.name);
    }
    output_members_ = member_names(names, taken);
  }

  void drive_links() {
    SceneLines lines(parameters_);
    drivers_ = mustache::data{mustache::data::type::list};
    for (const DrivenLink& link : order_.driven) {
      const MechanismJoint& at = joint(link.joint);
      const SceneDriver& driver = scene_.drivers[static_cast<std::size_t>(link.driver)];
      const std::string& member = driver_members_[static_cast<std::size_t>(link.driver)];
      const std::string sign = at.first == link.from ? "" : "-";
      const double sense = at.first == link.from ? 1 : -1;
      const Dual position = values_.value(driver.position);
      const std::string state = "drivers." + member;
      const std::string gradient = lines.gradient(at.name + "_gradient", sense * position);
      const std::string moved = (at.prismatic ? "sliding" : "turning") +
                                std::string("<double, order, parameter_count>(") + sign + state +
                                ".position, " + sign + "rates_of(" + state + "), " + gradient + ")";
      const std::string near = lines.frame(on(at.name, link.from), feature_frame(at, link.from));
      const std::string far =
          lines.frame(link_name(link.to) + "_on_" + at.name, own_frame(feature_frame(at, link.to)));
      lines.add(placed(link.to) + " = " + nested_frames({placed(link.from), near, moved, far}) +
                ";");
      if (at.prismatic) {
        const std::string& slide = joint_members_[static_cast<std::size_t>(at.scene_joint)];
        lines.add("placed.slide_" + slide + " = {" + state + ".position, rates_of(" + state +
                  ")};");
        slides_.push_back(slide);
      }
      show_driver(at, link, position);
      steps_.push_back(link_name(link.to) + ", driven at " + at.name + " from " +
                       link_name(link.from));
    }
    view_.set("driving", line_list(lines.lines(), ""));
  }

  /// A joint's feature as a frame of the link: a line along its x-axis, a point in the link's axes.
  static Pose<Dual> feature_frame(const MechanismJoint& at, int link) {
    const LinkFeature<Dual>& feature = at.on(link);
    return {feature.x, feature.y, at.prismatic ? feature.along : Direction<Dual>{Dual(1), Dual(0)}};
  }

  void show_driver(const MechanismJoint& at, const DrivenLink& link, const Dual& position) {
    const SceneDriver& driver = scene_.drivers[static_cast<std::size_t>(link.driver)];
    std::vector<double> law = {position.value(), values_.value(driver.velocity).value(),
                               values_.value(driver.acceleration).value()};
    law.resize(1 + static_cast<std::size_t>(derivative_order_));
    mustache::data entry;
    entry.set("member", driver_members_[static_cast<std::size_t>(link.driver)]);
    entry.set("law",
              joined(law, ", ", [](double value) { return "Scalar(" + round_trip(value) + ")"; }));
    entry.set("meaning", comment_text(at.name + ", from " + link_name(at.first) + " to " +
                                      link_name(at.second)));
    drivers_ << entry;
  }

  [[nodiscard]] PosedGroup normal_group(std::size_t index) const {
    const FoundGroup& found = order_.groups[index];
    const std::string where = scene_.file + ": links: " + listed(order_.group_links[index]) + ": ";
    if (!verdict_of(*found.model).rigid) {
      throw InputError(where + "the group is degenerate, prismatic joints over-determine its " +
                       "angles, so it has no solver");
    }
    std::string obstacle;
    std::optional<PosedGroup> group = in_normal_form(order_.mechanism, found, values_, obstacle);
    if (!group) {
      throw InputError(where + "the group is degenerate: " + obstacle);
    }
    return *group;
  }

  /// Where the ground holds a joint, a line's direction included, or nothing for moving inputs.
  void add_inputs(const MechanismJoint& at, int base, double unit, GroupNumbers& numbers) const {
    const LinkFeature<Dual>& feature = at.on(base);
    std::vector<DimensionValue<Dual>> values = {{false, feature.x, {}}, {false, feature.y, {}}};
    if (at.prismatic) {
      values.push_back({true, Dual(0), feature.along});
    }
    for (const DimensionValue<Dual>& value : values) {
      const bool fixed = base == order_.mechanism.ground;
      append(value, unit, numbers.input_gradient, fixed);
      numbers.inputs.push_back(fixed ? std::optional(in_unit(value, unit)) : std::nullopt);
    }
  }

  static DimensionValue<double> in_unit(const DimensionValue<Dual>& value, double unit) {
    return {value.is_angle,
            value.length.value() / unit,
            {value.angle.cos.value(), value.angle.sin.value()}};
  }

  /// Adds a row with the derivatives of a dimension or an input; zero where it moves.
  void append(const DimensionValue<Dual>& value, double unit, Eigen::MatrixXd& gradient,
              bool fixed) const {
    gradient.conservativeResize(gradient.rows() + 1, parameters_.count());
    const Eigen::VectorXd row = value.is_angle ? parameters_.gradient(angle_of(value.angle))
                                               : parameters_.gradient(value.length) / unit;
    gradient.row(gradient.rows() - 1) =
        (fixed ? row : Eigen::VectorXd::Zero(parameters_.count()).eval()).transpose();
  }

  /// The power of two below the longest length of a group: of its dimensions, of the arms of the
  /// moving links that hold it, and between the joints that the ground holds.
  [[nodiscard]] double unit_of(const PosedGroup& group) const {
    double longest = 0;
    for (const NormalForm<Dual>& link : group.problem.links) {
      for (int index = 0; index < link.dimension_count; ++index) {
        longest = std::max(
            longest, std::abs(link.dimensions[static_cast<std::size_t>(index)].length.value()));
      }
    }
    const LinkFeature<Dual>* first = nullptr;
    for (const auto& [at, base] : external_joints(group)) {
      const LinkFeature<Dual>& feature = at->on(base);
      const bool fixed = base == order_.mechanism.ground;
      if (fixed && first == nullptr) {
        first = &feature;
      }
      const double x = feature.x.value() - (fixed ? first->x.value() : 0);
      const double y = feature.y.value() - (fixed ? first->y.value() : 0);
      longest = std::max({longest, std::abs(x), std::abs(y)});
    }
    return longest > 0 ? std::ldexp(1.0, std::ilogb(longest)) : 1;
  }

  /// The external joints of a group in its order, each with the link that holds it.
  [[nodiscard]] std::vector<std::pair<const MechanismJoint*, int>> external_joints(
      const PosedGroup& group) const {
    std::vector<std::pair<const MechanismJoint*, int>> list;
    const Group& structure = *group.group->model->group;
    for (int index = 0; index < structure.joint_count(); ++index) {
      const Joint& wanted = structure.joints()[static_cast<std::size_t>(index)];
      if (wanted.external()) {
        const MechanismJoint& at = played_joint(order_.mechanism, *group.roles, index);
        const int inner = group.roles->links[static_cast<std::size_t>(wanted.second)];
        list.emplace_back(&at, at.first == inner ? at.second : at.first);
      }
    }
    return list;
  }

  void add_group(std::size_t index) {
    const PosedGroup group = normal_group(index);
    const Model& model = *group.group->model;
    const double unit = unit_of(group);
    GroupNumbers numbers{&model, unit, derivative_order_, {}, {}, {}, {}};
    for (const NormalForm<Dual>& link : group.problem.links) {
      for (int place = 0; place < link.dimension_count; ++place) {
        const DimensionValue<Dual>& value = link.dimensions[static_cast<std::size_t>(place)];
        numbers.dimensions.push_back(in_unit(value, unit));
        append(value, unit, numbers.dimension_gradient, true);
      }
    }
    SceneLines held(parameters_);
    int first = 0;
    for (const auto& [at, base] : external_joints(group)) {
      add_inputs(*at, base, unit, numbers);
      if (base != order_.mechanism.ground) {
        hold(*at, base, first, held);
        first += at->prismatic ? 3 : 2;
      }
    }
    const std::string number = std::to_string(index + 1);
    const std::string title = "Group " + number + ", links " +
                              comment_text(listed(order_.group_links[index])) + ", " +
                              model.title();
    SpecialisedGroup special = specialised(numbers, struct_ + "Group" + number, title, index);
    const bool last = index + 1 == order_.groups.size();
    special.view.set("call", "solve_group_" + number);
    special.view.set("next_call",
                     last ? "list(next, search)"
                          : "solve_group_" + std::to_string(index + 2) + "(next, search)");
    special.view.set("held", line_list(held.lines(), ""));
    special.view.set("placing", line_list(placing(group).lines(), ""));
    special.view.set("operations", std::to_string(special.operations.multiplications) + ", " +
                                       std::to_string(special.operations.additions) + ", " +
                                       std::to_string(special.operations.divisions));
    groups_ << special.view;
    max_configurations_ *= special.max_configurations;
    steps_.push_back(listed(order_.group_links[index]) + ": " + model.group->name() + " " +
                     spell(*model.group, group.group->kind) + ", at most " +
                     std::to_string(special.max_configurations) + " configurations");
  }

  [[nodiscard]] SpecialisedGroup specialised(const GroupNumbers& numbers, const std::string& name,
                                             const std::string& title, std::size_t index) const {
    try {
      return specialised_group(numbers, name, title);
    } catch (const InputError& error) {
      throw InputError(scene_.file + ": links: " + listed(order_.group_links[index]) + ": " +
                       error.what());
    }
  }

  void hold(const MechanismJoint& at, int base, int first, SceneLines& held) const {
    const std::string place = "<" + std::to_string(first) + ">(";
    const LinkFeature<Dual>& feature = at.on(base);
    if (at.prismatic) {
      const std::string line = held.frame(on(at.name, base), feature_frame(at, base));
      held.add("held.hold_line" + place + nested_frames({placed(base), line}) + ");");
    } else {
      const std::string point = held.point(on(at.name, base), feature.x, feature.y);
      held.add("held.hold_point" + place + "point_in(" + placed(base) + ", " + point + "));");
    }
  }

  [[nodiscard]] SceneLines placing(const PosedGroup& group) {
    SceneLines lines(parameters_);
    for (std::size_t link = 0; link < group.problem.links.size(); ++link) {
      const int played = group.roles->links[link];
      if (is_of_scene(played)) {
        const std::string own = lines.frame(link_name(played) + "_in_its_normal_frame",
                                            own_frame(group.problem.links[link].frame));
        lines.add("next." + link_members_[static_cast<std::size_t>(played)] + " = " +
                  nested_frames({"group.frames[" + std::to_string(link) + "]", own}) + ";");
      }
    }
    const ClosureEquations equations = closure_equations(*group.group->model);
    for (std::size_t index = 0; index < equations.unknowns.size(); ++index) {
      if (equations.unknowns[index].is_angle()) {
        continue;
      }
      const int owner = equations.owners[index];
      const MechanismJoint& at = played_joint(order_.mechanism, *group.roles, owner);
      const auto [sense, shift] = slide_measure(order_.mechanism, group, owner, values_);
      const std::string sign = sense < 0 ? "-" : "";
      const std::string& slide = joint_members_[static_cast<std::size_t>(at.scene_joint)];
      const std::string shifted = shift.value() == 0
                                      ? "Group::unit * q." + equations.unknowns[index].name
                                      : "(Group::unit * q." + equations.unknowns[index].name +
                                            " + " + round_trip(shift.value()) + ")";
      lines.add("next.slide_" + slide + ".displacement = " + sign + shifted + ";");
      lines.add("next.slide_" + slide + ".rates = " + sign + "Group::unit * group.rates.row(" +
                std::to_string(index) + ");");
      slides_.push_back(slide);
    }
    return lines;
  }

  void list_results() {
    SceneLines lines(parameters_);
    mustache::data links{mustache::data::type::list};
    mustache::data moving{mustache::data::type::list};
    const std::vector<bool> driven = order_.placed_by_drivers();
    int moving_count = 0;
    for (std::size_t link = 0; link < scene_.links.size(); ++link) {
      const std::string& member = link_members_[link];
      if (static_cast<int>(link) == order_.mechanism.ground) {
        continue;
      }
      lines.add("state.links." + member + " = state_of(placed." + member + ");");
      links << mustache::data{"member", member};
      if (!driven[link]) {
        moving << mustache::data{"member", member};
        ++moving_count;
      }
    }
    view_.set("links", links);
    view_.set("moving", moving);
    view_.set("moving_count", std::to_string(moving_count));
    mustache::data slides{mustache::data::type::list};
    std::string keys;
    for (const std::string& slide : slides_) {
      lines.add("state.slides." + slide + " = state_of(placed.slide_" + slide + ");");
      slides << mustache::data{"member", slide};
      keys += ", placed.slide_" + slide + ".displacement";
    }
    view_.set("slides", slides);
    view_.set("has_slides", !slides_.empty());
    view_.set("slide_keys", keys);
    view_.set("key_size", std::to_string(4 + slides_.size()));
    mustache::data outputs{mustache::data::type::list};
    for (std::size_t index = 0; index < scene_.outputs.size(); ++index) {
      const SceneOutput& output = scene_.outputs[index];
      const SceneFeature& feature = scene_.feature(output.point);
      const std::string point = lines.point(on(feature.name, output.point.link),
                                            values_.value(feature.x), values_.value(feature.y));
      const std::string& base = placed(output.point.link);
      lines.add("state.outputs." + output_members_[index] + " = state_of(" +
                (base.empty() ? point : "point_in(" + base + ", " + point + ")") + ");");
      outputs << mustache::data{"member", output_members_[index]};
    }
    view_.set("outputs", outputs);
    view_.set("has_outputs", !scene_.outputs.empty());
    view_.set("listing", line_list(lines.lines(), ""));
  }

  void show_scene() {
    const SceneWant& want = scene_.want;
    show_partials(view_);
    view_.set("groups", groups_);
    view_.set("file", comment_text(file_));
    view_.set("name", comment_text(scene_.name.empty() ? file_ : scene_.name));
    view_.set("struct", struct_);
    view_.set("drivers", drivers_);
    view_.set("has_drivers", !scene_.drivers.empty());
    view_.set("drivers_name", scene_.drivers.empty() ? "" : " drivers");
    view_.set("rates_name", derivative_order_ == 0 ? "" : " driver");
    view_.set("first_call",
              order_.groups.empty() ? "list(placed, search)" : "solve_group_1(placed, search)");
    view_.set("steps", line_list(commented(steps_), ""));
    view_.set("max_configurations", std::to_string(max_configurations_));
    view_.set("order", std::to_string(derivative_order_));
    view_.set("first_order", derivative_order_ > 0);
    view_.set("second_order", derivative_order_ > 1);
    view_.set("position", want.position);
    view_.set("velocity", want.velocity);
    view_.set("acceleration", want.acceleration);
    view_.set("sensitivity", parameters_.count() > 0);
    view_.set("parameter_count", std::to_string(parameters_.count()));
    view_.set("parameter_list", listed(parameters_.names()));
    view_.set("parameter_strings", joined(parameters_.names(), ", ", [](const std::string& name) {
                return "\"" + name + "\"";
              }));
    std::vector<double> tolerances;
    for (const int index : parameters_.indices()) {
      tolerances.push_back(values_.tolerances()(index));
    }
    const bool any = parameters_.count() > 0 && !values_.tolerances().isZero(0.0);
    view_.set("tolerances", any);
    view_.set("tolerance_list", joined(tolerances, ", ", round_trip));
  }

  static std::vector<std::string> commented(std::vector<std::string> texts) {
    std::transform(texts.begin(), texts.end(), texts.begin(), comment_text);
    return texts;
  }

  const Scene& scene_;
  ParameterValues values_;
  PlacementOrder order_;
  ModelledParameters parameters_;
  int derivative_order_;
  std::string file_;
  std::string struct_;
  std::vector<std::string> link_members_, driver_members_, joint_members_, output_members_;
  std::vector<std::string> slides_;  ///< members, in the order of `assur solve`
  std::vector<std::string> steps_;
  int max_configurations_ = 1;
  mustache::data view_;
  mustache::data drivers_{mustache::data::type::list};
  mustache::data groups_{mustache::data::type::list};
};

}  // namespace

EmittedFile emit_scene(const Scene& scene) { return SceneEmitter(scene).run(); }

}  // namespace assur::generator
