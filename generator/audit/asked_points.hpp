// Points at which a user's program is run, drawn from a closure system.
#pragma once

#include "audit/rounding_bound.hpp"
#include "audit/run_statement.hpp"

namespace assur::generator::audit {

/// The expected entries of a program's matrix, row by row, each with its name.
struct ExpectedMatrix {
  running::MatrixSize size;
  std::vector<std::string> items;
  std::vector<GiNaC::ex> derived;
  bool on_closures = false;  ///< whether it is compared only where the closures hold
};

/// A point, the values that the program receives there, and those that it should return.
struct Asked {
  closures::ClosurePoints::Point point;
  SymbolValues values;
  std::vector<double> computed;
};

/// Draws points for one statement.
class AskedPoints {
 public:
  using Point = closures::ClosurePoints::Point;

  AskedPoints(closures::ClosurePoints& points, const ExpectedMatrix& expected,
              const RunStatement& run)
      : points_(points), expected_(expected), run_(run), assembled_(expected.on_closures) {}

  /// Returns points for comparisons. Points at which a given length is negative come last, since a
  /// program may refuse such lengths; unknown lengths have either sign. Points at which an entry
  /// has no value are left out. Throws FormulaError if there are too few points.
  [[nodiscard]] std::vector<Asked> drawn();
  /// Returns points of small numbers, for counterexamples that can be checked with a pencil. May be
  /// empty.
  [[nodiscard]] std::vector<Asked> simple();
  /// Whether the closures hold at the points.
  [[nodiscard]] bool assembled() const { return assembled_; }
  /// Returns the number and sort of points as text: `40 assembled rational points`.
  [[nodiscard]] std::string sort_of(const std::vector<Asked>& points) const;

  /// Returns the exact value, rounded to a double. Throws NotAlgebraic.
  [[nodiscard]] double value_at(const GiNaC::ex& expression, closures::ClosurePoints::Point& point);
  /// Whether the program receives the rates of a symbol. It receives those of an unknown only where
  /// its call names them.
  [[nodiscard]] bool has_rates(const closures::AuditSymbol& symbol) const;
  /// Whether the call of the program contains this name.
  [[nodiscard]] bool mentions(const std::string& name) const;

 private:
  [[nodiscard]] bool is_allowed(Point& point);
  /// The point with the unknown lengths negated, if the closures can hold there.
  [[nodiscard]] std::optional<Point> turned(const Point& point);
  [[nodiscard]] bool parameters_positive(const Point& point) const;
  /// Returns false, and adds nothing, where an entry has no value.
  bool add_point(const Point& point, std::vector<Asked>& list);
  /// Computes the input of the program, and the derivatives in the entries. Throws NotAlgebraic.
  void complete(Asked& asked);

  closures::ClosurePoints& points_;
  const ExpectedMatrix& expected_;
  const RunStatement& run_;
  bool assembled_;
  std::string obstacle_;  ///< why an entry or condition has no value somewhere
};

}  // namespace assur::generator::audit
