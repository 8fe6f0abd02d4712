#include "audit/run_audit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "audit/branch_condition.hpp"
#include "audit/slip_guess.hpp"
#include "closures/read_formula.hpp"

namespace assur::generator::audit {

namespace {

using closures::ClosurePoints;
using Point = ClosurePoints::Point;

std::string decimal_text(double value) {
  std::ostringstream text;
  text.precision(12);
  text << value;
  return text.str();
}

/// Points, the values that a program returns and those that it should return; after a crash there
/// are none.
struct Comparisons {
  std::vector<Asked> asked;
  std::vector<running::PointValues> given;
  std::vector<std::vector<ExpectedValue>> expected;
};

/// The program of one statement, and the points at which it is run.
class ProgramAudit {
 public:
  ProgramAudit(ClosurePoints& points, const ExpectedMatrix& expected, RunReference& reference,
               const RunStatement& run, const running::RunLimits& limits)
      : points_(points),
        expected_(expected),
        reference_(reference),
        run_(run),
        limits_(limits),
        drawing_(points, reference.drawn(), run) {}

  RunAnswer answer() {
    drawn_.asked = drawing_.drawn();
    simple_.asked = drawing_.simple();
    compute();
    drawn_.expected = reference_.at(drawn_.asked, drawing_, precision());
    RunAnswer answer;
    for (std::size_t entry = 0; entry < expected_.items.size(); ++entry) {
      answer.findings.push_back(judged(entry));
    }
    answer.remark = remark();
    const bool wrong = std::any_of(answer.findings.begin(), answer.findings.end(),
                                   [](const Finding& each) { return each.is_wrong(); });
    if (wrong) {
      simple_.expected = reference_.at(simple_.asked, drawing_, precision());
      explain(answer.findings);
    }
    return answer;
  }

 private:
  /// The number of points, the conditions of the run, and the reminder that this is not a proof.
  [[nodiscard]] std::string remark() const {
    std::string text = "computed at " + drawing_.sort_of(drawn_.asked);
    for (const closures::PlacedText& condition : run_.where) {
      text += (&condition == (run_.where).data() ? " where " : " and ") + condition.text + " > 0";
    }
    text += single_ ? ", in single precision" : "";
    if (run_.rounding > 0) {
      text += ", to a relative " + decimal_text(run_.rounding);
    }
    return text + reference_.remark() + ": evidence, not proof";
  }

  /// Runs the program at the points, once more at the first of them, and last at the simple ones,
  /// where it may fail.
  void compute() {
    running::PointTable table;
    const std::vector<GivenQuantity> given = given_quantities(points_.system(), drawing_);
    for (const GivenQuantity& quantity : given) {
      table.names.push_back(quantity.name);
    }
    const auto add = [&](const Asked& asked) {
      std::vector<double> row;
      for (const GivenQuantity& quantity : given) {
        row.push_back(asked.values.at(quantity.symbol).value);
      }
      table.points.push_back(std::move(row));
    };
    std::for_each(drawn_.asked.begin(), drawn_.asked.end(), add);
    add(drawn_.asked.front());
    std::for_each(simple_.asked.begin(), simple_.asked.end(), add);
    running::ProgramValues values =
        running::program_values(run_.program, expected_.size, table, limits_);
    single_ = values.single_precision;
    std::vector<running::PointValues>& all = values.points;
    const auto begin = all.begin();
    const auto end_of_drawn = begin + std::ssize(drawn_.asked);
    if (all.size() <= drawn_.asked.size()) {
      drawn_.given = std::move(all);
      return;
    }
    drawn_.given.assign(begin, end_of_drawn);
    repeated_ = *end_of_drawn;
    simple_.given.assign(end_of_drawn + 1, all.end());
  }

  [[nodiscard]] const Precision& precision() const { return single_ ? in_single : in_double; }

  /// The values of the symbols that the derived entry or the call of the program mentions.
  [[nodiscard]] std::string point_text(const Point& point, std::size_t entry) const {
    std::vector<GiNaC::ex> told = {reference_.expressions()[entry]};
    for (const closures::AuditSymbol& symbol : points_.system().symbols()) {
      for (const auto& [name, value] :
           {std::pair(symbol.name, symbol.symbol), std::pair("rate_" + symbol.name, symbol.rate),
            std::pair("rate2_" + symbol.name, symbol.second_rate)}) {
        if (drawing_.mentions(name)) {
          told.emplace_back(value);
        }
      }
    }
    return points_.point_text(point, told, drawing_.assembled());
  }

  /// A difference without whole turns, if the entry is an angle.
  [[nodiscard]] double without_turns(std::size_t entry, double difference) const {
    return reference_.is_angle(entry) ? std::remainder(difference, 2 * std::numbers::pi)
                                      : difference;
  }

  /// Whether two numbers agree as the entry's value up to rounding.
  [[nodiscard]] bool alike(std::size_t entry, double computed, double value,
                           double tolerance) const {
    const double of_large_angles =
        reference_.is_angle(entry) ? precision().unit * std::abs(computed) : 0;
    return std::abs(without_turns(entry, computed - value)) <= tolerance + of_large_angles;
  }

  /// The fault of the entry at a point: the program fails there, or the value differs.
  [[nodiscard]] std::optional<Verdict> fault(std::size_t entry, const Comparisons& compared,
                                             std::size_t at) const {
    const ExpectedValue& expected = compared.expected[at][entry];
    if (!expected.exists) {
      return std::nullopt;
    }
    if (!compared.given[at].faults[entry].empty()) {
      return Verdict::fails;
    }
    const double computed = compared.given[at].entries[entry];
    const bool differs =
        expected.tolerance && !alike(entry, computed, expected.value, *expected.tolerance);
    return differs ? std::optional(Verdict::differs) : std::nullopt;
  }

  /// Makes a point with this fault the entry's counterexample if it is simpler than the last one.
  void show(std::size_t entry, const Comparisons& compared, std::size_t at, Verdict fault,
            Finding& finding) const {
    const std::string point = point_text(compared.asked[at].point, entry);
    Comparison& comparison = finding.comparison;
    if (!comparison.point.empty() && point.size() >= comparison.point.size()) {
      return;
    }
    const ExpectedValue& expected = compared.expected[at][entry];
    const running::PointValues& given = compared.given[at];
    comparison.point = point;
    finding.derived =
        reference_.text(entry) + (expected.tolerance ? " = " + decimal_text(expected.value) : "");
    if (fault == Verdict::fails) {
      finding.printed = given.faults[entry];
      return;
    }
    const double computed = given.entries[entry];
    comparison.difference = decimal_text(without_turns(entry, computed - expected.value));
    finding.printed = "computes " + decimal_text(computed);
  }

  Finding judged(std::size_t entry) {
    Finding finding{expected_.items[entry], run_.result.place, {}, "", "", ""};
    finding.derived = reference_.text(entry);
    Comparison& comparison = finding.comparison;
    std::size_t told = 0;
    std::size_t failing = 0;
    std::size_t differing = 0;
    bool negated = true;
    std::vector<TestedPoint> tested;
    for (std::size_t at = 0; at < drawn_.given.size(); ++at) {
      const ExpectedValue& expected = drawn_.expected[at][entry];
      if (!expected.obstacle.empty()) {
        comparison = {Verdict::undecided, expected.obstacle, "", ""};
        return finding;
      }
      const std::optional<Verdict> wrong = fault(entry, drawn_, at);
      failing += wrong == Verdict::fails ? 1 : 0;
      differing += wrong == Verdict::differs ? 1 : 0;
      if (wrong == Verdict::fails || !expected.tolerance) {
        continue;
      }
      ++told;
      tested.push_back({&drawn_.asked[at].point, !wrong});
      negated = negated &&
                alike(entry, drawn_.given[at].entries[entry], -expected.value, *expected.tolerance);
    }
    comparison.evidence = "computed at " + std::to_string(told) + " points: evidence, not proof";
    comparison.verdict = differing > 0 ? negated ? Verdict::differs_by_sign : Verdict::differs
                         : failing > 0 ? Verdict::fails
                                       : Verdict::agrees;
    if (differing > 0 && differing < told) {
      const BranchCondition branch =
          branch_condition(points_, reference_.expressions()[entry], tested);
      comparison.branch = branch_text(tested, branch);
      comparison.evidence = comparison.branch + ": evidence, not proof";
      comparison.verdict = branch.empty() ? Verdict::differs : Verdict::on_one_branch;
    }
    show_all(entry, drawn_, finding);
    if (failing > 0) {
      finding.note = failing_text(failing, differing, told);
    } else if (told < fewest_points) {
      comparison = {Verdict::undecided, reference_.why_untold(), "", ""};
    } else if (differs_later(entry)) {
      const double first = drawn_.given.front().entries[entry];
      comparison.verdict = Verdict::differs;
      comparison.point = point_text(drawn_.asked.front().point, entry);
      comparison.difference = decimal_text(repeated_.entries[entry] - first);
      finding.printed = "computes " + decimal_text(first) + ", and later " +
                        (repeated_.faults[entry].empty() ? decimal_text(repeated_.entries[entry])
                                                         : repeated_.faults[entry]);
      finding.note = "the same call gives another value later: something is kept between calls";
    }
    return finding;
  }

  /// Text about the points where the program fails, and its values elsewhere.
  [[nodiscard]] std::string failing_text(std::size_t failing, std::size_t differing,
                                         std::size_t told) const {
    const std::string all = std::to_string(drawn_.asked.size());
    const std::string others = told == 0           ? ""
                               : differing == 0    ? "; it agrees at the others"
                               : differing == told ? "; it differs at the others"
                                                   : "; it differs at some of the others";
    if (drawn_.given.size() < drawn_.asked.size()) {
      return "it is not run beyond point " + std::to_string(drawn_.given.size()) + " of " + all +
             others;
    }
    return failing == drawn_.asked.size()
               ? "it fails at all " + all + " points"
               : "it fails at " + std::to_string(failing) + " of " + all + " points" + others;
  }

  /// Shows the simplest point at which the entry has the fault of its verdict.
  void show_all(std::size_t entry, const Comparisons& compared, Finding& finding) const {
    const Verdict kind =
        finding.comparison.verdict == Verdict::fails ? Verdict::fails : Verdict::differs;
    for (std::size_t at = 0; at < compared.given.size(); ++at) {
      if (fault(entry, compared, at) == kind) {
        show(entry, compared, at, kind, finding);
      }
    }
  }

  [[nodiscard]] bool differs_later(std::size_t entry) const {
    if (repeated_.entries.empty()) {
      return false;
    }
    const running::PointValues& first = drawn_.given.front();
    const bool has_value = first.faults[entry].empty();
    return has_value != repeated_.faults[entry].empty() ||
           (has_value && first.entries[entry] != repeated_.entries[entry]);
  }

  void explain(std::vector<Finding>& findings) {
    ComputedMatrix matrix{expected_.size.rows, expected_.size.columns, {}, {}, {}, {}, 0};
    matrix.slack = reference_.slack(precision());
    matrix.derived = reference_.expressions();
    for (std::size_t entry = 0; entry < findings.size(); ++entry) {
      matrix.angles.push_back(reference_.is_angle(entry));
    }
    for (std::size_t entry = 0; entry < findings.size(); ++entry) {
      Finding& finding = findings[entry];
      if (!finding.is_wrong()) {
        continue;
      }
      if (finding.comparison.verdict == Verdict::fails) {
        show_all(entry, simple_, finding);
        continue;
      }
      const bool kept = !finding.note.empty() && differs_later(entry);
      if (!kept) {
        show_all(entry, simple_, finding);
      }
      matrix.points.clear();
      matrix.computed.clear();
      for (std::size_t at = 0; at < drawn_.given.size(); ++at) {
        if (drawn_.given[at].faults[entry].empty()) {
          matrix.points.push_back(drawn_.asked[at].values);
          matrix.computed.push_back(drawn_.given[at].entries);
        }
      }
      const std::string guess =
          matrix.points.size() < fewest_points ? "" : guessed_slip(matrix, entry, points_.system());
      finding.note += (finding.note.empty() || guess.empty() ? "" : "; ") + guess;
    }
  }

  ClosurePoints& points_;
  const ExpectedMatrix& expected_;
  RunReference& reference_;
  const RunStatement& run_;
  const running::RunLimits& limits_;
  AskedPoints drawing_;
  bool single_ = false;  ///< whether the program computes in single precision
  Comparisons drawn_;
  Comparisons simple_;
  running::PointValues repeated_;  ///< its values at the first point, computed again at the end
};

}  // namespace

RunAnswer audit_run(ClosurePoints& points, const ExpectedMatrix& expected, RunReference& reference,
                    const RunStatement& run, const running::RunLimits& limits) {
  const std::string file = run.program.file.filename().string();
  try {
    return ProgramAudit(points, expected, reference, run, limits).answer();
  } catch (const running::ProgramError& error) {
    throw closures::FormulaError(file + " cannot be audited: " + error.what(), run.result.place);
  } catch (const closures::NotAlgebraic& error) {
    throw closures::FormulaError(file + " cannot be audited: " + error.what(), run.result.place);
  }
}

}  // namespace assur::generator::audit
