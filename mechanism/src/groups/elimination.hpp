// Eliminations that reduce the equations of a group to one unknown, by its graph.
#pragma once

#include <assur/loops/elimination.hpp>
#include <vector>

#include "groups/loop_equations.hpp"

namespace assur::mechanism::groups {

/// Eliminations, with the tables to which they refer.
class Eliminations {
 public:
  Eliminations() = default;
  Eliminations(Eliminations&&) = default;
  Eliminations& operator=(Eliminations&&) = default;
  Eliminations(const Eliminations&) = delete;
  Eliminations& operator=(const Eliminations&) = delete;
  ~Eliminations() = default;

  [[nodiscard]] const std::vector<loops::Elimination>& list() const { return list_; }
  void add(int ground, int hidden, int degree, std::vector<loops::AngleSet> sets,
           std::vector<loops::AngleSet> products, std::vector<int> lowest_powers);
  void put_smallest_first();

 private:
  std::vector<loops::Elimination> list_;
  std::vector<std::vector<loops::AngleSet>> sets_;
  std::vector<std::vector<int>> powers_;
};

/// The usable eliminations of a group in general position. A displacement must run along the ground
/// or the hidden angle; if slides have three directions, there is none (`Starts`).
[[nodiscard]] Eliminations eliminations_of(const LoopEquations& general);

}  // namespace assur::mechanism::groups
