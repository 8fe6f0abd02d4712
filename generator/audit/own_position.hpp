// The derivatives of the positions that a program gives, which are computed by running it.
#pragma once

#include "audit/run_reference.hpp"

namespace assur::generator::audit {

/// What an entry should be: a derivative of one component of the position.
struct OwnDerivative {
  std::size_t component;
  const closures::AuditSymbol* by;  ///< a parameter; null: the time
  int order;                        ///< 2: the second derivative by the time
};

/// The derivatives of a statement `of ... against own position`.
struct OwnDerivatives {
  std::vector<std::string> components;
  std::vector<OwnDerivative> entries;
  ExpectedMatrix expected;  ///< its expressions are symbols of their own
};

/// Reads `of NAMES by PARAMETERS`, also transposed, or `of rate(NAME), rate2(NAME), D(NAME,
/// PARAMETER), ...`. The names are those of the components of the position, in the order in which
/// they occur first. Throws FormulaError.
[[nodiscard]] OwnDerivatives read_own_derivatives(const closures::PlacedText& columns,
                                                  const closures::PlacedText& rows,
                                                  bool is_transposed,
                                                  const closures::ClosureSystem& system);

/// Complex steps, where the position of the program takes complex numbers and they confirm the
/// differences; else extrapolated differences on both sides of each point.
class OwnPosition : public RunReference {
 public:
  /// Throws FormulaError where nothing moves, or the program is given unknowns.
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
  std::size_t by_steps_ = 0;        ///< how many values complex steps gave
  std::size_t by_differences_ = 0;  ///< how many values only differences gave
  double largest_bound_ = 0;
  std::string failure_;  ///< why the position has no value at a point, if so
};

}  // namespace assur::generator::audit
