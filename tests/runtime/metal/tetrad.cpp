// Solves a group with numbers unknown to the compiler, so that the linked program holds all of the
// code for configurations and sensitivities.
#include <assur/assembly.hpp>
#include <assur/kinematics.hpp>
#include <assur/tetrad/model_01.hpp>

namespace {
volatile double given[16];
volatile double result;
volatile int word;
}  // namespace

int main() {
  using Model = assur::tetrad::Model01;
  Model::Dimensions<double> d;
  Model::Inputs<double> u;
  int next = 0;
  const auto fill = [&next](auto&... member) { ((member = given[next++]), ...); };
  std::apply(fill, d.members());
  std::apply(fill, u.members());
  const auto found = assur::assemblies<Model>(d, u);
  const auto& q = found.configurations[0];
  word = static_cast<int>(found.status);
  assur::Sensitivities<Model, double> sensitive;
  word = static_cast<int>(assur::sensitivities<Model, double>(d, u, q, sensitive));
  result = sensitive.to_dimensions(0, 0);
}
