// Law: groups in special position, on a small integer lattice, have the answers of exact
// arithmetic: every isolated configuration once, with its regularity, and families told as such.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "mechanism/lattice_run.hpp"
#include "mechanism/lattice_search.hpp"
#include "whole_campaign.hpp"

namespace assur::test::lattice_test {
namespace {

constexpr std::size_t default_scenes = 575;

/// The table's row of a dyad, derived by hand.
struct ByHand {
  bool family;
  int isolated, singular;
};

int dot(const LatticeVector& a, const LatticeVector& b) { return a.x * b.x + a.y * b.y; }
int cross(const LatticeVector& a, const LatticeVector& b) { return a.x * b.y - a.y * b.x; }
LatticeVector from(const LatticeVector& a, const LatticeVector& b) {
  return {b.x - a.x, b.y - a.y};
}

/// The two configurations mirror one another in the line between two centers, or in the normal of a
/// slide; if the known one is its own image they are one, a dead centre.
ByHand mirrored(bool family, int distance) {
  return family ? ByHand{true, 0, 0} : distance == 0 ? ByHand{false, 1, 1} : ByHand{false, 2, 0};
}

ByHand dyad_by_hand(const LatticeScene& scene) {
  const LatticeJoint& B = scene.joints()[0];
  const LatticeJoint& C = scene.joints()[1];
  const LatticeJoint& D = scene.joints()[2];
  const LatticeVector BC = from(B.at, C.at);
  const LatticeVector DC = from(D.at, C.at);
  const LatticeVector BD = from(B.at, D.at);
  const auto is_zero = [](const LatticeVector& a) { return a.x == 0 && a.y == 0; };
  const std::string& kind = scene.kind().spelling;
  if (kind == "RRR") {
    return mirrored(is_zero(BC) || is_zero(DC) || is_zero(BD), cross(BC, DC));
  }
  if (kind == "RRP") {
    return mirrored(is_zero(BC), dot(BC, D.along));
  }
  if (kind == "PRR") {
    return mirrored(is_zero(DC), dot(DC, B.along));
  }
  if (kind == "RPR") {
    return mirrored(is_zero(BD), dot(BD, C.along));
  }
  // Neither link turns; they slide along two given directions.
  const LatticeVector& one = kind == "RPP" ? C.along : B.along;
  const LatticeVector& other = kind == "PPR" ? C.along : D.along;
  const bool parallel = cross(one, other) == 0;
  return {parallel, parallel ? 0 : 1, 0};
}

TEST(LatticeTruth, AgreesWithDyadsByHand) {
  int dyads = 0;
  const std::vector<LatticeKind> kinds = lattice_kinds();
  for (const LatticeTruth& truth : read_lattice_truth(ASSUR_LATTICE_TRUTH, 100000)) {
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const LatticeKind& at) {
      return at.spelling == truth.kind;
    });
    ASSERT_NE(kind, kinds.end()) << truth.kind;
    if (kind->group->name != "dyad") {
      continue;
    }
    const LatticeScene scene(*kind, truth.seed);
    SCOPED_TRACE(scene.name());
    const ByHand hand = dyad_by_hand(scene);
    EXPECT_EQ(truth.exactness, lattice_class_name(scene.exactness()));
    EXPECT_TRUE(truth.known);
    EXPECT_EQ(truth.mobility > 0, hand.family);
    EXPECT_EQ(truth.isolated, hand.isolated);
    EXPECT_EQ(truth.singular, hand.singular);
    ++dyads;
  }
  std::cout << dyads << " dyads\n";
  EXPECT_GT(dyads, 100);
}

TEST(LatticeTruth, AgreesWithASearchFromRandomStarts) {
  constexpr unsigned search_seed = 2718;
  int configurations = 0;
  int missed = 0;
  const std::vector<LatticeKind> kinds = lattice_kinds();
  const std::size_t scenes = (is_whole_campaign() ? 2 : 1) * kinds.size();
  for (const LatticeTruth& truth : read_lattice_truth(ASSUR_LATTICE_TRUTH, scenes)) {
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const LatticeKind& at) {
      return at.spelling == truth.kind;
    });
    const LatticeScene scene(*kind, truth.seed);
    SCOPED_TRACE(scene.name());
    const auto found = static_cast<int>(searched_configurations(scene, 150, search_seed).size());
    // On a family every configuration is singular.
    EXPECT_LE(found, truth.regular());
    configurations += truth.regular();
    missed += truth.regular() - found;
    if (found < truth.regular()) {
      std::cout << scene.name() << ": the search finds " << found << " of " << truth.regular()
                << '\n';
    }
  }
  std::cout << "seed " << search_seed << ", " << configurations
            << " regular configurations, the search misses " << missed << '\n';
  EXPECT_LE(50 * missed, configurations);
}

/// Each scene in two listings. ASSUR_LATTICE_DUMP names a directory for the scenes that fail.
TEST(Lattice, AnswersAreExact) {
  const char* directory = std::getenv("ASSUR_LATTICE_DUMP");
  LatticeRun run(std::cout, directory == nullptr ? "" : directory);
  for (const LatticeTruth& truth : read_lattice_truth(ASSUR_LATTICE_TRUTH, default_scenes)) {
    EXPECT_TRUE(run.run(truth)) << truth.kind << ' ' << truth.seed;
  }
  run.print();
}

}  // namespace
}  // namespace assur::test::lattice_test
