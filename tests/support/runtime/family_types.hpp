// The families of the stability laboratory as the types of a suite, with names.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>

namespace assur::stability {

template <typename List>
struct TypesOf;
template <typename... Family>
struct TypesOf<std::tuple<Family...>> {
  using Types = testing::Types<Family...>;
};
struct FamilyNames {
  template <typename Family>
  static std::string GetName(int) {
    std::string name = Family::name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  }
};

}  // namespace assur::stability
