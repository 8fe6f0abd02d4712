// Complex configurations of a group in general position, the start points of homotopies.
#pragma once

#include <assur/loops/start.hpp>
#include <complex>
#include <vector>

#include "groups/loop_equations.hpp"

namespace assur::mechanism::groups {

/// Starts, with the tables to which they refer.
class Starts {
 public:
  Starts() = default;
  Starts(Starts&&) = default;
  Starts& operator=(Starts&&) = default;
  Starts(const Starts&) = delete;
  Starts& operator=(const Starts&) = delete;
  ~Starts() = default;
  /// All configurations at one set of random numbers: a random one, and those to which closed paths
  /// through other numbers lead from the known ones. None if the first one is not isolated.
  explicit Starts(GeneralEquations& general);

  /// The same configurations several times, each time with other paths from them.
  [[nodiscard]] const std::vector<loops::Start>& list() const { return list_; }
  [[nodiscard]] int complex_count() const {
    return list_.empty() ? 0 : list_.front().configurations;
  }

 private:
  std::vector<loops::Start> list_;
  std::vector<std::complex<double>> of_angles_, of_slides_, theta_, s_;
};

}  // namespace assur::mechanism::groups
