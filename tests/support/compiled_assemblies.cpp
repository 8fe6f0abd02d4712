// Turns every rigid model into an instance of the search for all its configurations.
#include <assur/assembly.hpp>

#include "compiled_models.hpp"
#include "instances.hpp"
#include "registry.hpp"

namespace assur::test::compiled {

template <typename Model>
Assemblies<Model> assemblies(const typename Model::template Dimensions<double>& d,
                             const typename Model::template Inputs<double>& u) {
  return assur::assemblies<Model>(d, u);
}

template <typename Model>
struct AssembliesOf {
  static constexpr auto pointer = &assemblies<Model>;
};
using AllAssemblies = decltype(instances<AssembliesOf>(AllModelsTuple()));
// A table that other files could see keeps its functions from being left out.
extern const AllAssemblies all_assemblies;
const AllAssemblies all_assemblies = instances<AssembliesOf>(AllModelsTuple());

}  // namespace assur::test::compiled
