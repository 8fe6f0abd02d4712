#include "audit/rounding_bound.hpp"

#include <algorithm>
#include <cmath>

#include "closures/numeric_matrix.hpp"

namespace assur::generator::audit {

namespace {

double as_double(const GiNaC::ex& value) {
  const GiNaC::ex decimal = value.evalf();
  if (!GiNaC::is_a<GiNaC::numeric>(decimal) || !GiNaC::ex_to<GiNaC::numeric>(decimal).is_real()) {
    throw closures::NotAlgebraic("a value that is no real number");
  }
  return GiNaC::ex_to<GiNaC::numeric>(decimal).to_double();
}

RoundedValue rounded(double value, double error) { return {value, error + std::abs(value)}; }

/// f(x), given its value and the slope of f at x.
RoundedValue through(const RoundedValue& x, double value, double slope) {
  return rounded(value, std::abs(slope) * x.error);
}

class Evaluator {
 public:
  explicit Evaluator(const SymbolValues& values) : values_(values) {}

  RoundedValue operator()(const GiNaC::ex& e) const {
    if (const auto known = values_.find(e); known != values_.end()) {
      return known->second;
    }
    if (GiNaC::is_a<GiNaC::numeric>(e) || GiNaC::is_a<GiNaC::constant>(e)) {
      return rounded(as_double(e), 0);
    }
    if (GiNaC::is_a<GiNaC::add>(e)) {
      return sum(e);
    }
    if (GiNaC::is_a<GiNaC::mul>(e)) {
      return product(e);
    }
    if (GiNaC::is_a<GiNaC::power>(e)) {
      const RoundedValue base = (*this)(e.op(0));
      const double exponent = (*this)(e.op(1)).value;
      const double value = std::pow(base.value, exponent);
      return through(base, value, exponent * std::pow(base.value, exponent - 1));
    }
    if (GiNaC::is_a<GiNaC::function>(e)) {
      return function(e);
    }
    throw closures::NotAlgebraic("a symbol without a value");
  }

 private:
  [[nodiscard]] RoundedValue sum(const GiNaC::ex& e) const {
    RoundedValue total;
    for (const GiNaC::ex& term : e) {
      const RoundedValue next = (*this)(term);
      total = rounded(total.value + next.value, total.error + next.error);
    }
    return total;
  }

  [[nodiscard]] RoundedValue product(const GiNaC::ex& e) const {
    RoundedValue all{1, 0};
    for (const GiNaC::ex& factor : e) {
      const RoundedValue next = (*this)(factor);
      all = rounded(all.value * next.value,
                    all.error * std::abs(next.value) + next.error * std::abs(all.value));
    }
    return all;
  }

  [[nodiscard]] RoundedValue function(const GiNaC::ex& e) const {
    const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
    const RoundedValue x = (*this)(e.op(0));
    const double root = std::sqrt(1 - x.value * x.value);
    if (name == "sin") return through(x, std::sin(x.value), std::cos(x.value));
    if (name == "cos") return through(x, std::cos(x.value), std::sin(x.value));
    if (name == "tan") return through(x, std::tan(x.value), 1 / std::pow(std::cos(x.value), 2));
    if (name == "asin") return through(x, std::asin(x.value), 1 / root);
    if (name == "acos") return through(x, std::acos(x.value), 1 / root);
    if (name == "atan") return through(x, std::atan(x.value), 1 / (1 + x.value * x.value));
    if (name == "atan2") {
      const RoundedValue below = (*this)(e.op(1));
      const double square = x.value * x.value + below.value * below.value;
      return rounded(std::atan2(x.value, below.value),
                     (std::abs(below.value) * x.error + std::abs(x.value) * below.error) / square);
    }
    throw closures::NotAlgebraic("the function '" + name + "' has no value here");
  }

  const SymbolValues& values_;
};

/// The condition number of J x = b, J the Jacobian: the largest row sum of |J^-1| |J|, at least 1.
double condition(const closures::ClosurePoints::Point& point) {
  const GiNaC::matrix& inverse = point.inverse_jacobian;
  if (inverse.is_zero_matrix()) {
    return 1;  // no unknown is solved for
  }
  const GiNaC::matrix jacobian = closures::inverse_of(inverse);
  double largest = 1;
  for (unsigned row = 0; row < inverse.rows(); ++row) {
    double all = 0;
    for (unsigned middle = 0; middle < inverse.rows(); ++middle) {
      for (unsigned column = 0; column < inverse.rows(); ++column) {
        all += std::abs(as_double(inverse(row, middle)) * as_double(jacobian(middle, column)));
      }
    }
    largest = std::max(largest, all);
  }
  return largest;
}

}  // namespace

SymbolValues symbol_values(closures::ClosurePoints& points,
                           const closures::ClosurePoints::Point& point) {
  SymbolValues values;
  double solving = 0;
  for (const auto& [symbol, value] : point.values) {
    const double number = as_double(value);
    values[symbol] = rounded(number, 0);
  }
  const auto solved = [&](const GiNaC::symbol& symbol, double size) {
    if (const auto found = values.find(symbol); found != values.end()) {
      solving = solving == 0 ? condition(point) : solving;
      found->second.error = 8 * solving * (size + std::abs(found->second.value));
    }
  };
  closures::ClosureSystem& system = points.system();
  for (const auto& [symbol, value] : point.values) {
    if (system.derivative_of(symbol) != nullptr) {
      solved(GiNaC::ex_to<GiNaC::symbol>(symbol), 1);
    }
  }
  double longest = 0;
  for (const closures::AuditSymbol& symbol : system.symbols()) {
    if (!symbol.angle) {
      longest = std::max(longest, std::abs(values.at(symbol.symbol).value));
    }
  }
  for (const closures::AuditSymbol& symbol : system.symbols()) {
    if (symbol.angle) {
      const equations::Vector2 direction = points.direction(symbol.symbol);
      const double angle = std::atan2(values.at(direction.y).value, values.at(direction.x).value);
      values[symbol.symbol] = rounded(angle, 0);
    }
    if (symbol.unknown) {  // computed from all lengths, also if zero
      solved(symbol.symbol, symbol.angle ? 1 : longest);
    }
  }
  return values;
}

RoundedValue rounded_value(const GiNaC::ex& expression, const SymbolValues& values) {
  return Evaluator(values)(expression);
}

}  // namespace assur::generator::audit
