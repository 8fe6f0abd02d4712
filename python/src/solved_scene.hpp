// Solutions as objects whose arrays are views of rows of numbers.
#pragma once

#include <assur/mechanism/report.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "plan.hpp"
#include "rows.hpp"

namespace assur::python {

/// All configurations at one set of values, or the requested one.
struct SolvedScene : RowsView, std::enable_shared_from_this<SolvedScene> {
  /// The requested configurations: all, the one with a number, or the nearest to the reference.
  enum class Asked : unsigned char { all, numbered, nearest };

  /// Throws as Plan::solve, solve_one and solve_nearest do, with the scene's file in front.
  SolvedScene(SharedPlan of, Replaced replaced_values, Asked what = Asked::all,
              std::size_t number = 0);

  SharedPlan planned;
  Replaced replaced;
  mechanism::Solution solution;
  std::optional<mechanism::Nearest> nearest;
  Asked asked;
  std::size_t asked_number;
  /// Rates of the motions through each configuration; null if there is only one motion.
  std::vector<std::shared_ptr<const Rows>> branches;

  /// The values that were solved.
  [[nodiscard]] mechanism::Values values() const { return planned->plan.values(replaced); }
  /// The report that the command prints.
  [[nodiscard]] mechanism::Report report(const mechanism::Values& values) const;
  /// The number of the configuration in a row, if it is known.
  [[nodiscard]] std::optional<std::size_t> number_of(std::size_t at) const;
  /// The same, found by solving for all configurations if it is not known.
  [[nodiscard]] std::size_t number_in_all(std::size_t at) const;

 private:
  void solve(const mechanism::Values& values);
  [[nodiscard]] std::shared_ptr<const Rows> rows_of(const mechanism::Values& values);
};

using SharedSolution = std::shared_ptr<SolvedScene>;

}  // namespace assur::python
