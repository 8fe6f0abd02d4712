// Law: nearly all groups in general position whose configurations follow by formula are listed by
// it; a closer look, which takes several times as long, is the exception.
#include <gtest/gtest.h>

#include <assur/detail/closed_search.hpp>
#include <assur/dyad/model_01.hpp>
#include <assur/dyad/model_05.hpp>
#include <assur/tetrad/model_04.hpp>
#include <assur/tetrad/model_15.hpp>
#include <iostream>

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

}  // namespace
}  // namespace assur::test::closed_search_test
