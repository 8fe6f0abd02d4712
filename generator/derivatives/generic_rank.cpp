#include "derivatives/generic_rank.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "equations/seeded_numbers.hpp"

namespace assur::generator::derivatives {

namespace {

constexpr unsigned wanted_points = 3;
constexpr unsigned most_draws = 20;
constexpr int decimal_digits = 60;
/// What is smaller is zero but for the rounding of roots.
constexpr int digits_of_zero = 40;

using Row = std::vector<GiNaC::numeric>;

/// Raises the number of digits of roots for as long as it lives.
class MoreDigits {
 public:
  MoreDigits() : before_(GiNaC::Digits) { GiNaC::Digits = decimal_digits; }
  ~MoreDigits() { GiNaC::Digits = before_; }
  MoreDigits(const MoreDigits&) = delete;
  MoreDigits& operator=(const MoreDigits&) = delete;

 private:
  long before_;
};

bool is_nothing(const GiNaC::numeric& number) {
  return GiNaC::abs(number) < GiNaC::pow(GiNaC::numeric(10), GiNaC::numeric(-digits_of_zero));
}

GiNaC::numeric value_of(const GiNaC::ex& expression, const GiNaC::exmap& values) {
  const GiNaC::ex value = expression.subs(values, GiNaC::subs_options::no_pattern).expand();
  return GiNaC::ex_to<GiNaC::numeric>(value);
}

/// Values of all variables and names; nothing where a denominator vanishes. Roots may be imaginary,
/// which changes no generic rank.
std::optional<GiNaC::exmap> random_point(const equations::ImplicitEquations& equations,
                                         unsigned seed) {
  equations::SeededNumbers random(seed);
  GiNaC::exmap values;
  for (const std::deque<equations::Variable>* list :
       {&equations.unknowns, &equations.dimensions, &equations.inputs}) {
    for (const equations::Variable& variable : *list) {
      const equations::Vector2 direction = random.direction();
      values[variable.cosine] = direction.x;
      values[variable.sine] = direction.y;
      values[variable.value] = random.number();
    }
  }
  using Form = equations::NamedQuantity::Form;
  for (const equations::NamedQuantity& quantity : equations.vocabulary.quantities()) {
    GiNaC::numeric value = value_of(quantity.definition, values);
    if (quantity.form == Form::reciprocal && is_nothing(value)) {
      return std::nullopt;
    }
    values[quantity.symbol] = quantity.form == Form::reciprocal    ? value.inverse()
                              : quantity.form == Form::square_root ? GiNaC::sqrt(value)
                                                                   : value;
  }
  return values;
}

/// By elimination, which takes the largest entry of each column.
unsigned rank_of(std::vector<Row> rows, std::size_t columns) {
  std::size_t rank = 0;
  for (std::size_t column = 0; column < columns && rank < rows.size(); ++column) {
    const auto from = rows.begin() + static_cast<std::ptrdiff_t>(rank);
    const auto pivot = std::max_element(from, rows.end(), [&](const Row& one, const Row& other) {
      return GiNaC::abs(one[column]) < GiNaC::abs(other[column]);
    });
    if (is_nothing((*pivot)[column])) {
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

}  // namespace

unsigned generic_rank(const equations::ImplicitEquations& equations,
                      const ExpressionMatrix& jacobian) {
  const MoreDigits digits;
  unsigned rank = 0;
  unsigned points = 0;
  for (unsigned seed = 1; seed <= most_draws && points < wanted_points; ++seed) {
    const std::optional<GiNaC::exmap> values = random_point(equations, seed);
    if (!values) {
      continue;
    }
    std::vector<Row> rows;
    for (const std::vector<GiNaC::ex>& entries : jacobian) {
      Row row;
      std::transform(entries.begin(), entries.end(), std::back_inserter(row),
                     [&](const GiNaC::ex& entry) { return value_of(entry, *values); });
      rows.push_back(std::move(row));
    }
    rank = std::max(rank, rank_of(std::move(rows), equations.unknowns.size()));
    ++points;
  }
  return rank;
}

}  // namespace assur::generator::derivatives
