#include "smooth_crossings.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <assur/local/crossing.hpp>
#include <assur/local/singular_point.hpp>
#include <assur/mechanism/error.hpp>
#include <cmath>
#include <limits>

#include "plan/plan_data.hpp"
#include "solve/closure_error.hpp"
#include "solve/constraints_on_way.hpp"

namespace assur::mechanism::follow {

namespace {

/// A singular point that branches go through.
struct Crossing {
  EventLocation location;
  Eigen::VectorXd place;  ///< in the coordinates of configurations
  int corank;             ///< the rank that the constraints lose there
  std::vector<PointIndex> through;
};

class Crossings {
 public:
  Crossings(SnapshotSolver& solver, const SnapshotPointer& left, const SnapshotPointer& right,
            const BranchMatching& matching)
      : solver_(solver), left_(*left), right_(*right), matching_(matching) {}

  [[nodiscard]] std::optional<CrossedBranches> run() {
    if (left_.count() != right_.count() || solver_.do_laws_read_joints()) {
      return std::nullopt;
    }
    CrossedBranches result{matching_.to_right, {}};
    Table<PointIndex, bool> is_unclear(left_.count(), false);
    const auto note = [&](PointIndex point) { is_unclear[point] = true; };
    std::ranges::for_each(matching_.left_alone, note);
    std::ranges::for_each(matching_.turned, note);
    for (const TouchingPair& pair : matching_.touching) {
      note(pair.one);
      note(pair.other);
    }
    Table<PointIndex, bool> is_taken(right_.count(), false);
    for (const PointIndex point : is_unclear.keys()) {
      if (is_unclear[point]) {
        result.to_right[point] = through_crossing(point);
      }
      const PointIndex to = result.to_right[point];
      if (!to.exists() || is_taken[to]) {
        return std::nullopt;
      }
      is_taken[to] = true;
    }
    for (Crossing& crossing : crossings_) {
      if (crossing.through.size() > 1) {
        result.crossings.push_back({EventKind::crossing,
                                    crossing.location.parameter,
                                    std::move(crossing.through),
                                    {},
                                    PointIndex(),
                                    std::move(crossing.location.configuration),
                                    crossing.location.uncertainty});
      }
    }
    std::ranges::sort(result.crossings, {}, [this](const SingularEvent& event) {
      return std::copysign(1.0, width()) * event.parameter;
    });
    return result;
  }

 private:
  [[nodiscard]] double width() const { return right_.parameter - left_.parameter; }

  /// The point of the right set to which a branch goes through a crossing; none if it is unknown.
  [[nodiscard]] PointIndex through_crossing(PointIndex point) {
    for (Crossing& crossing : crossings_) {
      if (const PointIndex to = beyond(crossing, point); to.exists()) {
        crossing.through.push_back(point);
        return to;
      }
    }
    if (auto crossing = crossing_ahead(point)) {
      if (const PointIndex to = beyond(*crossing, point); to.exists()) {
        crossing->through.push_back(point);
        crossings_.push_back(std::move(*crossing));
        return to;
      }
    }
    return {};
  }

  [[nodiscard]] PointIndex beyond(const Crossing& crossing, PointIndex from) const {
    const PointIndex to = led_to(crossing, left_, from, right_);
    if (!to.exists() || led_to(crossing, right_, to, left_) != from) {
      return {};
    }
    // Each lost rank reverses the sign of one group's determinant.
    int changed = 0;
    for (const GroupIndex group : left_.roles.keys()) {
      const double product = left_.configuration(from).determinants[group] *
                             right_.configuration(to).determinants[group];
      if (left_.roles[group] != right_.roles[group] || std::isnan(product)) {
        return {};
      }
      changed += product < 0 ? 1 : 0;
    }
    return changed == crossing.corank ? to : PointIndex();
  }

  /// The point that tangent and bend predict beyond a crossing, if only one configuration is near.
  [[nodiscard]] static PointIndex led_to(const Crossing& crossing, const Snapshot& near,
                                         PointIndex from, const Snapshot& far) {
    const double before = crossing.location.parameter - near.parameter;
    const double after = far.parameter - crossing.location.parameter;
    const ConfigurationPoint& here = near.points[from];
    Eigen::VectorXd on;
    if (!local::goes_on_behind<Eigen::VectorXd>(crossing.place - here.at, before * here.slope,
                                                after / before, 0.0, on)) {
      return {};
    }
    const Eigen::VectorXd place = crossing.place + on;
    const PointIndex to = nearest(far, place);
    const double miss = (far.points[to].at - place).norm();
    const bool is_only = std::ranges::all_of(far.points, [&](const ConfigurationPoint& other) {
      return &other == &far.points[to] ||
             miss < local::CrossingLimits<double>().correction * (other.at - place).norm();
    });
    return is_only ? to : PointIndex();
  }

  /// The singular point to which the tangent of a configuration leads.
  [[nodiscard]] std::optional<Crossing> crossing_ahead(PointIndex point) {
    const Configuration& start = left_.configuration(point);
    const double way_of_size = solver_.way_of_size(left_);
    solve::ConstraintsOnWay::Point at{solve::poses_of(start.links), left_.parameter};
    try {
      Values& values = solver_.values_at(left_.parameter);
      const std::vector<RedundantJoint> left_out =
          start.is_consistent ? solver_.plan().redundant() : std::vector<RedundantJoint>();
      const solve::ConstraintsOnWay system(values, left_out, solver_.sweep().parameter, way_of_size,
                                           at);
      const Eigen::VectorXd direction = std::copysign(1.0, width()) * system.direction(start.links);
      const auto [distance, corank] = first_singular(system, at, direction);
      if (!(distance * way_of_size <= 2 * std::abs(width()))) {
        return std::nullopt;
      }
      system.move(distance * direction, at);
      const auto singular = local::singular_point(system, at, corank);
      const double parameter = singular.at.parameter;
      if (!singular.is_found || singular.opening > system.rounding() ||
          !((parameter - left_.parameter) * (parameter - right_.parameter) < 0)) {
        return std::nullopt;
      }
      Crossing crossing{{parameter, configuration(singular.at), 0}, {}, corank, {}};
      // A few roundings of the data from which F' is computed.
      constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
      crossing.location.uncertainty = rounding * (way_of_size + std::abs(parameter));
      crossing.place = solver_.place_of(crossing.location.configuration);
      return crossing;
    } catch (const MechanismError&) {
      return std::nullopt;  // a formula may have no value there
    }
  }

  /// The distance from a point to the rank loss of F', to first order, and the number of ranks lost
  /// together.
  [[nodiscard]] static std::pair<double, int> first_singular(
      const solve::ConstraintsOnWay& system, const solve::ConstraintsOnWay::Point& point,
      const Eigen::VectorXd& direction) {
    const Eigen::Index unknowns = system.unknown_count();
    const Eigen::MatrixXd J = system.jacobian(point).leftCols(unknowns);
    const Eigen::MatrixXd change = system.bends(point, direction).leftCols(unknowns);
    const Eigen::MatrixXd ratio = J.colPivHouseholderQr().solve(-change);
    const Eigen::VectorXcd inverses = ratio.eigenvalues();
    double nearest = std::numeric_limits<double>::infinity();
    const auto each_zero = [&](const auto& use) {
      for (const std::complex<double>& inverse : inverses) {
        // The bend of the branch spreads the m zeros of a point where m ranks are lost over a
        // circle; `together` allows this width.
        constexpr double nearly_real = 0.3;
        if (inverse.real() > 0 && std::abs(inverse.imag()) < nearly_real * inverse.real()) {
          use(1 / inverse.real());
        }
      }
    };
    each_zero([&](double zero) { nearest = std::min(nearest, zero); });
    int count = 0;
    each_zero([&](double zero) {
      count += zero < local::CrossingLimits<double>().together * nearest ? 1 : 0;
    });
    return {nearest, count};
  }

  /// A configuration in which only the links' places are known.
  [[nodiscard]] Configuration configuration(const solve::ConstraintsOnWay::Point& at) {
    Configuration result = unknown_configuration(solver_.plan());
    const Values& values = solver_.values_at(at.parameter);
    const Mechanism& mechanism = solver_.plan().mechanism();
    for (const LinkIndex link : result.links.keys()) {
      result.links[link].pose = at.links[link];
    }
    for (const OutputIndex output : result.outputs.keys()) {
      const FeatureIndex point = mechanism.outputs()[output].point;
      const Pose<double> pose =
          support::pose_in(at.links[mechanism.features()[point].link], values.frame(point).pose);
      result.outputs[output].position = {pose.x, pose.y};
    }
    result.residual = solve::closure_error(values, result, solver_.length());
    return result;
  }

  SnapshotSolver& solver_;
  const Snapshot& left_;
  const Snapshot& right_;
  const BranchMatching& matching_;
  std::vector<Crossing> crossings_;
};

}  // namespace

std::optional<CrossedBranches> smooth_crossings(SnapshotSolver& solver, const SnapshotPointer& left,
                                                const SnapshotPointer& right,
                                                const BranchMatching& matching) {
  return Crossings(solver, left, right, matching).run();
}

}  // namespace assur::mechanism::follow
