#include "audit/run_audit.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "audit/branch_condition.hpp"
#include "audit/slip_guess.hpp"
#include "closures/formula_text.hpp"
#include "closures/read_formula.hpp"

namespace assur::generator::audit {

namespace {

using closures::ClosurePoints;
using Point = ClosurePoints::Point;

/// Half a unit in the last place of a double, and the factor by which another order of operations
/// may exceed the bound on the rounding error for the derived one.
constexpr double half_ulp = 0x1p-53;
constexpr double other_orders = 4096;
/// A point at which rounding alone may cause a larger error than this is not used.
constexpr double blurred = 1e-6;

std::string decimal_text(double value) {
  std::ostringstream text;
  text.precision(12);
  text << value;
  return text.str();
}

/// The program of one statement, and the points at which it is run.
class ProgramAudit {
 public:
  ProgramAudit(ClosurePoints& points, const ExpectedMatrix& expected, const RunStatement& run,
               const running::RunLimits& limits)
      : points_(points),
        expected_(expected),
        run_(run),
        limits_(limits),
        drawing_(points, expected, run) {}

  RunAnswer answer() {
    asked_ = drawing_.drawn();
    compute(asked_, true);
    RunAnswer answer;
    for (std::size_t entry = 0; entry < expected_.derived.size(); ++entry) {
      answer.findings.push_back(judged(entry));
    }
    const bool wrong = std::any_of(answer.findings.begin(), answer.findings.end(),
                                   [](const Finding& each) { return each.is_wrong(); });
    if (wrong) {
      ask_simple_points();
      explain(answer.findings);
    }
    answer.remark = remark();
    return answer;
  }

 private:
  /// At how many points and under which conditions the program was run, and that this is no proof.
  [[nodiscard]] std::string remark() const {
    std::string text = "computed at " + drawing_.sort_of(asked_);
    for (const closures::PlacedText& condition : run_.where) {
      text += (&condition == (run_.where).data() ? " where " : " and ") + condition.text + " > 0";
    }
    if (run_.rounding > 0) {
      text += ", to a relative " + decimal_text(run_.rounding);
    }
    return text + ": evidence, not proof";
  }

  /// The program may fail at special points; then there are no simple points.
  void ask_simple_points() {
    std::vector<Asked> list = drawing_.simple();
    try {
      if (!list.empty()) {
        compute(list, false);
        simple_ = std::move(list);
      }
    } catch (const running::ProgramError&) {
      simple_.clear();
    }
  }

  void compute(std::vector<Asked>& list, bool repeat) {
    running::PointTable table;
    std::vector<GiNaC::symbol> given;
    for (const closures::AuditSymbol& symbol : points_.system().symbols()) {
      table.names.push_back(symbol.name);
      given.push_back(symbol.symbol);
      for (const auto& [prefix, rate] :
           {std::pair("rate_", symbol.rate), std::pair("rate2_", symbol.second_rate)}) {
        if (drawing_.has_rates(symbol)) {
          table.names.push_back(prefix + symbol.name);
          given.push_back(rate);
        }
      }
    }
    const auto add = [&](const Asked& asked) {
      std::vector<double> row;
      for (const GiNaC::symbol& symbol : given) {
        row.push_back(asked.values.at(symbol).value);
      }
      table.points.push_back(std::move(row));
    };
    std::for_each(list.begin(), list.end(), add);
    if (repeat) {
      add(list.front());
    }
    std::vector<std::vector<double>> values =
        running::program_values(run_.program, expected_.size, table, limits_);
    if (repeat) {
      repeated_ = std::move(values.back());
    }
    for (std::size_t at = 0; at < list.size(); ++at) {
      list[at].computed = std::move(values[at]);
    }
  }

  /// The values of the symbols that the derived entry or the call of the program mentions.
  [[nodiscard]] std::string point_text(const Point& point, std::size_t entry) {
    std::vector<GiNaC::ex> told = {expected_.derived[entry]};
    for (const closures::AuditSymbol& symbol : points_.system().symbols()) {
      if (drawing_.mentions(symbol.name)) {
        told.emplace_back(symbol.symbol);
      }
      for (const auto& [prefix, rate] :
           {std::pair("rate_", symbol.rate), std::pair("rate2_", symbol.second_rate)}) {
        if (drawing_.mentions(prefix + symbol.name)) {
          told.emplace_back(rate);
        }
      }
    }
    return points_.point_text(point, told, drawing_.assembled());
  }

  /// The error that rounding may cause, or nothing where it may hide the value.
  [[nodiscard]] std::optional<double> tolerance(std::size_t entry, const Asked& asked) const {
    const GiNaC::ex derived = points_.system().expanded(expected_.derived[entry]);
    const RoundedValue value = rounded_value(derived, asked.values);
    const double by_rounding = value.error * half_ulp * other_orders;
    if (!(by_rounding <= blurred * (1 + std::abs(value.value)))) {
      return std::nullopt;
    }
    return by_rounding + value.error * run_.rounding;
  }

  /// Whether the entry differs at the point. The simplest such point becomes its counterexample.
  [[nodiscard]] bool differs(std::size_t entry, Asked& asked, Finding& finding) {
    const std::optional<double> allowed = tolerance(entry, asked);
    const double derived = drawing_.value_at(expected_.derived[entry], asked.point);
    const double computed = asked.computed[entry];
    if (!allowed || std::abs(computed - derived) <= *allowed) {
      return false;
    }
    const std::string point = point_text(asked.point, entry);
    Comparison& comparison = finding.comparison;
    if (comparison.point.empty() || point.size() < comparison.point.size()) {
      comparison.point = point;
      comparison.difference = decimal_text(computed - derived);
      finding.printed = "computes " + decimal_text(computed);
      finding.derived =
          closures::formula_text(expected_.derived[entry]) + " = " + decimal_text(derived);
    }
    return true;
  }

  Finding judged(std::size_t entry) {
    Finding finding{expected_.items[entry], run_.result.place, {}, "", "", ""};
    finding.derived = closures::formula_text(expected_.derived[entry]);
    Comparison& comparison = finding.comparison;
    std::size_t told = 0;
    bool negated = true;
    bool wrong = false;
    std::vector<Trial> trials;
    try {
      for (Asked& asked : asked_) {
        const std::optional<double> allowed = tolerance(entry, asked);
        told += allowed ? 1 : 0;
        const bool different = differs(entry, asked, finding);
        wrong = different || wrong;
        if (allowed) {
          trials.push_back({&asked.point, !different});
        }
        const double derived = drawing_.value_at(expected_.derived[entry], asked.point);
        negated = negated && (!allowed || std::abs(asked.computed[entry] + derived) <= *allowed);
      }
    } catch (const closures::NotAlgebraic& error) {
      comparison = {Verdict::undecided, error.what(), "", ""};
      return finding;
    }
    comparison.evidence = "computed at " + std::to_string(told) + " points: evidence, not proof";
    comparison.verdict = !wrong    ? Verdict::agrees
                         : negated ? Verdict::differs_by_sign
                                   : Verdict::differs;
    const bool somewhere =
        wrong && std::ranges::any_of(trials, [](const Trial& trial) { return trial.holds; });
    if (somewhere) {
      const BranchCondition branch = branch_condition(points_, expected_.derived[entry], trials);
      comparison.evidence = branch_text(trials, branch) + ": evidence, not proof";
      comparison.branch = branch_text(trials, branch);
      if (!branch.empty()) {
        comparison.verdict = Verdict::on_one_branch;
      }
    }
    if (told < fewest_points) {
      comparison.verdict = Verdict::undecided;
      comparison.evidence = "rounding hides its value at nearly all points";
    } else if (repeated_[entry] != asked_.front().computed[entry]) {
      comparison.verdict = Verdict::differs;
      comparison.point = point_text(asked_.front().point, entry);
      comparison.difference = decimal_text(repeated_[entry] - asked_.front().computed[entry]);
      finding.printed = "computes " + decimal_text(asked_.front().computed[entry]) +
                        ", and later " + decimal_text(repeated_[entry]);
      finding.note = "the same call gives another value later: something is kept between calls";
    }
    return finding;
  }

  void explain(std::vector<Finding>& findings) {
    ComputedMatrix matrix{expected_.size.rows, expected_.size.columns, {}, {}, {}};
    for (const GiNaC::ex& derived : expected_.derived) {
      matrix.derived.push_back(points_.system().expanded(derived));
    }
    for (const Asked& asked : asked_) {
      matrix.points.push_back(asked.values);
      matrix.computed.push_back(asked.computed);
    }
    for (std::size_t entry = 0; entry < findings.size(); ++entry) {
      Finding& finding = findings[entry];
      if (!finding.is_wrong()) {
        continue;
      }
      if (finding.note.empty()) {
        for (Asked& asked : simple_) {
          static_cast<void>(differs(entry, asked, finding));
        }
      }
      const std::string guess = guessed_slip(matrix, entry, points_.system());
      finding.note += (finding.note.empty() || guess.empty() ? "" : "; ") + guess;
    }
  }

  ClosurePoints& points_;
  const ExpectedMatrix& expected_;
  const RunStatement& run_;
  const running::RunLimits& limits_;
  AskedPoints drawing_;
  std::vector<Asked> asked_;
  std::vector<Asked> simple_;
  std::vector<double> repeated_;  ///< the values at the first point, computed again at the end
};

}  // namespace

RunAnswer audit_run(ClosurePoints& points, const ExpectedMatrix& expected, const RunStatement& run,
                    const running::RunLimits& limits) {
  const std::string file = run.program.file.filename().string();
  try {
    return ProgramAudit(points, expected, run, limits).answer();
  } catch (const running::ProgramError& error) {
    throw closures::FormulaError(file + " cannot be audited: " + error.what() +
                                     (error.point == running::ProgramError::none
                                          ? ""
                                          : ", at point " + std::to_string(error.point + 1)),
                                 run.result.place);
  } catch (const closures::NotAlgebraic& error) {
    throw closures::FormulaError(file + " cannot be audited: " + error.what(), run.result.place);
  }
}

}  // namespace assur::generator::audit
