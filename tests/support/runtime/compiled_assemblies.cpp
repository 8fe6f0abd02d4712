// The search for all configurations of every rigid model, on plain arrays of numbers, from the
// instances compiled in assur::mechanism.
#include <algorithm>
#include <assur/mechanism/group_model.hpp>
#include <assur/support/flat_variables.hpp>

#include "models/model_kernel.hpp"
#include "runtime/compiled_models.hpp"
#include "runtime/instances.hpp"
#include "runtime/registry.hpp"

namespace assur::test::compiled {
namespace {

const mechanism::ModelKernel& kernel_of(const char* group, int number) {
  const auto& groups = mechanism::known_groups();
  const auto models = std::find_if(groups.begin(), groups.end(), [group](const auto& candidate) {
    return candidate.structure.name == group;
  });
  return *models->models[static_cast<std::size_t>(number - 1)].kernel;
}

}  // namespace

template <typename Model>
Assemblies<Model> assemblies(const typename Model::template Dimensions<double>& d,
                             const typename Model::template Inputs<double>& u,
                             const support::Displacement& displaced) {
  static const mechanism::ModelKernel& kernel = kernel_of(Model::group, Model::number);
  mechanism::models::FlatVariables dimensions{};
  mechanism::models::FlatVariables inputs{};
  support::flatten(d, dimensions);
  support::flatten(u, inputs);
  mechanism::models::GroupAssemblies found;
  kernel.assemble(dimensions, inputs, displaced, found);
  Assemblies<Model> result;
  result.status = found.status;
  result.count = static_cast<int>(found.count);
  result.mobility = found.mobility;
  for (std::size_t index = 0; index < found.count; ++index) {
    using Configuration = typename Model::template Configuration<double>;
    result.configurations[index] = support::unflattened<Configuration>(found.configurations[index]);
    result.regularity[index] = found.regularity[index];
  }
  return result;
}

template <typename Model>
struct AssembliesOf {
  static constexpr auto pointer = &assemblies<Model>;
};
using AllAssemblies = decltype(instances<AssembliesOf>(AllModelsTuple()));
// The table has external linkage, so that the compiler does not leave its functions out.
extern const AllAssemblies all_assemblies;
const AllAssemblies all_assemblies = instances<AssembliesOf>(AllModelsTuple());

}  // namespace assur::test::compiled
