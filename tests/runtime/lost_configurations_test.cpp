// Laws of the laboratory of configurations: what docs/stability_configurations.svg shows, asserted
// on the same families and the same methods.
#include <gtest/gtest.h>

#include <iostream>

#include "family_types.hpp"
#include "stability/configurations/rows.hpp"

namespace assur::stability {
namespace {

template <typename Family>
class LostConfigurations : public testing::Test {};
TYPED_TEST_SUITE(LostConfigurations, TypesOf<ConfigurationFamilies>::Types, FamilyNames);

/// Of 300 groups, each list is as long as Sturm's theorem says and holds the configurations of
/// which the group was made (append_listing_rows), and the generated solver tells every one. At
/// distance 0 every method that trusts the roots of the final polynomial is wrong.
TYPED_TEST(LostConfigurations, GeneratedLosesAndInventsNoneWherePeersDo) {
  std::vector<ListingRow> rows;
  ASSERT_TRUE(append_listing_rows<TypeParam>(rows));
  double error = 0;
  for (const ListingRow& row : rows) {
    const std::string method = row.method;
    if (method == "generated") {
      EXPECT_EQ(row.lost, 0) << row.distance;
      EXPECT_EQ(row.invented, 0) << row.distance;
      error = std::max(error, row.error);
    } else if (row.distance == 0 && method != "Newton from 64 starts") {
      EXPECT_GE(row.lost + row.invented, members_per_distance) << method;
    }
  }
  EXPECT_LT(error, 5e-9);  // of displacements up to 4e6 lengths
  std::cout << TypeParam::name << ", seed " << seed << ": largest error " << error << '\n';
}

/// The doubles hold the groups exactly: in them the final polynomial has a root fewer than the
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
