// Maps the motor torques of a five-bar leg to the force at its foot and back, along a step.
//
// With the foot at p(y), y the angles of the two motors, and the Jacobian G = dp/dy, the first
// coefficients of the solver, the power of the motors equals that of the force of the foot on the
// floor: tau . y' = f . p', so that tau = G^T f. Efforts are mapped by the transpose, not by G or
// its inverse.
#include <Eigen/LU>
#include <array>
#include <assur/scenes/five_bar_leg.hpp>
#include <cmath>
#include <cstdio>

using Leg = assur::scenes::FiveBarLeg;

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
    Leg::Drivers<double> motors;
    motors.A.position = drawn.A.position + 0.2 * std::sin(phase);
    motors.B.position = drawn.B.position + 0.2 * (1 - std::cos(phase));
    motors.A.velocity = 0.2 * std::cos(phase);
    motors.B.velocity = 0.2 * std::sin(phase);
    if (Leg::track(motors, branch, state).status != assur::Status::ok) {
      return 1;  // the current branch does not reach these angles
    }
    const auto& foot = state.outputs.P;
    const Eigen::Matrix2d G = state.coefficients.outputs.P.first;  // a column for each motor
    const Eigen::Vector2d torques = G.transpose() * push;
    const Eigen::Vector2d back = G.transpose().inverse() * torques;
    std::printf("%8.4f %8.4f   %8.3f %8.3f   %8.3f %8.3f\n", foot.position(0), foot.position(1),
                torques.x(), torques.y(), back.x(), back.y());
    const double power_in = torques.dot(Eigen::Vector2d(motors.A.velocity, motors.B.velocity));
    const double power_out = push.dot(Eigen::Vector2d(foot.velocity(0), foot.velocity(1)));
    worst = std::fmax(worst, std::fabs(power_in - power_out));
    worst = std::fmax(worst, (back - push).norm());
  }
  const bool balances = worst < 1e-12;  // watts, and newtons, of some tens
  std::printf("power in %s power out\n", balances ? "equals" : "DIFFERS FROM");
  return balances ? 0 : 1;
}
