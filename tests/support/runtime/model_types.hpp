// The registry of generated models as the types of a parameterised test suite.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include "runtime/registry.hpp"

namespace assur::test {

template <typename Tuple>
struct TypesOf;
template <typename... Models>
struct TypesOf<std::tuple<Models...>> {
  using Type = testing::Types<Models...>;
};

/// A law is one typed suite over these.
using AllModels = TypesOf<AllModelsTuple>::Type;

/// The models of which a law holds: those for which `Holds<Model>` is true.
template <template <typename> typename Holds, typename... Models>
auto models_where(std::tuple<Models...>) -> TypesOf<decltype(std::tuple_cat(
    std::declval<
        std::conditional_t<Holds<Models>::value, std::tuple<Models>, std::tuple<>>>()...))>;
template <template <typename> typename Holds>
using ModelsWhere = typename decltype(models_where<Holds>(std::declval<AllModelsTuple>()))::Type;

template <typename Model>
using IsRigid = std::bool_constant<Model::rigid>;
using RigidModels = ModelsWhere<IsRigid>;

template <typename Model>
std::string model_name() {
  return std::string(Model::group) + "_" + std::to_string(Model::number);
}

struct ModelNames {
  template <typename Model>
  static std::string GetName(int) {
    return model_name<Model>();
  }
};

}  // namespace assur::test
