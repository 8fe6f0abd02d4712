// The ways to bring the equations of a group to one unknown, as its graph allows them.
#pragma once

#include <assur/loops/elimination.hpp>
#include <vector>

#include "groups/loop_equations.hpp"

namespace assur::mechanism::groups {

/// Eliminations, with the tables that they refer to.
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

/// The eliminations that serve a group in general position. A displacement must run along the
/// ground or the hidden angle; there is none where slides lie in three directions (`Starts`).
[[nodiscard]] Eliminations eliminations_of(const LoopEquations& general);

}  // namespace assur::mechanism::groups
