// Follows the configurations of a mechanism from one set of parameters' values to the next.
#include <algorithm>
#include <assur/mechanism/continuation.hpp>
#include <utility>

#include "branch_matching.hpp"
#include "snapshot.hpp"
#include "solve/longest_on_links.hpp"
#include "straight_way.hpp"

namespace assur::mechanism::follow {

namespace {

/// The shortest step that is tried, as a part of the way between two sets: a sweep along the rest
/// of the way, the last resort, takes steps that are no longer.
constexpr double shortest_part = 1.0 / 512;
/// The largest distance between two solutions of one configuration, in lengths of the mechanism:
/// half of the digits are lost where it is singular.
constexpr double same_configuration = 1e-6;

/// The plan of a request with a sweep, even if it is never run, so that it carries the derivatives
/// and determinants needed to follow branches. Derivatives with respect to several parameters come
/// with the sensitivities only.
Plan plan_for(Mechanism mechanism, Request request, const std::vector<ParameterIndex>& changing) {
  request.want.sensitivity = request.want.sensitivity || changing.size() > 1;
  if (!changing.empty()) {
    const NumberIndex zero = mechanism.add_number(0, "sweep.from");
    request.sweep = Sweep{changing.front(), zero, zero, 1};
  }
  return Plan(mechanism, request);
}

}  // namespace

}  // namespace assur::mechanism::follow

namespace assur::mechanism {

/// Holds the present set of the branches, `here_`, and the set solved last, `next_`. Once the
/// branches have reached the latter, the two exchange places before another is solved.
class Continuation::Follower {
 public:
  Follower(const Mechanism& mechanism, const Request& request, std::vector<ParameterIndex> changing)
      : mechanism_(mechanism),
        request_(request),
        changing_(std::move(changing)),
        plan_(follow::plan_for(mechanism, request, changing_)),
        between_(plan_.values()),
        length_(solve::longest_on_links(between_)) {
    const std::vector<ParameterIndex>& columns = between_.columns();
    for (const ParameterIndex parameter : changing_) {
      columns_.push_back(std::ranges::find(columns, parameter) - columns.begin());
    }
  }

  [[nodiscard]] const Plan& plan() const { return plan_; }

  const Solution& solve(const Values& values) {
    if (std::exchange(are_there_, false)) {
      std::swap(here_, next_);
    }
    solve_at(values, next_);
    return next_.set.solution;
  }

  Next next() {
    if (here_.set.count() == 0 || next_.set.count() == 0) {
      return Next(here_.set.count());
    }
    const std::optional<Next> clear = step(here_, next_);
    return clear ? *clear : walk();
  }

  bool go_to() {
    are_there_ = are_known(next_) || !are_known(here_);
    return are_there_;
  }

 private:
  /// Values and their configurations.
  struct Item {
    std::vector<std::pair<ParameterIndex, double>> replaced;
    follow::StraightWay::Place at;  ///< the values of the changing parameters
    follow::Snapshot set;
  };

  [[nodiscard]] static bool are_known(const Item& item) {
    const auto& configurations = item.set.solution.configurations;
    return !configurations.empty() &&
           std::ranges::all_of(configurations, &Configuration::path_known);
  }

  [[nodiscard]] std::vector<std::pair<std::string, double>> named(
      const std::vector<std::pair<ParameterIndex, double>>& replaced) const {
    std::vector<std::pair<std::string, double>> result;
    for (const auto& [parameter, value] : replaced) {
      result.emplace_back(plan_.mechanism().parameters()[parameter].name, value);
    }
    return result;
  }

  void solve_at(const Values& values, Item& item) const {
    item.set.points.resize(0);
    plan_.solve(values, item.set.solution);
    item.set.points.resize(item.set.solution.configurations.size());
    item.set.roles.resize(plan_.structure().groups.size());
    for (const GroupIndex group : item.set.roles.keys()) {
      item.set.roles[group] = values.group(group).roles;
    }
    item.replaced = values.replaced();
    item.at.clear();
    for (const ParameterIndex parameter : changing_) {
      item.at.push_back(values.parameter(parameter));
    }
  }

  /// Sets the points of both ends of a step, which is 1 long, with slopes along it.
  void set_points(Item& from, Item& to) const {
    Eigen::VectorXd along(static_cast<Eigen::Index>(changing_.size()));
    for (std::size_t one = 0; one < changing_.size(); ++one) {
      along(static_cast<Eigen::Index>(one)) = to.at[one] - from.at[one];
    }
    from.set.parameter = 0;
    to.set.parameter = 1;
    for (Item* item : {&from, &to}) {
      for (const follow::PointIndex point : item->set.points.keys()) {
        follow::set_point(
            item->set.configuration(point), length_,
            [&](const Frame& link) {
              Eigen::Vector3d slope = Eigen::Vector3d::Zero();
              for (std::size_t one = 0; one < columns_.size(); ++one) {
                slope +=
                    link.follows.first.col(columns_[one]) * along(static_cast<Eigen::Index>(one));
              }
              return slope;
            },
            item->set.points[point]);
      }
      item->set.closest = follow::least_distance(item->set.points);
    }
  }

  /// The configurations of `to` that continue those of `from`, if the step between them is
  /// unambiguous.
  [[nodiscard]] std::optional<Next> step(Item& from, Item& to) const {
    set_points(from, to);
    if (!follow::is_regular(from.set) || !follow::is_regular(to.set)) {
      return std::nullopt;
    }
    const follow::BranchMatching matching = follow::match(from.set, to.set);
    if (!matching.clear()) {
      return std::nullopt;
    }
    Next result;
    for (const follow::PointIndex point : matching.to_right) {
      result.emplace_back(point.place());
    }
    return result;
  }

  /// Goes to the last set in shorter steps. If none is short enough, a sweep goes the rest of the
  /// way.
  [[nodiscard]] Next walk() {
    Next result(here_.set.count());
    for (std::size_t place = 0; place < result.size(); ++place) {
      result[place] = place;
    }
    Item current = here_;
    double part = 0;
    double width = 0.5;
    try {
      while (part < 1) {
        Item further;
        const bool arrives = part + width >= 1;
        if (arrives) {
          further = next_;
        } else {
          solve_between(part + width, further);
        }
        if (const auto found = step(current, further)) {
          append(*found, result);
          part = arrives ? 1 : part + width;
          std::swap(current, further);
          width *= 2;
        } else if (width > follow::shortest_part) {
          width /= 2;
        } else {
          append(sweep_from(current), result);
          return result;
        }
      }
    } catch (const MechanismError&) {
      return Next(here_.set.count());  // A formula may have no value on the way.
    }
    return result;
  }

  static void append(const Next& step, Next& way) {
    for (std::optional<std::size_t>& place : way) {
      place = place ? step[*place] : std::nullopt;
    }
  }

  void solve_between(double part, Item& item) {
    std::vector<std::pair<ParameterIndex, double>> changed = next_.replaced;
    for (auto& [parameter, value] : changed) {
      const auto at = std::ranges::find(changing_, parameter);
      if (at != changing_.end()) {
        const auto one = static_cast<std::size_t>(at - changing_.begin());
        value = here_.at[one] * (1 - part) + next_.at[one] * part;
      }
    }
    between_.set(changed);
    solve_at(between_, item);
  }

  [[nodiscard]] Next sweep_from(const Item& from) {
    if (!straight_) {
      straight_.emplace(mechanism_, request_, changing_);
    }
    std::vector<std::pair<ParameterIndex, double>> others = next_.replaced;
    std::erase_if(others, [this](const auto& one) {
      return std::ranges::find(changing_, one.first) != changing_.end();
    });
    Next result(from.set.count());
    for (const auto& [number, end] : straight_->branches(from.at, next_.at, named(others))) {
      const auto place = static_cast<std::size_t>(number) - 1;
      if (place < result.size()) {
        result[place] = place_in_next(end);
      }
    }
    return result;
  }

  /// The configuration of the last set that equals one found by a sweep.
  [[nodiscard]] std::optional<std::size_t> place_in_next(const Configuration& found) const {
    follow::ConfigurationPoint sought;
    const auto still = [](const Frame&) { return Eigen::Vector3d::Zero().eval(); };
    follow::set_point(found, length_, still, sought);
    for (const follow::PointIndex point : next_.set.points.keys()) {
      if ((next_.set.points[point].at - sought.at).norm() < follow::same_configuration) {
        return point.place();
      }
    }
    return std::nullopt;
  }

  Mechanism mechanism_;
  Request request_;
  std::vector<ParameterIndex> changing_;
  Plan plan_;
  Values between_;
  std::vector<Eigen::Index> columns_;  ///< of derivatives by the changing parameters
  std::optional<follow::StraightWay> straight_;
  Item here_, next_;
  double length_;  ///< of the mechanism, the unit of points
  bool are_there_ = false;
};

Continuation::Continuation(const Mechanism& mechanism, const Request& request,
                           std::vector<ParameterIndex> changing)
    : follower_(std::make_unique<Follower>(mechanism, request, std::move(changing))) {}

Continuation::~Continuation() = default;

const Plan& Continuation::plan() const { return follower_->plan(); }
const Solution& Continuation::solve(const Values& values) { return follower_->solve(values); }
Continuation::Next Continuation::next() { return follower_->next(); }
bool Continuation::go_to() { return follower_->go_to(); }

}  // namespace assur::mechanism
