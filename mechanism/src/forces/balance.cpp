#include "balance.hpp"

#include <algorithm>
#include <assur/support/rigid_motion.hpp>
#include <optional>

#include "plan/plan_data.hpp"

namespace assur::mechanism::forces {

namespace {

using Eigen::Vector2d;

Vector2d place_of(const Frame& frame) { return {frame.pose.x, frame.pose.y}; }

}  // namespace

Balance::Balance(const Values& values, const Configuration& configuration)
    : values_(values),
      mechanism_(values.plan().mechanism),
      configuration_(configuration),
      coordinates_(values, configuration),
      pivots_(mechanism_.links().size(), Vector2d::Zero()),
      row_of_(mechanism_.links().size(), -1) {
  list_pairs();
  find_pivots();
  Eigen::Index rows = 0;
  for (const LinkIndex link : mechanism_.links().keys()) {
    if (link != mechanism_.ground()) {
      row_of_[link] = rows;
      rows += 3;
    }
  }
  for (std::size_t index = 0; index < pairs_.size(); ++index) {
    const HeldPair& pair = pairs_[index];
    for (const int coordinate : {0, 1, 2}) {
      if (pair.holds[static_cast<std::size_t>(coordinate)]) {
        const bool is_driven = pair.driver.exists() && pair.driven == coordinate;
        Reaction unit = along(pair.first, pair.second, coordinate);
        unit.couple *= unit_of(coordinate);
        held_.push_back({index, coordinate, is_driven ? pair.driver : DriverIndex(), unit});
      }
    }
  }
  matrix_.resize(rows, std::ssize(held_));
  for (Eigen::Index column = 0; column < matrix_.cols(); ++column) {
    const HeldCoordinate& held = held_[static_cast<std::size_t>(column)];
    matrix_.col(column) = rows_of(held.unit);
    if (!held.driver.exists()) {
      continue;
    }
    const std::vector<JointIndex> read = coordinates_.joints_of(held.driver);
    const Dual law = read.empty() ? Dual() : coordinates_.law(held.driver);
    for (std::size_t place = 0; place < read.size() && law.derivatives().size() > 0; ++place) {
      const CoordinatePair pair = coordinates_.pair_of(read[place]);
      matrix_.col(column) -= unit_of(held.coordinate) *
                             law.derivatives()(static_cast<Eigen::Index>(place)) *
                             rows_of(along(pair.first, pair.second, pair.coordinate));
    }
  }
}

void Balance::list_pairs() {
  const std::vector<RedundantJoint>& redundant = values_.plan().redundant;
  pairs_ = held_pairs(mechanism_, redundant);
  for (const Joint& joint : mechanism_.joints()) {
    if (!is_stand_in(joint, redundant)) {
      names_.insert(names_.end(), joint.between.size() - 1, joint.name);
    }
  }
  for (const RedundantJoint& joint : redundant) {
    names_.push_back(joint.name);
  }
}

/// The first of a link's features that a joint holds is its pivot. The size is the longest distance
/// from a pivot to a place where the link is held.
void Balance::find_pivots() {
  Table<LinkIndex, bool> found(mechanism_.links().size(), false);
  found[mechanism_.ground()] = true;
  double longest = 0;
  for (const bool measures : {false, true}) {
    for (const HeldPair& pair : pairs_) {
      for (const FeatureIndex feature : {pair.first, pair.second}) {
        const LinkIndex link = mechanism_.features()[feature].link;
        const Vector2d at = place_of(placed(pair.second));
        if (!found[link]) {
          pivots_[link] = at;
          found[link] = true;
        }
        if (measures && link != mechanism_.ground()) {
          longest = std::max(longest, (at - pivots_[link]).norm());
        }
      }
    }
  }
  size_ = longest > 0 ? longest : 1;
}

Frame Balance::placed(FeatureIndex feature) const {
  return composed(configuration_.links[mechanism_.features()[feature].link],
                  values_.frame(feature));
}

Reaction Balance::along(FeatureIndex first, FeatureIndex second, int coordinate) const {
  const auto& features = mechanism_.features();
  const auto& [c, s] = placed(first).pose.direction;
  const Vector2d force = coordinate == 0   ? Vector2d(c, s)
                         : coordinate == 1 ? Vector2d(-s, c)
                                           : Vector2d::Zero();
  return {features[second].link, features[first].link, place_of(placed(second)), force,
          coordinate == 2 ? 1.0 : 0.0};
}

Eigen::VectorXd Balance::rows_of(const Reaction& reaction) const {
  Eigen::VectorXd rows = Eigen::VectorXd::Zero(matrix_.rows());
  const auto add = [&](LinkIndex link, double sense) {
    if (row_of_[link] >= 0) {
      const double moment =
          reaction.couple + moment_of(reaction.at - pivots_[link], reaction.force);
      rows.segment<2>(row_of_[link]) += sense * reaction.force;
      rows(row_of_[link] + 2) += sense * moment / size_;
    }
  };
  add(reaction.on, 1);
  add(reaction.from, -1);
  return rows;
}

Eigen::VectorXd Balance::rows_of(const Table<LinkIndex, Wrench>& wrenches) const {
  Eigen::VectorXd rows = Eigen::VectorXd::Zero(matrix_.rows());
  for (const LinkIndex link : wrenches.keys()) {
    if (row_of_[link] >= 0) {
      rows.segment<2>(row_of_[link]) = wrenches[link].force;
      rows(row_of_[link] + 2) = wrenches[link].moment / size_;
    }
  }
  return rows;
}

double Balance::threshold() const {
  /// Six digits of the largest force remain where a direction is shortened by this much.
  constexpr double least = 1e-9;
  const NumberIndex tolerance = values_.plan().request.redundancy_tolerance;
  return tolerance.exists() ? std::max(least, values_.value_of(tolerance) / size_) : least;
}

std::string Balance::reason() const {
  return values_.plan().redundant.empty()
             ? "the configuration is singular, or its rates are not known: the equilibrium of the "
               "links does not determine the force"
             : "redundant constraints share the load: the equilibrium of the links does not "
               "determine the part of each";
}

}  // namespace assur::mechanism::forces
