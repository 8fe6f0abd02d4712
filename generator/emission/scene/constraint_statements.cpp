#include "emission/scene/constraint_statements.hpp"

#include <algorithm>
#include <assur/text/names.hpp>
#include <utility>

namespace assur::generator::emission::scene {

namespace {

/// Of links that groups place: J takes 8 * 3 n * (3 n + 2) bytes, and its factors as much again.
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

  void add_pairs() {
    const mechanism::Mechanism& described = solver_.mechanism();
    for (const mechanism::JointIndex index : described.joints().keys()) {
      const mechanism::Joint& joint = described.joints()[index];
      const bool is_slide = joint.type != mechanism::JointType::revolute;
      const bool is_slot = joint.type == mechanism::JointType::pin_in_slot;
      if (solver_.plan.is_stand_in(index)) {
        continue;
      }
      for (std::size_t other = 1; other < joint.between.size(); ++other) {
        const mechanism::FeatureIndex one = joint.between[0];
        const bool is_line_first = described.features()[one].is_line;
        add(is_slot && !is_line_first ? joint.between[other] : one,
            is_slot && !is_line_first ? one : joint.between[other],
            {!is_slide, true, is_slide && !is_slot});
      }
    }
    for (const mechanism::RedundantJoint& joint : solver_.plan.redundant()) {
      const bool is_line = described.features()[joint.one].is_line;
      const bool are_lines = is_line && described.features()[joint.other].is_line;
      add(joint.one, joint.other, {!is_line, true, are_lines});
    }
  }

  void add(mechanism::FeatureIndex one, mechanism::FeatureIndex other,
           const std::array<bool, 3>& holds) {
    if (is_fixed(link_of(one)) && is_fixed(link_of(other))) {
      return;
    }
    rows_ += static_cast<int>(std::ranges::count(holds, true));
    const auto flag = [&](std::size_t place) { return holds[place] ? "true" : "false"; };
    const std::string frames = frame(one) + ", " + frame(other);
    pairs_.push_back("support::HeldPair<LinkFrame>{" + place(one) + ", " + place(other) + ", " +
                     frames + ", {{" + flag(0) + ", " + flag(1) + ", " + flag(2) + "}}}");
  }

  [[nodiscard]] mechanism::LinkIndex link_of(mechanism::FeatureIndex feature) const {
    return solver_.mechanism().features()[feature].link;
  }
  /// The place of a feature's link among those that move.
  [[nodiscard]] std::string place(mechanism::FeatureIndex feature) const {
    const auto found = std::ranges::find(moving_, link_of(feature));
    return found == moving_.end() ? "-1" : std::to_string(found - moving_.begin());
  }
  /// On a link that moves its own frame, else that in which the feature stands.
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
