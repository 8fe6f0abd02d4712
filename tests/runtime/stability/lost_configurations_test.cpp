// Laws of the laboratory of configurations: the results for generated solvers in
// docs/reports/stability_configurations.svg, asserted on the same families.
#include <gtest/gtest.h>

#include <iostream>

#include "runtime/family_types.hpp"
#include "stability/configurations/rows.hpp"
#include "whole_campaign.hpp"

namespace assur::stability {
namespace {

template <typename Family>
class LostConfigurations : public testing::Test {};
TYPED_TEST_SUITE(LostConfigurations, TypesOf<ConfigurationFamilies>::Types, FamilyNames);

/// The list of each of 300 groups, by default 75, is as long as Sturm's theorem says and holds the
/// configurations of which the group was made (append_listing_rows), and the generated solver finds
/// every one.
TYPED_TEST(LostConfigurations, GeneratedLosesAndInventsNone) {
  using Model = typename TypeParam::Model;
  const int members = test::is_whole_campaign() ? members_per_distance : 5;
  std::vector<ListingRow> rows;
  ASSERT_TRUE(
      append_listing_rows<TypeParam>({{"generated", speed::closed_form<Model>}}, rows, members));
  double error = 0;
  for (const ListingRow& row : rows) {
    EXPECT_EQ(row.lost, 0) << row.distance;
    EXPECT_EQ(row.invented, 0) << row.distance;
    error = std::max(error, row.error);
  }
  EXPECT_LT(error, 5e-9);  // of displacements up to 4e6 lengths
  std::cout << TypeParam::name << ", seed " << seed << ": largest error " << error << '\n';
}

/// Doubles represent the groups exactly, so that the final polynomial has one root fewer than the
/// group has configurations.
TEST(SharedUnknown, IsSharedExactlyAtZero) {
  for (int number = 0; number < members_per_distance; ++number) {
    const auto member = make_configuration_member<SharedUnknown>(number, 0);
    EXPECT_EQ(test::exact_assembly_count<Model01>(member.given.d, member.given.u) + 1,
              static_cast<int>(member.truth.list.size()))
        << number;
  }
}

}  // namespace
}  // namespace assur::stability
