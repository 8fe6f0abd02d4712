// Law: packs also settle groups in any unit and far from the origin, and configurations made
// uncertain by distant coordinates are not called ok.
#include <gtest/gtest.h>

#include <assur/batch.hpp>
#include <assur/kinematics.hpp>
#include <assur/support/scale.hpp>
#include <assur/tetrad/model_01.hpp>
#include <assur/tetrad/model_04.hpp>
#include <assur/tetrad/model_05.hpp>
#include <cmath>
#include <iostream>
#include <type_traits>
#include <vector>

#include "runtime/drawn_groups.hpp"

namespace assur::test::far_batch_test {
namespace {

constexpr unsigned seed = 9042;
constexpr std::size_t count = 400;

/// Groups as columns, and room for their answers.
template <typename Model>
struct Groups {
  using Dimensions = typename Model::template Dimensions<double>;
  using Inputs = typename Model::template Inputs<double>;
  using Configuration = typename Model::template Configuration<double>;
  static constexpr auto capacity = static_cast<std::size_t>(Model::max_configurations);

  std::vector<double> dimensions = std::vector<double>(Columns<Dimensions>::count * count);
  std::vector<double> inputs = std::vector<double>(Columns<Inputs>::count * count);
  std::vector<AssemblyStatus> status = std::vector<AssemblyStatus>(count);
  std::vector<int> counts = std::vector<int>(count);
  std::vector<int> mobility = std::vector<int>(count);
  std::vector<Status> regularity = std::vector<Status>(capacity * count);
  std::vector<double> configurations =
      std::vector<double>(capacity * Columns<Configuration>::count * count);

  void put(std::size_t group, const Dimensions& d, const Inputs& u) {
    put_group({dimensions.data(), count}, group, d);
    put_group({inputs.data(), count}, group, u);
  }
  /// Returns how many groups were solved by themselves.
  std::size_t solve() {
    return assemblies<Model, 4>(count, {dimensions.data(), count}, {inputs.data(), count},
                                {status.data(), counts.data(), mobility.data(), regularity.data(),
                                 configurations.data(), count});
  }
};

/// How many groups in general position are solved by themselves after they are moved by `far` and
/// then scaled by `unit`.
template <typename Model>
std::size_t alone_of(double far, double unit) {
  DrawnGroups<double> draws(seed, false);
  Groups<Model> groups;
  const auto change = [unit](double moved) {
    return [=](auto& member, std::size_t) {
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
        member = (member + moved) * unit;
      }
    };
  };
  for (std::size_t group = 0; group < count; ++group) {
    auto d = draws.template variables<typename Groups<Model>::Dimensions>();
    auto u = draws.template variables<typename Groups<Model>::Inputs>();
    for_each_member(d, change(0));
    for_each_member(u, change(far));
    groups.put(group, d, u);
  }
  const std::size_t alone = groups.solve();
  std::cout << "model " << Model::number << ", " << far << " from the origin, unit " << unit << ": "
            << alone << " of " << count << " alone\n";
  return alone;
}

TEST(FarBatches, AreSettledInAnyUnit) {
  for (const double unit : {0x1p-20, 0x1p-12, 0x1p12, 0x1p20}) {
    EXPECT_LE(alone_of<tetrad::Model01>(0, unit), count / 50);
    EXPECT_LE(alone_of<tetrad::Model04>(0, unit), count / 50);
    EXPECT_LE(alone_of<tetrad::Model05>(0, unit), count / 50);
  }
}

TEST(FarBatches, AreSettledFarFromTheOrigin) {
  EXPECT_LE(alone_of<tetrad::Model01>(1e3, 1), count / 20);
  EXPECT_LE(alone_of<tetrad::Model05>(1e3, 1), count / 20);
}

/// RRP-PRR of which both slides of link CD are nearly parallel, so that they are loose.
template <typename Use>
void for_each_loose_group(const Use& use) {
  using Model = tetrad::Model04;
  for (std::size_t group = 0; group < count; ++group) {
    Model::Dimensions<double> d{0.3, 1.2, 0.4, -0.5, 0.9, 0.7, {}, 1.5};
    d.psi_D_CD = direction_of(0.1 * std::pow(0.97, static_cast<double>(group)));
    Model::Inputs<double> u{0, 0, 1.5, 0.6};
    for_each_member(u, [](double& place, std::size_t) { place += 256; });
    use(group, d, u);
  }
}

/// `regularity` gets the uncertainty of places far from the origin here, and then decides otherwise
/// for some groups than without it.
TEST(FarBatches, CountThePlacesOfTheJointsInVerdicts) {
  using Model = tetrad::Model04;
  Groups<Model> groups;
  for_each_loose_group(
      [&](std::size_t group, const auto& d, const auto& u) { groups.put(group, d, u); });
  static_cast<void>(groups.solve());
  int listed = 0;
  int decided = 0;
  for_each_loose_group([&](std::size_t group, const auto& d, const auto& u) {
    const Assemblies<Model> found = assemblies<Model>(d, u);
    ASSERT_EQ(groups.counts[group], found.count);
    const double unsure = support::unsure_jacobian<Model, double>(d, u, {});
    for (std::size_t index = 0; index < static_cast<std::size_t>(found.count); ++index) {
      const auto& q = found.configurations[index];
      const Status expected = regularity<Model, double>(d, u, q, unsure).status;
      EXPECT_EQ(found.regularity[index], expected) << group;
      EXPECT_EQ(groups.regularity[index * count + group], expected) << group;
      ++listed;
      decided += expected != (regularity<Model, double>(d, u, q).status) ? 1 : 0;
    }
  });
  EXPECT_GT(listed, 400);
  EXPECT_GT(decided, 20);
}

}  // namespace
}  // namespace assur::test::far_batch_test
