// Maps the motor torques of a five-bar leg to the force at its foot and back, along a step.
//
// With the foot at p(y), y the angles of the two motors, and the Jacobian G = dp/dy, the power of
// the motors is that of the force with which the foot pushes on the floor: tau . y' = f . p', so
// that tau = G^T f. Neither G nor its inverse maps efforts forward: it is the transpose.
#include <Eigen/LU>
#include <array>
#include <assur/scenes/five_bar_leg.hpp>
#include <cmath>
#include <cstdio>

using Leg = assur::scenes::FiveBarLeg;

/// The foot and how it follows the motors.
struct Foot {
  Eigen::Vector2d position, velocity;
  Eigen::Matrix2d jacobian;  ///< a column for each motor, metres
};

/// Moves the leg to other angles of the motors. False where the leg does not reach them on the
/// branch that it is on. The columns of G are the velocities of the foot at unit speeds.
bool move(const std::array<double, 2>& angles, const std::array<double, 2>& speeds,
          Leg::Branch& branch, Leg::State<double>& state, Foot& foot) {
  Leg::Drivers<double> drivers;
  drivers.A.position = angles[0];
  drivers.B.position = angles[1];
  const auto at_speeds = [&](double first, double second) {
    drivers.A.velocity = first;
    drivers.B.velocity = second;
    return Leg::track(drivers, branch, state).status == assur::Status::ok;
  };
  for (int motor = 0; motor < 2; ++motor) {
    if (!at_speeds(motor == 0 ? 1 : 0, motor == 1 ? 1 : 0)) {
      return false;
    }
    foot.jacobian.col(motor) = state.outputs.P.velocity;
  }
  if (!at_speeds(speeds[0], speeds[1])) {
    return false;
  }
  foot.position = state.outputs.P.position;
  foot.velocity = state.outputs.P.velocity;
  return true;
}

int main() {
  const Leg::Drivers<double> drawn;
  std::array<Leg::State<double>, Leg::max_configurations> states;
  const Leg::Solution found = Leg::solve(drawn, states);
  if (found.count == 0) {
    return 1;
  }
  const int nearest = Leg::nearest(found, states).configuration;
  Leg::Branch branch = Leg::branch(drawn, nearest);
  Leg::State<double> state = states[static_cast<std::size_t>(nearest)];

  const Eigen::Vector2d push(5, -80);  // newtons, of the foot on the floor
  double worst = 0;
  std::printf("   foot [m]           torques [N m]      force back [N]\n");
  for (int step = 0; step < 5; ++step) {
    const double phase = 0.3 * step;
    const std::array<double, 2> angles{drawn.A.position + 0.2 * std::sin(phase),
                                       drawn.B.position + 0.2 * (1 - std::cos(phase))};
    const std::array<double, 2> speeds{0.2 * std::cos(phase), 0.2 * std::sin(phase)};
    Foot foot;
    if (!move(angles, speeds, branch, state, foot)) {
      return 1;
    }
    const Eigen::Vector2d torques = foot.jacobian.transpose() * push;
    const Eigen::Vector2d back = foot.jacobian.transpose().inverse() * torques;
    std::printf("%8.4f %8.4f   %8.3f %8.3f   %8.3f %8.3f\n", foot.position.x(), foot.position.y(),
                torques.x(), torques.y(), back.x(), back.y());
    const double power_in = torques.x() * speeds[0] + torques.y() * speeds[1];
    const double power_out = push.dot(foot.velocity);
    worst = std::fmax(worst, std::fabs(power_in - power_out));
    worst = std::fmax(worst, (back - push).norm());
  }
  const bool balances = worst < 1e-12;  // watts, and newtons, of some tens
  std::printf("power in %s power out\n", balances ? "equals" : "DIFFERS FROM");
  return balances ? 0 : 1;
}
