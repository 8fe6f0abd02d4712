// The steps of an elimination, as records for readers and checks.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "elimination/univariate.hpp"

namespace assur::generator::elimination {

/// A quantity that a step introduces besides the names of the vocabulary.
struct RecordedQuantity {
  GiNaC::symbol symbol;
  GiNaC::ex value;
  std::string meaning;
  bool vanishes = false;  ///< zero in every assembled configuration
};

/// A polynomial in the final unknown that a step introduces.
struct RecordedSeries {
  std::string name;
  std::string formula;  ///< in earlier quantities: `P1*C2 - P2*C1`
  Univariate value;
};

/// One step from the closures to the final polynomial.
struct RecordedStep {
  std::string title;                  ///< `BCDEB squared: free of theta_CD`
  std::string rule;                   ///< why the step is allowed; formulas in backquotes
  std::vector<std::string> formulas;  ///< the rule in symbols, in the syntax of scene files
  std::vector<const equations::Variable*> eliminated;  ///< no later step contains them
  std::vector<RecordedQuantity> quantities = {};
  std::vector<RecordedSeries> series = {};
  std::size_t vocabulary_size = 0;  ///< number of names after the step

  /// Records a quantity and returns its symbol, which later quantities may use.
  GiNaC::symbol record(const std::string& name, const GiNaC::ex& value, const std::string& meaning);
  /// Records both components of a vector, except those that need no name.
  equations::Vector2 record(const std::string& name, const equations::Vector2& value,
                            const std::string& meaning);
  /// Records an equation, value = 0.
  void record_equation(const std::string& name, const GiNaC::ex& value, const std::string& meaning);
};

/// Two equations as polynomials in `second`, with coefficients in no unknown but `first`.
[[nodiscard]] RecordedStep ordered_by_second(const std::vector<std::array<GiNaC::ex, 3>>& equations,
                                             const equations::Variable& second,
                                             const equations::Variable& first);

/// The coefficients of the final polynomial; its only formula is the polynomial in their names.
/// Above its degree, up to `formal_degree`, the coefficients vanish.
[[nodiscard]] RecordedStep final_coefficients(const std::vector<equations::Vector2>& polynomial,
                                              const equations::Variable& unknown,
                                              std::size_t formal_degree);

/// (1 + t^2)^n T with cos kx + i sin kx = ((1 + i t)^2 / (1 + t^2))^k, t = tan(x/2), in the
/// quantities of `final_coefficients`.
[[nodiscard]] RecordedStep half_angle_form(const std::vector<RecordedQuantity>& coefficients,
                                           const equations::Variable& unknown);

}  // namespace assur::generator::elimination
