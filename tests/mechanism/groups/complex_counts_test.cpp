// Law: the number of complex configurations of a group in its model is the dimension of a quotient
// ring, computed from rigid bodies modulo primes, by ranks here and by Singular.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <set>

#include "mechanism/complex_count.hpp"
#include "mechanism/larger_groups.hpp"
#include "whole_campaign.hpp"

namespace assur::test::complex_counts_test {
namespace {

constexpr unsigned seed = 1231;
constexpr std::array<Residues::Value, 2> primes = {2147483647, 2147483629};
/// No rigid group of eight links or less needs multiples of a higher degree.
constexpr int highest_degree = 6;

/// A group with some of its joints sliding.
struct Kind {
  mechanism::GroupStructure group;
  std::vector<bool> slides;

  [[nodiscard]] int links() const { return static_cast<int>(group.link_count()); }
  [[nodiscard]] std::vector<ModelJoint> joints() const {
    std::vector<ModelJoint> result = group.joints;
    for (std::size_t joint = 0; joint < result.size(); ++joint) {
      result[joint].prismatic = slides[joint];
    }
    return result;
  }
};

std::vector<Kind> kinds_of(const mechanism::GroupStructure& group) {
  std::vector<Kind> result;
  for (unsigned bits = 0; bits < (1U << group.joints.size()); ++bits) {
    Kind kind{group, {}};
    for (std::size_t joint = 0; joint < group.joints.size(); ++joint) {
      kind.slides.push_back(((bits >> joint) & 1U) != 0);
    }
    result.push_back(std::move(kind));
  }
  return result;
}

/// All kinds of the seven-link chains; the number does not depend on the base.
std::vector<Kind> seven_link_kinds() {
  std::vector<Kind> result;
  for (const Chain& chain : seven_link_chains()) {
    const std::vector<Kind> kinds = kinds_of(grounded(chain, 7, 6));
    result.insert(result.end(), kinds.begin(), kinds.end());
  }
  return result;
}

/// The kinds of the dyad, the triad and the tetrad.
std::vector<Kind> kinds_with_generated_models() {
  std::vector<Kind> result;
  for (const mechanism::GroupModels& group : mechanism::known_groups()) {
    const std::vector<Kind> kinds = kinds_of(group.structure);
    result.insert(result.end(), kinds.begin(), kinds.end());
  }
  return result;
}

std::vector<Kind> nine_link_chains() {
  std::vector<Kind> result;
  for (const Chain& chain : chains_of(9, 12, 0)) {
    result.push_back({grounded(chain, 9, 8), std::vector<bool>(12, false)});
  }
  return result;
}

/// How many kinds have each number of configurations; the group moves where it is 0.
using Tally = std::map<int, int>;

/// Holds a model against a number that was counted without it; a group that moves has no finite
/// number, or no configuration at all, and a model of its own never.
void compare(const Kind& kind, int counted, Tally& tally) {
  ++tally[counted];
  const mechanism::GroupModel* model = model_of(kind.group, kind.slides);
  EXPECT_EQ(model == nullptr ? 0 : model->max_configurations, counted);
}

void expect_counts_modulo_primes(const std::vector<Kind>& kinds, Tally& tally) {
  for (const Kind& kind : kinds) {
    SCOPED_TRACE(testing::PrintToString(kind.slides));
    std::set<int> counts;
    for (const Residues::Value prime : primes) {
      const GroupModuloPrime group(kind.links(), kind.joints(), prime,
                                   seed + static_cast<unsigned>(counts.size()));
      counts.insert(group.count(highest_degree).value_or(0));
    }
    ASSERT_EQ(counts.size(), 1U) << "the primes disagree";
    compare(kind, *counts.begin(), tally);
  }
}

TEST(ComplexCounts, OfDyadsTriadsAndTetradsAreThoseModuloPrimes) {
  Tally tally;
  expect_counts_modulo_primes(kinds_with_generated_models(), tally);
  EXPECT_EQ(tally[0], 1 + 10 + 10) << "the kinds that move";
  // The dyad has 2 or 1; of the rigid kinds of the tetrad 13, 12, 17 and 12 have 6, 4, 2 and 1.
  Tally of_tetrad;
  expect_counts_modulo_primes(kinds_of(mechanism::known_groups().back().structure), of_tetrad);
  EXPECT_EQ(of_tetrad, (std::map<int, int>{{0, 10}, {1, 12}, {2, 17}, {4, 12}, {6, 13}}));
}

constexpr std::size_t kind_stride = 31;
const std::map<int, int> all_seven_link_kinds = {{0, 305}, {1, 139}, {2, 272}, {4, 243},
                                                 {6, 188}, {8, 107}, {10, 53}, {12, 99},
                                                 {14, 62}, {16, 35}, {18, 33}};

TEST(ComplexCounts, OfSevenLinkChainsAreThoseModuloPrimes) {
  Tally tally;
  expect_counts_modulo_primes(share_of(seven_link_kinds(), kind_stride), tally);
  if (is_whole_campaign()) {
    EXPECT_EQ(tally, all_seven_link_kinds);
  }
}

TEST(ComplexCounts, OfSevenLinkChainsWithSlidesInThreeDirectionsAreThoseModuloPrimes) {
  std::vector<Kind> kinds;
  for (const auto& [chain, slides] : chains_with_slides_in_three_directions()) {
    kinds.push_back({grounded(chain, 7, 6), slides});
  }
  EXPECT_EQ(kinds.size(), 63U);
  Tally tally;
  expect_counts_modulo_primes(share_of(kinds, 21), tally);
  EXPECT_EQ(tally[0], 0);
}

TEST(LongComplexCounts, OfNineLinkChainsAreThoseModuloPrimes) {
  Tally tally;
  expect_counts_modulo_primes(nine_link_chains(), tally);
}

/// Singular's dimensions of the quotient rings of groups; one that is not finite as 0.
std::vector<int> counts_of_singular(const std::vector<Kind>& kinds) {
  const std::filesystem::path script =
      std::filesystem::temp_directory_path() / "assur_complex_counts.sing";
  std::ofstream file(script);
  for (const Kind& kind : kinds) {
    file << GroupModuloPrime(kind.links(), kind.joints(), primes.front(), seed).asked_of_singular();
  }
  file << "quit;\n";
  file.close();
  std::vector<int> result;
  if (FILE* answers = popen(("Singular -q " + script.string()).c_str(), "r")) {
    int count = 0;
    while (std::fscanf(answers, "%d", &count) == 1) {
      result.push_back(std::max(count, 0));
    }
    pclose(answers);
  }
  std::filesystem::remove(script);
  return result;
}

TEST(ComplexCounts, AreThoseOfSingular) {
  if (std::system("command -v Singular > /dev/null") != 0) {
    GTEST_SKIP() << "Singular is not installed";
  }
  std::vector<Kind> kinds = share_of(seven_link_kinds(), kind_stride);
  const std::vector<Kind> generated = kinds_with_generated_models();
  const std::vector<Kind> larger = share_of(nine_link_chains(), 27);
  kinds.insert(kinds.end(), generated.begin(), generated.end());
  kinds.insert(kinds.end(), larger.begin(), larger.end());
  const std::vector<int> counts = counts_of_singular(kinds);
  ASSERT_EQ(counts.size(), kinds.size());
  Tally tally;
  for (std::size_t place = 0; place < kinds.size(); ++place) {
    SCOPED_TRACE(testing::PrintToString(kinds[place].slides));
    compare(kinds[place], counts[place], tally);
  }
  std::cout << kinds.size() << " kinds\n";
}

}  // namespace
}  // namespace assur::test::complex_counts_test
