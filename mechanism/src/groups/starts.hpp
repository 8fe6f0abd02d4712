// The complex configurations of a group in general position, from which those of the same group
// with other numbers are continued.
#pragma once

#include <assur/loops/start.hpp>
#include <complex>
#include <vector>

#include "groups/loop_equations.hpp"

namespace assur::mechanism::groups {

/// Starts, with the tables that they refer to.
class Starts {
 public:
  Starts() = default;
  Starts(Starts&&) = default;
  Starts& operator=(Starts&&) = default;
  Starts(const Starts&) = delete;
  Starts& operator=(const Starts&) = delete;
  ~Starts() = default;
  /// All configurations of one set of numbers: a drawn one, and those to which closed paths through
  /// other numbers lead from the ones that are known. None where the drawn one is not isolated.
  explicit Starts(GeneralEquations& general);

  /// The same configurations with different paths from them.
  [[nodiscard]] const std::vector<loops::Start>& list() const { return list_; }
  [[nodiscard]] int complex_count() const {
    return list_.empty() ? 0 : list_.front().configurations;
  }

 private:
  std::vector<loops::Start> list_;
  std::vector<std::complex<double>> of_angles_, of_slides_, theta_, s_;
};

}  // namespace assur::mechanism::groups
