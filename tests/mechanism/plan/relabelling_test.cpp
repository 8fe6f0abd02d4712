// Law: over all rigid kinds of the tetrad, a scene gives the same configurations in the same order
// however its links and joints are listed, and the one from which it was made is among them; so
// does a scene with redundant constraints.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <assur/tetrad/models.hpp>
#include <numeric>

#include "largest.hpp"
#include "mechanism/kind_scene.hpp"
#include "mechanism/scene_maker.hpp"
#include "mechanism/solved.hpp"

namespace assur::test::relabelling_test {
namespace {

/// Angles of the links by name, per configuration.
std::vector<std::map<std::string, double>> angles(const std::string& text) {
  const Solved solved(mechanism::parse_scene(text, "scene"));
  std::vector<std::map<std::string, double>> result;
  for (const Configuration& configuration : solved.configurations()) {
    result.emplace_back();
    for (const mechanism::LinkIndex link : configuration.links.keys()) {
      result.back()[solved.plan.mechanism().links()[link].name] =
          angle_of(configuration.links[link].pose.direction);
    }
  }
  return result;
}

double apart(double one, double other) {
  return std::abs(std::remainder(one - other, 2 * std::acos(-1.0)));
}

template <typename Model>
void check_kinds(int& groups) {
  if constexpr (Model::rigid) {
    for (const auto& roles : Model::kinds) {
      for (unsigned sample = 0; sample < 3; ++sample) {
        const unsigned seed = 300 * static_cast<unsigned>(Model::number) + sample;
        SCOPED_TRACE(std::string(roles.kind) + ", seed " + std::to_string(seed));
        const KindInSpace<Model> space(roles, seed);
        std::vector<std::size_t> links(4);
        std::vector<std::size_t> joints(6);
        std::iota(links.begin(), links.end(), std::size_t{0});
        std::iota(joints.begin(), joints.end(), std::size_t{0});
        const auto reference = angles(scene_text(space, links, joints));
        const bool made_is_found =
            std::any_of(reference.begin(), reference.end(), [&](const auto& configuration) {
              double worst = 0;
              for (std::size_t link = 0; link < 4; ++link) {
                worst = largest(worst, apart(configuration.at("L" + std::to_string(link)),
                                             static_cast<double>(space.bodies.poses[link].theta)));
              }
              return worst < 1e-6;
            });
        EXPECT_TRUE(made_is_found);
        std::mt19937 engine(seed);
        for (int relabelling = 0; relabelling < 4; ++relabelling) {
          std::shuffle(links.begin(), links.end(), engine);
          std::shuffle(joints.begin(), joints.end(), engine);
          const auto relabelled = angles(scene_text(space, links, joints));
          ASSERT_EQ(relabelled.size(), reference.size());
          for (std::size_t index = 0; index < reference.size(); ++index) {
            for (const auto& [link, angle] : reference[index]) {
              EXPECT_LT(apart(angle, relabelled[index].at(link)), 1e-8);
            }
          }
        }
        ++groups;
      }
    }
  }
}

TEST(Relabelling, KeepsConfigurationsAndTheirOrder) {
  int groups = 0;
  std::apply([&](auto... model) { (check_kinds<decltype(model)>(groups), ...); }, tetrad::Models());
  std::cout << groups << " groups, each in five listings\n";
  EXPECT_GT(groups, 100);
}

/// A coupler on three equal cranks: in every listing the same redundant constraint is left out,
/// along the same line, on which the verdict on a configuration depends.
TEST(Relabelling, KeepsWhatIsLeftOutOfTooManyConstraints) {
  SceneMaker maker;
  maker.parameter("phi", "-pi/2").drive("A0", "phi", 1, 0);
  const std::array<std::array<double, 2>, 3> pivots{{{5, 4}, {5, 3}, {0, 2}}};
  for (std::size_t crank = 0; crank < pivots.size(); ++crank) {
    const std::string number = std::to_string(crank);
    const auto& [x, y] = pivots[crank];
    maker.point("ground", "A" + number, x, y).point("coupler", "B" + number, x, y + 2);
    maker.point("leg" + number, "A" + number, 0, 0).point("leg" + number, "B" + number, 0, 2);
  }
  const Solved reference(mechanism::parse_scene(maker.scene().dump(), "scene"));
  ASSERT_EQ(reference.configurations().size(), 1U);
  for (const int listing : {1, 2}) {
    const Solved found(
        mechanism::parse_scene(scene_listed(maker.scene(), listing).dump(), "scene"));
    ASSERT_EQ(found.configurations().size(), 1U);
    EXPECT_EQ(found.configurations()[0].regularity, reference.configurations()[0].regularity);
    EXPECT_NEAR(found.configurations()[0].link("leg1").velocity(2), 1, 1e-7);
  }
}

}  // namespace
}  // namespace assur::test::relabelling_test
