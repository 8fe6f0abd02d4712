// A leg whose knee is moved by a rod, as a transmission for robot software: the joint angles q =
// gamma(y) of hip and knee for the angles y of the motors, the Jacobian G = dq/dy, and the bias G'
// y', called once a millisecond for a second. G and its derivatives are the first and second
// coefficients of the joints in the solver's state.
//
// Efforts at the joints become those of the motors by tau_y = G^T tau_q, and a controller of joint
// accelerations asks the motors for y'' = G^-1 (q'' - G' y').
#include <Eigen/LU>
#include <array>
#include <assur/scenes/knee_drive.hpp>
#include <cmath>
#include <cstdio>

using Drive = assur::scenes::KneeDrive;

struct Transmission {
  Eigen::Vector2d joints;    ///< q: hip, and knee as the angle of the shank on the thigh
  Eigen::Matrix2d jacobian;  ///< G
  Eigen::Vector2d bias;      ///< G' y'
  /// The rates of the joints, and their accelerations at constant motor speeds, from the motion of
  /// the links.
  Eigen::Vector2d rate, acceleration;
};

/// Follows the branch of the drawn configuration.
class Leg {
 public:
  Leg() {
    std::array<Drive::State<double>, Drive::max_configurations> states;
    const Drive::Solution found = Drive::solve(drivers_, states);
    const int drawn = Drive::nearest(found, states).configuration;
    branch_ = Drive::branch(drivers_, drawn);
    state_ = states[static_cast<std::size_t>(drawn)];
    knee_ = 0;
    knee_ = knee();
  }

  [[nodiscard]] Eigen::Vector2d drawn() const {
    const Drive::Drivers<double> drivers;
    return {drivers.hip.position, drivers.motor.position};
  }

  /// False where the transmission does not reach the angles.
  bool at(const Eigen::Vector2d& y, const Eigen::Vector2d& speeds, Transmission& result) {
    drivers_.hip.position = y(0);
    drivers_.motor.position = y(1);
    drivers_.hip.velocity = speeds(0);
    drivers_.motor.velocity = speeds(1);
    if (Drive::track(drivers_, branch_, state_).status != assur::Status::ok) {
      return false;
    }
    knee_ = knee();
    result.joints = {y(0), knee_};
    const auto& joints = state_.coefficients.joints;
    result.jacobian << joints.hip.first, joints.knee.first;
    result.bias.setZero();
    for (int motor = 0; motor < 2; ++motor) {
      const auto place = static_cast<std::size_t>(motor);
      Eigen::Matrix2d change;
      change << joints.hip.second[place], joints.knee.second[place];
      result.bias += change * speeds * speeds(motor);
    }
    result.rate = rates(state_.links.thigh.velocity, state_.links.shank.velocity);
    result.acceleration = rates(state_.links.thigh.acceleration, state_.links.shank.acceleration);
    return true;
  }

 private:
  /// The knee's angle, next to the last one.
  [[nodiscard]] double knee() const {
    const auto& thigh = state_.links.thigh.pose.direction;
    const auto& shank = state_.links.shank.pose.direction;
    const double angle = std::atan2(shank.sin * thigh.cos - shank.cos * thigh.sin,
                                    shank.cos * thigh.cos + shank.sin * thigh.sin);
    return knee_ + std::remainder(angle - knee_, 2 * std::acos(-1.0));
  }

  [[nodiscard]] static Eigen::Vector2d rates(const Eigen::Vector3d& thigh,
                                             const Eigen::Vector3d& shank) {
    return {thigh(2), shank(2) - thigh(2)};
  }

  Drive::Drivers<double> drivers_;
  Drive::Branch branch_;
  Drive::State<double> state_;
  double knee_ = 0;
};

int main() {
  Leg leg;
  const Eigen::Vector2d start = leg.drawn();
  constexpr double period = 1e-3;
  constexpr int cycles = 1000;
  const Eigen::Vector2d load(-12, 30);  // torques at hip and knee, N m
  double error = 0;
  double power = 0;
  double bias = 0;
  Transmission before, here;
  Eigen::Vector2d rate_before;
  for (int cycle = 0; cycle <= cycles; ++cycle) {
    const double t = period * cycle;
    const Eigen::Vector2d y = start + Eigen::Vector2d(0.3 * std::sin(4 * t), 0.4 * std::sin(6 * t));
    const Eigen::Vector2d speeds(1.2 * std::cos(4 * t), 2.4 * std::cos(6 * t));
    const Eigen::Vector2d second(-4.8 * std::sin(4 * t), -14.4 * std::sin(6 * t));
    if (!leg.at(y, speeds, here)) {
      std::printf("not reached at %g s\n", t);
      return 1;
    }
    const Eigen::Vector2d rate = here.jacobian * speeds;
    const Eigen::Vector2d acceleration = here.jacobian * second + here.bias;
    const Eigen::Vector2d motors = here.jacobian.transpose() * load;
    power = std::fmax(power, std::fabs(motors.dot(speeds) - load.dot(here.rate)));
    bias = std::fmax(bias, (here.acceleration - here.bias).cwiseAbs().maxCoeff());
    if (cycle % 250 == 0) {
      std::printf("%.2f s: knee %8.4f, rate %8.4f, bias %8.4f, motors %8.3f %8.3f\n", t,
                  here.joints(1), rate(1), here.bias(1), motors(0), motors(1));
    }
    if (cycle > 0) {  // the joints arrive where their rates lead, to the second order
      const Eigen::Vector2d way = period / 2 * (rate_before + rate);
      error = std::fmax(error, (here.joints - before.joints - way).cwiseAbs().maxCoeff());
      const Eigen::Vector2d change = rate - rate_before;
      error = std::fmax(error, (change - period * acceleration).cwiseAbs().maxCoeff() * period);
    }
    before = here;
    rate_before = rate;
  }
  const bool agree = error < 1e-7 && power < 1e-11 && bias < 1e-11;
  std::printf("%d cycles, %s\n", cycles,
              agree ? "q, G and G' y' agree, power in equals power out" : "THEY DISAGREE");
  return agree ? 0 : 1;
}
