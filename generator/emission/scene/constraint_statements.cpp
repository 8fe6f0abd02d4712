#include "emission/scene/constraint_statements.hpp"

#include <algorithm>
#include <assur/mechanism/held_pairs.hpp>
#include <assur/text/names.hpp>
#include <utility>

namespace assur::generator::emission::scene {

namespace {

/// The most links that groups may place: for n links, J takes 8 * 3 n * (3 n + 2) bytes, and its
/// factors as much again.
constexpr std::size_t most_links = 16;

class Constraints {
 public:
  explicit Constraints(const SolverScene& solver)
      : solver_(solver),
        stands_(solver.plan.structure().placed_by_drivers()),
        lines_(solver.parameters, solver.numbers, solver.derivative_order) {
    for (const mechanism::LinkIndex link : solver.mechanism().links().keys()) {
      if (!is_fixed(link)) {
        moving_.push_back(link);
      }
    }
  }

  [[nodiscard]] bool can_be_closed() const {
    const mechanism::Mechanism& described = solver_.mechanism();
    const auto is_known = [&](const mechanism::Driver& driver) {
      return std::ranges::all_of(
          described.joints()[driver.joint].between,
          [&](mechanism::FeatureIndex at) { return is_fixed(described.features()[at].link); });
    };
    bool reports_slides = false;
    for (const mechanism::JointIndex joint : described.joints().keys()) {
      reports_slides =
          reports_slides || (described.joints()[joint].type != mechanism::JointType::revolute &&
                             solver_.reports(joint));
    }
    return !solver_.plan.redundant().empty() &&
           !solver_.plan.request().redundancy_tolerance.exists() &&
           solver_.plan.structure().reading.empty() && !moving_.empty() &&
           moving_.size() <= most_links && std::ranges::all_of(described.drivers(), is_known) &&
           !reports_slides;
  }

  [[nodiscard]] std::vector<std::string> statements() {
    add_pairs();
    const std::string links =
        text::joined(moving_, ", ", [&](auto link) { return "&" + solver_.placed(link); });
    lines_.add("return support::settle_links<" + std::to_string(rows_) +
               ">(std::array<LinkFrame*, " + std::to_string(moving_.size()) + ">{{" + links +
               "}}, std::array<support::HeldPair<LinkFrame>, " + std::to_string(pairs_.size()) +
               ">{{" + text::joined(pairs_, ", ") + "}}, placed.regularity);");
    return lines_.lines();
  }

 private:
  [[nodiscard]] bool is_fixed(mechanism::LinkIndex link) const {
    return solver_.is_ground(link) || stands_[link];
  }

  /// Links that drivers place are fixed, so no pair needs a driver.
  void add_pairs() {
    for (const mechanism::HeldPair& pair :
         mechanism::held_pairs(solver_.mechanism(), solver_.plan.redundant())) {
      if (is_fixed(link_of(pair.first)) && is_fixed(link_of(pair.second))) {
        continue;
      }
      rows_ += static_cast<int>(std::ranges::count(pair.holds, true));
      const std::string holds = text::joined(
          pair.holds, ", ", [](bool is_held) -> std::string { return is_held ? "true" : "false"; });
      const std::string frames = frame(pair.first) + ", " + frame(pair.second);
      pairs_.push_back("support::HeldPair<LinkFrame>{" + place(pair.first) + ", " +
                       place(pair.second) + ", " + frames + ", {{" + holds + "}}}");
    }
  }

  [[nodiscard]] mechanism::LinkIndex link_of(mechanism::FeatureIndex feature) const {
    return solver_.mechanism().features()[feature].link;
  }
  /// The place of a feature's link among those that move; -1 for a fixed link.
  [[nodiscard]] std::string place(mechanism::FeatureIndex feature) const {
    const auto found = std::ranges::find(moving_, link_of(feature));
    return found == moving_.end() ? "-1" : std::to_string(found - moving_.begin());
  }
  /// The frame of a feature: on its link, if that moves, and else in the fixed frame.
  [[nodiscard]] std::string frame(mechanism::FeatureIndex index) {
    const mechanism::Feature& feature = solver_.mechanism().features()[index];
    const LinkFeature<SceneNumber> at = solver_.numbers.feature(index, feature.is_line);
    const std::string own = lines_.frame("held", {at.x, at.y, at.along});
    const std::string link = is_fixed(feature.link) ? solver_.placed(feature.link) : "";
    return link.empty()  ? own.empty() ? "LinkFrame()" : own
           : own.empty() ? link
                         : "support::frame_in(" + link + ", " + own + ")";
  }

  const SolverScene& solver_;
  mechanism::Table<mechanism::LinkIndex, bool> stands_;
  SceneLines lines_;
  std::vector<mechanism::LinkIndex> moving_;
  std::vector<std::string> pairs_;
  int rows_ = 0;
};

}  // namespace

std::vector<std::string> settling_statements(const SolverScene& solver) {
  Constraints constraints(solver);
  return constraints.can_be_closed() ? constraints.statements() : std::vector<std::string>{};
}

}  // namespace assur::generator::emission::scene
