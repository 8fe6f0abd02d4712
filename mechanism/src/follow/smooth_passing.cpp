#include "smooth_passing.hpp"

#include <algorithm>
#include <array>
#include <assur/mechanism/error.hpp>
#include <cmath>
#include <limits>

#include "solve/closure_error.hpp"

namespace assur::mechanism::follow {

namespace {

/// The first group whose determinant changes its sign between two points, if any.
GroupIndex first_turned(const BranchPoint& from, const BranchPoint& to) {
  const auto& before = from.state().determinants;
  const auto& after = to.state().determinants;
  for (const GroupIndex group : before.keys()) {
    if (from.set->roles[group] == to.set->roles[group] &&
        std::min(before[group], after[group]) < 0 && std::max(before[group], after[group]) > 0) {
      return group;
    }
  }
  return {};
}

/// The places of samples on one side, in parts of the width. From the outer ones follows where a
/// smooth branch would be at the innermost.
constexpr std::array sample_places{0.25, 0.5, 0.75, 1.0};
constexpr std::size_t inner_samples = 2;  ///< the first two, one on either side

class Passing {
 public:
  Passing(LoneBranches& branches, const BranchPoint& from, const BranchPoint& to, GroupIndex group)
      : branches_(branches), from_(from), to_(to), group_(group) {
    const double before = determinant(from);
    centre_ = from.set->parameter +
              (to.set->parameter - from.set->parameter) * before / (before - determinant(to));
  }

  std::optional<SmoothPassing> run() {
    constexpr double ratio = 1.6;
    constexpr int widths = 16;
    constexpr int most_in_vain = 3;
    const double start = (to_.set->parameter - from_.set->parameter) / 2;
    for (const double factor : {ratio, 1 / ratio}) {
      double width = factor > 1 ? start : start * factor;
      int in_vain = 0;
      for (int index = 0; index < widths && in_vain < most_in_vain; ++index, width *= factor) {
        const bool is_better = take(at_width(width));
        in_vain = is_better ? 0 : in_vain + (best_ ? 1 : 0);
      }
    }
    return std::move(best_);
  }

 private:
  /// Keeps the place of the width with the least residual of the closures, and the least opening of
  /// all widths. Returns whether the opening has become smaller.
  bool take(std::optional<SmoothPassing> found) {
    if (!found) {
      return false;
    }
    if (!best_) {
      best_ = std::move(found);
      return true;
    }
    const double opening = std::min(found->opening, best_->opening);
    const bool is_better = opening < best_->opening;
    if (residual_of(*found) < residual_of(*best_)) {
      best_ = std::move(found);
    }
    best_->opening = opening;
    return is_better;
  }
  static double residual_of(const SmoothPassing& passing) {
    return passing.location.configuration.residual;
  }

  [[nodiscard]] double determinant(const BranchPoint& point) const {
    return point.state().determinants[group_];
  }

  /// Whether the links of the group play the same roles at a point as at the start: only then are
  /// determinants comparable.
  [[nodiscard]] bool plays_its_roles(const BranchPoint& point) const {
    return point.set->roles[group_] == from_.set->roles[group_];
  }

  /// The residual of the closures at a place; infinite where a formula has no value.
  [[nodiscard]] double closure_error(const EventLocation& location) const {
    SnapshotSolver& solver = branches_.solver();
    try {
      return solve::closure_error(solver.values_at(location.parameter), location.configuration,
                                  solver.length());
    } catch (const MechanismError&) {
      return std::numeric_limits<double>::infinity();
    }
  }

  /// The samples, alternately before and after the centre, from the inside out; empty if one cannot
  /// be found.
  [[nodiscard]] std::vector<BranchPoint> samples(double width) {
    std::vector<BranchPoint> found;
    BranchPoint before = from_;
    BranchPoint after = to_;
    for (const double place : sample_places) {
      const auto earlier = branches_.continued(before, centre_ - width * place);
      const auto later =
          earlier ? branches_.continued(after, centre_ + width * place) : std::nullopt;
      if (!later || !plays_its_roles(*earlier) || !plays_its_roles(*later)) {
        return {};
      }
      found.push_back(before = *earlier);
      found.push_back(after = *later);
    }
    return found;
  }

  [[nodiscard]] std::optional<SmoothPassing> at_width(double width) {
    const std::vector<BranchPoint> found = samples(width);
    if (found.empty()) {
      return std::nullopt;
    }
    Eigen::VectorXd nodes(static_cast<Eigen::Index>(found.size()));
    for (std::size_t index = 0; index < found.size(); ++index) {
      nodes(static_cast<Eigen::Index>(index)) = determinant(found[index]);
    }
    if (!is_monotonic(nodes)) {
      return std::nullopt;
    }
    const Eigen::VectorXd weights = weights_at_zero(nodes);
    SmoothPassing passing{{centre_, {}}, Eigen::VectorXd::Zero(found[0].here().at.size()), {}, 0};
    Blend blend(branches_.solver().plan());
    for (std::size_t index = 0; index < found.size(); ++index) {
      const double weight = weights(static_cast<Eigen::Index>(index));
      passing.location.parameter += weight * (found[index].set->parameter - centre_);
      passing.place += weight * found[index].here().at;
      blend.add(found[index].state(), weight);
    }
    passing.location.configuration = blend.result();
    passing.location.configuration.residual = closure_error(passing.location);
    const Eigen::VectorXd way = found[1].here().at - found[0].here().at;
    passing.slope = way / (found[1].set->parameter - found[0].set->parameter);
    for (std::size_t inner = 0; inner < inner_samples; ++inner) {
      const double miss = (found[inner].here().at - smooth_place(found, found[inner])).norm();
      passing.opening = std::max(passing.opening, miss * way.norm() / 2);
    }
    return passing;
  }

  /// Whether nodes that are listed alternately on both sides, from the inside out, grow on either
  /// side.
  [[nodiscard]] static bool is_monotonic(const Eigen::VectorXd& nodes) {
    for (Eigen::Index index = 0; index < nodes.size(); ++index) {
      const double nearer = index < 2 ? 0 : std::abs(nodes(index - 2));
      if (!(std::abs(nodes(index)) > nearer) || nodes(index) * nodes(index % 2) < 0 ||
          nodes(0) * nodes(1) > 0) {
        return false;
      }
    }
    return true;
  }

  /// Where the branch would be at the parameter of a sample, from places and slopes of the outer
  /// ones.
  [[nodiscard]] static Eigen::VectorXd smooth_place(const std::vector<BranchPoint>& found,
                                                    const BranchPoint& sample) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(sample.here().at.size());
    const double place = sample.set->parameter;
    for (std::size_t one = inner_samples; one < found.size(); ++one) {
      double basis = 1;
      double slope = 0;
      for (std::size_t other = inner_samples; other < found.size(); ++other) {
        if (other != one) {
          const double apart = found[one].set->parameter - found[other].set->parameter;
          basis *= (place - found[other].set->parameter) / apart;
          slope += 1 / apart;
        }
      }
      const double away = place - found[one].set->parameter;
      const ConfigurationPoint& point = found[one].here();
      sum += basis * basis * ((1 - 2 * slope * away) * point.at + away * point.slope);
    }
    return sum;
  }

  LoneBranches& branches_;
  BranchPoint from_, to_;
  GroupIndex group_;
  double centre_;
  std::optional<SmoothPassing> best_;
};

}  // namespace

bool is_turned(const BranchPoint& from, const BranchPoint& to) {
  return first_turned(from, to).exists();
}

std::optional<SmoothPassing> passing(LoneBranches& branches, const BranchPoint& from,
                                     const BranchPoint& to) {
  const GroupIndex group = first_turned(from, to);
  return group.exists() ? Passing(branches, from, to, group).run() : std::nullopt;
}

}  // namespace assur::mechanism::follow
