// Law: for drivers at any joint and laws that read any joint, rigid bodies with constraints,
// without groups, agree with all results of the solver.
#include <gtest/gtest.h>

#include <algorithm>
#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>

#include "largest.hpp"
#include "mechanism/driven_scene_campaign.hpp"
#include "mechanism/rigid_poses.hpp"
#include "mechanism/scene_solutions.hpp"
#include "richardson.hpp"
#include "whole_campaign.hpp"

namespace assur::test::drivers_anywhere_test {
namespace {

struct Errors {
  double pose = 0, velocity = 0, acceleration = 0, joints = 0;
};

struct Tally {
  int scenes = 0, driven_in_groups = 0, relative_groups = 0, couplings = 0, configurations = 0,
      compared = 0, without_rates = 0, largest_listing = 0;
  double closure = 0;
  Errors regular, other;
};

void compare(const Solved& scene, const RigidScene& rigid, const Configuration& configuration,
             Tally& tally) {
  const bool is_regular = configuration.regularity == Status::ok;
  Errors& errors = is_regular ? tally.regular : tally.other;
  ++tally.compared;
  const RealVector listed = poses_of(rigid, configuration);
  RealVector q = listed;
  if (!rigid.assemble(q)) {
    // Near singular configurations rounding may keep Newton's method from coming to rest.
    EXPECT_FALSE(is_regular && condition_of(rigid, listed) > 1e-6) << "does not come to rest";
    return;
  }
  errors.pose = largest(errors.pose, static_cast<double>(distance(rigid, q, listed)));
  if (!configuration.rates_known) {
    EXPECT_FALSE(is_regular);
    ++tally.without_rates;
    return;
  }
  const RealVector v = rigid.velocity(q);
  const RealVector a = rigid.acceleration(q, v);
  const double velocity = relative(rates_of(rigid, configuration, &mechanism::Frame::velocity), v);
  const double acceleration =
      relative(rates_of(rigid, configuration, &mechanism::Frame::acceleration), a);
  errors.velocity = largest(errors.velocity, velocity);
  errors.acceleration = largest(errors.acceleration, acceleration);
  EXPECT_LT(velocity, is_regular ? 1e-6 : 1e-2);
  EXPECT_LT(acceleration, is_regular ? 1e-6 : 1e-2);
  for (const mechanism::SlideState& state : configuration.slides) {
    ASSERT_TRUE(state.joint.exists());
    const RigidScene::Jet moved =
        rigid.displacement(scene.plan.mechanism().joints()[state.joint], q, v, a);
    const Real size = 1 + a.cwiseAbs().maxCoeff();
    const double error = static_cast<double>(
        std::max({std::abs(state.displacement - moved.c0), std::abs(state.velocity - moved.c1),
                  std::abs(state.acceleration - 2 * moved.c2)}) /
        size);
    errors.joints = largest(errors.joints, error);
    EXPECT_LT(error, is_regular ? 1e-6 : 1e-2);
  }
}

void check(const RandomDrivenScene& made, unsigned seed, Tally& tally) {
  const Solved scene(mechanism::parse_scene(made.scene().dump(), "random"));
  ++tally.scenes;
  tally.largest_listing =
      std::max(tally.largest_listing, static_cast<int>(scene.configurations().size()));
  ASSERT_EQ(scene.solution.status, SolutionStatus::ok) << scene.plan.obstacle(scene.values);
  const RigidScene rigid(scene.plan.mechanism(), scene.values);
  ASSERT_EQ(rigid.values_of(RealVector::Zero(rigid.size())).size(), rigid.size());
  const RealVector thrown = thrown_poses(rigid, scene.plan.mechanism(), made);
  ASSERT_LT(rigid.values_of(thrown).cwiseAbs().maxCoeff(), 1e-13) << "the scene is made wrong";
  EXPECT_TRUE(is_listed(rigid, thrown, scene.solution, 1e-7)) << "the thrown pose is not listed";
  // One scene has 3200 configurations: all must close, and an even share is compared.
  constexpr std::size_t most_compared = 50;
  const std::size_t stride = 1 + scene.configurations().size() / most_compared;
  for (std::size_t place = 0; place < scene.configurations().size(); ++place) {
    SCOPED_TRACE("configuration " + std::to_string(place + 1));
    ++tally.configurations;
    const double closure = closure_of(rigid, poses_of(rigid, scene.configurations()[place]));
    EXPECT_LT(closure, 1e-15);
    tally.closure = largest(tally.closure, closure);
    if (place % stride == 0) {
      compare(scene, rigid, scene.configurations()[place], tally);
    }
  }
  for (unsigned listing = 1; listing <= 2; ++listing) {
    SCOPED_TRACE("listing " + std::to_string(listing));
    const Solved other(mechanism::parse_scene(made.listed(seed + listing).dump(), "random"));
    expect_same_configurations(scene, other);
  }
  for (const auto& [name, driver] : made.scene()["drivers"].items()) {
    const std::string law = driver["position"];
    tally.couplings += law.find("joint(") != std::string::npos ? 1 : 0;
  }
  const auto& structure = scene.plan.structure();
  const auto placed = structure.carried_by_ground();
  for (const mechanism::FoundGroup& group : structure.groups) {
    tally.relative_groups += group.base.exists() ? 1 : 0;
  }
  for (const mechanism::CarriedLink& link : structure.carried) {
    tally.driven_in_groups += link.driver.exists() && !placed[link.to] ? 1 : 0;
  }
}

std::ostream& operator<<(std::ostream& out, const Errors& errors) {
  return out << "pose " << errors.pose << ", velocity " << errors.velocity << ", acceleration "
             << errors.acceleration << ", joints " << errors.joints;
}

using DriversAnywhere = DrivenScenes;
INSTANTIATE_TEST_SUITE_P(Tied, DriversAnywhere,
                         testing::Values(Ties::drivers, Ties::groups,
                                         Ties::drivers_in_larger_groups),
                         name_of_ties);

TEST_P(DriversAnywhere, AgreeWithRigidBodiesInMotion) {
  Tally tally;
  for_each_scene(15, 1000, Places::anywhere,
                 [&](const RandomDrivenScene& made, unsigned seed) { check(made, seed, tally); });
  EXPECT_EQ(tally.relative_groups > 0, GetParam() == Ties::groups);
  std::cout << tally.driven_in_groups << " driven links in or behind groups, "
            << tally.relative_groups << " groups relative to moving links, " << tally.couplings
            << " laws that read joints; " << tally.configurations << " configurations, at most "
            << tally.largest_listing << " of a scene, close to " << tally.closure << "; of "
            << tally.compared << " (" << tally.without_rates
            << " without rates) relative errors of regular ones: " << tally.regular
            << "; of others: " << tally.other << '\n';
}

/// Newton's method from many places finds nothing that is not listed.
TEST_P(DriversAnywhere, ListWhateverNewtonFinds) {
  if (GetParam() == Ties::drivers_in_larger_groups) {
    GTEST_SKIP() << "none is small; LargerGroups.LackNoConfigurationThatNewtonFinds asks Newton";
  }
  constexpr int starts = 25;
  constexpr Eigen::Index largest_scene = 24;
  int arrived = 0;
  int searched = 0;
  for_each_scene(12, 600, Places::anywhere, [&](const RandomDrivenScene& made, unsigned seed) {
    const Solved scene(mechanism::parse_scene(made.scene().dump(), "random"));
    const RigidScene rigid(scene.plan.mechanism(), scene.values);
    if (rigid.size() > largest_scene) {
      return;
    }
    ++searched;
    std::mt19937 engine(seed);
    for (int start = 0; start < starts; ++start) {
      RealVector q = rigid.scattered(engine);
      if (rigid.assemble(q, 40)) {
        ++arrived;
        EXPECT_TRUE(is_listed(rigid, q, scene.solution, 1e-7)) << "start " << start << " found\n"
                                                               << q.transpose();
      }
    }
  });
  std::cout << searched << " of them small, " << arrived << " starts of " << starts
            << " for each arrived\n";
  EXPECT_GT(arrived, searched);
}

/// The sensitivities of all links to all parameters are compared with bodies that are assembled
/// again with one parameter changed. By default a seventh of the parameters is compared.
TEST_P(DriversAnywhere, HaveTheSensitivitiesOfRigidBodies) {
  double worst = 0;
  int count = 0;
  int at_folds = 0;
  int number = 0;
  for_each_scene(3, 150, Places::anywhere, [&](const RandomDrivenScene& made, unsigned) {
    const Solved scene(mechanism::parse_scene(made.scene().dump(), "random"));
    const RigidScene rigid(scene.plan.mechanism(), scene.values);
    const std::size_t checked = std::min<std::size_t>(scene.configurations().size(), 3);
    for (std::size_t place = 0; place < checked; ++place) {
      const Configuration& configuration = scene.configurations()[place];
      if (configuration.regularity != Status::ok) {
        continue;
      }
      const RealVector start = poses_of(rigid, configuration);
      for (const mechanism::ParameterIndex index : scene.plan.mechanism().parameters().keys()) {
        if (number++ % 7 != 0 && !is_whole_campaign()) {
          continue;
        }
        const std::string& name = scene.plan.mechanism().parameters()[index].name;
        SCOPED_TRACE("configuration " + std::to_string(place + 1) + ", " + name);
        const auto assembled = [&](double offset, RealVector& q) {
          const Values there = scene.plan.values({{name, scene.values.parameter(index) + offset}});
          q = start;
          return RigidScene(scene.plan.mechanism(), there).assemble(q) &&
                 distance(rigid, q, start) < 0.1;
        };
        // Near a fold the bodies can only be assembled after small steps.
        double step = 2e-3;
        RealVector q;
        while (step > 1e-5 && !(assembled(step, q) && assembled(-step, q))) {
          step /= 4;
        }
        if (step <= 1e-5) {
          ++at_folds;
          continue;
        }
        const auto moved = [&](double offset) -> Eigen::VectorXd {
          EXPECT_TRUE(assembled(offset, q));
          return (q - start).cast<double>();
        };
        const auto difference = best_richardson<Eigen::VectorXd>(moved, step, 3);
        Eigen::VectorXd listed(rigid.size());
        for (const mechanism::LinkIndex link : configuration.links.keys()) {
          if (const Eigen::Index first = rigid.coordinate(link); first >= 0) {
            listed.segment<3>(first) = configuration.links[link].follows.first.col(index.row());
          }
        }
        const double size = std::max(1e-3, listed.cwiseAbs().maxCoeff());
        const double error = (listed - difference.derivative).cwiseAbs().maxCoeff() / size;
        EXPECT_LT(error, 1e-7 + 10 * difference.uncertainty / size);
        if (difference.uncertainty < 1e-9 * size) {
          worst = largest(worst, error);
          ++count;
        }
      }
    }
  });
  std::cout << count << " sensitivities of all links, " << at_folds
            << " too near to a fold; relative error " << worst << '\n';
  EXPECT_LT(at_folds, 1 + count / 20);
  EXPECT_GT(count, 0);
  EXPECT_LT(worst, 1e-7);
}

/// The scene with one parameter moving at a constant rate, and nothing else driven.
Json with_one_moving(Json scene, const std::string& name, double velocity) {
  for (const auto& [other, entry] : scene["parameters"].items()) {
    if (entry.is_object()) {
      entry = entry["value"];
    }
  }
  for (const auto& [joint, driver] : scene["drivers"].items()) {
    driver.erase("velocity");
    driver.erase("acceleration");
  }
  scene["parameters"][name] = {{"value", scene["parameters"][name]}, {"velocity", velocity}};
  return scene;
}

/// A sweep counts the angles that laws read over whole turns. A solution by itself has them in
/// (-pi, pi], so that what follows such a law stands elsewhere and the numbering may differ.
bool is_counted_on(const Configuration& row) {
  return std::ranges::any_of(row.counted, [](const mechanism::CountedAngle& counted) {
    return std::abs(counted.angle) > std::numbers::pi;
  });
}

/// Every row of a sweep is a solution at its value, with the rates of its branch.
TEST_P(DriversAnywhere, SweepAsTheyAreSolvedAtEachStep) {
  constexpr int steps = 21;
  constexpr double range = 0.02;
  constexpr double velocity = 0.7;
  int rows = 0;
  int counted_on = 0;
  int differences = 0;
  double pointwise = 0;
  double followed = 0;
  double along_branch = 0;
  for_each_scene(6, 200, Places::anywhere, [&](const RandomDrivenScene& made, unsigned seed) {
    const std::string name = made.free_parameters()[seed % made.free_parameters().size()];
    Json json = with_one_moving(made.scene(), name, velocity);
    const double middle = json["parameters"][name]["value"];
    const Plan alone(mechanism::parse_scene(json.dump(), "random"));
    if (alone.solve(alone.values()).configurations.size() > mechanism::most_followed) {
      return;  // too many for a sweep
    }
    json["sweep"] = {
        {"parameter", name}, {"from", middle - range}, {"to", middle + range}, {"count", steps}};
    const Plan plan(mechanism::parse_scene(json.dump(), "random"));
    const mechanism::ParameterIndex swept = plan.request().sweep->parameter;
    Values values = alone.values();
    Solution solution;
    int step = -1;
    std::size_t rows_of_step = 0;
    // Every step has as many rows as configurations.
    const auto go_to = [&](int next) {
      while (step < next) {
        EXPECT_EQ(rows_of_step, solution.configurations.size()) << "step " << step;
        if (++step == steps) {
          return;
        }
        rows_of_step = 0;
        const double from = plan.values().value_of(plan.request().sweep->from);
        const double to = plan.values().value_of(plan.request().sweep->to);
        values.set(swept, from + (to - from) * step / (steps - 1));
        alone.solve(values, solution);
      }
    };
    const auto rigid = [&] { return RigidScene(alone.mechanism(), values); };
    bool step_is_counted_on = false;
    std::map<int, std::map<int, RealVector>> poses;       // by branch and step
    std::map<int, std::map<int, RealVector>> velocities;  // by branch and step
    const auto record = [&](const mechanism::SweepRecord& row) {
      if (!row.event.empty()) {
        return;
      }
      go_to(row.step);
      EXPECT_NEAR(row.parameter, values.parameter(swept), 1e-15);
      ++rows_of_step;
      ++rows;
      ASSERT_LE(static_cast<std::size_t>(row.configuration), solution.configurations.size());
      const Configuration& here =
          solution.configurations[static_cast<std::size_t>(row.configuration - 1)];
      const RigidScene bodies = rigid();
      const RealVector q = poses_of(bodies, *row.state);
      if (step_is_counted_on) {
        ++counted_on;
        if (row.state->regularity == Status::ok) {
          poses[row.branch][row.step] = q;
          velocities[row.branch][row.step] =
              rates_of(bodies, *row.state, &mechanism::Frame::velocity);
        }
        return;
      }
      const double apart = static_cast<double>(distance(bodies, q, poses_of(bodies, here)));
      EXPECT_LT(apart, 1e-9);
      pointwise = largest(pointwise, apart);
      if (row.state->regularity != Status::ok) {
        return;
      }
      const RealVector v = rates_of(bodies, *row.state, &mechanism::Frame::velocity);
      const double rates = relative(v, rates_of(bodies, here, &mechanism::Frame::velocity)) +
                           relative(rates_of(bodies, *row.state, &mechanism::Frame::acceleration),
                                    rates_of(bodies, here, &mechanism::Frame::acceleration));
      EXPECT_LT(rates, 1e-6);
      RealVector follows(bodies.size());
      for (const mechanism::LinkIndex link : here.links.keys()) {
        if (const Eigen::Index first = bodies.coordinate(link); first >= 0) {
          follows.segment<3>(first) =
              here.links[link].follows.first.col(swept.row()).cast<Real>() * velocity;
        }
      }
      const double follow = relative(v, follows);
      EXPECT_LT(follow, 1e-6);
      followed = largest(followed, std::max(rates, follow));
      poses[row.branch][row.step] = q;
      velocities[row.branch][row.step] = v;
    };
    const auto judge = [&](double, const Solution& swept_to) {
      step_is_counted_on = std::ranges::any_of(swept_to.configurations, is_counted_on);
    };
    mechanism::sweep(plan, {record, judge, [](int) {}});
    go_to(steps);
    const double h = 2 * range / (steps - 1) / velocity;  // in time
    const Real turn = 2 * std::acos(-1.0L);
    for (const auto& [branch, by_step] : poses) {
      for (const auto& [at, q] : by_step) {
        if (branch > 0 && by_step.contains(at - 1) && by_step.contains(at + 1) &&
            by_step.contains(at - 2) && by_step.contains(at + 2)) {
          const auto central = [&, &at = at, &by_step = by_step](int by) {
            RealVector change = by_step.at(at + by) - by_step.at(at - by);
            for (Eigen::Index angle = 2; angle < change.size(); angle += 3) {
              change(angle) = std::remainder(change(angle), turn);
            }
            return RealVector(change / (2 * by * h));
          };
          const RealVector near = central(1);
          const RealVector best = near + (near - central(2)) / 3;
          const Real size = 1 + velocities[branch][at].cwiseAbs().maxCoeff();
          const auto error =
              static_cast<double>((best - velocities[branch][at]).cwiseAbs().maxCoeff() / size);
          const auto trust = static_cast<double>((best - near).cwiseAbs().maxCoeff() / size);
          if (trust < 1e-3) {  // elsewhere the steps are too long for differences
            EXPECT_LT(error, 1e-7 + trust) << "branch " << branch << ", step " << at;
            along_branch = largest(along_branch, error);
            ++differences;
          }
        }
      }
    }
  });
  EXPECT_LT(counted_on, 1 + rows / 5);
  std::cout << rows << " rows of sweeps, " << counted_on
            << " of them with angles beyond half a turn; from solutions at their values "
            << pointwise << ", rates " << followed << ", from " << differences
            << " differences along branches " << along_branch << '\n';
  EXPECT_GT(differences, 0);
}

}  // namespace
}  // namespace assur::test::drivers_anywhere_test
