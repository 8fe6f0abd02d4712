// Law: a tracked branch ends where the complete sets of configurations, followed in small steps,
// lead; otherwise a report is given.
#include <assur/assembly.hpp>
#include <assur/tracking.hpp>

#include "exact.hpp"
#include "model_types.hpp"

namespace assur::test {
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
    std::apply(
        [&](const auto&... x) {
          std::apply([&](const auto&... y) { ((largest = std::max(largest, off(x, y))), ...); },
                     b.members());
        },
        a.members());
    return largest;
  }

  /// 200 steps, each to the nearest configuration; false where another is nearly as near.
  static bool follow(const Drive& drive, double to, Configuration& q) {
    constexpr int steps = 200;
    for (int step = 1; step <= steps; ++step) {
      const auto set = assemblies<Model>(drive.d, drive(to * step / steps).u);
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

TYPED_TEST_SUITE(Tracking, AllModels, ModelNames);

TYPED_TEST(Tracking, KeepsTheBranchOrReports) {
  using Model = TypeParam;
  if constexpr (!Model::rigid) {
    GTEST_SKIP() << "has no configurations to track";
  } else {
    RandomInputs random(seed + static_cast<unsigned>(Model::number));
    int compared = 0;
    int reported = 0;
    for (int group = 0; group < 60; ++group) {
      typename TestFixture::Drive drive;
      drive.d = random.variables<typename Model::template Dimensions<double>>();
      drive.u = random.variables<typename Model::template Inputs<double>>();
      drive.rate = random.vector<Vector<double, Model::input_count>>();
      const auto set = assemblies<Model>(drive.d, drive.u);
      const double to = group % 2 == 0 ? 0.1 : 0.3;
      for (int index = 0; index < set.count; ++index) {
        BranchPoint<Model> point;
        point.q = set.configurations[static_cast<std::size_t>(index)];
        auto expected = point.q;
        if (!TestFixture::follow(drive, to, expected) ||
            motion<Model, double>(drive.d, drive.u, point.q, drive.rate, drive(0).second_rate,
                                  point.motion) != Status::ok) {
          continue;
        }
        double at = 0;
        const Status status = track<Model>(drive.d, drive, at, to, point);
        ++compared;
        if (status != Status::ok) {
          ++reported;
          continue;
        }
        EXPECT_EQ(at, to);
        EXPECT_LT(TestFixture::apart(point.q, expected), 1e-7)
            << "seed " << seed << ", group " << group << ", configuration " << index;
      }
    }
    EXPECT_GT(compared, 15) << "seed " << seed;
    EXPECT_LE(20 * reported, compared) << "seed " << seed;
  }
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
    const auto set = assemblies<Model>(d, u);
    for (int index = 0; index < set.count; ++index) {
      BranchPoint<Model> point;
      point.q = set.configurations[static_cast<std::size_t>(index)];
      const auto start = away(0);
      ASSERT_TRUE(is_solvable(
          motion<Model, double>(d, u, point.q, start.rate, start.second_rate, point.motion)));
      double at = 0;
      EXPECT_EQ((track<Model>(d, away, at, 1, point)), Status::no_convergence);
      EXPECT_LT(at, 1);
      ++ended;
    }
  }
  EXPECT_GT(ended, 50);
}

}  // namespace
}  // namespace assur::test
