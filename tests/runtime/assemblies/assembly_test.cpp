// Law: the list has as many configurations as Sturm's theorem over the rationals counts real roots,
// and each regular one closes the loops to rounding.
#include <assur/assemblies.hpp>
#include <iostream>

#include "largest.hpp"
#include "runtime/compiled_models.hpp"
#include "runtime/exact.hpp"
#include "runtime/model_types.hpp"
#include "runtime/sturm.hpp"
#include "whole_campaign.hpp"

namespace assur::test::assembly_test {
namespace {

/// `ctest -L long` draws all samples.
const int samples = is_whole_campaign() ? 300 : 120;
constexpr unsigned seed = 14142;

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
      const Assemblies<Model> found = compiled::assemblies<Model>(d, u);
      ASSERT_EQ(found.status, AssemblyStatus::ok);
      const int expected = compiled::exact_assembly_count<Model>(d, u);
      EXPECT_EQ(found.count, expected) << "sample " << sample;
      ++histogram[static_cast<std::size_t>(found.count)];
      total += found.count;
      for (int index = 0; index < found.count; ++index) {
        const auto slot = static_cast<std::size_t>(index);
        near += found.regularity[slot] == Status::ok ? 0 : 1;
        Vector<double, Model::equation_count> f;
        Model::residual(d, u, found.configurations[slot], f);
        if (found.regularity[slot] == Status::ok) {
          const double longest = std::max(
              {longest_length(d), longest_length(u), longest_length(found.configurations[slot])});
          worst = largest(worst, f.cwiseAbs().maxCoeff() / longest);
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
}  // namespace assur::test::assembly_test
