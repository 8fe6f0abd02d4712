#include "circuit_finder.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace assur::mechanism::follow {

namespace {

/// Two places of the mechanism that are nearer than this, relative to its size, are one. Rounding
/// moves configurations beside a fold by its square root, a hundredth of this, and an angle that a
/// person types with seven digits is as near to a whole turn.
constexpr double same_place = 1e-6;

bool are_same(const Shapes& one, const Shapes& other) {
  const auto is_near = [](double a, double b) { return std::abs(a - b) < same_place; };
  const auto is_turned = [](double a, double b) {
    return 2 * std::abs(std::sin((a - b) / 2)) < same_place;
  };
  return std::ranges::equal(one.lengths, other.lengths, is_near) &&
         std::ranges::equal(one.angles, other.angles, is_turned);
}

/// Whether all branches of an event meet in one configuration.
bool is_meeting(EventKind kind) {
  return kind == EventKind::fold || kind == EventKind::birth || kind == EventKind::crossing;
}

}  // namespace

void CircuitFinder::join_at(const BranchEvent& event) {
  if (!is_meeting(event.kind)) {
    return;
  }
  std::vector<int> met = event.ended;
  met.insert(met.end(), event.begun.begin(), event.begun.end());
  met.push_back(event.through);
  std::erase(met, 0);
  for (const int branch : met) {
    join(met.front(), branch);
  }
}

void CircuitFinder::join_at_step(double parameter, const std::vector<StepRow>& rows) {
  const Shapes shapes = shapes_at(parameter);
  const bool is_first = !has_begun_;
  if (is_first) {
    has_begun_ = true;
    shapes_ = shapes;
  }
  next_.clear();
  const bool is_same = are_same(shapes, shapes_);
  const StepRow* before = nullptr;
  for (const StepRow& row : rows) {
    if (row.branch == 0 || !row.state->is_consistent) {
      continue;
    }
    if (before != nullptr && before->point == row.point) {
      join(before->branch, row.branch);
    }
    before = &row;
    if (!is_same) {
      continue;
    }
    const Eigen::VectorXd at = solver_.place_of(*row.state);
    if (is_first) {
      starts_.push_back({row.branch, at});
      continue;
    }
    const auto apart = [&at](const Start& start) { return (start.at - at).norm(); };
    const auto nearest = std::ranges::min_element(starts_, {}, apart);
    if (nearest != starts_.end() && apart(*nearest) < same_place) {
      join(nearest->branch, row.branch);
      next_.emplace_back(row.branch, nearest->branch);
    }
  }
}

void CircuitFinder::join(int one, int other) {
  const int first = std::min(first_of(one), first_of(other));
  for (const int branch : {one, other}) {
    joined_with_[static_cast<std::size_t>(first_of(branch))] = first;
  }
}

int CircuitFinder::first_of(int branch) {
  const std::size_t known = joined_with_.size();
  if (static_cast<std::size_t>(branch) >= known) {
    joined_with_.resize(static_cast<std::size_t>(branch) + 1);
    std::iota(joined_with_.begin() + static_cast<std::ptrdiff_t>(known), joined_with_.end(),
              static_cast<int>(known));
  }
  int& with = joined_with_[static_cast<std::size_t>(branch)];
  return with == branch ? branch : with = first_of(with);
}

Shapes CircuitFinder::shapes_at(double parameter) {
  const Values& values = solver_.values_at(parameter);
  const Mechanism& mechanism = solver_.plan().mechanism();
  const double length = solver_.length();
  Shapes shapes;
  for (const Feature& feature : mechanism.features()) {
    shapes.lengths.push_back(values.value_of(feature.x) / length);
    shapes.lengths.push_back(values.value_of(feature.y) / length);
    if (feature.is_line) {
      const double x = values.value_of(feature.along_x);
      const double y = values.value_of(feature.along_y);
      const double along = std::hypot(x, y);
      shapes.lengths.insert(shapes.lengths.end(), {x / along, y / along});
    }
  }
  for (const Driver& driver : mechanism.drivers()) {
    if (!mechanism.numbers()[driver.position].formula.joints().empty()) {
      continue;
    }
    const double position = values.value_of(driver.position);
    if (mechanism.joints()[driver.joint].type == JointType::revolute) {
      shapes.angles.push_back(position);
    } else {
      shapes.lengths.push_back(position / length);
    }
  }
  return shapes;
}

Circuits CircuitFinder::found(const ShownBranches& told) {
  const auto shown = static_cast<std::size_t>(told.count());
  Circuits circuits{std::vector<int>(shown, 0), std::vector<int>(shown, 0)};
  const std::vector<int> trackers = told.in_order();
  std::map<int, int> numbers;
  for (std::size_t place = 0; place < shown; ++place) {
    const auto number = static_cast<int>(numbers.size()) + 1;
    circuits.of_branch[place] =
        numbers.try_emplace(first_of(trackers[place]), number).first->second;
  }
  for (const auto& [branch, next] : next_) {
    const int from = told.shown_so_far(branch);
    if (from > 0) {
      circuits.next[static_cast<std::size_t>(from) - 1] = told.shown_so_far(next);
    }
  }
  return circuits;
}

}  // namespace assur::mechanism::follow
