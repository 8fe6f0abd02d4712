#include "emission/scene/constraint_statements.hpp"

#include <algorithm>
#include <assur/mechanism/held_pairs.hpp>
#include <utility>

#include "emission/cpp/page.hpp"
#include "emission/scene/carried_links.hpp"

namespace assur::generator::emission::scene {

namespace {

/// The largest number of links that groups may place: for n links, J takes 8 * 3 n * (3 n + 2)
/// bytes, and its factors as much again.
constexpr std::size_t most_links = 16;

class Constraints {
 public:
  explicit Constraints(const SolverScene& solver)
      : solver_(solver),
        stands_(solver.plan.structure().placed_by_drivers()),
        body_(solver.body()) {
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
    return !solver_.plan.redundant().empty() &&
           !solver_.plan.request().redundancy_tolerance.exists() &&
           solver_.plan.structure().reading.empty() && !moving_.empty() &&
           moving_.size() <= most_links && std::ranges::all_of(described.drivers(), is_known);
  }

  [[nodiscard]] cpp::Block statements(const std::vector<std::string>& slides) {
    add_pairs();
    std::vector<cpp::Expression> links;
    for (const mechanism::LinkIndex link : moving_) {
      links.push_back(cpp::address(*solver_.placed(link)));
    }
    const cpp::Expression hold = cpp::variable("hold");
    body_.add(cpp::declared(
        "const bool", hold,
        cpp::call("support::settle_links<" + std::to_string(rows_) + ">",
                  {cpp::array({"LinkFrame*", "LinkFrame"}, std::move(links)),
                   cpp::array({"support::HeldPair<LinkFrame>", "LinkFrame"}, std::move(pairs_)),
                   cpp::variable("placed").member("regularity")})));
    add_slides(slides);
    body_.add(cpp::returned(hold));
    return body_.block();
  }

 private:
  [[nodiscard]] bool is_fixed(mechanism::LinkIndex link) const {
    return solver_.is_ground(link) || stands_[link];
  }

  /// Links that drivers place are fixed, so drivers need no pair.
  void add_pairs() {
    for (const mechanism::HeldPair& pair :
         mechanism::held_pairs(solver_.mechanism(), solver_.plan.redundant())) {
      if (is_fixed(link_of(pair.first)) && is_fixed(link_of(pair.second))) {
        continue;
      }
      rows_ += static_cast<int>(std::ranges::count(pair.holds, true));
      std::vector<cpp::Expression> holds;
      for (const bool is_held : pair.holds) {
        holds.push_back(cpp::word(cpp::boolean(is_held)));
      }
      const cpp::Expression second = frame(pair.second);
      const cpp::Expression first = frame(pair.first);
      pairs_.push_back(cpp::braces({"support::HeldPair<LinkFrame>", "LinkFrame"},
                                   {place(pair.first), place(pair.second), first, second,
                                    cpp::braces("", {cpp::braces("", std::move(holds))})}));
    }
  }

  /// Measures the slides between the settled links; those of drivers do not change.
  void add_slides(const std::vector<std::string>& slides) {
    for (const mechanism::JointIndex joint : solver_.mechanism().joints().keys()) {
      const std::string& member = solver_.members.joints[joint];
      if (std::ranges::find(slides, member) == slides.end() ||
          solver_.mechanism().driver_of(joint).exists()) {
        continue;
      }
      add_measured_slide(solver_, joint, body_);
    }
  }

  [[nodiscard]] mechanism::LinkIndex link_of(mechanism::FeatureIndex feature) const {
    return solver_.mechanism().features()[feature].link;
  }
  /// The index of a feature's link among the moving ones; -1 for a fixed link.
  [[nodiscard]] cpp::Expression place(mechanism::FeatureIndex feature) const {
    const auto found = std::ranges::find(moving_, link_of(feature));
    return cpp::word(found == moving_.end() ? "-1" : std::to_string(found - moving_.begin()));
  }
  /// The frame of a feature: on its link if that moves, else in the fixed frame.
  [[nodiscard]] cpp::Expression frame(mechanism::FeatureIndex index) {
    const mechanism::Feature& feature = solver_.mechanism().features()[index];
    const LinkFeature<SceneNumber> at = solver_.numbers.feature(index, feature.is_line);
    const OptionalExpression own = body_.frame("held", {at.x, at.y, at.along});
    const OptionalExpression link =
        is_fixed(feature.link) ? solver_.placed(feature.link) : std::nullopt;
    return link || own ? nested_frames({link, own}) : cpp::call(cpp::alias("LinkFrame"));
  }

  const SolverScene& solver_;
  mechanism::Table<mechanism::LinkIndex, bool> stands_;
  FunctionBody body_;
  std::vector<mechanism::LinkIndex> moving_;
  std::vector<cpp::Expression> pairs_;
  int rows_ = 0;
};

}  // namespace

cpp::Block settling_statements(const SolverScene& solver, const std::vector<std::string>& slides) {
  Constraints constraints(solver);
  return constraints.can_be_closed() ? constraints.statements(slides) : cpp::Block{};
}

}  // namespace assur::generator::emission::scene
