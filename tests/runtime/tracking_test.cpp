// Law: a tracked branch leads to the same configuration as the complete sets of configurations,
// followed in small steps; otherwise the status reports that it does not.
#include <assur/assemblies.hpp>
#include <assur/tracking.hpp>
#include <iostream>
#include <numbers>

#include "largest.hpp"
#include "runtime/compiled_models.hpp"
#include "runtime/exact.hpp"
#include "runtime/model_types.hpp"

namespace assur::test::tracking_test {
namespace {

constexpr unsigned seed = 14142;

template <typename Model>
class Tracking : public testing::Test {
 protected:
  using Configuration = typename Model::template Configuration<double>;

  struct Drive {
    typename Model::template Dimensions<double> d;
    typename Model::template Inputs<double> u;
    Vector<double, Model::input_count> rate;

    [[nodiscard]] InputMotion<Model> operator()(double time) const {
      InputMotion<Model> motion{u, rate, Vector<double, Model::input_count>::Zero()};
      advance(motion.u, Vector<double, Model::input_count>(time * rate));
      return motion;
    }
  };

  static double apart(const Configuration& a, const Configuration& b) {
    double largest = 0;
    const auto off = [](const auto& x, const auto& y) {
      if constexpr (std::is_same_v<std::decay_t<decltype(x)>, double>) {
        return std::abs(x - y);
      } else {
        return std::max(std::abs(x.cos - y.cos), std::abs(x.sin - y.sin));
      }
    };
    for_each_pair(a, b,
                  [&](const auto& x, const auto& y) { largest = std::max(largest, off(x, y)); });
    return largest;
  }

  /// 200 steps, each to the nearest configuration; false where another is nearly as near.
  static bool follow(const Drive& drive, double to, Configuration& q) {
    constexpr int steps = 200;
    for (int step = 1; step <= steps; ++step) {
      const auto set = compiled::assemblies<Model>(drive.d, drive(to * step / steps).u);
      double nearest = 0.1;
      double second = 10;
      int chosen = -1;
      for (int index = 0; index < set.count; ++index) {
        const double distance = apart(set.configurations[static_cast<std::size_t>(index)], q);
        if (distance < nearest) {
          second = chosen < 0 ? second : nearest;
          nearest = distance;
          chosen = index;
        } else {
          second = std::min(second, distance);
        }
      }
      if (chosen < 0 || 10 * nearest > second) {
        return false;
      }
      q = set.configurations[static_cast<std::size_t>(chosen)];
    }
    return true;
  }
};

TYPED_TEST_SUITE(Tracking, RigidModels, ModelNames);

TYPED_TEST(Tracking, KeepsTheBranchOrReports) {
  using Model = TypeParam;
  RandomInputs random(seed + static_cast<unsigned>(Model::number));
  int compared = 0;
  int reported = 0;
  for (int group = 0; group < 60; ++group) {
    typename TestFixture::Drive drive;
    drive.d = random.variables<typename Model::template Dimensions<double>>();
    drive.u = random.variables<typename Model::template Inputs<double>>();
    drive.rate = random.vector<Vector<double, Model::input_count>>();
    const auto set = compiled::assemblies<Model>(drive.d, drive.u);
    const double to = group % 2 == 0 ? 0.1 : 0.3;
    for (int index = 0; index < set.count; ++index) {
      const auto& q = set.configurations[static_cast<std::size_t>(index)];
      auto expected = q;
      if (!TestFixture::follow(drive, to, expected) ||
          set.regularity[static_cast<std::size_t>(index)] != Status::ok) {
        continue;
      }
      const auto start = branch_point<Model>(drive.d, drive(0), q);
      EXPECT_EQ(start.status, Status::ok);
      const auto way = track<Model>(drive.d, drive, 0, to, start);
      ++compared;
      if (way.status != Status::ok) {
        ++reported;
        continue;
      }
      EXPECT_EQ(way.reached, to);
      EXPECT_LT(TestFixture::apart(way.point.q, expected), 1e-7)
          << "seed " << seed << ", group " << group << ", configuration " << index;
    }
  }
  EXPECT_GT(compared, 15) << "seed " << seed;
  EXPECT_LE(20 * reported, compared) << "seed " << seed;
}

TEST(TrackingReport, BranchesThatPassCloselyAreToldApart) {
  // Two branches come within 0.007 radians after 0.08 of the crank's 0.1 radians, and each goes on
  // where the other was heading: only the sign of det J tells a step across that from a jump.
  using Model = tetrad::Model01;
  const Model::Dimensions<double> d{-0.37577811848562592, -1.3833727523473776, 1.7614270028643166,
                                    0.77184454352437148,  -1.4526254646752201, -0.26681985255125884,
                                    -1.9220285840143581,  1.7108834703071421};
  const auto crank = [](double angle) {
    const double x = 0.59745757831560786 * std::cos(angle);
    const double y = 0.59745757831560786 * std::sin(angle);
    return InputMotion<Model>{{1.0126703636326408 + x, -0.92489419868693057 + y,
                               0.11751261101126964, -0.6690541157942218},
                              {-y, x, 0, 0},
                              {-x, -y, 0, 0}};
  };
  const auto at_BCG = [&](double angle, double theta_BCG) {
    const auto set = compiled::assemblies<Model>(d, crank(angle).u);
    for (const auto& q : set.configurations) {
      if (std::abs(q.theta_BCG.cos - std::cos(theta_BCG)) < 1e-8 &&
          std::abs(q.theta_BCG.sin - std::sin(theta_BCG)) < 1e-8) {
        return q;
      }
    }
    ADD_FAILURE() << "no such configuration at " << angle;
    return set.configurations[0];
  };
  const double from = 1.4193939272584151;
  const double to = from + 0.1;
  const auto start = branch_point<Model>(d, crank(from), at_BCG(from, -1.372750676));
  const auto way = track<Model>(d, crank, from, to, start);
  ASSERT_EQ(way.status, Status::ok);
  EXPECT_NEAR(way.point.q.theta_GF.sin, at_BCG(to, -1.533676130).theta_GF.sin, 1e-9);
}

TEST(TrackingReport, IsGivenWhereABranchEnds) {
  using Model = tetrad::Model01;
  RandomInputs random(seed);
  int ended = 0;
  for (int group = 0; group < 200; ++group) {
    const auto d = random.variables<Model::Dimensions<double>>();
    const auto u = random.variables<Model::Inputs<double>>();
    const auto away = [&](double time) {  // until no link reaches
      InputMotion<Model> moving{u, {0, 0, 100, 0}, {0, 0, 0, 0}};
      moving.u.x_E += 100 * time;
      return moving;
    };
    const auto set = compiled::assemblies<Model>(d, u);
    for (int index = 0; index < set.count; ++index) {
      const auto& q = set.configurations[static_cast<std::size_t>(index)];
      const auto start = branch_point<Model>(d, away(0), q);
      const auto way = track<Model>(d, away, 0, 1, start);
      EXPECT_EQ(way.status, Status::no_convergence);
      EXPECT_LT(way.reached, 1);
      ++ended;
    }
  }
  EXPECT_GT(ended, 50);
}

TEST(TrackingReport, IsWithinAFifthOfAPercentOfTheEnd) {
  // B leaves along a line; the dyad's branches meet where its distance from D is first the sum or
  // the difference of the links. Lines that pass the inner of these two circles closely are left
  // out.
  using Model = dyad::Model01;
  RandomInputs random(seed);
  int ended = 0;
  double farthest = 0;
  for (int group = 0; group < 1000; ++group) {
    const Model::Dimensions<double> d{random.between(0.5, 2), random.between(0.5, 2)};
    const auto u = random.variables<Model::Inputs<double>>();
    const auto v = direction_of(random.angle());
    const double way_length = random.between(0.5, 20);
    const auto away = [&](double time) {
      const double x = way_length * v.cos;
      const double y = way_length * v.sin;
      return InputMotion<Model>{
          {u.x_B + x * time, u.y_B + y * time, u.x_D, u.y_D}, {x, y, 0, 0}, {0, 0, 0, 0}};
    };
    // |B - D + t v|^2 = r^2.
    const double along = (u.x_B - u.x_D) * v.cos + (u.y_B - u.y_D) * v.sin;
    const double across = (u.x_B - u.x_D) * v.sin - (u.y_B - u.y_D) * v.cos;
    double end = 1;
    for (const double reach : {d.BC + d.CD, std::abs(d.BC - d.CD)}) {
      const double root = std::sqrt(reach * reach - across * across);
      for (const double length : {-along - root, -along + root}) {
        if (length > 0 && length / way_length < end) {
          end = length / way_length;
        }
      }
    }
    const double passed = std::abs(across) - std::abs(d.BC - d.CD);
    if (passed > 0 && passed < 0.05 * way_length) {
      continue;
    }
    const auto set = compiled::assemblies<Model>(d, u);
    for (int index = 0; end < 1 && index < set.count; ++index) {
      const auto start =
          branch_point<Model>(d, away(0), set.configurations[static_cast<std::size_t>(index)]);
      const auto way = track<Model>(d, away, 0, 1, start);
      EXPECT_EQ(way.status, Status::no_convergence) << "seed " << seed << ", group " << group;
      EXPECT_LE(way.reached, end) << "seed " << seed << ", group " << group;
      farthest = largest(farthest, end - way.reached);
      ++ended;
    }
  }
  std::cout << ended << " branches end, at most " << 100 * farthest
            << "% of the way from where they were followed to; seed " << seed << '\n';
  EXPECT_LT(farthest, 2e-3);
  EXPECT_GT(ended, 300);
}

TEST(TrackingReport, ChangePointsAndGapsAreNotPassed) {
  // The crank a of a four-bar passes where it is in line with the frame d, or ends there, or begins
  // beside; with d = b + c - a branches cross there, and a little longer there is a gap. It goes at
  // one speed, or begins at rest, or ends at rest as well.
  using Model = dyad::Model01;
  RandomInputs random(seed);
  int reached = 0;
  int stopped = 0;
  for (int mechanism = 0; mechanism < 3000; ++mechanism) {
    const double a = 1 + mechanism % 3;
    const Model::Dimensions<double> d{std::floor(random.between(2, 6)),
                                      std::floor(random.between(2, 6))};
    const double opening = mechanism % 2 == 0 ? 0 : std::pow(10, random.between(-13, -1));
    const double apart = mechanism % 4 < 2 ? d.BC + d.CD - a : a + std::abs(d.BC - d.CD);
    const double frame = std::max(apart + opening, 0.5);
    const double in_line = mechanism % 4 < 2 ? std::numbers::pi : 0;
    const double width = (mechanism % 8 < 4 ? 1 : -1) * std::pow(10, random.between(-2, -0.5));
    const double from = in_line - width * (mechanism % 3 == 0   ? random.between(0, 1)
                                           : mechanism % 3 == 1 ? 0.5
                                                                : 1);
    const double to = from + width;
    const auto crank = [&](double time) {
      const std::array<double, 3> gone =  // and its derivatives
          mechanism % 5 == 0 ? std::array{time * time, 2 * time, 2.0}
          : mechanism % 5 == 1
              ? std::array{time * time * (3 - 2 * time), 6 * time * (1 - time), 6 - 12 * time}
              : std::array{time, 1.0, 0.0};
      const double x = a * std::cos(from + width * gone[0]);
      const double y = a * std::sin(from + width * gone[0]);
      const double rate = width * gone[1];
      const double second = width * gone[2];
      return InputMotion<Model>{
          {x, y, frame, 0},
          {-y * rate, x * rate, 0, 0},
          {-x * rate * rate - y * second, -y * rate * rate + x * second, 0, 0}};
    };
    double margin = std::numeric_limits<double>::infinity();
    for (const double angle : {from, in_line, to}) {  // the distance of B and D is extreme in line
      const double r = std::hypot(a * std::cos(angle) - frame, a * std::sin(angle));
      margin = std::min({margin, d.BC + d.CD - r, r - std::abs(d.BC - d.CD)});
    }
    const auto set = compiled::assemblies<Model>(d, crank(0).u);
    for (int index = 0; index < set.count; ++index) {
      const auto start =
          branch_point<Model>(d, crank(0), set.configurations[static_cast<std::size_t>(index)]);
      const auto way = track<Model>(d, crank, 0, 1, start);
      if (way.status != Status::ok) {
        ++stopped;
        continue;
      }
      ++reached;
      EXPECT_GT(margin, 0) << "seed " << seed << ", mechanism " << mechanism;
      EXPECT_GT(way.point.pivots(0) * start.pivots(0), 0) << "mechanism " << mechanism;
    }
  }
  std::cout << reached << " tracks reached their end, " << stopped << " stopped; seed " << seed
            << '\n';
  EXPECT_GT(reached, 200);
  EXPECT_GT(stopped, 1000);
}

TEST(TrackingReport, AWholeTurnFromRestToRestIsNotTakenForNoWay) {
  // Nothing can be assembled where the crank is stretched out, and both ends of the way are alike.
  using Model = dyad::Model01;
  const Model::Dimensions<double> d{1.5, 2};
  const auto crank = [](double time) {
    const double t = time * time * time;
    const double angle = 0.3 + 2 * std::numbers::pi * t * (10 + time * (6 * time - 15));
    const double rate = 60 * std::numbers::pi * time * time * (1 - time) * (1 - time);
    const double x = 2 * std::cos(angle);
    const double y = 2 * std::sin(angle);
    const double second = 120 * std::numbers::pi * time * (1 - time) * (1 - 2 * time);
    return InputMotion<Model>{{x, y, 3, 0},
                              {-y * rate, x * rate, 0, 0},
                              {-x * rate * rate - y * second, -y * rate * rate + x * second, 0, 0}};
  };
  const auto set = compiled::assemblies<Model>(d, crank(0).u);
  ASSERT_EQ(set.count, 2);
  for (const auto& q : {set.configurations[0], set.configurations[1]}) {
    const auto way = track<Model>(d, crank, 0, 1, branch_point<Model>(d, crank(0), q));
    EXPECT_EQ(way.status, Status::no_convergence);
    EXPECT_LT(way.reached, 0.5);
  }
}

}  // namespace
}  // namespace assur::test::tracking_test
