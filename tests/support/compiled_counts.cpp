// Turns every rigid model into an instance of the exact count of its configurations.
#include "compiled_models.hpp"
#include "instances.hpp"
#include "registry.hpp"
#include "sturm.hpp"

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
