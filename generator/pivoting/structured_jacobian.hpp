// The order of elimination for the framed Jacobian: single unknowns by its zeros, and a core solved
// at once.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "pivoting/framed_jacobian.hpp"

namespace assur::generator::pivoting {

/// A divisor of the elimination.
struct Pivot {
  GiNaC::ex value;         ///< in names of the vocabulary
  GiNaC::ex bound;         ///< of |value|, from the size of the loops: its unit of measurement
  std::string text;        ///< `GF`, `sin(phi_B - phi_E)`, or the core's determinant in its entries
  std::string cause;       ///< `a dead centre`, `CD = 0`
  std::string degeneracy;  ///< the meaning of its zero
};

/// One unknown from one row, after the row's other unknowns are known.
struct EliminationStep {
  std::size_t row;
  std::size_t unknown;
};

/// The structure of J x = b in the frames of the loops: rows with a single unknown come first,
/// unknowns that occur in a single row come last, and between them is the core, solved by Cramer's
/// rule. With the pivots, det J = sign * product of their values.
class StructuredJacobian {
 public:
  /// Throws GeneratorError if the Jacobian is not square or structurally singular.
  explicit StructuredJacobian(const equations::ClosureEquations& equations);

  [[nodiscard]] const FramedClosures& closures() const { return closures_; }
  /// Names of the closures, of the core's determinant and of its reciprocal.
  [[nodiscard]] const equations::Vocabulary& vocabulary() const { return vocabulary_; }
  /// The core's determinant first, by factors if it is a product of sines and cosines; then the
  /// divisors of the single steps, except plus or minus one.
  [[nodiscard]] const std::vector<Pivot>& pivots() const { return pivots_; }
  [[nodiscard]] std::size_t core_pivot_count() const { return core_pivot_count_; }
  /// Sum of the magnitudes of the terms of the core's determinant, the reference for rounding.
  [[nodiscard]] const GiNaC::ex& core_terms() const { return core_terms_; }
  [[nodiscard]] int sign() const { return sign_; }
  /// J, in the frames of the loops.
  [[nodiscard]] const GiNaC::ex& entry(std::size_t row, std::size_t unknown) const {
    return entries_[row][unknown];
  }
  /// det J as the product of its factors, as text.
  [[nodiscard]] std::string determinant_text() const;

  /// The contribution of the known components of x to a row of J x; unknown components are zero.
  using KnownPart = std::function<GiNaC::ex(std::size_t row, const std::vector<GiNaC::ex>& solved)>;
  /// The solution of J x = b, for b in names. A component that needs a name is defined in `names`,
  /// by the symbol of its unknown in `symbols` and with `meaning`.
  [[nodiscard]] std::vector<GiNaC::ex> solve(const std::vector<GiNaC::ex>& rhs,
                                             const std::vector<GiNaC::symbol>& symbols,
                                             const std::string& meaning,
                                             equations::Vocabulary& names) const;
  /// The same, with the known part of each row written by the caller.
  [[nodiscard]] std::vector<GiNaC::ex> solve(const std::vector<GiNaC::ex>& rhs,
                                             const std::vector<GiNaC::symbol>& symbols,
                                             const std::string& meaning,
                                             equations::Vocabulary& names,
                                             const KnownPart& known_part) const;
  /// J^T, solved by the same steps in reverse with the same pivots: its rows are the unknowns of J,
  /// and its unknowns the rows of J.
  [[nodiscard]] StructuredJacobian transposed() const;

 private:
  using Core = std::vector<std::vector<GiNaC::ex>>;

  void fill_entries();
  void order_elimination();
  void name_pivots();
  void divide_once();
  [[nodiscard]] GiNaC::ex inverse_of(const GiNaC::ex& pivot) const;
  [[nodiscard]] std::string core_text() const;
  [[nodiscard]] std::string readable(const GiNaC::ex& value) const;
  [[nodiscard]] Core core() const;
  void name_core_pivots(const GiNaC::ex& determinant, const GiNaC::ex& size);
  /// The solution for the core, by Cramer's rule.
  [[nodiscard]] std::vector<GiNaC::ex> solve_core(const std::vector<GiNaC::ex>& rhs) const;

  FramedClosures closures_;
  equations::Vocabulary vocabulary_;
  Core entries_;                               ///< [row][unknown]
  std::vector<EliminationStep> first_, last_;  ///< in order of solution
  std::vector<std::size_t> core_rows_, core_unknowns_;
  std::vector<Pivot> pivots_;
  std::size_t core_pivot_count_ = 0;
  GiNaC::ex core_terms_;
  std::vector<std::pair<GiNaC::ex, GiNaC::ex>> inverses_;
  int sign_ = 1;
};

}  // namespace assur::generator::pivoting
