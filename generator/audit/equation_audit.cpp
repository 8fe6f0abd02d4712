#include "audit/equation_audit.hpp"

#include "closures/formula_text.hpp"

namespace assur::generator::audit {

namespace {

Finding unreadable(const std::string& item, const std::string& printed,
                   const closures::FormulaError& error) {
  return {item, error.place, {Verdict::unreadable, error.what(), "", ""}, printed, "", ""};
}

/// `a`, or `a - b` for `a = b`.
GiNaC::ex read_equation(closures::ClosureSystem& system, const closures::PlacedText& text) {
  const auto [left, right] = closures::cut(text, '=');
  const GiNaC::ex side = closures::read_formula(left, system);
  return right.empty() ? side : side - closures::read_formula(right, system);
}

}  // namespace

Finding audit_closure(closures::ClosurePoints& points, const std::string& name,
                      const closures::PlacedText& printed) {
  closures::ClosureSystem& system = points.system();
  const GiNaC::ex derived = *system.closure_named(name);
  Finding finding{name, printed.place, {}, printed.text, closures::formula_text(derived) + " = 0",
                  ""};
  try {
    const GiNaC::ex read = read_equation(system, printed);
    finding.comparison = compare(points, read, derived, false);
    if (finding.comparison.verdict == Verdict::differs_by_sign) {
      system.negate_closure(name);
      finding.comparison = compare(points, read, -derived, false);
      finding.note = "both sides negated";
    }
    if (!finding.agrees() && !system.follows_closures(read)) {
      finding.note = "printed less derived: " + closures::formula_text((read - derived).expand());
    }
  } catch (const closures::FormulaError& error) {
    return unreadable(name, printed.text, error);
  }
  return finding;
}

DerivedEntry derived_entry(closures::ClosureSystem& system, const PrintedMatrix& matrix,
                           std::size_t place) {
  const std::string& row = matrix.rows[place / matrix.columns.size()];
  const std::string& column = matrix.columns[place % matrix.columns.size()];
  const closures::AuditSymbol& by = *system.symbol_named(column);
  const GiNaC::ex* closure = system.closure_named(row);
  const std::string item = "(" + std::to_string(place / matrix.columns.size() + 1) + "," +
                           std::to_string(place % matrix.columns.size() + 1) + ") " +
                           (closure == nullptr ? "D " : "d ") + row + "/" +
                           (closure == nullptr ? "D " : "d ") + column;
  return {item, closure == nullptr ? system.total(*system.meaning_of(row), by)
                                   : system.partial(*closure, by.symbol)};
}

std::vector<Finding> audit_matrix(closures::ClosurePoints& points, const PrintedMatrix& matrix) {
  closures::ClosureSystem& system = points.system();
  std::vector<Finding> findings;
  for (std::size_t place = 0; place < matrix.entries.size(); ++place) {
    const auto [item, derived] = derived_entry(system, matrix, place);
    const PrintedEntry& entry = matrix.entries[place];
    try {
      const GiNaC::ex printed =
          entry.text.empty() ? 0 : closures::read_formula(entry.text, system, entry.locals);
      findings.push_back({item, entry.text.place, compare(points, printed, derived, false),
                          entry.printed(), closures::formula_text(derived), ""});
    } catch (const closures::FormulaError& error) {
      findings.push_back(unreadable(item, entry.printed(), error));
    }
  }
  return findings;
}

Finding audit_equation(closures::ClosurePoints& points, const std::string& item,
                       const closures::PlacedText& left, const closures::PlacedText& right,
                       const closures::LocalNames& locals) {
  const std::string printed = left.text + " = " + right.text;
  try {
    const GiNaC::ex one = closures::read_formula(left, points.system(), locals);
    const GiNaC::ex other = closures::read_formula(right, points.system(), locals);
    Finding finding{item, left.place, compare(points, one, other, true), printed, "", ""};
    finding.note = finding.comparison.difference.empty() ? "" : "the difference is left less right";
    return finding;
  } catch (const closures::FormulaError& error) {
    return unreadable(item, printed, error);
  }
}

}  // namespace assur::generator::audit
