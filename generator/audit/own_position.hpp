// Derivatives of the positions that a program computes, by running it near each point.
#pragma once

#include "audit/run_reference.hpp"

namespace assur::generator::audit {

/// The expected value of an entry: a derivative of one component of the position.
struct OwnDerivative {
  std::size_t component;
  const closures::AuditSymbol* by;  ///< a parameter; null: the time
  int order;                        ///< 2: the second time derivative
};

/// The derivatives of a statement `of ... against own position`.
struct OwnDerivatives {
  std::vector<std::string> components;
  std::vector<OwnDerivative> entries;
  ExpectedMatrix expected;  ///< its expressions are symbols of their own
};

/// Reads `of NAMES by PARAMETERS`, also transposed, or `of rate(NAME), rate2(NAME), D(NAME,
/// PARAMETER), ...`. The names are those of the position's components, in the order of their first
/// occurrence. Throws FormulaError.
[[nodiscard]] OwnDerivatives read_own_derivatives(const closures::PlacedText& columns,
                                                  const closures::PlacedText& rows,
                                                  bool is_transposed,
                                                  const closures::ClosureSystem& system);

/// Complex steps, if the position of the program takes complex numbers and the differences confirm
/// them; else extrapolated differences on both sides of each point.
class OwnPosition : public RunReference {
 public:
  /// Throws FormulaError if nothing moves, or the program takes unknowns.
  OwnPosition(const closures::ClosureSystem& system, const OwnDerivatives& wanted,
              const RunStatement& run, const running::RunLimits& limits);

  [[nodiscard]] const ExpectedMatrix& drawn() const override { return drawn_; }
  [[nodiscard]] const std::vector<GiNaC::ex>& expressions() const override {
    return wanted_.expected.derived;
  }
  [[nodiscard]] std::string text(std::size_t entry) const override;
  [[nodiscard]] bool is_angle(std::size_t /*entry*/) const override { return false; }
  [[nodiscard]] std::vector<std::vector<ExpectedValue>> at(std::vector<Asked>& list,
                                                           AskedPoints& drawing,
                                                           const Precision& precision) override;
  [[nodiscard]] std::string remark() const override;
  [[nodiscard]] std::string why_untold() const override;
  [[nodiscard]] double slack(const Precision& precision) const override;

 private:
  struct Path;
  class Samples;

  [[nodiscard]] ExpectedValue expected_value(const OwnDerivative& wanted, const Samples& samples,
                                             std::size_t point, const Precision& precision);

  const closures::ClosureSystem& system_;
  const OwnDerivatives& wanted_;
  const RunStatement& run_;
  const running::RunLimits& limits_;
  ExpectedMatrix drawn_;
  std::size_t by_steps_ = 0;        ///< number of values by complex steps
  std::size_t by_differences_ = 0;  ///< number of values by differences only
  double largest_bound_ = 0;
  std::string failure_;  ///< why the position has no value at a point, if so
};

}  // namespace assur::generator::audit
