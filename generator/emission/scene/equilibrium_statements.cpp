#include "emission/scene/equilibrium_statements.hpp"

#include <algorithm>

#include "emission/cpp/page.hpp"
#include "emission/scene/carried_links.hpp"
#include "emission/scene/link_loads.hpp"
#include "emission/scene/told_joints.hpp"

namespace assur::generator::emission::scene {

namespace {

using mechanism::FeatureIndex;
using mechanism::HeldPair;
using mechanism::LinkIndex;

class EquilibriumStatements {
 public:
  explicit EquilibriumStatements(const SolverScene& solver)
      : solver_(solver),
        pairs_(mechanism::held_pairs(solver.mechanism(), solver.plan.redundant())),
        body_(solver.body()) {
    for (const LinkIndex link : solver.mechanism().links().keys()) {
      if (!solver.is_ground(link)) {
        moving_.push_back(link);
      }
    }
    for (const HeldPair& pair : pairs_) {
      first_.push_back(unknowns_);
      unknowns_ += static_cast<std::size_t>(std::ranges::count(pair.holds, true));
    }
  }

  [[nodiscard]] cpp::Block run() {
    add_loads();
    for (const HeldPair& pair : pairs_) {
      hold(pair);
    }
    for (std::size_t pair = 0; pair < pairs_.size(); ++pair) {
      if (pairs_[pair].driver.exists()) {
        pass_on(pair);
      }
    }
    const mechanism::NumberIndex tolerance = solver_.plan.request().redundancy_tolerance;
    call("solve",
         {tolerance.exists() ? body_.number(solver_.numbers.number(tolerance)) : cpp::number(0)});
    for (std::size_t pair = 0; pair < pairs_.size(); ++pair) {
      if (tells_effort(pair)) {
        body_.add(cpp::assigned(
            state("efforts").member(solver_.members.drivers[pairs_[pair].driver]),
            all_.member("effort").at({cpp::word(unknown(pair, pairs_[pair].driven))})));
      }
    }
    for (const ToldJoint& joint : told_joints(solver_)) {
      tell(joint);
    }
    const cpp::Block statements = body_.take_from(0);
    body_.add(cpp::declared("support::Equilibrium<" + std::to_string(moving_.size()) + ", " +
                                std::to_string(unknowns_) + ", " + std::to_string(passed_) + ", " +
                                std::to_string(springs_) + ", Scalar>",
                            all_));
    body_.add(statements);
    return behind_joints_read(solver_, body_);
  }

 private:
  [[nodiscard]] static cpp::Expression state(const std::string& part) {
    return cpp::variable("state").member(part);
  }
  [[nodiscard]] bool tells_effort(std::size_t pair) const {
    return pairs_[pair].driver.exists() && !solver_.mechanism().holds_idle(pairs_[pair].driver);
  }
  [[nodiscard]] LinkIndex link_of(FeatureIndex feature) const {
    return solver_.mechanism().features()[feature].link;
  }
  void call(const std::string& function, std::vector<cpp::Expression> arguments) {
    body_.add(cpp::called(all_.member(function).at(std::move(arguments))));
  }
  /// The index of a link among the moving ones; -1 for the ground.
  [[nodiscard]] cpp::Expression place_of(LinkIndex link) const {
    const auto found = std::ranges::find(moving_, link);
    return cpp::word(found == moving_.end() ? "-1" : std::to_string(found - moving_.begin()));
  }
  /// The links and the positions of two features, as arguments.
  [[nodiscard]] std::vector<cpp::Expression> between(FeatureIndex first,
                                                     FeatureIndex second) const {
    return {place_of(link_of(first)), place_of(link_of(second)), pose_of(solver_, first, body_),
            pose_of(solver_, second, body_)};
  }
  /// The unknown force component by which a pair constrains a coordinate.
  [[nodiscard]] std::size_t unknown(std::size_t pair, int coordinate) const {
    const auto& holds = pairs_[pair].holds;
    return first_[pair] +
           static_cast<std::size_t>(std::count(holds.begin(), holds.begin() + coordinate, true));
  }

  void add_loads() {
    LinkLoads loads(solver_, body_);
    const cpp::Block declarations = body_.take_from(0);
    const std::vector<DirectedPull> pulls = loads.add_all_known();
    const cpp::Block added = body_.take_from(0);
    std::vector<cpp::Expression> links = {loads.on(solver_.linkage().ground)};
    std::vector<cpp::Statement> declared = {declarations[solver_.linkage().ground.place()]};
    for (const LinkIndex link : moving_) {
      links.push_back(loads.on(link));
      declared.push_back(declarations[link.place()]);
    }
    body_.add(declared);
    body_.add(added);
    for (std::size_t place = 0; place < moving_.size(); ++place) {
      call("load", {cpp::word(place), links[place + 1]});
    }
    add_ground_resultant(cpp::call("support::together", std::move(links)), body_);
    for (const DirectedPull& pull : pulls) {
      call("pull", {place_of(pull.first), place_of(pull.second), pull.at, pull.pull});
    }
    springs_ = pulls.size();
  }

  void hold(const HeldPair& pair) {
    std::vector<cpp::Expression> arguments = between(pair.first, pair.second);
    std::vector<cpp::Expression> holds;
    for (const bool is_held : pair.holds) {
      holds.push_back(cpp::word(cpp::boolean(is_held)));
    }
    arguments.push_back(cpp::braces("", {cpp::braces("", std::move(holds))}));
    call("hold", std::move(arguments));
  }

  /// A driver whose law reads joints also loads these joints.
  void pass_on(std::size_t pair) {
    const mechanism::DriverIndex driver = pairs_[pair].driver;
    const mechanism::NumberIndex law = solver_.mechanism().drivers()[driver].position;
    for (const mechanism::JointIndex joint : solver_.mechanism().numbers()[law].formula.joints()) {
      const cpp::Expression slope = body_.number(solver_.numbers.slope(driver, joint));
      if (slope.is_number(0)) {
        continue;
      }
      const std::vector<FeatureIndex>& ends = solver_.mechanism().joints()[joint].between;
      const auto is_line = [&](std::size_t end) {
        return solver_.mechanism().features()[ends[end]].is_line;
      };
      const bool turns = !is_line(0) && !is_line(1);
      const std::size_t first = turns || is_line(0) ? 0 : 1;
      std::vector<cpp::Expression> arguments = between(ends[first], ends[1 - first]);
      arguments.insert(arguments.begin(), cpp::word(unknown(pair, pairs_[pair].driven)));
      arguments.push_back(cpp::word(turns ? "2" : "0"));
      arguments.push_back(slope);
      call("pass_on", std::move(arguments));
      ++passed_;
    }
  }

  /// The unknowns of a pair's bearing force, without a driver's effort, and its sense on a link.
  [[nodiscard]] cpp::Expression bearings(std::size_t pair, LinkIndex link) const {
    const HeldPair& held = pairs_[pair];
    const bool drives_along = held.driver.exists() && held.driven == 0;
    const std::size_t count = held.holds[0] && !drives_along ? 2 : 1;
    return cpp::braces("", {cpp::word(unknown(pair, count == 2 ? 0 : 1)), cpp::word(count),
                            cpp::word(link_of(held.second) == link ? "1" : "-1")});
  }
  /// The force of a joint on one of its links.
  [[nodiscard]] cpp::Expression force_on(const ToldJoint& joint, LinkIndex link) const {
    std::vector<cpp::Expression> parts;
    for (const std::size_t pair : joint.pairs) {
      if (link_of(pairs_[pair].first) == link || link_of(pairs_[pair].second) == link) {
        parts.push_back(bearings(pair, link));
      }
    }
    return all_.member("force").at({cpp::braces("", std::move(parts))});
  }

  void tell(const ToldJoint& joint) {
    const cpp::Expression target = state("forces").member(joint.member);
    for (std::size_t link = 0; joint.is_pin() && link < joint.links.size(); ++link) {
      body_.add(cpp::assigned(target.member(joint.link_members[link]),
                              force_on(joint, joint.links[link])));
    }
    if (joint.is_pin()) {
      return;
    }
    const cpp::Expression force = force_on(joint, joint.links.back());
    if (!joint.has_moment) {
      body_.add(cpp::assigned(target, force));
      return;
    }
    std::vector<cpp::Expression> couples;
    for (const std::size_t pair : joint.pairs) {
      if (pairs_[pair].holds[2]) {
        couples.push_back(cpp::word(unknown(pair, 2)));
      }
    }
    const cpp::Expression couple =
        couples.empty() ? cpp::number(0)
                        : all_.member("couple").at({cpp::braces("", std::move(couples))});
    body_.add(cpp::assigned(target, cpp::braces("", {force, couple})));
  }

  const SolverScene& solver_;
  std::vector<HeldPair> pairs_;
  FunctionBody body_;
  std::vector<LinkIndex> moving_;
  std::vector<std::size_t> first_;  ///< the first unknown of each pair
  std::size_t unknowns_ = 0, passed_ = 0, springs_ = 0;
  cpp::Expression all_ = cpp::variable("all");
};

}  // namespace

cpp::Block equilibrium_statements(const SolverScene& solver) {
  return solver.plan.request().want.forces ? EquilibriumStatements(solver).run() : cpp::Block{};
}

}  // namespace assur::generator::emission::scene
