// Law: the efforts and forces of an emitted solver keep every link in equilibrium, and equal those
// of `assur solve`.
#include <gtest/gtest.h>

#include <iostream>
#include <numeric>

#include "generator/mixed_scene.hpp"
#include "generator/printed_forces.hpp"
#include "mechanism/driven_scene_campaign.hpp"
#include "mechanism/equilibrium.hpp"
#include "mechanism/kind_scene.hpp"
#include "mechanism/loaded_scene.hpp"

namespace assur::test::emit_forces_test {
namespace {

struct Worst {
  int configurations = 0, left_out = 0;
  double unbalanced = 0, against_solve = 0;
};

/// Compares one configuration, if its constraints' Jacobian is far from a singular one.
void compare(const Solved& scene, const Configuration& configuration, const mechanism::Forces& told,
             Worst& worst) {
  const mechanism::Mechanism& mechanism = scene.plan.mechanism();
  const RigidScene rigid(mechanism, scene.values);
  RealVector poses(rigid.size());
  for (const mechanism::LinkIndex link : mechanism.links().keys()) {
    if (const Eigen::Index first = rigid.coordinate(link); first >= 0) {
      const auto& pose = configuration.links[link].pose;
      poses.segment<3>(first) << pose.x, pose.y, angle_of(pose.direction);
    }
  }
  if (configuration.regularity != Status::ok || condition_of(rigid, poses) < 1e-3L) {
    ++worst.left_out;
    return;
  }
  const LinkSums sums(mechanism, scene.values, configuration, told);
  const double unit = std::max(1.0, sums.largest());
  for (const mechanism::LinkIndex link : mechanism.links().keys()) {
    Eigen::Vector3d left = sums.on(link);
    if (link == mechanism.ground()) {
      left -= Eigen::Vector3d(told.ground.force.x(), told.ground.force.y(), told.ground.moment);
    }
    worst.unbalanced = largest(worst.unbalanced, left.norm() / unit);
  }
  const std::vector<ToldNumber> own = numbers_of(told);
  const std::vector<ToldNumber> dense =
      numbers_of(mechanism::forces_of(scene.values, configuration));
  for (std::size_t place = 0; place < own.size(); ++place) {
    worst.against_solve =
        largest(worst.against_solve, std::abs(own[place].value - dense[place].value) / unit);
  }
  ++worst.configurations;
}

/// Emits a solver for each scene, runs them all in one program, and compares what they tell.
Worst compare_all(const std::vector<NamedScene>& scenes, double most = 1e-10,
                  const std::string& scalar = "double") {
  Worst worst;
  for_each_printed(
      scenes, printed_states(scenes, code_that_prints_forces, scalar),
      [&](const Solved& known, const Configuration& configuration, std::istream& printed) {
        const double before = std::max(worst.unbalanced, worst.against_solve);
        compare(known, configuration, read_forces(printed, known), worst);
        const double after = std::max(worst.unbalanced, worst.against_solve);
        EXPECT_FALSE(after > most && after > before) << after;
      });
  return worst;
}

void expect_equal(const Worst& worst, double most = 1e-10) {
  std::cout << worst.configurations << " configurations, " << worst.left_out
            << " left out as nearly singular; unbalanced " << worst.unbalanced
            << ", against dense equilibrium " << worst.against_solve << "\n";
  EXPECT_GT(worst.configurations, 0);
  EXPECT_LT(worst.unbalanced, most);
  EXPECT_LT(worst.against_solve, most);
}

const std::vector<std::string> wanted = {"position", "forces"};

class EmitForcesOfKinds : public testing::TestWithParam<std::size_t> {};

/// Every kind of a group, held by the ground; of the larger groups one of 25, unless the whole
/// campaign is asked for.
TEST_P(EmitForcesOfKinds, KeepLinksInEquilibrium) {
  const mechanism::GroupModels& group = mechanism::known_groups()[GetParam()];
  const std::vector<ModelLink> links(group.structure.link_count());
  std::vector<NamedScene> scenes;
  unsigned seed = 4711;
  for (const mechanism::GroupModel& model : group.models) {
    for (const std::string& kind : model.rigid ? model.kinds : std::vector<std::string>()) {
      const KindBodies bodies(group.structure.joints, links, {}, kind.c_str(), ++seed);
      if (!is_whole_campaign() && links.size() > 2 && seed % 25 != 0) {
        continue;
      }
      std::vector<std::size_t> link_order(links.size());
      std::vector<std::size_t> joint_order(group.structure.joints.size());
      std::iota(link_order.begin(), link_order.end(), 0U);
      std::iota(joint_order.begin(), joint_order.end(), 0U);
      Json json = loaded(Json::parse(scene_text(bodies, link_order, joint_order)), seed);
      json["want"] = wanted;
      scenes.push_back({"kind_" + std::to_string(seed), json});
    }
  }
  std::cout << group.structure.name << ": " << scenes.size() << " kinds, seeds from 4712: ";
  expect_equal(compare_all(scenes));
}

INSTANTIATE_TEST_SUITE_P(All, EmitForcesOfKinds,
                         testing::Range(std::size_t{0}, mechanism::known_groups().size()));

class EmitForcesOfScenes : public DrivenScenes {};

/// Drivers anywhere, laws that read joints, racks, cylinders, pins of many links, slots.
TEST_P(EmitForcesOfScenes, KeepLinksInEquilibrium) {
  std::vector<NamedScene> scenes;
  for_each_scene(2, 60, Places::anywhere, [&](const RandomDrivenScene& made, unsigned seed) {
    Json json = loaded(made.scene(), seed);
    json["want"] = wanted;
    scenes.push_back({"scene_" + std::to_string(seed), json});
  });
  expect_equal(compare_all(scenes));
}

/// A law that reads a joint shapes a link, and so moves the origin of the link's normal frame.
TEST(EmitForces, FollowLinksThatLawsShape) {
  Json json = loaded(driven_scene(27190, Places::anywhere).scene(), 27190);
  json["want"] = wanted;
  expect_equal(compare_all({{"shaped", json}}));
}

INSTANTIATE_TEST_SUITE_P(Ties, EmitForcesOfScenes, testing::Values(Ties::drivers, Ties::groups),
                         name_of_ties);

/// Their multipliers are found in numbers.
TEST(EmitForces, KeepLargerGroupsInEquilibrium) {
  constexpr unsigned seed = 61;
  const RandomDrivenScene made(seed, Places::anywhere, 1, Ties::drivers_in_larger_groups);
  Json json = loaded(made.scene(), seed);
  json["want"] = wanted;
  expect_equal(compare_all({{"larger", json}}));
}

TEST(EmitForces, TellOfPinsSlidesAndLoadsThatReadJoints) {
  expect_equal(compare_all({{"mixed", mixed_scene()}}));
}

/// In float six digits remain of the largest force where the mechanism is far from singular.
TEST(EmitForces, AreTheSameInFloatToItsDigits) {
  expect_equal(compare_all({{"mixed", mixed_scene()}}, 1e-5, "float"), 1e-5);
}

}  // namespace
}  // namespace assur::test::emit_forces_test
