// Law: the random assemblies at which ranks and degrees are determined close exactly.
#include <gtest/gtest.h>

#include <string>

#include "derivatives/mobility.hpp"
#include "equations/closure.hpp"
#include "generator/all_models.hpp"

namespace assur::test::random_assembly_test {
namespace {

using generator::equations::ClosureEquations;
using generator::equations::Variable;

class RandomAssembly : public testing::TestWithParam<const generator::structure::Model*> {};

TEST_P(RandomAssembly, IsOnTheCircleAndCloses) {
  const ClosureEquations equations = generator::equations::closure_equations(*GetParam());
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const GiNaC::exmap values = generator::derivatives::random_assembly(equations, seed);
    for (const auto* variables : {&equations.unknowns, &equations.dimensions, &equations.inputs}) {
      for (const Variable& variable : *variables) {
        if (variable.is_angle()) {
          const GiNaC::ex cosine = values.at(variable.cosine);
          const GiNaC::ex sine = values.at(variable.sine);
          EXPECT_TRUE((cosine * cosine + sine * sine).is_equal(1)) << variable.name;
        }
      }
    }
    for (const GiNaC::ex& residual : equations.residuals) {
      EXPECT_TRUE(equations.vocabulary.expand(residual).subs(values).expand().is_zero())
          << residual;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllModels, RandomAssembly, testing::ValuesIn(all_models()), name_of_model);

}  // namespace
}  // namespace assur::test::random_assembly_test
