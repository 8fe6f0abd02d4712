// Laws of the laboratory of configurations: what docs/stability_configurations.svg shows, asserted
// on the same families and the same methods.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "stability/configurations/rows.hpp"

namespace assur::stability {
namespace {

template <typename List>
struct TypesOf;
template <typename... Family>
struct TypesOf<std::tuple<Family...>> {
  using Types = testing::Types<Family...>;
};
struct FamilyNames {
  template <typename Family>
  static std::string GetName(int) {
    std::string name = Family::name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  }
};

template <typename Family>
class LostConfigurations : public testing::Test {};
TYPED_TEST_SUITE(LostConfigurations, TypesOf<ConfigurationFamilies>::Types, FamilyNames);

/// The list of all configurations is as long as Sturm's theorem says, and holds those of which the
/// group was made.
TYPED_TEST(LostConfigurations, TruthIsVouchedFor) {
  for (const double distance : configuration_distances()) {
    for (int number = 0; number < members_per_distance; ++number) {
      EXPECT_TRUE(make_configuration_member<TypeParam>(number, distance).is_vouched)
          << "distance " << distance << ", member " << number;
    }
  }
}

/// A configuration a million lengths away and more, on its way to infinity, may be missed or listed
/// twice: of 60 groups at these distances this many are. All others are told rightly.
constexpr int known_failures = 3;
bool is_on_its_way(const ListingRow& row) {
  return row.family != std::string(SharedUnknown::name) && row.distance > 0.9e-9 &&
         row.distance < 1.1e-7;
}

TYPED_TEST(LostConfigurations, GeneratedLosesAndInventsNone) {
  std::vector<ListingRow> rows;
  ASSERT_TRUE(append_listing_rows<TypeParam>(rows));
  double error = 0;
  int failures = 0;
  for (const ListingRow& row : rows) {
    if (row.method != std::string("generated")) {
      continue;
    }
    if (is_on_its_way(row)) {
      failures += row.lost + row.invented;
      continue;
    }
    EXPECT_EQ(row.lost, 0) << row.distance;
    EXPECT_EQ(row.invented, 0) << row.distance;
    error = std::max(error, row.error);
  }
  EXPECT_LE(failures, known_failures);
  std::cout << TypeParam::name << ", seed " << seed << ": largest error " << error
            << ", lost or invented on the way to infinity " << failures << '\n';
}

/// Lost and invented of each method, at distance 0.
template <typename Family>
std::map<std::string, ListingRow> at_zero() {
  std::vector<ListingRow> rows;
  EXPECT_TRUE(append_listing_rows<Family>(rows));
  std::map<std::string, ListingRow> result;
  for (const ListingRow& row : rows) {
    if (row.distance == 0) {
      result[row.method] = row;
    }
  }
  return result;
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

TEST(SharedUnknown, RootsDoNotTellTheConfigurations) {
  const auto rows = at_zero<SharedUnknown>();
  for (const char* method : {"companion eigenvalues", "half-angle polynomial", "grid of 360"}) {
    EXPECT_GE(rows.at(method).lost, members_per_distance) << method;
  }
}

TEST(ToInfinity, RootsStayOfConfigurationsThatHaveGone) {
  const auto rows = at_zero<SomeToInfinity>();
  for (const char* method : {"companion eigenvalues", "half-angle polynomial", "grid of 360"}) {
    EXPECT_GE(rows.at(method).invented, members_per_distance) << method;
  }
}

}  // namespace
}  // namespace assur::stability
