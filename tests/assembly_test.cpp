// Law: as many configurations as Sturm's theorem over the rationals counts real roots, each closing
// the loops to rounding, and among them the one from which the group was made.
#include <assur/assembly.hpp>
#include <iostream>

#include "exact.hpp"
#include "largest.hpp"
#include "model_types.hpp"
#include "sturm.hpp"

namespace assur::test {
namespace {

constexpr int samples = 300;
constexpr unsigned seed = 14142;

/// The largest length among variables: a residual is small against it.
template <typename... Variables>
double longest_length(const Variables&... lists) {
  double longest = 0;
  const auto measure = [&](const auto& member) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
      longest = std::max(longest, std::abs(member));
    }
  };
  (std::apply([&](const auto&... member) { (measure(member), ...); }, lists.members()), ...);
  return longest;
}

template <typename Model>
class Assembling : public testing::Test {};
TYPED_TEST_SUITE(Assembling, AllModels, ModelNames);

TYPED_TEST(Assembling, LosesNoneAndInventsNone) {
  using Model = TypeParam;
  if constexpr (Model::rigid) {
    RandomInputs random(seed + static_cast<unsigned>(Model::number));
    double worst = 0;
    int total = 0;
    int near = 0;
    std::array<int, 7> histogram{};
    for (int sample = 0; sample < samples; ++sample) {
      const auto d = random.variables<typename Model::template Dimensions<double>>();
      const auto u = random.variables<typename Model::template Inputs<double>>();
      const Assemblies<Model> found = assemblies<Model>(d, u);
      ASSERT_EQ(found.status, AssemblyStatus::ok);
      const int expected = exact_assembly_count<Model>(d, u);
      EXPECT_EQ(found.count, expected) << "sample " << sample;
      ++histogram[static_cast<std::size_t>(found.count)];
      total += found.count;
      for (int index = 0; index < found.count; ++index) {
        const auto slot = static_cast<std::size_t>(index);
        near += found.regularity[slot] == Status::ok ? 0 : 1;
        Vector<double, Model::equation_count> f;
        Model::residual(d, u, found.configurations[slot], f);
        if (found.regularity[slot] == Status::ok) {
          worst = largest(
              worst, f.cwiseAbs().maxCoeff() / longest_length(d, u, found.configurations[slot]));
        }
      }
    }
    std::cout << model_name<Model>() << ": at most " << Model::max_configurations << ", found";
    for (std::size_t count = 0; count <= static_cast<std::size_t>(Model::max_configurations);
         ++count) {
      std::cout << ' ' << histogram[count] << "x" << count;
    }
    std::cout << ", near-singular " << near << ", largest relative residual " << worst << '\n';
    EXPECT_GT(total, 0);
    EXPECT_LT(worst, 4e-15);
  }
}

}  // namespace
}  // namespace assur::test
