// Tables of function pointers to the instances of a template over the rigid models.
#pragma once

#include <tuple>

namespace assur::test {

/// The pointer `Of<Model>::pointer` of a rigid model; null for any other.
template <template <typename> typename Of, typename Model>
constexpr auto instance() {
  if constexpr (Model::rigid) {
    return Of<Model>::pointer;
  } else {
    return nullptr;
  }
}
template <template <typename> typename Of, typename... Models>
constexpr auto instances(std::tuple<Models...> /*models*/) {
  return std::tuple(instance<Of, Models>()...);
}

}  // namespace assur::test
