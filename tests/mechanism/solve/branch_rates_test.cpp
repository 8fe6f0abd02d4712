// Law: if several motions pass through one configuration, the rates of each are those of the
// neighbouring configurations on both sides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "mechanism/scene_maker.hpp"
#include "mechanism/solved.hpp"

namespace assur::test::branch_rates_test {
namespace {

/// A scene that is driven by its parameter phi at these rates, and how many motions go through the
/// near-singular configurations at its own value of phi.
struct Meeting {
  std::string name;
  SceneMaker scene;
  double velocity, acceleration;
  std::size_t branches;

  friend std::ostream& operator<<(std::ostream& out, const Meeting& meeting) {
    return out << meeting.name;
  }
};

/// A configuration as numbers that are smooth in time, with their rates: places, directions,
/// displacements.
struct Motion {
  std::vector<double> at, rate, second;

  void add(double value, double first, double next) {
    at.push_back(value);
    rate.push_back(first);
    second.push_back(next);
  }
};

Motion motion_of(const Configuration& configuration) {
  Motion motion;
  for (const mechanism::Frame& link : configuration.links) {
    const auto& [cosine, sine] = link.pose.direction;
    const double omega = link.velocity(2);
    const double alpha = link.acceleration(2);
    motion.add(link.pose.x, link.velocity(0), link.acceleration(0));
    motion.add(link.pose.y, link.velocity(1), link.acceleration(1));
    motion.add(cosine, -sine * omega, -sine * alpha - cosine * omega * omega);
    motion.add(sine, cosine * omega, cosine * alpha - sine * omega * omega);
  }
  for (const mechanism::SlideState& slide : configuration.slides) {
    motion.add(slide.displacement, slide.velocity, slide.acceleration);
  }
  for (const mechanism::Point& point : configuration.outputs) {
    motion.add(point.position.x(), point.velocity.x(), point.acceleration.x());
    motion.add(point.position.y(), point.velocity.y(), point.acceleration.y());
  }
  return motion;
}

/// How far the rates of a motion are from central differences between two configurations, one at -h
/// and one at h.
double miss(const Motion& motion, const Motion& before, const Motion& after, double h) {
  double largest = 0;
  for (std::size_t place = 0; place < motion.at.size(); ++place) {
    const double rate = (after.at[place] - before.at[place]) / (2 * h);
    const double second = (after.at[place] - 2 * motion.at[place] + before.at[place]) / (h * h);
    const double first_miss = std::abs(motion.rate[place] - rate) / (1 + std::abs(rate));
    const double next_miss = std::abs(motion.second[place] - second) / (1 + std::abs(second));
    const double here = std::max(first_miss, next_miss);
    largest = std::isfinite(here) ? std::max(largest, here) : 1e300;
  }
  return largest;
}

class EveryMeeting : public testing::TestWithParam<Meeting> {};

TEST_P(EveryMeeting, HaveTheRatesOfTheirBranches) {
  const Meeting& meeting = GetParam();
  constexpr double h = 2e-4;
  std::vector<std::vector<double>> first;
  for (int listing = 0; listing < listings; ++listing) {
    SCOPED_TRACE(listing);
    const Plan plan(
        mechanism::parse_scene(scene_listed(meeting.scene.scene(), listing).dump(), "scene"));
    const auto phi = plan.mechanism().parameter_named("phi", "");
    const double start = plan.values().parameter(phi);
    const auto motions_at = [&](double time) {
      mechanism::Values values = plan.values();
      values.set(phi, start + meeting.velocity * time + meeting.acceleration / 2 * time * time);
      std::vector<Motion> motions;
      for (const Configuration& configuration : plan.solve(values).configurations) {
        motions.push_back(motion_of(configuration));
      }
      return motions;
    };
    const std::vector<Motion> before = motions_at(-h);
    const std::vector<Motion> after = motions_at(h);
    int singular = 0;
    std::vector<std::vector<double>> rates;
    for (const Configuration& configuration : plan.solve(plan.values()).configurations) {
      if (configuration.regularity == Status::ok) {
        continue;
      }
      ++singular;
      EXPECT_FALSE(configuration.derivatives_known);
      std::vector<Configuration> branches = configuration.branches;
      EXPECT_EQ(configuration.rates_known, meeting.branches == 1);
      if (configuration.rates_known) {
        EXPECT_TRUE(branches.empty());
        branches.push_back(configuration);
      }
      EXPECT_EQ(branches.size(), meeting.branches);
      for (const Configuration& branch : branches) {
        EXPECT_TRUE(branch.rates_known);
        const Motion motion = motion_of(branch);
        double least = 1e300;
        for (const Motion& one : before) {
          for (const Motion& other : after) {
            least = std::min(least, miss(motion, one, other, h));
          }
        }
        EXPECT_LT(least, 1e-3);
        rates.push_back(motion.rate);
      }
    }
    EXPECT_GT(singular, 0);
    // Beside a configuration without motions there is none, at least on one side.
    EXPECT_TRUE(meeting.branches > 0 || before.empty() || after.empty());
    // No two motions are the same.
    for (std::size_t one = 0; one < rates.size(); ++one) {
      for (std::size_t other = 0; other < one && meeting.branches > 1; ++other) {
        double apart = 0;
        for (std::size_t place = 0; place < rates[one].size(); ++place) {
          apart = std::max(apart, std::abs(rates[one][place] - rates[other][place]));
        }
        EXPECT_GT(apart, 1e-3);
      }
    }
    if (listing == 0) {
      first = rates;
    }
    EXPECT_EQ(rates.size(), first.size());
  }
}

/// A crank and a rocker on A = (0, 0) and D = (ground, 0).
SceneMaker four_bar(double crank, double coupler, double rocker, double ground,
                    const std::string& phi, double velocity, double acceleration) {
  SceneMaker maker;
  return maker.parameter("phi", phi)
      .drive("A", "phi", velocity, acceleration)
      .point("ground", "A", 0, 0)
      .point("ground", "D", ground, 0)
      .bar("crank", {{"A", 0}, {"B", crank}})
      .bar("coupler", {{"B", 0}, {"C", coupler}})
      .bar("rocker", {{"D", 0}, {"C", rocker}});
}

Meeting flat(double crank, double coupler, double rocker, double ground, const std::string& phi,
             double velocity, double acceleration) {
  return {"flat_" + std::to_string(static_cast<int>(crank)) +
              std::to_string(static_cast<int>(coupler)) + std::to_string(static_cast<int>(rocker)) +
              std::to_string(static_cast<int>(ground)) + (phi == "0" ? "_at_0" : "_at_pi"),
          four_bar(crank, coupler, rocker, ground, phi, velocity, acceleration), velocity,
          acceleration, 2};
}

/// A slider-crank with equal bars, where the slider passes the crank's pivot.
Meeting isosceles() {
  SceneMaker maker;
  maker.parameter("phi", "pi/2")
      .drive("A", "phi", 3, -2)
      .point("ground", "A", 0, 0)
      .line("ground", "way", {0, 0}, {1, 0})
      .bar("crank", {{"A", 0}, {"B", 2}})
      .bar("rod", {{"B", 0}, {"C", 2}})
      .line("block", "way", {0, 0}, {1, 0})
      .point("block", "C", 0, 0)
      .slide("S", "ground.way", "block.way");
  return {"isosceles_slider_crank", maker, 3, -2, 2};
}

/// A dyad of 4 and 3 that hangs stretched between a point of a four-bar and the ground; the point
/// moves across it.
Meeting behind(const std::string& name, const std::string& on, double x, double y, double ground_x,
               double ground_y) {
  SceneMaker maker;
  maker.parameter("phi", "pi/2")
      .drive("A", "phi", 1.5, 0.75)
      .point("ground", "A", 0, 0)
      .point("ground", "D", 4, 0)
      .bar("crank", {{"A", 0}, {"B", 2}})
      .bar("coupler", {{"B", 0}, {"C", 5}})
      .bar("rocker", {{"D", 0}, {"C", 5}})
      .point(on, "E", x, y)
      .point("ground", "G", ground_x, ground_y)
      .bar("first", {{"E", 0}, {"F", 4}})
      .bar("last", {{"G", 0}, {"F", 3}});
  return {name, maker, 1.5, 0.75, 2};
}

/// The same above a coupler that comes no nearer: the dyad closes in this place alone.
Meeting nowhere_to_go() {
  Meeting meeting = behind("beneath_a_coupler", "coupler", 2.5, 1, 1.4, 11.3);
  meeting.branches = 0;
  return meeting;
}

/// A platform on three parallel legs, one of them on a crank that hangs: it may go either way.
Meeting three_parallel_legs(double above, double crank) {
  SceneMaker maker;
  maker.parameter("phi", "-pi/2")
      .drive("A", "phi", 1, 0.5)
      .point("ground", "A", 5, crank - 4)
      .bar("crank", {{"A", 0}, {"B", crank}})
      .bar("leg", {{"B", 0}, {"K", 4 + above}})
      .point("ground", "C", 0, -3)
      .point("ground", "D", 2, -4)
      .bar("left", {{"C", 0}, {"L", 3}})
      .bar("middle", {{"D", 0}, {"M", 4}})
      .point("platform", "L", 0, 0)
      .point("platform", "M", 2, 0)
      .point("platform", "K", 5, above);
  return {"three_parallel_legs_" + std::to_string(static_cast<int>(above)) + "_" +
              std::to_string(static_cast<int>(crank)),
          maker, 1, 0.5, 2};
}

/// Two parallelograms, one on the other's rocker: each may turn over or not.
Meeting two_in_a_row() {
  SceneMaker maker = four_bar(2, 5, 2, 5, "0", 1, 0.5);
  maker.point("rocker", "H", 3, 0)
      .point("ground", "G", 12, 0)
      .bar("second", {{"H", 0}, {"K", 7}})
      .bar("third", {{"G", 0}, {"K", 3}});
  return {"two_in_a_row", maker, 1, 0.5, 4};
}

/// A dyad with both ends on one link, which holds it stretched wherever the link goes.
Meeting stretched_throughout() {
  SceneMaker maker;
  maker.parameter("phi", "1")
      .drive("A", "phi", 2, 1)
      .point("ground", "A", 0, 0)
      .bar("crank", {{"A", 0}, {"B", 2}, {"C", 5}})
      .bar("first", {{"B", 0}, {"K", 1}})
      .bar("last", {{"K", 0}, {"C", 2}});
  return {"stretched_throughout", maker, 2, 1, 1};
}

INSTANTIATE_TEST_SUITE_P(Everywhere, EveryMeeting,
                         testing::Values(flat(2, 3, 2, 3, "0", 1, 0), flat(2, 3, 2, 3, "pi", 2, 1),
                                         flat(3, 2, 3, 2, "0", -1, 2), flat(3, 2, 3, 2, "pi", 1, 1),
                                         flat(2, 4, 5, 3, "0", 1, -3),
                                         flat(2, 4, 1, 3, "pi", 1, -3),
                                         flat(2, 2, 2, 2, "pi", 1, 1), isosceles(),
                                         behind("behind_a_rocker", "rocker", 5, 0, 4, -2),
                                         behind("behind_a_coupler", "coupler", 2.5, 0, 2, -3.5),
                                         nowhere_to_go(), three_parallel_legs(1, 2),
                                         three_parallel_legs(2, 3), two_in_a_row(),
                                         stretched_throughout()),
                         [](const auto& meeting) { return meeting.param.name; });

/// The angular accelerations of the rocker in all motions through the first configuration.
std::vector<double> rocker_accelerations(const SceneMaker& scene) {
  const Solved solved(mechanism::parse_scene(scene.scene().dump(), "scene"));
  std::vector<double> result;
  for (const Configuration& branch : solved.configurations().at(0).branches) {
    result.push_back(branch.link("rocker").acceleration(2));
  }
  return result;
}

/// From rest, the rocker's accelerations have the ratios that its velocities have in passing.
TEST(Meetings, AreLeftFromRestAsTheyArePassed) {
  const std::vector<double> found = rocker_accelerations(four_bar(2, 1, 2, 1, "pi", 0, 1));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0] + found[1], 4.0 / 3, 1e-9);
  EXPECT_NEAR(found[0] * found[1], 1.0 / 3, 1e-9);
}

/// Parallelograms in a row that are flat at one angle, whatever rounding makes of their Jacobians:
/// each rocker turns as the one before it, or at one other ratio.
TEST(Meetings, OfGroupsInARowHaveAllTheirMotions) {
  for (const double crank : {0.75, 1.0, 2.0, 3.0, 1.3}) {
    for (const double coupler : {4.0, 3.5, 5.7}) {
      for (const char* phi : {"pi/2", "-pi/2", "3*pi/2"}) {
        SceneMaker scene;
        scene.parameter("phi", phi)
            .drive("A", "phi", 1, 0)
            .point("ground", "A", 0, 0)
            .bar("crank", {{"A", 0}, {"C0", crank}});
        for (int stage = 1; stage < 4; ++stage) {
          const std::string before = std::to_string(stage - 1);
          const std::string here = std::to_string(stage);
          scene.point("ground", "D" + here, 0, stage * coupler)
              .bar("coupler" + here, {{"C" + before, 0}, {"C" + here, coupler}})
              .bar("rocker" + here, {{"D" + here, 0}, {"C" + here, crank}});
        }
        const Solved solved(mechanism::parse_scene(scene.scene().dump(), "scene"));
        ASSERT_EQ(solved.configurations().size(), 1U);
        const std::vector<Configuration>& branches = solved.configurations()[0].branches;
        EXPECT_EQ(branches.size(), 8U) << crank << " " << coupler << " " << phi;
        const double sense = phi[0] == 'p' ? 1 : -1;  // the crank points along the row, or back
        const double other = (coupler + sense * crank) / (coupler - sense * crank);
        for (const Configuration& branch : branches) {
          double before = 1;
          for (int stage = 1; stage < 4; ++stage) {
            const double omega = branch.link("rocker" + std::to_string(stage)).velocity(2);
            const double ratio = omega / before;
            EXPECT_LT(std::min(std::abs(ratio - 1), std::abs(ratio + other)), 1e-5) << ratio;
            before = omega;
          }
        }
      }
    }
  }
}

/// Neither the unit of length nor the speed changes how many digits are known.
TEST(Meetings, DoNotDependOnUnits) {
  const std::vector<double> truth = rocker_accelerations(four_bar(2, 5, 4, 3, "0", 1, -3));
  ASSERT_EQ(truth.size(), 2U);
  for (const int exponent : {-300, -100, 100, 300}) {
    const double unit = std::ldexp(1.0, exponent);
    const std::vector<double> found =
        rocker_accelerations(four_bar(2 * unit, 5 * unit, 4 * unit, 3 * unit, "0", 1, -3));
    ASSERT_EQ(found.size(), 2U) << exponent;
    EXPECT_NEAR(found[0], truth[0], 1e-9) << exponent;
    EXPECT_NEAR(found[1], truth[1], 1e-9) << exponent;
  }
  for (const double speed : {1e-12, 1e-6, 1e6, 1e12}) {
    const std::vector<double> found =
        rocker_accelerations(four_bar(2, 5, 4, 3, "0", speed, -3 * speed * speed));
    ASSERT_EQ(found.size(), 2U) << speed;
    EXPECT_NEAR(found[0] / (speed * speed), truth[0], 1e-9) << speed;
    EXPECT_NEAR(found[1] / (speed * speed), truth[1], 1e-9) << speed;
  }
}

/// At a distance s from a crossing, velocities lose 1 / s^2 and accelerations 1 / s^3; rates
/// without two digits are not given. The true rates hardly differ from those at the crossing.
TEST(Meetings, BesideThemNothingIsToldThatIsNotKnown) {
  for (const double beside : {1e-3, 1e-4, 1e-5, 3e-6, 1e-6, 3e-7, 1e-7, 1e-8}) {
    SceneMaker scene = four_bar(4, 5, 3, 6, "0", -1, 0);
    scene.parameter("phi", beside);
    const Solved solved(mechanism::parse_scene(scene.scene().dump(), "scene"));
    for (const Configuration& configuration : solved.configurations()) {
      std::vector<Configuration> known = configuration.branches;
      if (configuration.rates_known) {
        known.push_back(configuration);
      }
      for (const Configuration& motion : known) {
        const double omega = motion.link("rocker").velocity(2);
        const double alpha = motion.link("rocker").acceleration(2);
        EXPECT_LT(std::min(std::abs(omega + 1.16228), std::abs(omega - 5.16228)), 0.05) << beside;
        EXPECT_FALSE(std::abs(alpha) > 0.2) << beside << ": " << alpha;
      }
    }
  }
}

/// In both motions of a parallelogram tan(rocker / 2) is a multiple of tan(crank / 2). Where a
/// configuration is regular its accelerations have six digits, and it is regular from 5e-3 rad on.
TEST(Meetings, BesideThemWhatIsRegularHasSixDigits) {
  constexpr double crank = 2;
  constexpr double ground = 3;
  constexpr double rate = -1.3;
  constexpr double second_rate = 0.4;
  int regular = 0;
  for (double beside = 1e-5; beside < 0.1; beside *= 1.1) {
    SceneMaker scene = four_bar(crank, ground, crank, ground, "0", rate, second_rate);
    scene.parameter("phi", beside);
    const Solved solved(mechanism::parse_scene(scene.scene().dump(), "scene"));
    ASSERT_EQ(solved.configurations().size(), 2U) << beside;
    for (const Configuration& configuration : solved.configurations()) {
      if (configuration.regularity != Status::ok) {
        EXPECT_LT(beside, 5e-3);
        continue;
      }
      ++regular;
      const double t = std::tan(beside / 2);
      const mechanism::Frame& rocker = configuration.link("rocker");
      const bool is_parallel = rocker.pose.direction.sin > 0;
      const double times = is_parallel ? 1 : -(ground + crank) / (ground - crank);
      const double reduced = 1 + times * times * t * t;
      const double slope = times * (1 + t * t) / reduced;
      const double bend = times * t * (1 - times * times) * (1 + t * t) / (reduced * reduced);
      const double alpha = bend * rate * rate + slope * second_rate;
      EXPECT_NEAR(rocker.velocity(2), slope * rate, 5e-7 * std::abs(slope * rate)) << beside;
      EXPECT_NEAR(rocker.acceleration(2), alpha,
                  5e-7 * std::max(std::abs(alpha), slope * slope * rate * rate))
          << beside;
    }
  }
  EXPECT_GT(regular, 80);
}

}  // namespace
}  // namespace assur::test::branch_rates_test
