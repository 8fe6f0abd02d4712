#include "audit/equation_audit.hpp"

#include <algorithm>
#include <iterator>

#include "closures/extent.hpp"
#include "closures/formula_text.hpp"

namespace assur::generator::audit {

namespace {

/// The largest matrix that is inverted: the inverse's formulas grow with the factorial.
constexpr std::size_t most_inverted = 3;

/// The matrix that was printed instead, and the note on it.
struct Mistake {
  GiNaC::matrix matrix;
  const char* note;
};

std::vector<Mistake> mistakes(const GiNaC::matrix& efforts) {
  const GiNaC::matrix velocities = efforts.transpose();
  std::vector<Mistake> list = {
      {velocities, "printed is the map of velocities itself; its transpose maps efforts"}};
  if (velocities.rows() <= most_inverted && !velocities.determinant().normal().is_zero()) {
    const GiNaC::matrix inverse = velocities.inverse();
    list.push_back(
        {inverse, "printed is the inverse of the map of velocities; its transpose maps efforts"});
    list.push_back({inverse.transpose(),
                    "printed is the transposed inverse, which maps efforts the other way"});
  }
  return list;
}

/// Adds a note to the wrong entries of a transposed matrix if the printed one is the map of
/// velocities itself, its inverse, or the transposed inverse.
void explain_map_of_efforts(closures::ClosurePoints& points, const PrintedMatrix& matrix,
                            std::vector<Finding>& findings) {
  const bool is_wrong = std::ranges::any_of(findings, &Finding::is_wrong);
  if (!matrix.is_transposed || matrix.height() != matrix.width() || !is_wrong) {
    return;
  }
  const auto size = static_cast<unsigned>(matrix.width());
  GiNaC::matrix efforts(size, size);
  GiNaC::matrix printed(size, size);
  for (unsigned place = 0; place < size * size; ++place) {
    const PrintedEntry& entry = matrix.entries[place];
    if (findings[place].comparison.verdict == Verdict::unreadable) {
      return;
    }
    efforts(place / size, place % size) = derived_entry(points.system(), matrix, place).value;
    printed(place / size, place % size) = entry.text.empty() ? GiNaC::ex(0)
                                          : entry.value
                                              ? entry.value()
                                              : closures::read_formula(entry.text, points.system());
  }
  for (const Mistake& mistake : mistakes(efforts)) {
    bool is_this = true;
    for (unsigned place = 0; place < size * size && is_this; ++place) {
      is_this = compare(points, printed(place / size, place % size),
                        mistake.matrix(place / size, place % size), false)
                    .verdict == Verdict::agrees;
    }
    if (is_this) {
      for (Finding& finding : findings) {
        finding.note = finding.is_wrong() ? mistake.note : finding.note;
      }
      return;
    }
  }
}

const std::string turned_round = "printed with all signs reversed";

/// `a`, or `a - b` for `a = b`.
GiNaC::ex read_equation(closures::ClosureSystem& system, const closures::PlacedText& text) {
  const auto [left, right] = closures::cut(text, '=');
  const GiNaC::ex side = closures::read_formula(left, system);
  const bool one_side = closures::split(text, '=').size() == 1;  // `a =` has two, one missing
  return one_side ? side : side - closures::read_formula(right, system);
}

}  // namespace

Finding unreadable(const std::string& item, const std::string& printed,
                   const closures::FormulaError& error) {
  return {item, error.place, {Verdict::unreadable, error.what(), "", ""}, printed, "", ""};
}

Finding audit_closure(closures::ClosurePoints& points, const std::string& name,
                      const closures::PlacedText& printed) {
  try {
    return audit_closure(points, name, read_equation(points.system(), printed),
                         {printed.text, printed.place});
  } catch (const closures::FormulaError& error) {
    return unreadable(name, printed.text, error);
  }
}

Finding audit_closure(closures::ClosurePoints& points, const std::string& name,
                      const GiNaC::ex& read, const Printed& printed) {
  const GiNaC::ex derived = points.system().closure_as_typed(name);
  Finding finding{name,
                  printed.place,
                  compare(points, read, derived, false),
                  printed.text,
                  closures::formula_text(derived) + " = 0",
                  ""};
  if (finding.comparison.verdict == Verdict::differs_by_sign) {
    finding.comparison = compare(points, read, -derived, false);
    finding.note = turned_round;
  }
  if (!finding.agrees() && !points.system().follows_closures(read) &&
      closures::can_be_multiplied_out(read - derived)) {
    finding.note = "printed minus derived: " + closures::formula_text((read - derived).expand());
  }
  return finding;
}

DerivedEntry derived_entry(closures::ClosureSystem& system, const PrintedMatrix& matrix,
                           std::size_t place) {
  const std::size_t down = place / matrix.width();
  const std::size_t across = place % matrix.width();
  const std::string& row = matrix.rows[matrix.is_transposed ? across : down];
  const std::string& column = matrix.columns[matrix.is_transposed ? down : across];
  const closures::AuditSymbol& by = *system.symbol_named(column);
  const GiNaC::ex* closure = system.closure_named(row);
  const std::optional<GiNaC::ex> named = system.meaning_of(row);
  const std::string item = "(" + std::to_string(down + 1) + "," + std::to_string(across + 1) +
                           ") " + (closure == nullptr ? "D " : "d ") + row + "/" +
                           (closure == nullptr ? "D " : "d ") + column;
  if (closure != nullptr) {
    return {item, system.partial(*closure, by)};
  }
  return {item, system.total(named ? *named : closures::read_formula({row, {}}, system), by)};
}

std::vector<std::string> rows_in(
    const closures::PlacedText& list, closures::ClosureSystem& system,
    const std::function<std::vector<std::string>(const closures::PlacedText&)>& named) {
  std::vector<std::string> rows;
  for (const closures::PlacedText& row : closures::split(list, ' ')) {
    if (row.text.find('(') != std::string::npos) {
      static_cast<void>(closures::read_formula(row, system));
      rows.push_back(row.text);
    } else if (!row.empty()) {
      std::ranges::move(named(row), std::back_inserter(rows));
    }
  }
  return rows;
}

void expect_parameters(const PrintedMatrix& matrix, const closures::ClosureSystem& system,
                       closures::Place place) {
  for (const std::string& row : matrix.rows) {
    for (const std::string& column : matrix.columns) {
      if (system.closure_named(row) == nullptr && system.symbol_named(column)->unknown) {
        throw closures::FormulaError("'" + row + "' follows the closures, and '" + column +
                                         "' is an unknown; a matrix has derivatives by parameters",
                                     place);
      }
    }
  }
}

bool is_turned(const Finding& closure) { return closure.agrees() && closure.note == turned_round; }

std::vector<Finding> audit_matrix(closures::ClosurePoints& points, const PrintedMatrix& matrix) {
  std::vector<Finding> findings;
  for (std::size_t place = 0; place < matrix.entries.size(); ++place) {
    const PrintedEntry& entry = matrix.entries[place];
    findings.push_back(audit_entry(
        points, matrix, place / matrix.width(), place % matrix.width(),
        {entry.text.empty() ? "0" : entry.text.text, entry.text.place}, [&]() -> GiNaC::ex {
          return entry.text.empty() ? GiNaC::ex(0)
                 : entry.value      ? entry.value()
                                    : closures::read_formula(entry.text, points.system());
        }));
  }
  explain_map_of_efforts(points, matrix, findings);
  return findings;
}

Finding audit_entry(closures::ClosurePoints& points, const PrintedMatrix& frame, std::size_t row,
                    std::size_t column, const Printed& printed,
                    const std::function<GiNaC::ex()>& read) {
  const auto [item, derived] = derived_entry(points.system(), frame, row * frame.width() + column);
  try {
    const GiNaC::ex expression = read();
    return {item,
            printed.place,
            compare(points, expression, derived, false),
            printed.text,
            closures::formula_text(derived),
            ""};
  } catch (const closures::FormulaError& error) {
    return unreadable(item, printed.text, error);
  }
}

Finding audit_equation(closures::ClosurePoints& points, const std::string& item,
                       const closures::PlacedText& left, const closures::PlacedText& right,
                       const closures::LocalNames& locals) {
  const std::string printed = left.text + (right.empty() ? "" : " = " + right.text);
  try {
    if (right.empty()) {
      throw closures::FormulaError("expected an equation LEFT = RIGHT", left.place);
    }
    const GiNaC::ex one = closures::read_formula(left, points.system(), locals);
    const GiNaC::ex other = closures::read_formula(right, points.system(), locals);
    return audit_equation(points, item, one, other, {printed, left.place});
  } catch (const closures::FormulaError& error) {
    return unreadable(item, printed, error);
  }
}

Finding audit_equation(closures::ClosurePoints& points, const std::string& item,
                       const GiNaC::ex& left, const GiNaC::ex& right, const Printed& printed) {
  Finding finding{item, printed.place, compare(points, left, right, true), printed.text, "", ""};
  finding.note = finding.comparison.difference.empty()
                     ? ""
                     : "the difference is the left side minus the right side";
  return finding;
}

}  // namespace assur::generator::audit
