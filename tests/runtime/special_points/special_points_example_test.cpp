// Law: the special point method reproduces the worked example of Quintero, Calle, Diaz and Henao,
// shows which printed numbers leave it, and fails where its lines are parallel, and only there.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <assur/special_points.hpp>
#include <assur/tetrad/model_01.hpp>
#include <assur/tetrad/model_02.hpp>
#include <iostream>

#include "largest.hpp"
#include "runtime/exact_assembly.hpp"
#include "runtime/motion_error.hpp"

namespace assur::test::special_points_example_test {
namespace {

using Group = tetrad::Model02;
using Plane = Eigen::Vector2d;

/// The R-(RRP-RRR) mechanism at crank angle 70 degrees, the crank turning clockwise at 1 rad/s. The
/// paper's B, D, F are the model's; its E is the model's G, its G the model's E.
class WorkedExample : public testing::Test {
 protected:
  using System = SpecialPointSystem<Group, double>;
  static constexpr double pi = 3.14159265358979323846;
  /// The paper's order of the equations (35 to 38 and 50 to 53), by side of the system.
  static constexpr std::array<int, 4> side_of_velocity_equation = {0, 1, 2, 3};
  static constexpr std::array<int, 4> side_of_acceleration_equation = {2, 3, 0, 1};

  void SetUp() override {
    constexpr double GD = 300;
    constexpr double FG = 150;
    constexpr double FD = 180;
    const double along = (GD * GD + FG * FG - FD * FD) / (2 * GD);
    d_.x_G_BCG = 500;
    d_.ED = GD;
    d_.x_F_EDF = along;
    d_.y_F_EDF = -std::sqrt(FG * FG - along * along);
    d_.GF = 300;
    const double phi = 70 * pi / 180;
    u_.x_B = 100 * std::cos(phi);
    u_.y_B = 100 * std::sin(phi);
    u_.x_E = 275;
    q_.theta_BCG = direction_of(41.968 * pi / 180);
    q_.theta_EDF = direction_of(92.29 * pi / 180);
    q_.theta_GF = direction_of(-103.092 * pi / 180);
    q_.s_C = 307.74;
    ASSERT_EQ((refine<Group, double>(d_, u_, q_)), Status::ok);
    u_rate_ = {u_.y_B, -u_.x_B, 0, 0};
    u_second_rate_ = {-u_.x_B, -u_.y_B, 0, 0};
    ASSERT_EQ((special_point_motion<Group, double>(d_, u_, q_, u_rate_, u_second_rate_, motion_)),
              Status::ok);
    Matrix<double, 2, 2> points;
    ASSERT_EQ((special_points<Group, double>(d_, u_, q_, points)), Status::ok);
    S3_ = points.row(0);
    S5_ = points.row(1);
    Poses<double, Group::link_count> poses;
    Group::link_poses(d_, u_, q_, poses);
    B_ = {poses[0].x, poses[0].y};
    G_ = {poses[1].x, poses[1].y};
    D_ = {poses[2].x, poses[2].y};
    E_ = {poses[3].x, poses[3].y};
    F_ = E_ + d_.GF * Plane(q_.theta_GF.cos, q_.theta_GF.sin);
  }

  Group::Dimensions<double> d_;
  Group::Inputs<double> u_;
  Group::Configuration<double> q_;
  Vector<double, Group::input_count> u_rate_;
  Vector<double, Group::input_count> u_second_rate_;
  Motion<Group, double> motion_;
  Plane S3_, S5_, B_, D_, E_, F_, G_;
};

/// Half a unit of the fourth decimal, to which the derived column gives its numbers.
constexpr double printed = 5e-5;

TEST_F(WorkedExample, PointsAndLengths) {
  EXPECT_NEAR(S3_.x(), 282.2732, printed);
  EXPECT_NEAR(S3_.y(), -181.8487, printed);
  EXPECT_NEAR(S5_.x(), 521.2301, printed);
  EXPECT_NEAR(S5_.y(), 532.0031, printed);
  EXPECT_NEAR((S3_ - B_).norm(), 370.9648, printed);
  EXPECT_NEAR((S3_ - D_).norm(), 481.9941, printed);
  EXPECT_NEAR((S5_ - F_).norm(), 436.2223, printed);
  EXPECT_NEAR((S5_ - E_).norm(), 155.0344, printed);
  // S3 lies on GD and across from B to the rod, S5 on BE and GF.
  const auto cross = [](const Plane& a, const Plane& b) { return a.x() * b.y() - a.y() * b.x(); };
  EXPECT_NEAR(cross(S3_ - G_, D_ - G_), 0, 1e-8);
  EXPECT_NEAR((S3_ - B_).dot(E_ - B_), 0, 1e-8);
  EXPECT_NEAR(cross(S5_ - B_, E_ - B_), 0, 1e-8);
  EXPECT_NEAR(cross(S5_ - G_, F_ - G_), 0, 1e-8);
}

TEST_F(WorkedExample, LengthsAreThoseOfThePapersEquations) {
  const System system(d_, u_, q_);
  // Rows as Eqs. 35 to 38; columns w2 = w3, w4, w5, v_S3S2.
  const std::array<std::array<double, 4>, 4> derived = {
      {{370.9648, 0, 0, 1}, {481.9941, 300, 0, 0}, {500, 0, 155.0344, 0}, {0, 150, 436.2223, 0}}};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      EXPECT_NEAR(std::abs(system.lengths()(row, column)),
                  derived[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)],
                  printed);
    }
  }
}

TEST_F(WorkedExample, DiagramsAndRates) {
  const System system(d_, u_, q_);
  Matrix<double, 4, 2> known;
  Group::special_point_velocities(d_, u_, q_, system.places(), u_rate_, known);
  const Vector<double, 4> velocity_sums = system.sums(known);
  Group::special_point_accelerations(d_, u_, q_, system.places(), motion_.velocity, u_rate_,
                                     u_second_rate_, known);
  const Vector<double, 4> acceleration_sums = system.sums(known);
  const std::array<double, 4> velocity_equations = {59.4076, 138.2502, 21.4059, 119.3195};
  const std::array<double, 4> acceleration_equations = {158.1956, 137.7348, 40.3772, 6.1834};
  for (std::size_t equation = 0; equation < 4; ++equation) {
    EXPECT_NEAR(std::abs(velocity_sums(side_of_velocity_equation[equation])),
                velocity_equations[equation], printed);
    EXPECT_NEAR(std::abs(acceleration_sums(side_of_acceleration_equation[equation])),
                acceleration_equations[equation], printed);
  }
  // The paper counts angular velocities clockwise and angular accelerations counter-clockwise.
  EXPECT_NEAR(-motion_.velocity(0), 0.008608, 5e-7);
  EXPECT_NEAR(-motion_.velocity(1), 0.474664, 5e-7);
  EXPECT_NEAR(-motion_.velocity(2), 0.110311, 5e-7);
  EXPECT_NEAR(motion_.velocity(3), 62.6009, printed);
  EXPECT_NEAR(motion_.acceleration(0), 0.266305, 5e-7);
  EXPECT_NEAR(motion_.acceleration(1), 0.448469, 5e-7);
  EXPECT_NEAR(motion_.acceleration(2), 0.161533, 5e-7);
  EXPECT_NEAR(motion_.acceleration(3), -58.4125, printed);
}

/// The paper's equations 35 to 38 in clockwise w2, w4, w5 and v_S3S2, with its printed lengths
/// but for L_BS3.
Eigen::Vector4d solve_velocities(double L_BS3, const Eigen::Vector4d& sides) {
  Eigen::Matrix4d system;
  system << -L_BS3, 0, 0, 1, -481.9848, 300, 0, 0, 500, 0, 155.1123, 0, 0, 150, 436.2923, 0;
  return system.partialPivLu().solve(sides);
}
/// The same for equations 50 to 53, in counter-clockwise angular accelerations and a_S3S2^p.
Eigen::Vector4d solve_accelerations(double L_BS3, const Eigen::Vector4d& sides) {
  Eigen::Matrix4d system;
  system << 500, 0, 155.1123, 0, 0, 150, 436.2923, 0, L_BS3, 0, 0, 1, -481.9848, 300, 0, 0;
  return system.partialPivLu().solve(sides);
}

TEST_F(WorkedExample, PrintedNumbersLeaveTheMethodAtOneLength) {
  constexpr double printed_L_BS3 = 248.0601;
  const Eigen::Vector4d velocity_sides(59.3891, 138.2264, 21.4233, 119.3355);
  const Eigen::Vector4d acceleration_sides(158.2219, 137.7597, 40.3939, 6.173);
  // Neither the length nor the two numbers that follow from it are the mechanism's.
  EXPECT_GT(std::abs((S3_ - B_).norm() - printed_L_BS3), 100);
  EXPECT_GT(std::abs(motion_.velocity(3) - 61.5254), 1);
  EXPECT_GT(std::abs(motion_.acceleration(3) - -25.6695), 30);
  // It is the horizontal part of BS3, as far as the paper's drawing is the mechanism.
  EXPECT_NEAR(std::abs(S3_.x() - B_.x()), 248.0712, printed);
  EXPECT_NEAR(std::abs(S3_.x() - B_.x()), printed_L_BS3, 0.012);
  // With it the printed equations give the printed numbers, ...
  const Eigen::Vector4d v = solve_velocities(printed_L_BS3, velocity_sides);
  const Eigen::Vector4d a = solve_accelerations(printed_L_BS3, acceleration_sides);
  EXPECT_NEAR(v(0), 0.0086, printed);
  EXPECT_NEAR(v(1), 0.4746, 1e-4);
  EXPECT_NEAR(v(2), 0.1104, printed);
  EXPECT_NEAR(v(3), 61.5254, printed);
  EXPECT_NEAR(a(0), 0.2663, printed);
  EXPECT_NEAR(a(1), 0.4485, printed);
  EXPECT_NEAR(a(2), 0.1616, printed);
  EXPECT_NEAR(a(3), -25.6695, 2e-4);  // the printed sides carry 1e-4 into it
  // ... and with the true length the true ones, as far as the other printed numbers allow.
  EXPECT_NEAR(solve_velocities((S3_ - B_).norm(), velocity_sides)(3), motion_.velocity(3), 0.02);
  EXPECT_NEAR(solve_accelerations((S3_ - B_).norm(), acceleration_sides)(3),
              motion_.acceleration(3), 0.02);
}

/// RRR-RRR in which the angle between BC and ED shrinks to zero: S_CD runs to infinity, while the
/// group stays regular.
TEST(PointAtInfinity, IsSaidAndDigitsAreCounted) {
  using Model = tetrad::Model01;
  using Rates = Vector<double, Model::input_count>;
  constexpr unsigned seed = 1914;
  constexpr int groups = 200;
  constexpr int last_power = 17;
  RandomInputs random(seed);
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double worst_ratio = 0;  // of an error to epsilon condition(L)
  std::array<double, last_power> worst_error{};
  std::array<std::array<int, last_power + 1>, 3> count{};  // ok, near-singular, at infinity
  for (int group = 0; group < groups;) {
    const auto u1 = random.vector<Rates>();
    const auto u2 = random.vector<Rates>();
    const Assembly<Model, Rational> first = {random.variables<Model::Dimensions<Rational>>(),
                                             random.variables<Model::Inputs<Rational>>(),
                                             random.variables<Model::Configuration<Rational>>()};
    const auto zero = [](const auto& length) { return length == Rational(0); };
    if (zero(first.d.BC) || zero(first.d.ED) || (zero(first.d.x_G_BCG) && zero(first.d.y_G_BCG))) {
      continue;  // a side without its line
    }
    ++group;
    for (std::size_t power = 0; power <= last_power; ++power) {
      SCOPED_TRACE("group " + std::to_string(group) + ", power " + std::to_string(power));
      // t is the tangent of half the angle.
      Rational t = power == last_power ? 0 : 1;
      for (std::size_t factor = 0; factor < power; ++factor) {
        t = t / Rational(10);
      }
      const Rational square = Rational(1) + t * t;
      Assembly<Model, Rational> at = first;
      at.q.theta_EDF = turned(at.q.theta_BCG, {(Rational(1) - t * t) / square, 2 * t / square});
      ASSERT_TRUE(close_loops(at));
      const auto here = rounded<double>(at);
      const auto longer = rounded<long double>(at);
      if (!(regularity<Model, double>(here.d, here.u, here.q).margin > 1e-5)) {
        continue;  // the group itself is near-singular
      }
      const SpecialPointSystem<Model, double> system(here.d, here.u, here.q);
      Motion<Model, long double> truth;
      ASSERT_EQ((motion<Model, long double>(longer.d, longer.u, longer.q, u1.cast<long double>(),
                                            u2.cast<long double>(), truth)),
                Status::ok);
      Motion<Model, double> found;
      const Status status =
          special_point_motion<Model, double>(here.d, here.u, here.q, u1, u2, found);
      if (status == Status::point_at_infinity) {
        EXPECT_GE(power, 11U);
        ++count[2][power];
        continue;
      }
      ASSERT_TRUE(status == Status::ok || status == Status::near_singular) << to_string(status);
      ASSERT_LT(power, static_cast<std::size_t>(last_power));
      ++count[status == Status::ok ? 0 : 1][power];
      const double relative = relative_error(here, u1, u2, found, truth);
      worst_error[power] = largest(worst_error[power], relative);
      worst_ratio = largest(worst_ratio, relative * system.reciprocal_condition() / epsilon);
      if (status == Status::ok) {
        EXPECT_LT(relative, 1e-6);
      } else {
        EXPECT_GE(power, 5U);
      }
    }
  }
  std::cout << "seed " << seed << "; angle, largest relative error, groups ok, near-singular, at "
            << "infinity:\n";
  for (std::size_t power = 0; power < last_power; ++power) {
    std::cout << "  2e-" << power << "  " << worst_error[power] << "  " << count[0][power] << " "
              << count[1][power] << " " << count[2][power] << '\n';
  }
  std::cout << "largest error against epsilon condition(L): " << worst_ratio << '\n';
  EXPECT_LT(worst_ratio, 64);
  EXPECT_GT(count[0][0], groups / 4);
  EXPECT_GT(count[2][last_power], groups / 4);
}

}  // namespace
}  // namespace assur::test::special_points_example_test
