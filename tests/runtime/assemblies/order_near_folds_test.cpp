// Law: on the way to where two configurations meet, each keeps its number, as is seen from the sign
// of det J, which cannot change on that way; and keys of configurations that meet keep their order.
#include <Eigen/LU>
#include <assur/assemblies.hpp>
#include <assur/numeric/order.hpp>
#include <cmath>
#include <iostream>

#include "runtime/compiled_models.hpp"
#include "runtime/exact.hpp"
#include "runtime/model_types.hpp"
#include "whole_campaign.hpp"

namespace assur::test::order_near_folds_test {
namespace {

constexpr unsigned seed = 6174;

/// Only models with two configurations are tested: with more, others may lie on the way to where
/// two meet.
template <typename Model>
struct HasTwoConfigurations : std::bool_constant<Model::max_configurations == 2> {};
template <typename Model>
using HasTwo = std::conjunction<IsRigid<Model>, HasTwoConfigurations<Model>>;

template <typename Model>
class OrderNearFolds : public testing::Test {};
TYPED_TEST_SUITE(OrderNearFolds, ModelsWhere<HasTwo>, ModelNames);

TYPED_TEST(OrderNearFolds, StaysWhatItIs) {
  using Model = TypeParam;
  using Inputs = typename Model::template Inputs<double>;
  const int draws = is_whole_campaign() ? 250 : 100;
  RandomInputs random(seed + static_cast<unsigned>(Model::number));
  int folds = 0;
  int compared = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const auto d = random.template variables<typename Model::template Dimensions<double>>();
    const auto from = random.template variables<Inputs>();
    const auto to = random.template variables<Inputs>();
    const auto at = [&](double part) {
      Inputs u = from;
      for_each_pair(u, to, [part](auto& target, const auto& source) {
        if constexpr (std::is_same_v<std::decay_t<decltype(target)>, double>) {
          target += part * (source - target);
        }
      });
      return u;
    };
    const auto closes = [&](double part) {
      return compiled::assemblies<Model>(d, at(part)).count == 2;
    };
    double low = 0;
    double high = 1;
    if (!closes(low) || closes(high)) {
      continue;
    }
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (low + high) / 2;
      (closes(middle) ? low : high) = middle;
    }
    ++folds;
    int before = 0;
    for (double gap = 1e-3; gap > 1e-15; gap /= 4) {
      const Inputs u = at(low - gap);
      const Assemblies<Model> found = compiled::assemblies<Model>(d, u);
      if (low < gap || found.count != 2) {
        continue;
      }
      Matrix<double, Model::equation_count, Model::unknown_count> jacobian;
      Model::jacobian(d, u, found.configurations[0], jacobian);
      const int orientation = jacobian.determinant() < 0 ? -1 : 1;
      EXPECT_TRUE(before == 0 || orientation == before) << "draw " << draw << ", gap " << gap;
      before = orientation;
      ++compared;
    }
  }
  std::cout << model_name<Model>() << ", seed " << seed << ": " << folds << " folds, " << compared
            << " places\n";
  // The two configurations of some models never meet, those of others often do.
  EXPECT_TRUE(folds == 0 || folds > draws / 25);
}

/// Keys at a distance r from where two configurations meet: k + r v and k - r v, but for rounding.
TEST(Keys, OfConfigurationsThatMeetKeepTheirOrder) {
  using Key = std::array<double, 6>;
  RandomInputs random(seed);
  for (int draw = 0; draw < 10000; ++draw) {
    Key middle{};
    Key along{};
    const int leading_zeros = random.integer(0, 3);
    for (int place = 0; place < 6; ++place) {
      const auto slot = static_cast<std::size_t>(place);
      middle[slot] = random.between(-1, 1);
      const double size = std::pow(10, random.between(-2, 0));
      along[slot] = place < leading_zeros ? 0 : std::copysign(size, random.between(-1, 1));
    }
    const bool first = std::signbit(along[static_cast<std::size_t>(leading_zeros)]);
    for (double reach = 0.1; reach > 1e-8; reach /= 3) {
      Key left{};
      Key right{};
      for (std::size_t place = 0; place < left.size(); ++place) {
        left[place] = middle[place] + reach * along[place] + random.between(-2e-16, 2e-16);
        right[place] = middle[place] - reach * along[place] + random.between(-2e-16, 2e-16);
      }
      EXPECT_EQ(numeric::comes_before(left, right, 6, 1.0), first) << draw << ' ' << reach;
      EXPECT_EQ(numeric::comes_before(right, left, 6, 1.0), !first) << draw << ' ' << reach;
    }
  }
}

}  // namespace
}  // namespace assur::test::order_near_folds_test
