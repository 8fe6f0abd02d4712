// A row of the table of speed against accuracy, and the errors that it summarises.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace assur::speed {

/// One method on one task in one scalar.
struct Row {
  std::string task;
  std::string method;
  std::string scalar = "double";
  double ns = 0;              ///< median per evaluation
  double error = 0;           ///< the largest relative error of the answers that are not failures
  double error_999 = 0;       ///< the 99.9th percentile, where failures count as infinite
  std::size_t failures = 0;   ///< inputs with no or a wrong answer
  std::size_t evaluated = 0;  ///< inputs over which the error and the failures are taken
  std::optional<std::size_t> unreported{};  ///< of a tracking task: wrong answers without a report
};

/// An answer with fewer than two correct digits is wrong.
inline constexpr double wrong_error = 0.01;

/// Collects the relative errors of one method.
class ErrorTally {
 public:
  /// NaN and infinity are failures.
  void add(double error) {
    errors_.push_back(error <= wrong_error ? error : std::numeric_limits<double>::infinity());
  }
  void add_failure() { add(std::numeric_limits<double>::infinity()); }

  void write_to(Row& row) {
    std::sort(errors_.begin(), errors_.end());
    const auto first_failure =
        std::lower_bound(errors_.begin(), errors_.end(), std::numeric_limits<double>::infinity());
    const auto right = static_cast<std::size_t>(first_failure - errors_.begin());
    row.evaluated = errors_.size();
    row.failures = errors_.size() - right;
    row.error = right > 0 ? errors_[right - 1] : std::numeric_limits<double>::infinity();
    const double place = std::ceil(0.999 * static_cast<double>(errors_.size()));
    row.error_999 = errors_[static_cast<std::size_t>(std::max(place, 1.0)) - 1];
  }

 private:
  std::vector<double> errors_;
};

/// A row whose time is still to be measured. `run` evaluates the inputs in [first, last) and
/// discards the answers.
struct Entry {
  Row row;
  std::function<void(std::size_t first, std::size_t last)> run;
};

/// Methods that do the same work on the same inputs.
struct Task {
  std::string name;
  std::size_t inputs = 0;
  std::vector<Entry> entries;
};

}  // namespace assur::speed
