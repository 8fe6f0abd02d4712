// The models of all groups, and test names for them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "structure/kind.hpp"

namespace assur::test {

/// Every model of every group, in the order of their numbers.
inline std::vector<const generator::structure::Model*> all_models() {
  std::vector<const generator::structure::Model*> list;
  for (const generator::structure::Group& group : generator::structure::known_groups()) {
    for (const generator::structure::Model& model : generator::structure::models_of(group)) {
      list.push_back(&model);
    }
  }
  return list;
}

/// The name of a test of one model: `tetrad_1`.
inline std::string name_of_model(
    const testing::TestParamInfo<const generator::structure::Model*>& tested) {
  return tested.param->group->name() + "_" + std::to_string(tested.param->number);
}

}  // namespace assur::test
