// Turns the registry of generated models into the types of a parameterised test suite.
#pragma once

#include <gtest/gtest.h>

#include <assur/dyad/models.hpp>
#include <assur/tetrad/models.hpp>
#include <assur/triad/models.hpp>
#include <string>
#include <tuple>

namespace assur::test {

template <typename Tuple>
struct TypesOf;
template <typename... Models>
struct TypesOf<std::tuple<Models...>> {
  using Type = testing::Types<Models...>;
};

/// Every generated model of every group; a law is one typed suite over these.
using AllModelsTuple = decltype(std::tuple_cat(dyad::Models(), triad::Models(), tetrad::Models()));
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
