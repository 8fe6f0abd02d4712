// Turns the registry of generated models into the types of a parameterised test suite.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <tuple>

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
