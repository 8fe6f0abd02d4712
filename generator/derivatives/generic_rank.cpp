#include "derivatives/generic_rank.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>

#include "equations/more_digits.hpp"
#include "equations/seeded_numbers.hpp"

namespace assur::generator::derivatives {

namespace {

constexpr unsigned wanted_points = 4;
constexpr unsigned most_draws = 100;
/// A decimal counts as zero if this many digits cancelled in its sum.
constexpr int digits_of_zero = 40;

using Row = std::vector<GiNaC::numeric>;

/// A value, and the size of its terms if it is a sum. A sum that differs from zero only by the
/// rounding of roots is set to zero.
struct Sized {
  GiNaC::numeric value;
  GiNaC::numeric size;
};
using Values = std::map<GiNaC::ex, GiNaC::numeric, GiNaC::ex_is_less>;

/// Whether a number counts as zero: an exact one if it is zero, others if small beside `size`.
bool is_nothing(const GiNaC::numeric& number, const GiNaC::numeric& size) {
  if (number.is_zero() || number.is_crational()) {
    return number.is_zero();
  }
  return GiNaC::abs(number) <
         size * GiNaC::pow(GiNaC::numeric(10), GiNaC::numeric(-digits_of_zero));
}

Sized measured(const GiNaC::ex& expression, const Values& values) {
  if (const auto known = values.find(expression); known != values.end()) {
    return {known->second, GiNaC::abs(known->second)};
  }
  const bool sum = GiNaC::is_a<GiNaC::add>(expression);
  if (sum || GiNaC::is_a<GiNaC::mul>(expression)) {
    Sized result{sum ? 0 : 1, sum ? 0 : 1};
    for (const GiNaC::ex& part : expression) {
      const Sized one = measured(part, values);
      result = sum ? Sized{result.value + one.value, result.size + one.size}
                   : Sized{result.value * one.value, result.size * one.size};
    }
    if (sum && is_nothing(result.value, result.size)) {
      result.value = 0;
    }
    return result;
  }
  if (GiNaC::is_a<GiNaC::power>(expression)) {  // an integer power, since roots have names
    const auto exponent = GiNaC::ex_to<GiNaC::numeric>(expression.op(1));
    const Sized base = measured(expression.op(0), values);
    return {GiNaC::pow(base.value, exponent), GiNaC::pow(base.size, exponent)};
  }
  const GiNaC::ex constant =
      GiNaC::is_a<GiNaC::numeric>(expression) ? expression : expression.evalf();
  const auto& number = GiNaC::ex_to<GiNaC::numeric>(constant);
  return {number, GiNaC::abs(number)};
}

/// The requirement on the square roots at a random point.
enum class Roots : unsigned char { real, any };

/// Values of all variables and names; empty where a denominator vanishes or a root violates the
/// requirement. With odd seeds lengths are positive, since most roots are real there; with even
/// seeds their signs are alternately mixed and all negative.
std::optional<Values> random_point(const equations::ImplicitEquations& equations, unsigned seed,
                                   Roots roots) {
  equations::SeededNumbers random(seed);
  const bool one_sign = seed % 4 != 2;
  const int sign = seed % 4 == 0 ? -1 : 1;
  Values values;
  for (const std::deque<equations::Variable>* list :
       {&equations.unknowns, &equations.dimensions, &equations.inputs}) {
    for (const equations::Variable& variable : *list) {
      const equations::Vector2 direction = random.direction();
      values[variable.cosine] = GiNaC::ex_to<GiNaC::numeric>(direction.x);
      values[variable.sine] = GiNaC::ex_to<GiNaC::numeric>(direction.y);
      const GiNaC::numeric number = random.number();
      values[variable.value] = one_sign ? sign * GiNaC::abs(number) : number;
    }
  }
  using Form = equations::NamedQuantity::Form;
  for (const equations::NamedQuantity& quantity : equations.vocabulary.quantities()) {
    const GiNaC::numeric value = measured(quantity.definition, values).value;
    const bool imaginary = quantity.form == Form::square_root && !(value.is_real() && value >= 0);
    if ((quantity.form == Form::reciprocal && value.is_zero()) ||
        (roots == Roots::real && imaginary)) {
      return std::nullopt;
    }
    values[quantity.symbol] = quantity.form == Form::reciprocal    ? value.inverse()
                              : quantity.form == Form::square_root ? GiNaC::sqrt(value)
                                                                   : value;
  }
  return values;
}

/// Divides rows, and then columns, by their largest entries, so that all count alike.
void balance(std::vector<Row>& rows, std::size_t columns) {
  const auto larger = [](const GiNaC::numeric& one, const GiNaC::numeric& other) {
    return GiNaC::abs(one) < GiNaC::abs(other) ? GiNaC::abs(other) : GiNaC::abs(one);
  };
  for (Row& row : rows) {
    const GiNaC::numeric size = std::accumulate(row.begin(), row.end(), GiNaC::numeric(0), larger);
    for (GiNaC::numeric& entry : row) {
      entry = size.is_zero() ? entry : entry / size;
    }
  }
  for (std::size_t column = 0; column < columns; ++column) {
    GiNaC::numeric size = 0;
    for (const Row& row : rows) {
      size = larger(size, row[column]);
    }
    for (Row& row : rows) {
      row[column] = size.is_zero() ? row[column] : row[column] / size;
    }
  }
}

/// The rank by elimination, with the largest entry of each column as the pivot.
unsigned rank_of(std::vector<Row> rows, std::size_t columns) {
  balance(rows, columns);
  std::size_t rank = 0;
  for (std::size_t column = 0; column < columns && rank < rows.size(); ++column) {
    const auto from = rows.begin() + static_cast<std::ptrdiff_t>(rank);
    const auto pivot = std::max_element(from, rows.end(), [&](const Row& one, const Row& other) {
      return GiNaC::abs(one[column]) < GiNaC::abs(other[column]);
    });
    if (is_nothing((*pivot)[column], 1)) {
      continue;
    }
    std::iter_swap(from, pivot);
    for (std::size_t below = rank + 1; below < rows.size(); ++below) {
      const GiNaC::numeric factor = rows[below][column] / rows[rank][column];
      for (std::size_t place = column; place < columns; ++place) {
        rows[below][place] -= factor * rows[rank][place];
      }
    }
    ++rank;
  }
  return static_cast<unsigned>(rank);
}

/// The largest rank at a few random points; empty if no such point is found.
std::optional<unsigned> rank_at_points(const equations::ImplicitEquations& equations,
                                       const ExpressionMatrix& jacobian, Roots roots) {
  std::optional<unsigned> rank;
  unsigned points = 0;
  for (unsigned seed = 1; seed <= most_draws && points < wanted_points; ++seed) {
    const std::optional<Values> values = random_point(equations, seed, roots);
    if (!values) {
      continue;
    }
    std::vector<Row> rows;
    for (const std::vector<GiNaC::ex>& entries : jacobian) {
      Row row;
      std::transform(entries.begin(), entries.end(), std::back_inserter(row),
                     [&](const GiNaC::ex& entry) { return measured(entry, *values).value; });
      rows.push_back(std::move(row));
    }
    const unsigned here = rank_of(std::move(rows), equations.unknowns.size());
    rank = std::max(rank.value_or(0), here);
    ++points;
  }
  return rank;
}

}  // namespace

unsigned generic_rank(const equations::ImplicitEquations& equations,
                      const ExpressionMatrix& jacobian) {
  const equations::MoreDigits digits;
  // With imaginary roots, sqrt(x)*sqrt(y) may be -sqrt(x*y), and dependent equations seem
  // independent.
  if (const std::optional<unsigned> rank = rank_at_points(equations, jacobian, Roots::real)) {
    return *rank;
  }
  return rank_at_points(equations, jacobian, Roots::any).value_or(0);
}

}  // namespace assur::generator::derivatives
