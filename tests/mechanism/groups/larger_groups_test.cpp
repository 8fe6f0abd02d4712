// Law: any Assur group has as many complex configurations as theory tells, all real ones among them
// are found, and a box around each proves that none is missing.
#include "mechanism/larger_groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <cmath>
#include <iostream>
#include <map>
#include <random>
#include <set>

#include "mechanism/rigid_poses.hpp"
#include "mechanism/rigid_scene.hpp"
#include "mechanism/scene_solutions.hpp"
#include "whole_campaign.hpp"

namespace assur::test::larger_groups_test {
namespace {

using Json = nlohmann::ordered_json;

/// The complex configurations of a group that is derived from its graph; zero where it has none.
int complex_configurations(const mechanism::GroupStructure& group,
                           const std::vector<bool>& slides) {
  const mechanism::GroupModel* model = model_of(group, slides);
  return model == nullptr ? 0 : model->max_configurations;
}

// The generated models are rows of the same table.
TEST(LargerGroups, CountAsManyConfigurationsAsTheGeneratedModels) {
  int rigid = 0;
  for (const mechanism::GroupModels& group : mechanism::known_groups()) {
    for (unsigned kind = 0; kind < (1U << group.structure.joints.size()); ++kind) {
      std::vector<bool> slides;
      for (std::size_t joint = 0; joint < group.structure.joints.size(); ++joint) {
        slides.push_back(((kind >> joint) & 1U) != 0);
      }
      const mechanism::GroupModels::Served served = group.serving(slides);
      EXPECT_EQ(complex_configurations(group.structure, slides), served.model->max_configurations)
          << group.structure.name << " " << served.kind;
      rigid += served.model->rigid ? 1 : 0;
    }
  }
  EXPECT_EQ(rigid, 7 + 54 + 54);
}

// Innocenti, Journal of Mechanical Design 116 (1994) and 117 (1995); Rojas and Thomas, Mechanism
// and Machine Theory 46 (2011).
TEST(LargerGroups, OfSixLinksHave14Or16Or18Configurations) {
  std::multiset<int> found;
  for (const Chain& chain : seven_link_chains()) {
    EXPECT_TRUE(moves_in_all_parts(chain, 7, 0));
    std::set<int> counts;
    for (int base = 0; base < 7; ++base) {
      counts.insert(complex_configurations(grounded(chain, 7, base), std::vector<bool>(9, false)));
    }
    EXPECT_EQ(counts.size(), 1U) << "the number depends on the link that is the base";
    found.insert(*counts.begin());
  }
  EXPECT_EQ(found, (std::multiset<int>{14, 16, 18}));
}

/// Bars between points that are drawn anywhere: joint k of a chain at point Pk.
Json drawn_chain(const Chain& chain, int links, int ground, std::size_t driven,
                 std::mt19937& engine) {
  std::uniform_real_distribution<double> place(-4, 4);
  Json scene;
  for (std::size_t joint = 0; joint < chain.size(); ++joint) {
    scene["points"]["P" + std::to_string(joint)] = {place(engine), place(engine)};
  }
  for (int link = 0; link < links; ++link) {
    Json& points = scene["links"][link == ground ? "ground" : "L" + std::to_string(link)];
    for (std::size_t joint = 0; joint < chain.size(); ++joint) {
      if (chain[joint].first == link || chain[joint].second == link) {
        points.push_back("P" + std::to_string(joint));
      }
    }
  }
  scene["drivers"]["P" + std::to_string(driven)] = {{"velocity", 1}};
  return scene;
}

// All ways to ground and to drive the sixteen chains of eight links.
TEST(LargerGroups, SolveEveryEightBarLinkageAsItIsDrawn) {
  constexpr unsigned seed = 88;
  std::mt19937 engine(seed);
  const std::vector<Chain> chains = chains_of(8, 10, 1);
  ASSERT_EQ(chains.size(), 16U);
  std::map<int, int> counts;
  int cases = 0;
  double farthest = 0;
  for (const Chain& chain : chains) {
    for (int ground = 0; ground < 8; ++ground) {
      for (std::size_t driven = 0; driven < chain.size(); ++driven) {
        if (chain[driven].first != ground && chain[driven].second != ground) {
          continue;
        }
        ++cases;
        SCOPED_TRACE("case " + std::to_string(cases));
        mechanism::Scene scene = mechanism::parse_scene(
            drawn_chain(chain, 8, ground, driven, engine).dump(), "eight bars");
        scene.request.prove = true;
        const mechanism::Plan plan(scene);
        const mechanism::Values values = plan.values();
        const mechanism::Solution solution = plan.solve(values);
        EXPECT_EQ(solution.incomplete, "");
        const std::optional<mechanism::Nearest> drawn = plan.nearest(values, solution);
        ASSERT_TRUE(drawn);
        EXPECT_LT(drawn->distance, 1e-9);
        EXPECT_GT(drawn->runner_up.value_or(1), 1e-6) << "the drawn configuration is listed twice";
        farthest = std::max(farthest, drawn->distance);
        for (const mechanism::Configuration& configuration : solution.configurations) {
          for (const mechanism::GroupProof& proof : configuration.proofs) {
            EXPECT_TRUE(proof.is_complete()) << proof.boxes << " of " << proof.of;
          }
        }
        for (const mechanism::FoundGroup& group : plan.structure().groups) {
          counts[group.model->is_derived() ? group.model->max_configurations : 0] += 1;
        }
      }
    }
  }
  EXPECT_EQ(cases, 320);
  EXPECT_EQ(counts[14], 10);
  EXPECT_EQ(counts[16], 36);
  EXPECT_EQ(counts[18], 18);
  std::cout << "seed " << seed << ": drawn configurations found within " << farthest << " rad\n";
}

/// Newton's method on rigid bodies from many starts, which knows no groups.
void expect_all_found(const mechanism::Plan& plan, const mechanism::Values& values,
                      const mechanism::Solution& solution, int starts, std::mt19937& engine,
                      int& found) {
  const RigidScene rigid(plan.mechanism(), values);
  std::uniform_real_distribution<double> place(-6, 6);
  std::uniform_real_distribution<double> angle(-3.2, 3.2);
  for (int start = 0; start < starts; ++start) {
    RealVector q(rigid.size());
    for (Eigen::Index coordinate = 0; coordinate < q.size(); ++coordinate) {
      q(coordinate) = coordinate % 3 == 2 ? angle(engine) : place(engine);
    }
    if (rigid.assemble(q)) {
      ++found;
      EXPECT_TRUE(is_listed(rigid, q, solution, 1e-7)) << "a configuration is lost";
    }
  }
  for (const mechanism::Configuration& configuration : solution.configurations) {
    EXPECT_LT(closure_of(rigid, poses_of(rigid, configuration)), 1e-14) << "one is invented";
  }
}

TEST(LargerGroups, LackNoConfigurationThatNewtonFinds) {
  constexpr unsigned seed = 61;
  std::mt19937 engine(seed);
  const int groups = is_whole_campaign() ? 2000 : 30;
  const int starts = is_whole_campaign() ? 200 : 40;
  int found = 0;
  int listed = 0;
  for (int trial = 0; trial < groups; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    // A crank on the base drives one of the group's external joints.
    Chain chain = seven_link_chains()[static_cast<std::size_t>(trial % 3)];
    const int base = trial % 7;
    const auto external = std::ranges::find_if(
        chain, [&](const auto& joint) { return joint.first == base || joint.second == base; });
    (external->first == base ? external->first : external->second) = 7;
    chain.emplace_back(base, 7);
    const mechanism::Plan plan(mechanism::parse_scene(
        drawn_chain(chain, 8, base, chain.size() - 1, engine).dump(), "six links"));
    const mechanism::Values values = plan.values();
    const mechanism::Solution solution = plan.solve(values);
    EXPECT_EQ(solution.incomplete, "");
    listed += static_cast<int>(solution.configurations.size());
    expect_all_found(plan, values, solution, starts, engine, found);
  }
  std::cout << "seed " << seed << ", " << groups << " groups: " << listed
            << " configurations, Newton came to rest " << found << " times\n";
  EXPECT_GT(found, listed);
}

}  // namespace
}  // namespace assur::test::larger_groups_test
