// Instances of the exact count of configurations for every rigid model.
#include "runtime/compiled_models.hpp"
#include "runtime/instances.hpp"
#include "runtime/registry.hpp"
#include "runtime/sturm.hpp"

namespace assur::test::compiled {

template <typename Model>
int exact_assembly_count(const typename Model::template Dimensions<double>& d,
                         const typename Model::template Inputs<double>& u) {
  return test::exact_assembly_count<Model>(d, u);
}

template <typename Model>
struct CountOf {
  static constexpr auto pointer = &exact_assembly_count<Model>;
};
using AllCounts = decltype(instances<CountOf>(AllModelsTuple()));
extern const AllCounts all_counts;
const AllCounts all_counts = instances<CountOf>(AllModelsTuple());

}  // namespace assur::test::compiled
