#include "audit/equation_audit.hpp"

#include "closures/formula_text.hpp"

namespace assur::generator {

namespace {

Finding unreadable(const std::string& item, const std::string& printed, const FormulaError& error) {
  return {item, error.place, {Verdict::unreadable, error.what(), "", ""}, printed, "", ""};
}

/// `a`, or `a - b` for `a = b`.
GiNaC::ex read_equation(ClosureSystem& system, const PlacedText& text) {
  const auto [left, right] = cut(text, '=');
  const GiNaC::ex side = read_formula(left, system);
  return right.empty() ? side : side - read_formula(right, system);
}

}  // namespace

Finding audit_closure(ClosurePoints& points, const std::string& name, const PlacedText& printed) {
  ClosureSystem& system = points.system();
  const GiNaC::ex derived = *system.closure_named(name);
  Finding finding{name, printed.place, {}, printed.text, formula_text(derived) + " = 0", ""};
  try {
    const GiNaC::ex read = read_equation(system, printed);
    finding.comparison = compare(points, read, derived, false);
    if (finding.comparison.verdict == Verdict::differs_by_sign) {
      system.negate_closure(name);
      finding.comparison = compare(points, read, -derived, false);
      finding.note = "both sides negated";
    }
    if (!finding.agrees() && !system.follows_closures(read)) {
      finding.note = "printed less derived: " + formula_text((read - derived).expand());
    }
  } catch (const FormulaError& error) {
    return unreadable(name, printed.text, error);
  }
  return finding;
}

std::vector<Finding> audit_matrix(ClosurePoints& points, const PrintedMatrix& matrix) {
  ClosureSystem& system = points.system();
  std::vector<Finding> findings;
  for (std::size_t place = 0; place < matrix.entries.size(); ++place) {
    const std::string& row = matrix.rows[place / matrix.columns.size()];
    const std::string& column = matrix.columns[place % matrix.columns.size()];
    const AuditSymbol& by = *system.symbol_named(column);
    const GiNaC::ex* closure = system.closure_named(row);
    const PrintedEntry& entry = matrix.entries[place];
    const std::string item = "(" + std::to_string(place / matrix.columns.size() + 1) + "," +
                             std::to_string(place % matrix.columns.size() + 1) + ") " +
                             (closure == nullptr ? "D " : "d ") + row + "/" +
                             (closure == nullptr ? "D " : "d ") + column;
    try {
      const GiNaC::ex printed =
          entry.text.empty() ? 0 : read_formula(entry.text, system, entry.locals);
      const GiNaC::ex derived = closure == nullptr ? system.total(*system.meaning_of(row), by)
                                                   : system.partial(*closure, by.symbol);
      findings.push_back({item, entry.text.place, compare(points, printed, derived, false),
                          entry.printed(), formula_text(derived), ""});
    } catch (const FormulaError& error) {
      findings.push_back(unreadable(item, entry.printed(), error));
    }
  }
  return findings;
}

Finding audit_equation(ClosurePoints& points, const std::string& item, const PlacedText& left,
                       const PlacedText& right, const LocalNames& locals) {
  const std::string printed = left.text + " = " + right.text;
  try {
    const GiNaC::ex one = read_formula(left, points.system(), locals);
    const GiNaC::ex other = read_formula(right, points.system(), locals);
    Finding finding{item, left.place, compare(points, one, other, true), printed, "", ""};
    finding.note = finding.comparison.difference.empty() ? "" : "the difference is left less right";
    return finding;
  } catch (const FormulaError& error) {
    return unreadable(item, printed, error);
  }
}

}  // namespace assur::generator
