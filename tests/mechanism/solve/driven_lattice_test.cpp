// Law: in special positions the answers for scenes with drivers anywhere are true, complete, and
// the same in every order of listing.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <set>

#include "largest.hpp"
#include "mechanism/driven_scene_campaign.hpp"
#include "mechanism/rigid_poses.hpp"

namespace assur::test::driven_lattice_test {
namespace {

/// The tolerance at singular configurations, relative to the mechanism's size. Configurations that
/// meet are known to 1e-8; those that depend on them through a fold to the square root of that,
/// times its arm.
constexpr double within_singular = 1e-3;

/// Scenes on the lattice are exactly singular or far from it.
constexpr Real singular = 1e-13L;

struct Tally {
  int configurations = 0, singular = 0, without_rates = 0, families = 0, rates = 0;
  double velocity = 0, acceleration = 0;
};

/// A family in any order of listing: the links of its group, and where placed links are.
struct NamedFamily {
  std::set<std::string> group;
  int mobility;
  std::map<std::string, ::assur::Pose<double>> placed;
};

std::vector<NamedFamily> families_of(const Solved& scene) {
  std::vector<NamedFamily> result;
  const auto& structure = scene.plan.structure();
  for (const mechanism::Family& family : scene.solution.families) {
    const auto names = structure.names_of(structure.groups[family.group].links);
    NamedFamily named{{names.begin(), names.end()}, family.mobility, {}};
    for (const mechanism::LinkIndex link : family.is_placed.keys()) {
      if (family.is_placed[link]) {
        named.placed[structure.linkage.links[link]] = family.links[link].pose;
      }
    }
    result.push_back(std::move(named));
  }
  return result;
}

bool are_one(const NamedFamily& one, const NamedFamily& other, Real reach) {
  return one.group == other.group && one.mobility == other.mobility &&
         one.placed.size() == other.placed.size() &&
         std::ranges::all_of(one.placed, [&](const auto& link) {
           const auto found = other.placed.find(link.first);
           return found != other.placed.end() &&
                  pose_difference(link.second, found->second) < within_singular * (1 + reach);
         });
}

void expect_same_families(const Solved& one, const Solved& other, Real reach) {
  const std::vector<NamedFamily> here = families_of(one);
  const std::vector<NamedFamily> there = families_of(other);
  EXPECT_EQ(here.size(), there.size());
  for (const NamedFamily& family : here) {
    EXPECT_EQ(std::ranges::count_if(
                  there, [&](const NamedFamily& it) { return are_one(family, it, reach); }),
              1);
  }
}

void check_rates(const RigidScene& rigid, const Configuration& configuration, RealVector q,
                 Tally& tally) {
  constexpr int iterations = 4;  // the start closes to within rounding
  (void)rigid.assemble(q, iterations);
  const RealVector v = rigid.velocity(q);
  const double bound = configuration.regularity == Status::ok ? 1e-6 : 1e-2;
  const double of_velocity =
      relative(rates_of(rigid, configuration, &mechanism::Frame::velocity), v);
  EXPECT_LT(of_velocity, bound);
  tally.velocity = largest(tally.velocity, of_velocity);
  const RealVector listed = rates_of(rigid, configuration, &mechanism::Frame::acceleration);
  if (listed.allFinite()) {
    // Where terms cancel, the differences of the laws are accurate relative to the terms only.
    const Real speed = v.cwiseAbs().maxCoeff();
    const double of_acceleration = relative(listed, rigid.acceleration(q, v),
                                            std::max(Real(1e-9L), speed * speed / rigid.reach()));
    EXPECT_LT(of_acceleration, bound);
    tally.acceleration = largest(tally.acceleration, of_acceleration);
  }
  ++tally.rates;
}

void check(const RandomDrivenScene& made, unsigned seed, Tally& tally) {
  const Solved scene(mechanism::parse_scene(made.scene().dump(), "lattice"));
  const std::string report = mechanism::report_json(scene.report());
  EXPECT_EQ(report.find("nan"), std::string::npos);
  EXPECT_EQ(report.find("inf,"), std::string::npos);
  const RigidScene rigid(scene.plan.mechanism(), scene.values);
  const RealVector thrown = thrown_poses(rigid, scene.plan.mechanism(), made);
  ASSERT_LT(rigid.values_of(thrown).cwiseAbs().maxCoeff(), 1e-13) << "the scene is made wrong";
  const Real condition = condition_of(rigid, thrown);
  const Real within = condition < singular ? within_singular : 1e-7;
  EXPECT_TRUE(is_listed(rigid, thrown, scene.solution, within) ||
              (condition < singular && is_of_a_family(rigid, thrown, scene.solution, within)))
      << "the thrown pose, of condition " << condition << ", is neither among "
      << scene.configurations().size() << " configurations nor of one of "
      << scene.solution.families.size() << " families; " << scene.plan.obstacle(scene.values);
  tally.families += static_cast<int>(scene.solution.families.size());
  // One scene (seed 27329, ties by groups) has 3504 configurations; an even share is enough.
  constexpr std::size_t most_checked = 200;
  const std::size_t stride = 1 + scene.configurations().size() / most_checked;
  for (std::size_t place = 0; place < scene.configurations().size(); place += stride) {
    SCOPED_TRACE("configuration " + std::to_string(place + 1));
    const Configuration& configuration = scene.configurations()[place];
    ++tally.configurations;
    const RealVector q = poses_of(rigid, configuration);
    EXPECT_LT(closure_of(rigid, q), 4e-15);
    tally.without_rates += configuration.rates_known ? 0 : 1;
    if (condition_of(rigid, q) < singular) {
      ++tally.singular;
      EXPECT_NE(configuration.regularity, Status::ok);
      EXPECT_FALSE(configuration.derivatives_known);
    } else if (configuration.rates_known) {
      check_rates(rigid, configuration, q, tally);
    }
  }
  const Solved other(mechanism::parse_scene(made.listed(seed).dump(), "lattice"));
  expect_same_configurations(scene, other, within_singular);
  expect_same_families(scene, other, rigid.reach());
}

void print(const Tally& tally) {
  std::cout << tally.configurations << " configurations, " << tally.singular
            << " of them singular, " << tally.without_rates << " without rates, " << tally.families
            << " families; the rates of " << tally.rates << " differ by " << tally.velocity
            << " and " << tally.acceleration << '\n';
}

using DrivenLattice = DrivenScenes;
INSTANTIATE_TEST_SUITE_P(Tied, DrivenLattice, testing::Values(Ties::drivers, Ties::groups),
                         name_of_ties);

TEST_P(DrivenLattice, TellsTheTruthInSpecialPositions) {
  Tally tally;
  for_each_scene(12, 2000, Places::lattice,
                 [&](const RandomDrivenScene& made, unsigned seed) { check(made, seed, tally); });
  print(tally);
}

/// Three configurations meet, and a group that depends on them is at a fold (seed 29050).
TEST(KnownDrivenLattice, KnowsWhereThreeMeet) {
  Tally tally;
  constexpr unsigned seed = 29050;
  const RandomDrivenScene made = driven_scene(seed, Places::lattice);
  check(made, seed, tally);
  const Solved scene(mechanism::parse_scene(made.scene().dump(), "lattice"));
  EXPECT_EQ(scene.configurations().size(), 2U);
  const RigidScene rigid(scene.plan.mechanism(), scene.values);
  EXPECT_TRUE(
      is_listed(rigid, thrown_poses(rigid, scene.plan.mechanism(), made), scene.solution, 1e-12));
  print(tally);
}

/// A bar without length turns freely, and a law that reads its angle moves what holds a group that
/// is solved relative to a link: that group cannot be solved (seeds 27725, 27501).
TEST(KnownDrivenLattice, TellsFamiliesBesideGroupsThatReadThem) {
  Tally tally;
  for (const unsigned seed : {27725U, 27501U}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    check(driven_scene(seed, Places::lattice, Ties::groups), seed, tally);
  }
  EXPECT_GT(tally.families, 0);
  print(tally);
}

/// Links between parallel slides move freely though all else is held (seeds 27283 to 27745), or the
/// law of a driven link reads what moves (27870, 28470), or families differ by rounding alone.
TEST(KnownDrivenLattice, TellsWhatIsFreeAndWhatStandsInKnownScenes) {
  Tally tally;
  for (const unsigned seed : {27283U, 27346U, 27492U, 27540U, 27745U, 27635U, 27982U, 28617U,
                              27496U, 28555U, 27870U, 28470U}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    check(driven_scene(seed, Places::lattice), seed, tally);
  }
  print(tally);
}

}  // namespace
}  // namespace assur::test::driven_lattice_test
