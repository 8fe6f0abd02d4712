// Law: every example assembles along its whole sweep, and rigid bodies with constraints, without
// groups, agree with its configurations, rates and sensitivities.
#include <gtest/gtest.h>

#include <algorithm>
#include <assur/mechanism/sweep.hpp>
#include <filesystem>
#include <iostream>
#include <map>

#include "largest.hpp"
#include "mechanism/rigid_poses.hpp"
#include "mechanism/rigid_scene.hpp"
#include "mechanism/solved.hpp"
#include "richardson.hpp"
#include "scenes_of.hpp"
#include "whole_campaign.hpp"

namespace assur::test::examples_test {
namespace {

namespace fs = std::filesystem;

std::string setting(const std::string& name, double value) {
  std::array<char, 40> text{};
  (void)std::snprintf(text.data(), text.size(), "=%.17g", value);
  return name + text.data();
}

/// An example with the results that all examples are tested for, whatever it wants itself.
mechanism::Scene with_derivatives(mechanism::Scene scene) {
  scene.request.want.velocity = scene.request.want.acceleration = true;
  scene.request.want.sensitivity = true;
  return scene;
}

/// An example at one value of its swept parameter.
struct Position {
  Plan plan;
  Values values;

  Position(const std::string& file, const std::vector<std::string>& settings)
      : plan(with_derivatives(mechanism::read_scene(file, settings))), values(plan.values()) {}

  [[nodiscard]] const mechanism::Mechanism& mechanism() const { return plan.mechanism(); }
  [[nodiscard]] Solution solution() const { return plan.solve(values); }
  [[nodiscard]] RigidScene rigid() const { return {plan.mechanism(), values}; }
};

class Example : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { ASSERT_TRUE(mechanism::read_scene(file()).request.sweep.has_value()); }

  [[nodiscard]] static std::string file() {
    return (fs::path(ASSUR_EXAMPLES) / (GetParam() + ".json")).string();
  }

  /// Settings for `count` places along the sweep, away from its ends and from round angles.
  [[nodiscard]] static std::vector<std::vector<std::string>> places(int count) {
    const Position at(file(), {});
    const mechanism::Sweep& sweep = *at.plan.request().sweep;
    const double from = at.values.value_of(sweep.from);
    const double to = at.values.value_of(sweep.to);
    const std::string& name = at.mechanism().parameters()[sweep.parameter].name;
    std::vector<std::vector<std::string>> result;
    for (int place = 0; place < count; ++place) {
      result.push_back({setting(name, from + (to - from) * (place + 0.37) / count)});
    }
    return result;
  }

  /// Two places by `ctest -L long`, the first of them by default.
  [[nodiscard]] static std::vector<std::vector<std::string>> few_places() {
    std::vector<std::vector<std::string>> result = places(2);
    result.resize(is_whole_campaign() ? 2 : 1);
    return result;
  }
};

/// The difference of two vectors relative to the larger of them, or to `unit` if that is larger.
template <typename One, typename Other>
double relative(const One& one, const Other& other, double unit) {
  const Real size =
      std::max({static_cast<Real>(one.cwiseAbs().maxCoeff()),
                static_cast<Real>(other.cwiseAbs().maxCoeff()), static_cast<Real>(unit)});
  return static_cast<double>((one - other).cwiseAbs().maxCoeff() / size);
}

TEST_P(Example, AssemblesAllAlongItsSweep) {
  std::size_t least = 1000;
  std::size_t most = 0;
  for (const auto& settings : places(60)) {
    const Position at(file(), settings);
    const Solution solution = at.solution();
    EXPECT_EQ(solution.status, SolutionStatus::ok) << settings[0];
    least = std::min(least, solution.configurations.size());
    most = std::max(most, solution.configurations.size());
  }
  std::cout << least << " to " << most << " configurations\n";
}

/// A useful mechanism has a branch that goes all the way without a dead centre.
TEST_P(Example, HasABranchThatLivesThroughout) {
  const Plan plan(mechanism::read_scene(file()));
  std::map<int, int> rows;
  mechanism::sweep(plan, {[&](const mechanism::SweepRecord& record) { ++rows[record.branch]; },
                          [](double, const Solution&) {}, [](int) {}});
  const auto lasting = std::count_if(rows.begin(), rows.end(), [&](const auto& branch) {
    return branch.first > 0 && branch.second == plan.request().sweep->count;
  });
  std::cout << lasting << " branches live throughout\n";
  EXPECT_GT(lasting, 0);
}

TEST_P(Example, AgreesWithRigidBodiesInMotion) {
  double closure = 0;
  double pose = 0;
  double velocity = 0;
  double acceleration = 0;
  double joints = 0;
  double points = 0;
  int count = 0;
  for (const auto& settings : places(6)) {
    const Position at(file(), settings);
    const RigidScene rigid = at.rigid();
    const Solution solution = at.solution();
    for (const Configuration& configuration : solution.configurations) {
      SCOPED_TRACE(settings[0] + ", configuration " + std::to_string(++count));
      const RealVector listed = poses_of(rigid, configuration);
      ASSERT_EQ(rigid.values_of(listed).size(), rigid.size());
      closure = largest(closure, static_cast<double>(rigid.values_of(listed).cwiseAbs().maxCoeff() /
                                                     rigid.reach()));
      RealVector q = listed;
      ASSERT_TRUE(rigid.assemble(q));
      pose = largest(pose, static_cast<double>(distance(rigid, q, listed)));
      const RealVector v = rigid.velocity(q);
      const RealVector a = rigid.acceleration(q, v);
      RealVector listed_v(rigid.size());
      RealVector listed_a(rigid.size());
      for (const mechanism::LinkIndex link : configuration.links.keys()) {
        const Eigen::Index first = rigid.coordinate(link);
        if (first >= 0) {
          listed_v.segment(first, 3) = configuration.links[link].velocity.cast<Real>();
          listed_a.segment(first, 3) = configuration.links[link].acceleration.cast<Real>();
        }
      }
      velocity = largest(velocity, relative(listed_v, v, 1e-9));
      acceleration = largest(acceleration, relative(listed_a, a, 1e-9));
      for (const mechanism::SlideState& state : configuration.slides) {
        ASSERT_TRUE(state.joint.exists());
        const mechanism::Joint& joint = at.mechanism().joints()[state.joint];
        const RigidScene::Jet moved = rigid.displacement(joint, q, v, a);
        const Eigen::Vector3d listed_joint(state.displacement, state.velocity, state.acceleration);
        const Eigen::Vector3d own(static_cast<double>(moved.c0), static_cast<double>(moved.c1),
                                  static_cast<double>(2 * moved.c2));
        joints = largest(joints, relative(listed_joint, own, 1));
      }
      ASSERT_EQ(configuration.outputs.size(), at.mechanism().outputs().size());
      for (const mechanism::OutputIndex output : configuration.outputs.keys()) {
        const mechanism::Point& state = configuration.outputs[output];
        const auto [x, y] = rigid.point(at.mechanism().outputs()[output].point, q, v, a);
        Eigen::Matrix<double, 6, 1> own;
        own << static_cast<double>(x.c0), static_cast<double>(y.c0), static_cast<double>(x.c1),
            static_cast<double>(y.c1), static_cast<double>(2 * x.c2), static_cast<double>(2 * y.c2);
        Eigen::Matrix<double, 6, 1> listed_point;
        listed_point << state.position, state.velocity, state.acceleration;
        points = largest(points, relative(listed_point, own, 1));
      }
    }
  }
  std::cout << count << " configurations; relative errors: closure " << closure << ", pose " << pose
            << ", velocity " << velocity << ", acceleration " << acceleration << ", joints "
            << joints << ", points " << points << '\n';
  EXPECT_GT(count, 0);
  EXPECT_LT(closure, 1e-15);
  EXPECT_LT(pose, 1e-13);
  EXPECT_LT(velocity, 1e-11);
  EXPECT_LT(acceleration, 1e-11);
  EXPECT_LT(joints, 1e-11);
  EXPECT_LT(points, 1e-11);
}

/// Sensitivities of all outputs against re-assembled bodies with one parameter moved.
TEST_P(Example, SensitivitiesAreDifferencesOfRigidBodies) {
  double worst = 0;
  int count = 0;
  for (const auto& settings : few_places()) {
    const Position at(file(), settings);
    const Solution solution = at.solution();
    const RigidScene rigid = at.rigid();
    for (const mechanism::ParameterIndex index : at.mechanism().parameters().keys()) {
      const std::string& name = at.mechanism().parameters()[index].name;
      const double value = at.values.parameter(index);
      for (const Configuration& configuration : solution.configurations) {
        const RealVector start = poses_of(rigid, configuration);
        const auto outputs = [&](double offset) -> Eigen::VectorXd {
          std::vector<std::string> moved = settings;
          moved.push_back(setting(name, value + offset));
          const Position there(file(), moved);
          const RigidScene bodies = there.rigid();
          RealVector q = start;
          EXPECT_TRUE(bodies.assemble(q));
          const RealVector zero = RealVector::Zero(q.size());
          const auto& points = at.mechanism().outputs();
          Eigen::VectorXd result(2 * static_cast<Eigen::Index>(points.size()));
          for (const mechanism::OutputIndex output : points.keys()) {
            const auto [x, y] = bodies.point(points[output].point, q, zero, zero);
            const Eigen::Index row = 2 * output.row();
            result(row) = static_cast<double>(x.c0);
            result(row + 1) = static_cast<double>(y.c0);
          }
          return result;
        };
        // Near folds longer steps leave truncation errors: 1.7e-9 for the platform at 0.37 of its
        // sweep, where the solver agrees with 50 digits to 2.2e-13.
        const auto difference =
            best_richardson<Eigen::VectorXd>(outputs, 2.5e-4 * std::max(1.0, std::abs(value)), 2);
        Eigen::VectorXd listed(difference.derivative.size());
        for (const mechanism::OutputIndex output : configuration.outputs.keys()) {
          listed.segment<2>(2 * output.row()) =
              configuration.outputs[output].follows.first.col(index.row());
        }
        worst = largest(worst, relative(listed, difference.derivative, 1));
        ++count;
      }
    }
  }
  std::cout << count << " sensitivities of all outputs; relative error " << worst << '\n';
  EXPECT_GT(count, 0);
  EXPECT_LT(worst, 1e-9);
}

/// Newton's method from many starts finds only what is listed, and all of it; nothing is listed
/// twice. There are 120 starts by `ctest -L long` and 20 by default, and more while a configuration
/// is not found.
TEST_P(Example, ListsWhateverNewtonFinds) {
  const int starts = is_whole_campaign() ? 120 : 20;
  constexpr int most_starts = 960;
  constexpr unsigned seed = 20;
  for (const auto& settings : few_places()) {
    const Position at(file(), settings);
    const RigidScene rigid = at.rigid();
    const Solution solution = at.solution();
    std::vector<bool> found(solution.configurations.size(), false);
    for (std::size_t one = 0; one < found.size(); ++one) {
      for (std::size_t other = 0; other < one; ++other) {
        EXPECT_GT(distance(rigid, poses_of(rigid, solution.configurations[one]),
                           poses_of(rigid, solution.configurations[other])),
                  1e-9)
            << "configurations " << other + 1 << " and " << one + 1;
      }
    }
    std::mt19937 engine(seed);
    int arrived = 0;
    const auto is_missing = [&] { return std::count(found.begin(), found.end(), false) > 0; };
    int start = 0;
    for (; start < starts || (is_missing() && start < most_starts); ++start) {
      RealVector q = rigid.scattered(engine);
      if (!rigid.assemble(q, 40)) {
        continue;
      }
      ++arrived;
      bool known = false;
      for (std::size_t index = 0; index < found.size(); ++index) {
        if (distance(rigid, q, poses_of(rigid, solution.configurations[index])) < 1e-9) {
          known = true;
          found[index] = true;
        }
      }
      EXPECT_TRUE(known || is_of_a_family(rigid, q, solution, 1e-9))
          << "start " << start << " of seed " << seed << " found\n"
          << q.transpose();
    }
    const auto reached = std::count(found.begin(), found.end(), true);
    std::cout << "seed " << seed << ": " << arrived << " of " << start << " starts arrived at "
              << reached << " of " << found.size() << " configurations\n";
    EXPECT_EQ(reached, static_cast<std::ptrdiff_t>(found.size()));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Example, testing::ValuesIn(scenes_of(ASSUR_EXAMPLES)),
                         [](const auto& name) { return std::string(name.param); });

}  // namespace
}  // namespace assur::test::examples_test
