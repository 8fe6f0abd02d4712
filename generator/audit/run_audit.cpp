#include "audit/run_audit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <sstream>

#include "audit/slip_guess.hpp"
#include "closures/formula_text.hpp"
#include "closures/read_formula.hpp"

namespace assur::generator::audit {

namespace {

using closures::ClosurePoints;
using Point = ClosurePoints::Point;

/// Half a unit in the last place of a double, and how many of them another order of operations may
/// cost against the bound for the derived one.
constexpr double half_ulp = 0x1p-53;
constexpr double other_orders = 4096;
/// A point where rounding alone may do more than this tells nothing.
constexpr double blurred = 1e-6;
constexpr std::size_t fewest_points = 3;
constexpr std::size_t simple_points = 80;

std::string decimal_text(double value) {
  std::ostringstream text;
  text.precision(12);
  text << value;
  return text.str();
}

/// Points of few and small numbers, so that a counterexample can be checked with a pencil.
class SimpleValues {
 public:
  GiNaC::numeric length() { return GiNaC::numeric(1 + below(3)); }
  GiNaC::numeric rate() { return GiNaC::numeric(1 + below(2)); }
  std::pair<GiNaC::numeric, GiNaC::numeric> direction() {
    constexpr std::array<std::array<int, 2>, 4> fifths = {{{3, 4}, {4, 3}, {0, 5}, {5, 0}}};
    const auto [x, y] = fifths[static_cast<std::size_t>(below(4))];
    const int side = below(4);
    return {GiNaC::numeric(side % 2 == 0 ? x : -x, 5), GiNaC::numeric(side < 2 ? y : -y, 5)};
  }

 private:
  int below(unsigned most) { return static_cast<int>(engine_() % most); }
  std::mt19937 engine_{1};
};

/// The program of one statement, and the points at which it is asked.
class ProgramAudit {
 public:
  ProgramAudit(ClosurePoints& points, const ExpectedMatrix& expected, const RunStatement& run,
               const running::RunLimits& limits)
      : points_(points),
        expected_(expected),
        run_(run),
        limits_(limits),
        assembled_(expected.on_closures) {}

  RunAnswer answer() {
    draw_points();
    compute(asked_, true);
    RunAnswer answer;
    for (std::size_t entry = 0; entry < expected_.derived.size(); ++entry) {
      answer.findings.push_back(judged(entry));
    }
    const bool wrong = std::any_of(answer.findings.begin(), answer.findings.end(),
                                   [](const Finding& each) { return each.is_wrong(); });
    if (wrong) {
      show_simple_points();
      explain(answer.findings);
    }
    answer.remark = "computed at " + std::to_string(asked_.size()) +
                    (assembled_ ? " assembled" : "") + " rational points" +
                    (assembled_ == expected_.on_closures ? "" : ", none of them assembled") +
                    ": evidence, not proof";
    return answer;
  }

 private:
  /// A point, what the program is given there, and what it gives.
  struct Asked {
    Point point;
    SymbolValues values;
    std::vector<double> computed;
  };

  [[noreturn]] void fail(const std::string& what) const {
    throw closures::FormulaError(run_.program.file.filename().string() + ": " + what,
                                 run_.result.place);
  }

  [[nodiscard]] bool is_allowed(Point& point) {
    closures::ClosureSystem& system = points_.system();
    return std::all_of(run_.where.begin(), run_.where.end(), [&](const auto& condition) {
      const GiNaC::ex value = points_.value(closures::read_formula(condition, system), point);
      return value.evalf().info(GiNaC::info_flags::positive);
    });
  }

  [[nodiscard]] bool all_lengths_positive(const Point& point) const {
    const auto& symbols = points_.system().symbols();
    return std::all_of(symbols.begin(), symbols.end(), [&](const auto& symbol) {
      return symbol.angle || point.values.at(symbol.symbol).info(GiNaC::info_flags::positive);
    });
  }

  /// Where a length is negative comes last: a program may take none such.
  void draw_points() {
    std::vector<Point> others;
    for (std::size_t index = 0; asked_.size() < run_.points && index < 6 * run_.points; ++index) {
      Point* const point = points_.point(index, assembled_);
      if (point == nullptr) {
        break;
      }
      if (!is_allowed(*point)) {
        continue;
      }
      if (all_lengths_positive(*point)) {
        add_point(*point, asked_);
      } else {
        others.push_back(*point);
      }
    }
    for (const Point& point : others) {
      if (asked_.size() < run_.points) {
        add_point(point, asked_);
      }
    }
    if (asked_.size() < fewest_points && assembled_ && !follows_closures()) {
      assembled_ = false;  // its entries have values anywhere
      asked_.clear();
      draw_points();
    }
    if (asked_.size() < fewest_points) {
      fail("no points are found at which it can be asked");
    }
  }

  [[nodiscard]] bool follows_closures() const {
    return std::any_of(
        expected_.derived.begin(), expected_.derived.end(),
        [&](const GiNaC::ex& each) { return points_.system().follows_closures(each); });
  }

  void add_point(const Point& point, std::vector<Asked>& list) {
    Asked asked{point, {}, {}};
    for (const GiNaC::ex& derived : expected_.derived) {
      static_cast<void>(value_at(derived, asked.point));  // solves for what it needs
    }
    if (assembled_) {
      for (const closures::AuditSymbol* unknown : points_.system().unknowns()) {
        if (has_rates(*unknown)) {
          static_cast<void>(value_at(unknown->rate, asked.point));
        }
      }
    }
    asked.values = symbol_values(points_, asked.point);
    list.push_back(std::move(asked));
  }

  /// Whether the program is given rates of a symbol: of an unknown where it asks for them.
  [[nodiscard]] bool has_rates(const closures::AuditSymbol& symbol) const {
    const bool asked = mentions("rate_" + symbol.name) || mentions("rate2_" + symbol.name);
    return symbol.moving || (asked && symbol.unknown && assembled_);
  }

  /// Exact, as a double; throws NotAlgebraic.
  [[nodiscard]] double value_at(const GiNaC::ex& expression, Point& point) {
    const GiNaC::ex value = points_.value(expression, point).evalf();
    if (!GiNaC::is_a<GiNaC::numeric>(value)) {
      throw closures::NotAlgebraic("it has no rational value");
    }
    return GiNaC::ex_to<GiNaC::numeric>(value).to_double();
  }

  void compute(std::vector<Asked>& list, bool repeat) {
    running::PointTable table;
    std::vector<GiNaC::symbol> given;
    for (const closures::AuditSymbol& symbol : points_.system().symbols()) {
      table.names.push_back(symbol.name);
      given.push_back(symbol.symbol);
      for (const auto& [prefix, rate] :
           {std::pair("rate_", symbol.rate), std::pair("rate2_", symbol.second_rate)}) {
        if (has_rates(symbol)) {
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

  /// The point as far as the program is told of it.
  [[nodiscard]] std::string point_text(const Point& point, std::size_t entry) const {
    std::vector<GiNaC::ex> told = {expected_.derived[entry]};
    for (const closures::AuditSymbol& symbol : points_.system().symbols()) {
      if (mentions(symbol.name)) {
        told.emplace_back(symbol.symbol);
      }
    }
    return points_.point_text(point, told);
  }

  /// Whether the call of the program has this name in it.
  [[nodiscard]] bool mentions(const std::string& name) const {
    std::string text = run_.program.result;
    for (const std::string& line : run_.program.before) {
      text += " " + line;
    }
    const auto in_name = [&](std::size_t at) {
      return at < text.size() &&
             (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
    };
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
      if ((at == 0 || !in_name(at - 1)) && !in_name(at + name.size())) {
        return true;
      }
    }
    return false;
  }

  /// What rounding may do, or nothing where that hides everything.
  [[nodiscard]] std::optional<double> tolerance(std::size_t entry, const Asked& asked) const {
    const GiNaC::ex derived = points_.system().expanded(expected_.derived[entry]);
    const RoundedValue value = rounded_value(derived, asked.values);
    const double by_rounding = value.error * half_ulp * other_orders;
    if (!(by_rounding <= blurred * (1 + std::abs(value.value)))) {
      return std::nullopt;
    }
    return by_rounding + value.error * run_.rounding;
  }

  /// Takes the point as the entry's counterexample if it is one, and simpler than the last.
  [[nodiscard]] bool differs(std::size_t entry, Asked& asked, Finding& finding) {
    const std::optional<double> allowed = tolerance(entry, asked);
    const double derived = value_at(expected_.derived[entry], asked.point);
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
    try {
      for (Asked& asked : asked_) {
        const std::optional<double> allowed = tolerance(entry, asked);
        told += allowed ? 1 : 0;
        wrong = differs(entry, asked, finding) || wrong;
        const double derived = value_at(expected_.derived[entry], asked.point);
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

  void show_simple_points() {
    SimpleValues random;
    std::vector<Asked> list;
    closures::ClosureSystem& system = points_.system();
    for (std::size_t count = 0; count < simple_points; ++count) {
      GiNaC::exmap values;
      for (const closures::AuditSymbol& symbol : system.symbols()) {
        if (symbol.angle) {
          const auto [cosine, sine] = random.direction();
          values[points_.direction(symbol.symbol).x] = cosine;
          values[points_.direction(symbol.symbol).y] = sine;
        } else {
          values[symbol.symbol] = random.length();
        }
        if (symbol.moving) {
          values[symbol.rate] = random.rate();
          values[symbol.second_rate] = random.rate();
        }
      }
      try {
        std::optional<Point> point =
            assembled_ ? points_.assembled_from(values) : Point{values, {}};
        if (point && all_lengths_positive(*point) && is_allowed(*point)) {
          add_point(*point, list);
        }
      } catch (const std::runtime_error&) {  // a value is missing there
      }
    }
    try {
      if (!list.empty()) {
        compute(list, false);
        simple_ = std::move(list);
      }
    } catch (const running::ProgramError&) {  // special places may be too much for it
    }
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
  bool assembled_;  ///< whether the closures hold at the points
  std::vector<Asked> asked_;
  std::vector<Asked> simple_;
  std::vector<double> repeated_;  ///< what the first point gives when it is asked again
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
