// Audits printed closures, matrices and equations against a closure system.
#pragma once

#include <functional>

#include "audit/finding.hpp"
#include "closures/read_formula.hpp"

namespace assur::generator::audit {

/// The largest number of equations that one printed equation with indices may stand for.
constexpr std::size_t most_cases = 20'000;
/// The largest number of characters, or tokens, of all these equations.
constexpr std::size_t most_letters_of_cases = 10'000'000;
/// The largest number of entries of a matrix.
constexpr std::size_t most_entries = 20'000;

/// One entry of a printed matrix; empty text means zero.
struct PrintedEntry {
  closures::PlacedText text;
  std::function<GiNaC::ex()> value{};  ///< for a text that is not a formula; may throw FormulaError
};

/// A printed matrix: rows are closures or quantities that depend on them; columns are symbols. The
/// map of efforts is the transpose of that of velocities: its entry (i, j) is the derivative of
/// quantity j by symbol i.
struct PrintedMatrix {
  std::vector<std::string> rows;  ///< names, or formulas such as `rate(x)`
  std::vector<std::string> columns;
  std::vector<PrintedEntry> entries;  ///< row by row, as they are printed
  bool is_transposed = false;

  /// The printed numbers of rows and columns.
  [[nodiscard]] std::size_t height() const { return (is_transposed ? columns : rows).size(); }
  [[nodiscard]] std::size_t width() const { return (is_transposed ? rows : columns).size(); }
};

/// The derived value of an entry of a matrix, and its name in reports.
struct DerivedEntry {
  std::string item;
  GiNaC::ex value;
};
/// Throws FormulaError if a row is a formula that cannot be read.
[[nodiscard]] DerivedEntry derived_entry(closures::ClosureSystem& system,
                                         const PrintedMatrix& matrix, std::size_t place);

/// The rows in a list: names of anything in the system, or formulas, which have brackets. Throws
/// FormulaError for a formula that cannot be read; `named` checks entries without brackets.
[[nodiscard]] std::vector<std::string> rows_in(
    const closures::PlacedText& list, closures::ClosureSystem& system,
    const std::function<std::vector<std::string>(const closures::PlacedText&)>& named);
/// Throws FormulaError if a row depends on the closures and a column is an unknown.
void expect_parameters(const PrintedMatrix& matrix, const closures::ClosureSystem& system,
                       closures::Place place);

/// A printed text as reports show it, and its place.
struct Printed {
  std::string text;
  closures::Place place;
};

/// The finding for a printed text that cannot be read.
[[nodiscard]] Finding unreadable(const std::string& item, const std::string& printed,
                                 const closures::FormulaError& error);

/// Compares the printed closure with the derived one of that name. An equation may be printed with
/// all its signs reversed; then `is_turned`.
[[nodiscard]] Finding audit_closure(closures::ClosurePoints& points, const std::string& name,
                                    const closures::PlacedText& printed);
[[nodiscard]] Finding audit_closure(closures::ClosurePoints& points, const std::string& name,
                                    const GiNaC::ex& read, const Printed& printed);
[[nodiscard]] bool is_turned(const Finding& closure);

/// Compares each entry with the derivative of its row with respect to its column: the partial
/// derivative if the row is a closure, else the total one.
[[nodiscard]] std::vector<Finding> audit_matrix(closures::ClosurePoints& points,
                                                const PrintedMatrix& matrix);
/// Compares one entry of a matrix; row and column count from 0. `read` returns its expression.
[[nodiscard]] Finding audit_entry(closures::ClosurePoints& points, const PrintedMatrix& frame,
                                  std::size_t row, std::size_t column, const Printed& printed,
                                  const std::function<GiNaC::ex()>& read);

/// Compares both sides of a printed equation with each other, where the closures hold.
[[nodiscard]] Finding audit_equation(closures::ClosurePoints& points, const std::string& item,
                                     const closures::PlacedText& left,
                                     const closures::PlacedText& right,
                                     const closures::LocalNames& locals);
[[nodiscard]] Finding audit_equation(closures::ClosurePoints& points, const std::string& item,
                                     const GiNaC::ex& left, const GiNaC::ex& right,
                                     const Printed& printed);

}  // namespace assur::generator::audit
