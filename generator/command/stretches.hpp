// Remarks on the steps of a sweep without configurations: their ranges and reasons.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <string>
#include <vector>

namespace assur::generator::command {

/// A value of a sweep's parameter as printed in remarks.
[[nodiscard]] std::string shown_value(double number);

/// Reports each stretch of steps without configurations once: its range, and the reason.
class StretchTeller {
 public:
  /// The plan's request must have a sweep.
  explicit StretchTeller(const mechanism::Plan& plan);

  /// Takes the next step.
  void step(double parameter, const mechanism::Solution& solution);
  /// Prints the stretches that have ended.
  void tell();
  /// Ends the open stretch, if there is one.
  void finish();

 private:
  [[nodiscard]] const mechanism::Values& values_at(int step);
  [[nodiscard]] std::string reason_of_stretch(int count);

  const mechanism::Plan& plan_;
  mechanism::Values values_;
  double begin_, range_;                          ///< for the swept parameter
  std::string what_, reason_;                     ///< for the open stretch; empty if there is none
  std::string text_;                              ///< about the stretches that have ended
  std::vector<mechanism::LimitBreach> breaches_;  ///< in the open stretch
  int step_ = 0, first_ = 0;
  double from_ = 0, to_ = 0;
};

}  // namespace assur::generator::command
