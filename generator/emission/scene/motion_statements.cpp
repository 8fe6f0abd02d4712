#include "emission/scene/motion_statements.hpp"

#include <algorithm>
#include <assur/mechanism/forces.hpp>
#include <assur/text/names.hpp>
#include <map>

#include "emission/cpp/statement_text.hpp"
#include "emission/scene/carried_links.hpp"
#include "emission/scene/link_loads.hpp"
#include "emission/scene/state_members.hpp"
#include "emission/scene/told_joints.hpp"

namespace assur::generator::emission::scene {

namespace {

using mechanism::DriverIndex;
using mechanism::LinkIndex;
using mechanism::OutputIndex;

/// A few numbers with rates: a frame, a point, or the coordinate of a joint.
struct Rated {
  std::size_t first;    ///< the index of the first number among all
  std::size_t numbers;  ///< 3, 2 or 1
  /// `<0, 3>`, the template arguments that select them from the list of all.
  [[nodiscard]] std::string range() const {
    return "<" + std::to_string(first) + ", " + std::to_string(numbers) + ">";
  }
};

cpp::Expression from(const cpp::Expression& motions, const std::string& function,
                     const Rated& rated, std::vector<cpp::Expression> arguments = {}) {
  return motions.member("template " + function + rated.range()).at(std::move(arguments));
}

class MotionStatements {
 public:
  explicit MotionStatements(const SolverScene& solver)
      : solver_(solver),
        want_(solver.plan.request().want),
        rates_(solver.body()),
        finding_(solver.body()) {}

  void run() {
    finding_.add(
        cpp::declared("const auto", motions_,
                      cpp::call("support::CoordinateMotions<" + solver_.structure + ", Scalar>",
                                {cpp::variable("placed")})));
    if (want_.coefficients) {
      add_coefficients();
    }
    if (want_.dynamics) {
      add_dynamics();
    }
  }

  /// The statements that list the rates of all numbers.
  [[nodiscard]] cpp::Block rates() const { return rates_.block(); }
  [[nodiscard]] std::size_t rated_numbers() const { return rated_numbers_; }
  [[nodiscard]] cpp::Block finding() { return behind_joints_read(solver_, finding_); }
  [[nodiscard]] const std::vector<std::string>& links() const { return links_; }
  [[nodiscard]] const std::vector<std::string>& joints() const { return joints_; }

 private:
  [[nodiscard]] LinkIndex link_of(mechanism::FeatureIndex feature) const {
    return solver_.mechanism().features()[feature].link;
  }
  /// Adds statements that list the rates.
  Rated rated(const cpp::Expression& rates, std::size_t numbers) {
    const Rated result{rated_numbers_, numbers};
    rates_.add(cpp::called(cpp::call("support::put_rates<" + std::to_string(result.first) + ">",
                                     {rates, cpp::variable("rates")})));
    rated_numbers_ += numbers;
    return result;
  }
  const Rated& rated(LinkIndex link) {
    const auto known = of_links_.find(link);
    return known != of_links_.end()
               ? known->second
               : of_links_.emplace(link, rated(solver_.placed(link)->member("rates"), 3))
                     .first->second;
  }

  void tell(const std::string& part, const std::string& member, const Rated& rated) {
    finding_.add(
        cpp::assigned(cpp::variable("state").member("coefficients").member(part).member(member),
                      from(motions_, "coefficients", rated, {second_})));
  }

  void add_coefficients() {
    finding_.add(cpp::declared("const auto", second_, motions_.member("second").at({})));
    for (const LinkIndex link : solver_.mechanism().links().keys()) {
      if (!solver_.is_ground(link) && solver_.plan.request().reported.has(link)) {
        links_.push_back(solver_.members.links[link]);
        tell("links", links_.back(), rated(link));
      }
    }
    for (const OutputIndex index : solver_.mechanism().outputs().keys()) {
      const mechanism::Feature& feature =
          solver_.mechanism().features()[solver_.mechanism().outputs()[index].point];
      const LinkFeature<SceneNumber> place =
          solver_.numbers.feature(solver_.mechanism().outputs()[index].point, false);
      const cpp::Expression point = rates_.local("point_" + solver_.members.outputs[index]);
      rates_.add(cpp::declared(
          {"const LinkPoint", "LinkPoint"}, point,
          rates_.point(feature.name, solver_.placed(feature.link), place.x, place.y)));
      tell("outputs", solver_.members.outputs[index], rated(point.member("rates"), 2));
    }
    const auto pairs = mechanism::held_pairs(solver_.mechanism(), solver_.plan.redundant());
    for (const ToldJoint& joint : told_joints(solver_)) {
      if (joint.pairs.size() == 1) {
        joints_.push_back(joint.member);
        const auto& between = pairs[joint.pairs.front()].between;
        tell("joints", joint.member, rated(joint_rates({between.begin(), between.end()}), 1));
      }
    }
  }
  [[nodiscard]] cpp::Expression joint_rates(const std::vector<mechanism::FeatureIndex>& between) {
    const auto is_line = [&](mechanism::FeatureIndex feature) {
      return solver_.mechanism().features()[feature].is_line;
    };
    if (std::ranges::any_of(between, is_line)) {
      return displacement(solver_, between, rates_).member("rates");
    }
    const auto frame_of = [&](std::size_t end) {
      return nested_frames({solver_.placed(link_of(between[end]))});
    };
    return cpp::call("support::turning_rates", {frame_of(0), frame_of(1)});
  }

  void add_dynamics() {
    std::vector<cpp::Expression> accelerations;
    for (const DriverIndex driver : mechanism::free_drivers(solver_.mechanism())) {
      accelerations.push_back(
          cpp::variable("drivers").member(solver_.members.drivers[driver]).member("acceleration"));
    }
    const cpp::Expression equations = finding_.local("equations");
    finding_.add(cpp::declared(
        "auto", equations,
        cpp::call("support::EquationsOfMotion<Scalar, coordinate_count>",
                  {cpp::call("support::vector_of<Scalar>", std::move(accelerations))})));
    const cpp::Block before = finding_.take_from(0);
    LinkLoads loads(solver_, finding_);
    const cpp::Block declarations = finding_.take_from(0);
    loads.add_applied();
    const auto add = [&](LinkIndex link, const std::string& function,
                         std::vector<cpp::Expression> arguments) {
      arguments.insert(arguments.begin(), from(motions_, "first", rated(link)));
      finding_.add(cpp::called(equations.member(function).at(std::move(arguments))));
    };
    for (const mechanism::Mass& mass : solver_.mechanism().loading().masses) {
      const LinkIndex link = mass.at.link;
      const OptionalExpression frame = solver_.placed(link);
      if (frame && loads.counts(mass.mass)) {
        add(link, "add_mass", {*frame, loads.centre(mass), loads.value(mass.mass)});
      }
      if (frame && loads.counts(mass.inertia)) {
        add(link, "add_inertia", {*frame, loads.value(mass.inertia)});
      }
    }
    for (const LinkIndex link : solver_.mechanism().links().keys()) {
      if (!solver_.is_ground(link) && loads.bears(link)) {
        add(link, "add_load", {loads.on(link)});
      }
    }
    const cpp::Block own = finding_.take_from(0);
    finding_.add(before);
    for (const LinkIndex link : solver_.linkage().links.keys()) {
      if (loads.bears(link)) {
        finding_.add(declarations[link.place()]);
      }
    }
    finding_.add(own);
    finding_.add(cpp::assigned(cpp::variable("state").member("dynamics"),
                               equations.member("coefficients").at({})));
  }

  const SolverScene& solver_;
  const mechanism::Want& want_;
  FunctionBody rates_, finding_;
  std::size_t rated_numbers_ = 0;
  std::map<LinkIndex, Rated> of_links_;
  std::vector<std::string> links_, joints_;
  cpp::Expression motions_ = cpp::variable("motions");
  cpp::Expression second_ = cpp::variable("second");
};

}  // namespace

cpp::Block show_motions(const SolverScene& solver, cpp::View& view) {
  const mechanism::Want& want = solver.plan.request().want;
  const std::vector<DriverIndex> drivers = mechanism::free_drivers(solver.mechanism());
  const bool has_motions = solver.wants_coordinates() && !drivers.empty();
  view.set("has_motions", has_motions);
  view.set("has_coefficients", has_motions && want.coefficients);
  view.set("has_dynamics", has_motions && want.dynamics);
  if (!has_motions) {
    return {};
  }
  MotionStatements statements(solver);
  statements.run();
  cpp::Block all = statements.rates();
  view.set("rate_listing", cpp::line_list(cpp::printed(all), ""));
  view.set("rated_name", all.empty() ? "" : " placed");
  view.set("rates_name", all.empty() ? "" : " rates");
  view.set("rated_numbers", std::to_string(statements.rated_numbers()));
  const cpp::Block finding = statements.finding();
  view.set("motion_finding", cpp::line_list(cpp::printed(finding), ""));
  view.set("coordinate_count", std::to_string(drivers.size()));
  const auto listed = [&](const char* quote, const std::string& before) {
    return text::joined(drivers, ", ", [&](DriverIndex driver) {
      const std::string& name =
          *quote == '\0'
              ? solver.members.drivers[driver]
              : solver.mechanism().joints()[solver.mechanism().drivers()[driver].joint].name;
      return before + quote + name + quote;
    });
  };
  view.set("coordinate_names", listed("\"", ""));
  view.set("coordinate_words", cpp::comment_text(listed("", "")));
  view.set("coordinate_list", listed("", "&drivers."));
  view.set("solved_list", text::joined(solver.members.solved, ", ", [](const std::string& member) {
             return "placed." + member;
           }));
  view.set("solved_name", solver.members.solved.items().empty() ? "" : " placed");
  view.set("coefficient_links", member_list(statements.links()));
  view.set("has_coefficient_links", !statements.links().empty());
  view.set("coefficient_outputs", member_list(want.coefficients ? solver.members.outputs.items()
                                                                : std::vector<std::string>{}));
  view.set("has_coefficient_outputs", !solver.members.outputs.items().empty());
  view.set("coefficient_joints", member_list(statements.joints()));
  view.set("has_coefficient_joints", !statements.joints().empty());
  all.insert(all.end(), finding.begin(), finding.end());
  return all;
}

}  // namespace assur::generator::emission::scene
