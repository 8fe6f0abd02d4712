#include "audit/run_reference.hpp"

#include <algorithm>
#include <cmath>

#include "closures/formula_text.hpp"

namespace assur::generator::audit {

std::vector<GivenQuantity> given_quantities(const closures::ClosureSystem& system,
                                            const AskedPoints& drawing) {
  std::vector<GivenQuantity> given;
  for (const closures::AuditSymbol& symbol : system.symbols()) {
    given.push_back({symbol.name, &symbol, 0, symbol.symbol});
    if (drawing.has_rates(symbol)) {
      given.push_back({"rate_" + symbol.name, &symbol, 1, symbol.rate});
      given.push_back({"rate2_" + symbol.name, &symbol, 2, symbol.second_rate});
    }
  }
  return given;
}

DerivedReference::DerivedReference(closures::ClosurePoints& points, const ExpectedMatrix& expected,
                                   double rounding)
    : expected_(expected), rounding_(rounding), drawn_(expected) {
  for (GiNaC::ex& derived : drawn_.derived) {
    expressions_.push_back(points.system().expanded(derived));
    const GiNaC::ex cosine = GiNaC::cos(derived);
    angles_.push_back(points.obstacle(derived) && !points.obstacle(cosine));
    if (angles_.back()) {
      derived = cosine;  // the cosine is algebraic; the angle itself is not
    }
  }
}

std::string DerivedReference::text(std::size_t entry) const {
  return closures::formula_text(expected_.derived[entry]);
}

std::vector<std::vector<ExpectedValue>> DerivedReference::at(std::vector<Asked>& list,
                                                             AskedPoints& drawing,
                                                             const Precision& precision) {
  std::vector<std::vector<ExpectedValue>> values;
  for (Asked& asked : list) {
    values.emplace_back();
    for (std::size_t entry = 0; entry < expressions_.size(); ++entry) {
      values.back().push_back(value_at(entry, asked, drawing, precision));
    }
  }
  return values;
}

double DerivedReference::slack(const Precision& precision) const {
  constexpr double far_below_a_slip = 1e-9;
  return std::max({far_below_a_slip, precision.unit * precision.other_orders, rounding_});
}

ExpectedValue DerivedReference::value_at(std::size_t entry, Asked& asked, AskedPoints& drawing,
                                         const Precision& precision) const {
  ExpectedValue expected;
  try {
    const RoundedValue rounded = rounded_value(expressions_[entry], asked.values);
    expected.value =
        angles_[entry] ? rounded.value : drawing.value_at(expected_.derived[entry], asked.point);
    const double by_rounding = rounded.error * precision.unit * precision.other_orders;
    if (by_rounding <= precision.blurred * (1 + std::abs(rounded.value))) {
      expected.tolerance = by_rounding + rounded.error * rounding_;
    }
  } catch (const closures::NotAlgebraic& error) {
    expected.obstacle = error.what();
  }
  return expected;
}

}  // namespace assur::generator::audit
