#include "balance.hpp"

#include <algorithm>
#include <optional>

#include "plan/plan_data.hpp"

namespace assur::mechanism::forces {

namespace {

using Eigen::Vector2d;

Vector2d place_of(const MovingPose& pose) { return {pose.x.value(), pose.y.value()}; }

}  // namespace

Balance::Balance(const Values& values, const Configuration& configuration)
    : values_(values),
      mechanism_(values.plan().mechanism),
      links_(values, configuration),
      pairs_(held_pairs(mechanism_, values.plan().redundant)),
      pivots_(mechanism_.links().size(), Vector2d::Zero()),
      row_of_(mechanism_.links().size(), -1) {
  find_pivots();
  rows_ = 0;
  for (const LinkIndex link : mechanism_.links().keys()) {
    if (link != mechanism_.ground()) {
      row_of_[link] = rows_;
      rows_ += 3;
    }
  }
  for (std::size_t index = 0; index < pairs_.size(); ++index) {
    const HeldPair& pair = pairs_[index];
    for (const int coordinate : {0, 1, 2}) {
      if (pair.holds[static_cast<std::size_t>(coordinate)]) {
        const bool is_driven = pair.driver.exists() && pair.driven == coordinate;
        held_.push_back({index, coordinate, is_driven ? pair.driver : DriverIndex()});
      }
    }
  }
  here_ = equilibrium(links_, true);
}

Equilibrium Balance::equilibrium(const MovingLinks& links, bool with_laws) const {
  Equilibrium result;
  result.matrix.setZero(rows_, std::ssize(held_));
  result.derivative.setZero(rows_, std::ssize(held_));
  for (std::size_t place = 0; place < held_.size(); ++place) {
    const auto column = static_cast<Eigen::Index>(place);
    const HeldCoordinate& held = held_[place];
    const HeldPair& pair = pairs_[held.pair];
    const MovingNumber unit(unit_of(held.coordinate));
    Reaction reaction = links.along(pair.first, pair.second, held.coordinate);
    reaction.couple = unit * reaction.couple;
    add(reaction, MovingNumber(1), column, result);
    result.units.push_back(reaction);
    if (!with_laws || !held.driver.exists()) {
      continue;
    }
    for (const JointIndex joint : links.coordinates().joints_of(held.driver)) {
      const CoordinatePair read = links.coordinates().pair_of(joint);
      add(links.along(read.first, read.second, read.coordinate),
          -unit * links.law_slope(held.driver, joint), column, result);
    }
  }
  return result;
}

Eigen::MatrixXd Balance::matrix_with(const std::vector<Reaction>& further) const {
  Equilibrium all;
  all.matrix.setZero(rows_, here_.matrix.cols() + std::ssize(further));
  all.derivative = all.matrix;
  all.matrix.leftCols(here_.matrix.cols()) = here_.matrix;
  for (std::size_t place = 0; place < further.size(); ++place) {
    add(further[place], MovingNumber(1), here_.matrix.cols() + static_cast<Eigen::Index>(place),
        all);
  }
  return all.matrix;
}

/// The pivot of a link is the first of its features that a joint holds. The size is the longest
/// distance from a link's pivot to another of its held features.
void Balance::find_pivots() {
  Table<LinkIndex, bool> found(mechanism_.links().size(), false);
  found[mechanism_.ground()] = true;
  double longest = 0;
  for (const bool measures : {false, true}) {
    for (const HeldPair& pair : pairs_) {
      for (const FeatureIndex feature : {pair.first, pair.second}) {
        const LinkIndex link = mechanism_.features()[feature].link;
        const Vector2d at = place_of(links_.placed(pair.second));
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

void Balance::add(const Reaction& reaction, const MovingNumber& factor, Eigen::Index column,
                  Equilibrium& to) const {
  for (const auto& [link, sense] : {std::pair(reaction.on, 1.0), std::pair(reaction.from, -1.0)}) {
    const Eigen::Index row = row_of_[link];
    if (row < 0) {
      continue;
    }
    const Vector2d& pivot = pivots_[link];
    const MovingPlace force = (sense * factor) * reaction.force;
    const MovingNumber moment = sense * factor * reaction.couple +
                                (reaction.at.x - MovingNumber(pivot.x())) * force.y -
                                (reaction.at.y - MovingNumber(pivot.y())) * force.x;
    to.matrix.block<2, 1>(row, column) += force.value();
    to.matrix(row + 2, column) += moment.value() / size_;
    to.derivative.block<2, 1>(row, column) += force.derivative();
    to.derivative(row + 2, column) += moment.derivative() / size_;
  }
}

Eigen::VectorXd Balance::rows_of(const Table<LinkIndex, Wrench>& wrenches) const {
  Eigen::VectorXd rows = Eigen::VectorXd::Zero(rows_);
  for (const LinkIndex link : wrenches.keys()) {
    if (row_of_[link] >= 0) {
      rows.segment<2>(row_of_[link]) = wrenches[link].force;
      rows(row_of_[link] + 2) = wrenches[link].moment / size_;
    }
  }
  return rows;
}

double Balance::threshold() const {
  /// Six digits of the largest force remain if a direction is shortened by this factor.
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
