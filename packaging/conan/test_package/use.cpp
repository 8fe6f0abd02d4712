// Finds both configurations of two bars of length 5 between pivots that are 6 apart.
#include <assur/assembly.hpp>
#include <assur/dyad/model_01.hpp>
#include <cstdio>

int main() {
  using Model = assur::dyad::Model01;
  Model::Dimensions<double> dimensions;
  dimensions.BC = 5;
  dimensions.CD = 5;
  Model::Inputs<double> inputs;
  inputs.x_B = 0;
  inputs.y_B = 0;
  inputs.x_D = 6;
  inputs.y_D = 0;
  const auto found = assur::assemblies<Model>(dimensions, inputs);
  std::printf("%s, %d configurations\n", assur::to_string(found.status), found.count);
  return found.status == assur::AssemblyStatus::ok && found.count == 2 ? 0 : 1;
}
