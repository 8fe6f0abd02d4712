// Law: nearly all groups in general position whose configurations have a formula are listed by the
// formula; a closer look, which takes several times as long, is the exception.
#include <gtest/gtest.h>

#include <assur/detail/closed_search.hpp>
#include <assur/detail/general_search.hpp>
#include <assur/dyad/model_01.hpp>
#include <assur/dyad/model_02.hpp>
#include <assur/dyad/model_03.hpp>
#include <assur/dyad/model_05.hpp>
#include <assur/support/scale.hpp>
#include <assur/tetrad/model_01.hpp>
#include <assur/tetrad/model_04.hpp>
#include <assur/tetrad/model_05.hpp>
#include <assur/tetrad/model_15.hpp>
#include <cmath>
#include <iostream>
#include <limits>

#include "largest.hpp"
#include "runtime/drawn_groups.hpp"
#include "runtime/model_types.hpp"

namespace assur::test::closed_search_test {
namespace {

template <typename Model>
class ClosedSearch : public testing::Test {};
using Models = testing::Types<dyad::Model01, dyad::Model05, tetrad::Model04, tetrad::Model15>;
TYPED_TEST_SUITE(ClosedSearch, Models, ModelNames);

TYPED_TEST(ClosedSearch, ListsNearlyAllGroups) {
  using Model = TypeParam;
  constexpr int groups = 2000;
  DrawnGroups<double> draws(3301, false);
  int listed = 0;
  for (int group = 0; group < groups; ++group) {
    const auto d = draws.template variables<typename Model::template Dimensions<double>>();
    const auto u = draws.template variables<typename Model::template Inputs<double>>();
    Assemblies<Model> found;
    listed += detail::ClosedSearch<Model>::list(d, u, {}, found) ? 1 : 0;
  }
  std::cout << model_name<Model>() << ": " << groups - listed << " of " << groups
            << " groups need a closer look\n";
  EXPECT_LT(groups - listed, groups / 100);
}

template <typename Model>
class GeneralSearch : public testing::Test {};
using GeneralModels = testing::Types<tetrad::Model01, tetrad::Model05>;
TYPED_TEST_SUITE(GeneralSearch, GeneralModels, ModelNames);

/// Nearly all groups whose final polynomial has more roots are listed by the search in general
/// position; a search in special position, which takes a hundred times as long, is the exception.
TYPED_TEST(GeneralSearch, ListsNearlyAllGroups) {
  using Model = TypeParam;
  constexpr int groups = 500;
  DrawnGroups<double> draws(3302, false);
  int listed = 0;
  for (int group = 0; group < groups; ++group) {
    auto d = draws.template variables<typename Model::template Dimensions<double>>();
    auto u = draws.template variables<typename Model::template Inputs<double>>();
    const double scale = support::unit_scale<Model>(d, u);
    d = support::scaled_to<decltype(d)>(d, scale);
    u = support::scaled_to<decltype(u)>(u, scale);
    Assemblies<Model> found;
    listed += detail::GeneralSearch<Model, double, double>(d, u, 0, 0, found).run() ? 1 : 0;
  }
  std::cout << model_name<Model>() << ": " << groups - listed << " of " << groups
            << " groups need a search in special position\n";
  EXPECT_LT(groups - listed, groups / 100);
}

/// How far the directions that the formula finds are from the unit circle, in epsilons.
template <typename Model>
double off_the_circle() {
  DrawnGroups<double> draws(3303, false);
  double farthest = 0;
  for (int group = 0; group < 4000; ++group) {
    const auto d = draws.template variables<typename Model::template Dimensions<double>>();
    const auto u = draws.template variables<typename Model::template Inputs<double>>();
    Assemblies<Model> found;
    if (!detail::ClosedSearch<Model>::list(d, u, {}, found)) {
      continue;
    }
    for (std::size_t index = 0; index < static_cast<std::size_t>(found.count); ++index) {
      for_each_member(found.configurations[index], [&](const auto& member, std::size_t) {
        if constexpr (detail::is_direction<std::decay_t<decltype(member)>>) {
          const double square = member.cos * member.cos + member.sin * member.sin;
          farthest = largest(farthest, std::abs(square - 1));
        }
      });
    }
  }
  return farthest / std::numeric_limits<double>::epsilon();
}

/// Closures do not show this: a direction of another length than one may close its loop, too.
TEST(ClosedSearchReport, DirectionsAreUnitVectors) {
  EXPECT_LT(off_the_circle<dyad::Model01>(), 8);
  EXPECT_LT(off_the_circle<dyad::Model02>(), 8);
  EXPECT_LT(off_the_circle<dyad::Model03>(), 8);
}

}  // namespace
}  // namespace assur::test::closed_search_test
