// Derivatives of efforts and forces with respect to the parameters. With the equilibrium A x + w =
// 0 they are A x_a = -(w_a + A_a x), where links and their rates depend on the parameter a so that
// the held coordinates keep their values and their rates.
#include <algorithm>
#include <assur/mechanism/forces.hpp>
#include <cmath>
#include <limits>

#include "force_reader.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::forces {

namespace {

using Eigen::VectorXd;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The largest of the known numbers.
double largest(const Eigen::VectorXd& numbers) {
  double most = 0;
  for (const double number : numbers) {
    most = std::isfinite(number) ? std::max(most, std::abs(number)) : most;
  }
  return most;
}

/// Makes the links of one configuration depend on one parameter after the other.
class Following {
 public:
  Following(const Values& values, const Configuration& configuration, const Balance& balance)
      : values_(values),
        mechanism_(values.plan().mechanism),
        configuration_(configuration),
        balance_(balance),
        equations_(balance.equilibrium(balance.links(), false).matrix.transpose(),
                   balance.threshold(), LinearEquations::OfLinks::columns) {
    for (const DriverIndex driver : mechanism_.drivers().keys()) {
      readers_ += balance.coordinates().joints_of(driver).empty() ? 0 : 1;
    }
  }

  /// The links, without derivatives if a change of the parameter violates a redundant constraint.
  [[nodiscard]] MovingLinks along(ParameterIndex parameter) const {
    MovingLinks links(values_, configuration_);
    links.vary(parameter);
    Table<LinkIndex, Displacement> displaced(mechanism_.links().size());
    const auto displace = [&] {
      for (const LinkIndex link : displaced.keys()) {
        links.displace(link, {displaced[link].x, displaced[link].y}, displaced[link].turn);
      }
    };
    displace();
    // Each pass, with the derivatives of the held coordinates at the present poses, corrects the
    // variations of one further order, of three; a law follows the joints that it reads one pass
    // later.
    const Eigen::MatrixXd before = gaps(links);
    Eigen::MatrixXd gap = before;
    for (int pass = 0; pass < 3 * (1 + readers_); ++pass) {
      const Eigen::MatrixXd moved = equations_.solve(-gap);
      for (const LinkIndex link : displaced.keys()) {
        add(moved, link, displaced[link]);
      }
      displace();
      gap = gaps(links);
    }
    if (largest(gap.col(0)) > LinearSolution::response * largest(before.col(0))) {
      const MovingNumber unknown({0, none, none}, {none, none, none});
      for (const LinkIndex link : displaced.keys()) {
        links.displace(link, {unknown, unknown}, unknown);
      }
    }
    return links;
  }

 private:
  /// The displacement of a link's origin, and the turn of the link.
  struct Displacement {
    MovingNumber x, y, turn;
  };

  /// The deviation of each held coordinate from its law as links vary, in the order a, t, t^2, t a,
  /// t^2 a.
  [[nodiscard]] Eigen::MatrixXd gaps(const MovingLinks& links) const {
    Eigen::MatrixXd result(std::ssize(balance_.held()), 5);
    for (std::size_t place = 0; place < balance_.held().size(); ++place) {
      const HeldCoordinate& held = balance_.held()[place];
      const HeldPair& pair = balance_.pairs()[held.pair];
      MovingNumber gap = links.relative(pair.first, pair.second, held.coordinate);
      if (held.driver.exists()) {
        gap = gap - links.law(held.driver);
      }
      result.row(static_cast<Eigen::Index>(place)) << gap.by()[0], gap.at()[1], gap.at()[2],
          gap.by()[1], gap.by()[2];
      result.row(static_cast<Eigen::Index>(place)) *= balance_.unit_of(held.coordinate);
    }
    return result;
  }

  /// The equations give the displacements of the links' pivots.
  void add(const Eigen::MatrixXd& moved, LinkIndex link, Displacement& to) const {
    const Eigen::Index row = balance_.row_of(link);
    if (row < 0) {
      return;
    }
    const auto number = [&](const Eigen::RowVectorXd& c) {
      return MovingNumber({0, c(1), c(2)}, {c(0), c(3), c(4)});
    };
    const Pose<double>& pose = configuration_.links[link].pose;
    const Eigen::RowVectorXd turn = moved.row(row + 2) / balance_.size();
    const Eigen::Vector2d arm = Eigen::Vector2d(pose.x, pose.y) - balance_.pivots()[link];
    to.x = to.x + number(moved.row(row) - arm.y() * turn);
    to.y = to.y + number(moved.row(row + 1) + arm.x() * turn);
    to.turn = to.turn + number(turn);
  }

  const Values& values_;
  const Mechanism& mechanism_;
  const Configuration& configuration_;
  const Balance& balance_;
  LinearEquations equations_;
  int readers_ = 0;  ///< drivers whose laws read joints
};

/// The derivatives of all numbers except those of the ground's resultant, all unknown.
Forces unknown_derivatives(const Mechanism& mechanism, const Balance& balance,
                           const Wrench& ground) {
  ForceReader reader(mechanism, balance);
  reader.add(VectorXd::Constant(std::ssize(balance.held()), none), directions_of(balance.units()));
  Forces result = reader.take();
  result.ground = ground;
  return result;
}

/// The rows of loads, NaN for links on which unknown pulls act.
VectorXd known_rows(const Balance& balance, const LinkLoads& loads) {
  VectorXd rows = balance.rows_of(loads.applied) + balance.rows_of(loads.inertia);
  for (const Reaction& pull : loads.unknown_pulls) {
    for (const LinkIndex link : {pull.on, pull.from}) {
      if (const Eigen::Index row = balance.row_of(link); row >= 0) {
        rows.segment<3>(row).setConstant(none);
      }
    }
  }
  return rows;
}

std::vector<double*> numbers_of(Forces& forces) {
  std::vector<double*> numbers;
  for (double& effort : forces.efforts) {
    numbers.push_back(&effort);
  }
  for (JointForce& joint : forces.joints) {
    for (auto& [link, force] : joint.on) {
      numbers.insert(numbers.end(), {&force.x(), &force.y()});
    }
    numbers.push_back(&joint.moment);
  }
  numbers.insert(numbers.end(),
                 {&forces.ground.force.x(), &forces.ground.force.y(), &forces.ground.moment});
  return numbers;
}

/// Forces with each number equal to that of `of`, a function of all deviations due to tolerances. A
/// derivative may be unknown if its tolerance is zero.
template <typename Function>
Forces of_deviations(std::vector<Forces> sensitivities, const Spread& spread, const Function& of) {
  if (std::ssize(sensitivities) != spread.tolerances.size() || sensitivities.empty()) {
    throw MechanismError("", "expected one derivative of the forces for each parameter");
  }
  std::vector<std::vector<double*>> numbers;
  for (Forces& forces : sensitivities) {
    numbers.push_back(numbers_of(forces));
  }
  Forces result = sensitivities.front();
  const std::vector<double*> results = numbers_of(result);
  for (std::size_t number = 0; number < results.size(); ++number) {
    VectorXd deviations(spread.tolerances.size());
    for (std::size_t parameter = 0; parameter < numbers.size(); ++parameter) {
      const auto row = static_cast<Eigen::Index>(parameter);
      const double tolerance = spread.tolerances(row);
      deviations(row) = tolerance == 0 ? 0 : tolerance * *numbers[parameter][number];
    }
    *results[number] = of(deviations);
  }
  return result;
}

}  // namespace

}  // namespace assur::mechanism::forces

namespace assur::mechanism {

std::vector<Forces> force_sensitivities(const Values& values, const Configuration& configuration) {
  const Mechanism& mechanism = values.plan().mechanism;
  const forces::Balance balance(values, configuration);
  if (!configuration.derivatives_known || !configuration.rates_known) {
    return std::vector<Forces>(
        mechanism.parameters().size(),
        forces::unknown_derivatives(mechanism, balance,
                                    {Eigen::Vector2d::Constant(forces::none), forces::none}));
  }
  const forces::LinearEquations equations(balance.matrix(), balance.threshold(),
                                          forces::LinearEquations::OfLinks::rows);
  const forces::LinkLoads loads = forces::link_loads(values, configuration, balance);
  const Eigen::VectorXd load = balance.rows_of(loads.applied) + balance.rows_of(loads.inertia);
  const forces::LinearSolution unknowns = equations.solution(-load);
  const Eigen::VectorXd carried = equations.some_solution(-load);
  const forces::Following following(values, configuration, balance);
  std::vector<Forces> result;
  for (const ParameterIndex parameter : mechanism.parameters().keys()) {
    const forces::MovingLinks links = following.along(parameter);
    const forces::Equilibrium equilibrium = balance.equilibrium(links, true);
    const forces::LinkLoads change = forces::moving_loads(mechanism, links, balance).derivatives;
    const Wrench ground = forces::ground_resultant(mechanism, balance, change);
    if (!loads.unknown_pulls.empty()) {
      result.push_back(forces::unknown_derivatives(mechanism, balance, ground));
      continue;
    }
    const forces::LinearSolution rates = equations.solution(
        -(forces::known_rows(balance, change) + equilibrium.derivative * carried));
    const std::vector<Eigen::Vector2d> directions = forces::directions_of(equilibrium.units);
    forces::ForceReader reader(mechanism, balance);
    reader.add(rates.shortest, directions);
    reader.add_forces(carried, forces::turning_of(equilibrium.units));
    reader.forget(rates, directions);
    reader.forget(unknowns, directions);
    result.push_back(reader.take());
    result.back().ground = ground;
  }
  return result;
}

Forces worst_case(const std::vector<Forces>& sensitivities, const Spread& spread) {
  return forces::of_deviations(sensitivities, spread, [](const Eigen::VectorXd& deviations) {
    return deviations.cwiseAbs().sum();
  });
}

Forces root_sum_square(const std::vector<Forces>& sensitivities, const Spread& spread) {
  return forces::of_deviations(sensitivities, spread,
                               [](const Eigen::VectorXd& deviations) { return deviations.norm(); });
}

}  // namespace assur::mechanism
