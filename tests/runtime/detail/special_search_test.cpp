// Law: a group in special position is displaced only where double-double cannot decide its
// assemblies; the group itself is solved first, and closures are measured relative to its length.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <assur/detail/special_search.hpp>
#include <cmath>
#include <vector>

namespace assur::test::special_search_test {
namespace {

using detail::Completions;
using detail::FirstValue;
using detail::FirstValues;
using detail::FlatVariables;
using detail::Matrix4;
using detail::PreciseVariables;
using detail::Vector4;

/// What a search has asked of the group.
struct Asked {
  std::vector<double> within, firsts;
};
Asked asked;
/// The assembly x = `place` of one length, and whether its root is said to be simple.
double place = 0.25;
bool simple = true;

void evaluate(const void* /*group*/, const FlatVariables<double>& q, Vector4& f) {
  f(0) = q[0] - place;
}
void differentiate(const void* /*group*/, const FlatVariables<double>& /*q*/, Matrix4& jacobian) {
  jacobian(0, 0) = 1;
}
FirstValues first_values(const PreciseVariables& /*d*/, const PreciseVariables& /*u*/,
                         double within) {
  asked.within.push_back(within);
  FirstValues result;
  result.add({numeric::DoubleDouble(place), numeric::DoubleDouble(0), simple});
  return result;
}
Completions complete(const PreciseVariables& /*d*/, const PreciseVariables& /*u*/,
                     const FirstValue& first) {
  asked.firsts.push_back(static_cast<double>(first.cos));
  Completions result;
  result.list[0] = {static_cast<double>(first.cos)};
  result.count = 1;
  return result;
}

constexpr double given = 1e-15;
constexpr std::array<ModelUnknown, 1> unknowns = {{{"x", false, 0}}};
constexpr std::array<bool, 1> is_angle = {false};

detail::SpecialAssemblies searched(double at, bool is_simple) {
  asked = {};
  place = at;
  simple = is_simple;
  const detail::SpecialGroup group{
      {&evaluate, &differentiate, nullptr, unknowns.data(), 1, 0, 0, 1},
      is_angle.data(),
      is_angle.data(),
      1,
      1,
      false,
      given,
      false,
      &first_values,
      &complete};
  const PreciseVariables d{};
  const PreciseVariables u{};
  return detail::SpecialSearch<detail::SpecialGroup>(group, d, u).run();
}

TEST(SpecialSearch, DisplacesNothingWhereAllRootsAreSimple) {
  const auto found = searched(0.25, true);
  ASSERT_EQ(found.count, 1U);
  EXPECT_EQ(found.list[0][0], 0.25);
  EXPECT_FALSE(found.singular[0]);
  EXPECT_EQ(asked.within, std::vector<double>{given});
}

TEST(SpecialSearch, SolvesTheGroupAsItIsBeforeItsNeighbours) {
  const auto found = searched(0.25, false);
  ASSERT_EQ(found.count, 1U);
  EXPECT_EQ(found.list[0][0], 0.25);
  std::vector<double> expected(12, 0);  // the group, and five neighbours on either side
  expected[0] = given;
  EXPECT_EQ(asked.within, expected);
}

TEST(SpecialSearch, StartsOnBothSidesOfTheOrigin) {
  static_cast<void>(searched(0.25, false));
  const auto [least, most] = std::minmax_element(asked.firsts.begin(), asked.firsts.end());
  EXPECT_LT(*least, -1.5);
  EXPECT_GT(*least, -2);
  EXPECT_GT(*most, 1.5);
  EXPECT_LT(*most, 2);
}

/// An assembly that is farther away than rounding can resolve counts as infinitely far.
TEST(SpecialSearch, ListsNothingThatHasRunToInfinity) {
  EXPECT_EQ(searched(0x1p20, true).count, 1U);
  EXPECT_EQ(searched(0x1p27, true).count, 0U);
}

/// A bar between ends that coincide has no direction until it is given one.
TEST(Closures, GiveADirectionToWhatHasNone) {
  constexpr std::array<ModelUnknown, 1> turning = {{{"theta", true, 0}}};
  const detail::Closures closures{&evaluate, &differentiate, nullptr, turning.data(), 1, 0, 0, 1};
  FlatVariables<double> q{};
  closures.straighten(q);
  EXPECT_EQ(q[0], 1);
  EXPECT_EQ(q[1], 0);
  q = {3, 4};
  closures.straighten(q);
  EXPECT_EQ(q[0], 0.6);
  EXPECT_EQ(q[1], 0.8);
}

/// A specialised group may be much shorter than its unit: closures are relative to its length.
TEST(Closures, AreMeasuredByTheGroupsLength) {
  place = 0;
  const detail::Closures closures{&evaluate, &differentiate, nullptr, unknowns.data(), 1, 0, 0,
                                  0.25};
  FlatVariables<double> q{};
  q[0] = 0.125;
  EXPECT_EQ(closures.at(q)(0), 0.5);
  Vector4 step;
  step(0) = -0.5;
  EXPECT_EQ(closures.jacobian(q)(0, 0) * step(0), -closures.at(q)(0));
  closures.advance(step, q);
  EXPECT_EQ(closures.at(q)(0), 0);
}

}  // namespace
}  // namespace assur::test::special_search_test
