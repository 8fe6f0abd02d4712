// Tables of models as papers print them, for numbering the models and for comparison.
#pragma once

#include <string>
#include <vector>

#include "structure/group.hpp"

namespace assur::generator::structure {

/// One row of a printed table of kinematic models, with its misprints.
struct PrintedRow {
  int number;
  std::vector<std::string> kinds;
  std::string family;

  /// The paper's verdict: a model of family 3 is a structure, any other degenerates.
  [[nodiscard]] bool rigid() const { return family == "3"; }
};

/// Table 2 of Mitsi, Popescu and Luca for the tetrad; null for a group without a published table.
[[nodiscard]] const std::vector<PrintedRow>* printed_table(const Group& group);

}  // namespace assur::generator::structure
