#include "audit/own_position.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

#include "audit/extrapolated_derivative.hpp"
#include "closures/read_formula.hpp"

namespace assur::generator::audit {

namespace {

using closures::AuditSymbol;
using closures::FormulaError;
using closures::PlacedText;

/// The largest step as a part of the quantity's scale, and the number of halvings.
constexpr double first_step = 0.5;
constexpr std::size_t step_count = 8;
/// A step whose square vanishes beside 1.
constexpr double complex_step = 0x1p-80;
/// The assumed error of a position, in units in its last place.
constexpr double position_units = 64;

/// The scale of a quantity: itself, or one radian.
double scale_of(const AuditSymbol& symbol, const Asked& asked) {
  const double size = std::abs(asked.values.at(symbol.symbol).value);
  return symbol.angle || size == 0 ? 1 : size;
}

const AuditSymbol& parameter(const PlacedText& name, const closures::ClosureSystem& system) {
  const AuditSymbol* const symbol = system.symbol_named(name.text);
  if (symbol == nullptr || symbol->unknown) {
    throw FormulaError(symbol == nullptr
                           ? "no symbol named '" + name.text + "'"
                           : "'" + name.text + "' is an unknown; an own position is " +
                                 "differentiated by parameters and by the time",
                       name.place);
  }
  return *symbol;
}

std::size_t component(const std::string& name, std::vector<std::string>& components) {
  const auto found = std::find(components.begin(), components.end(), name);
  const auto index = static_cast<std::size_t>(found - components.begin());
  if (found == components.end()) {
    components.push_back(name);
  }
  return index;
}

/// `rate(x)` as `rate` and `x`; nothing for a formula of another form.
std::pair<std::string, std::vector<PlacedText>> derivative_parts(const PlacedText& formula) {
  const std::size_t open = formula.text.find('(');
  if (open == std::string::npos || !formula.text.ends_with(')')) {
    return {};
  }
  const std::size_t inside = formula.text.size() - open - 2;
  const std::vector<PlacedText> arguments =
      closures::split({formula.text.substr(open + 1, inside), formula.at(open + 2)}, ',');
  const bool are_names = std::all_of(arguments.begin(), arguments.end(), [](const auto& each) {
    return text::is_identifier(each.text);
  });
  return {closures::trimmed({formula.text.substr(0, open), formula.place}).text,
          are_names ? arguments : std::vector<PlacedText>{}};
}

}  // namespace

OwnDerivatives read_own_derivatives(const PlacedText& columns, const PlacedText& rows,
                                    bool is_transposed, const closures::ClosureSystem& system) {
  OwnDerivatives own;
  const auto add = [&](const std::string& item, const std::string& meaning,
                       const OwnDerivative& entry) {
    own.expected.items.push_back(item);
    own.expected.derived.push_back(GiNaC::symbol(meaning));
    own.entries.push_back(entry);
  };
  own.expected.on_closures = !system.closures().empty();
  if (!columns.empty()) {
    const std::vector<PlacedText> names = closures::words(rows);
    const std::vector<PlacedText> parameters = closures::words(columns);
    for (std::size_t row = 0; row < names.size(); ++row) {
      if (!text::is_identifier(names[row].text)) {
        throw FormulaError("expected the name of a component of the position", names[row].place);
      }
      if (component(names[row].text, own.components) != row) {
        throw FormulaError("'" + names[row].text + "' occurs twice", names[row].place);
      }
    }
    own.expected.size = {names.size(), parameters.size()};
    if (is_transposed) {
      std::swap(own.expected.size.rows, own.expected.size.columns);
    }
    for (std::size_t place = 0; place < names.size() * parameters.size(); ++place) {
      const std::size_t down = place / own.expected.size.columns;
      const std::size_t across = place % own.expected.size.columns;
      const std::size_t row = is_transposed ? across : down;
      const PlacedText& by = parameters[is_transposed ? down : across];
      add("(" + std::to_string(down + 1) + "," + std::to_string(across + 1) + ") d " +
              names[row].text + "/d " + by.text,
          "D(" + names[row].text + ", " + by.text + ")", {row, &parameter(by, system), 1});
    }
    return own;
  }
  for (const PlacedText& formula : closures::split(rows, ',')) {
    const auto [operation, arguments] = derivative_parts(formula);
    const bool by_time = operation == "rate" || operation == "rate2";
    if (arguments.size() != (by_time ? 1 : 2) || (!by_time && operation != "D")) {
      throw FormulaError("expected rate(NAME), rate2(NAME) or D(NAME, PARAMETER) of a position",
                         formula.place);
    }
    add(formula.text, formula.text,
        {component(arguments[0].text, own.components),
         by_time ? nullptr : &parameter(arguments[1], system), operation == "rate2" ? 2 : 1});
  }
  own.expected.size = {own.entries.size(), 1};
  return own;
}

/// A path through a point: one parameter changes, or all moving quantities change with time.
struct OwnPosition::Path {
  const AuditSymbol* by;
  double unit;  ///< scale of the parameter or the time

  [[nodiscard]] double change(const GivenQuantity& quantity, const Asked& asked,
                              double distance) const {
    if (by != nullptr) {
      return quantity.of == by && quantity.order == 0 ? distance : 0;
    }
    if (!quantity.of->moving) {
      return 0;
    }
    const double first = asked.values.at(quantity.of->rate).value;
    const double second = asked.values.at(quantity.of->second_rate).value;
    return quantity.order == 0   ? distance * (first + distance * second / 2)
           : quantity.order == 1 ? distance * second
                                 : 0;
  }
  /// The imaginary part of the quantity after an imaginary step, whose square, and so the change of
  /// the real part, vanishes.
  [[nodiscard]] double imaginary_change(const GivenQuantity& quantity, const Asked& asked) const {
    if (by == nullptr && quantity.of->moving && quantity.order < 2) {
      const GiNaC::symbol& rate =
          quantity.order == 0 ? quantity.of->rate : quantity.of->second_rate;
      return complex_step * unit * asked.values.at(rate).value;
    }
    return change(quantity, asked, complex_step * unit);
  }
};

/// The positions at all points of a list and around them.
class OwnPosition::Samples {
 public:
  Samples(const closures::ClosureSystem& system, const OwnDerivatives& wanted,
          const RunStatement& run, const running::RunLimits& limits, const std::vector<Asked>& list,
          const AskedPoints& drawing)
      : complex_(running::takes_complex_numbers(run.program.language)),
        given_(given_quantities(system, drawing)) {
    for (const OwnDerivative& each : wanted.entries) {
      if (std::find(directions_.begin(), directions_.end(), each.by) == directions_.end()) {
        directions_.push_back(each.by);
      }
    }
    for (const GivenQuantity& quantity : given_) {
      table_.names.push_back(quantity.name);
    }
    for (const Asked& asked : list) {
      add_rows(asked);
    }
    running::UserProgram position = run.program;
    position.result = run.position.text;
    position.entry.clear();
    values_ = running::program_values(position, {wanted.components.size(), 1}, table_, limits);
  }

  [[nodiscard]] double unit(const OwnDerivative& wanted, std::size_t point) const {
    return paths_[point * directions_.size() + direction(wanted)].unit;
  }
  [[nodiscard]] double middle(const OwnDerivative& wanted, std::size_t point) const {
    return entry(first_row(point), wanted.component);
  }
  [[nodiscard]] SymmetricSamples around(const OwnDerivative& wanted, std::size_t point) const {
    SymmetricSamples samples;
    samples.middle = middle(wanted, point);
    samples.first_step = first_step * unit(wanted, point);
    const std::size_t row = first_row(wanted, point);
    for (std::size_t at = 0; at < step_count; ++at) {
      samples.above.push_back(entry(row + 2 * at, wanted.component));
      samples.below.push_back(entry(row + 2 * at + 1, wanted.component));
    }
    return samples;
  }
  /// The first derivative by a complex step; not finite where the program has no value.
  [[nodiscard]] double by_complex_step(const OwnDerivative& wanted, std::size_t point) const {
    const std::size_t row = first_row(wanted, point) + 2 * step_count;
    const bool known = complex_ && row < values_.points.size() &&
                       values_.points[row].faults[wanted.component].empty();
    return known ? values_.points[row].imaginary[wanted.component] /
                       (complex_step * unit(wanted, point))
                 : std::numeric_limits<double>::quiet_NaN();
  }
  /// Why there is no position at a point; empty if there is one.
  [[nodiscard]] std::string failure(const OwnDerivative& wanted, std::size_t point) const {
    const std::size_t row = first_row(point);
    return row < values_.points.size() ? values_.points[row].faults[wanted.component]
                                       : "it stopped before this point";
  }
  [[nodiscard]] bool is_single() const { return values_.single_precision; }

 private:
  void add_rows(const Asked& asked) {
    const auto add = [&](const std::function<double(const GivenQuantity&)>& real,
                         const std::function<double(const GivenQuantity&)>& imaginary) {
      std::vector<double> reals;
      std::vector<double> imaginaries;
      for (const GivenQuantity& quantity : given_) {
        reals.push_back(asked.values.at(quantity.symbol).value + real(quantity));
        imaginaries.push_back(imaginary(quantity));
      }
      table_.points.push_back(std::move(reals));
      if (complex_) {
        table_.imaginary.push_back(std::move(imaginaries));
      }
    };
    const auto nothing = [](const GivenQuantity&) { return 0.0; };
    add(nothing, nothing);
    for (const AuditSymbol* by : directions_) {
      const Path path{by, by == nullptr ? time_unit(asked) : scale_of(*by, asked)};
      paths_.push_back(path);
      double step = first_step * path.unit;
      for (std::size_t at = 0; at < step_count; ++at, step /= 2) {
        for (const double distance : {step, -step}) {
          add([&](const GivenQuantity& each) { return path.change(each, asked, distance); },
              nothing);
        }
      }
      if (complex_) {
        add(nothing, [&](const GivenQuantity& each) { return path.imaginary_change(each, asked); });
      }
    }
  }

  /// The time in which the fastest quantity changes by its scale.
  [[nodiscard]] double time_unit(const Asked& asked) const {
    double fastest = 0;
    for (const GivenQuantity& quantity : given_) {
      if (quantity.of->moving && quantity.order == 0) {
        const double scale = scale_of(*quantity.of, asked);
        const double first = std::abs(asked.values.at(quantity.of->rate).value) / scale;
        const double second = std::abs(asked.values.at(quantity.of->second_rate).value) / scale;
        fastest = std::max({fastest, first, std::sqrt(second)});
      }
    }
    return fastest == 0 ? 1 : 1 / fastest;
  }

  [[nodiscard]] std::size_t direction(const OwnDerivative& wanted) const {
    return static_cast<std::size_t>(std::find(directions_.begin(), directions_.end(), wanted.by) -
                                    directions_.begin());
  }
  [[nodiscard]] std::size_t rows_of_path() const { return 2 * step_count + (complex_ ? 1 : 0); }
  [[nodiscard]] std::size_t first_row(std::size_t point) const {
    return point * (1 + directions_.size() * rows_of_path());
  }
  [[nodiscard]] std::size_t first_row(const OwnDerivative& wanted, std::size_t point) const {
    return first_row(point) + 1 + direction(wanted) * rows_of_path();
  }
  [[nodiscard]] double entry(std::size_t row, std::size_t component) const {
    const bool real = row < values_.points.size() &&
                      values_.points[row].faults[component].empty() &&
                      (!complex_ || values_.points[row].imaginary[component] == 0);
    return real ? values_.points[row].entries[component] : std::numeric_limits<double>::quiet_NaN();
  }

  bool complex_;
  std::vector<GivenQuantity> given_;
  std::vector<const AuditSymbol*> directions_;
  std::vector<Path> paths_;  ///< of each point, in the order of the directions
  running::PointTable table_;
  running::ProgramValues values_;
};

OwnPosition::OwnPosition(const closures::ClosureSystem& system, const OwnDerivatives& wanted,
                         const RunStatement& run, const running::RunLimits& limits)
    : system_(system), wanted_(wanted), run_(run), limits_(limits) {
  drawn_ = wanted.expected;
  drawn_.derived.clear();
  const auto& symbols = system.symbols();
  const bool moves = std::any_of(symbols.begin(), symbols.end(),
                                 [](const AuditSymbol& symbol) { return symbol.moving; });
  const bool by_time = std::any_of(wanted.entries.begin(), wanted.entries.end(),
                                   [](const OwnDerivative& each) { return each.by == nullptr; });
  if (by_time && !moves) {
    throw FormulaError("nothing moves, so the position has no rate; say what does: 'moving NAME'",
                       run.position.place);
  }
}

std::string OwnPosition::text(std::size_t entry) const {
  std::ostringstream text;
  text << wanted_.expected.derived[entry];
  return text.str();
}

std::vector<std::vector<ExpectedValue>> OwnPosition::at(std::vector<Asked>& list,
                                                        AskedPoints& drawing,
                                                        const Precision& precision) {
  for (const AuditSymbol* unknown : system_.unknowns()) {
    for (const char* prefix : {"", "rate_", "rate2_"}) {
      if (drawing.mentions(prefix + unknown->name)) {
        throw FormulaError("an own position is a function of parameters, and '" + unknown->name +
                               "' is an unknown; without closures it can be 'moving'",
                           run_.position.place);
      }
    }
  }
  const Samples samples(system_, wanted_, run_, limits_, list, drawing);
  const Precision& common = samples.is_single() ? in_single : precision;
  std::vector<std::vector<ExpectedValue>> values;
  for (std::size_t point = 0; point < list.size(); ++point) {
    values.emplace_back();
    for (std::size_t entry = 0; entry < wanted_.entries.size(); ++entry) {
      const ExpectedValue value = expected_value(wanted_.entries[entry], samples, point, common);
      const double error = value.tolerance ? *value.tolerance / in_double.unit : 1e300;
      list[point].values[wanted_.expected.derived[entry]] = {value.value, error};
      values.back().push_back(value);
    }
  }
  return values;
}

ExpectedValue OwnPosition::expected_value(const OwnDerivative& wanted, const Samples& samples,
                                          std::size_t point, const Precision& precision) {
  ExpectedValue expected;
  if (const std::string failure = samples.failure(wanted, point); !failure.empty()) {
    failure_ = failure_.empty() ? failure : failure_;
    expected.exists = false;
    return expected;
  }
  SymmetricSamples around = samples.around(wanted, point);
  double largest = std::abs(around.middle);
  for (const std::vector<double>* side : {&around.above, &around.below}) {
    for (const double value : *side) {
      largest = std::isfinite(value) ? std::max(largest, std::abs(value)) : largest;
    }
  }
  around.error = position_units * precision.unit * largest;
  BoundedValue best = wanted.order == 1 ? first_derivative(around) : second_derivative(around);
  const double size =
      std::abs(best.value) + largest / std::pow(samples.unit(wanted, point), wanted.order);
  const double rounding = precision.unit * precision.other_orders * size;
  const double step = wanted.order == 1 ? samples.by_complex_step(wanted, point)
                                        : std::numeric_limits<double>::quiet_NaN();
  const bool confirmed = std::abs(step - best.value) <= best.bound + rounding;
  const double bound = confirmed ? rounding : best.bound;
  if (!(best.bound <= precision.blurred * (1 + size))) {
    return expected;
  }
  (confirmed ? by_steps_ : by_differences_) += 1;
  largest_bound_ = std::max(largest_bound_, bound);
  expected.value = confirmed ? step : best.value;
  expected.tolerance = bound + rounding + run_.rounding * size;
  return expected;
}

std::string OwnPosition::remark() const {
  std::ostringstream text;
  text.precision(2);
  text << ", against the derivative of its own position by ";
  if (by_steps_ > 0) {
    text << "complex steps";
  }
  if (by_steps_ > 0 && by_differences_ > 0) {
    text << " and, in " << by_differences_ << " of " << by_steps_ + by_differences_ << " values, ";
  }
  if (by_differences_ > 0 || by_steps_ == 0) {
    text << "extrapolated differences";
  }
  text << ", to " << largest_bound_;
  if (!failure_.empty()) {
    text << ", where it has a value (elsewhere " << failure_ << ")";
  }
  return text.str();
}

std::string OwnPosition::why_untold() const {
  return failure_.empty() ? "differences of its position cannot tell its value at nearly all points"
                          : "its position has no value at nearly all points: " + failure_;
}

double OwnPosition::slack(const Precision& /*precision*/) const { return in_double.unit; }

}  // namespace assur::generator::audit
