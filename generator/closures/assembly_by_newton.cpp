#include "closures/assembly_by_newton.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "closures/circle_algebra.hpp"
#include "equations/more_digits.hpp"
#include "equations/symbols.hpp"

namespace assur::generator::closures {

namespace {

constexpr int starts = 24;
constexpr int most_steps = 60;
/// Few of each draw, so that the points come from many draws; the seed selects them.
constexpr std::size_t most_solutions = 4;
/// Equations count as independent if no pivot of J J^T is smaller than this part of the largest.
constexpr double least_pivot = 1e-9;
/// Solutions closer than this, relative to their size, are the same.
constexpr double same = 1e-6;
/// Numbers smaller than this, relative to the size, are zero: none comes so near by chance.
constexpr int zero_digits = 80;

double as_double(double value) { return value; }
double as_double(const GiNaC::numeric& value) { return value.to_double(); }

double power_of(double base, int exponent) { return std::pow(base, exponent); }
GiNaC::numeric power_of(const GiNaC::numeric& base, int exponent) {
  if (exponent < 0 && base.is_zero()) {
    throw NotAlgebraic("division by zero");
  }
  return base.power(exponent);
}

/// Solves a symmetric system in place, row by row with its right-hand side. Returns whether its
/// pivots are of similar size.
template <typename Number>
bool solve(std::vector<std::vector<Number>>& rows) {
  const std::size_t size = rows.size();
  double largest = 0;
  for (std::size_t column = 0; column < size; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column; row < size; ++row) {
      if (std::abs(as_double(rows[row][column])) > std::abs(as_double(rows[pivot][column]))) {
        pivot = row;
      }
    }
    std::swap(rows[column], rows[pivot]);
    const double here = std::abs(as_double(rows[column][column]));
    largest = std::max(largest, here);
    if (!(here > least_pivot * largest)) {
      return false;
    }
    for (std::size_t row = 0; row < size; ++row) {
      if (row == column) {
        continue;
      }
      const Number factor = rows[row][column] / rows[column][column];
      for (std::size_t place = column; place <= size; ++place) {
        rows[row][place] = rows[row][place] - factor * rows[column][place];
      }
    }
  }
  for (std::size_t row = 0; row < size; ++row) {
    rows[row][size] = rows[row][size] / rows[row][row];
  }
  return true;
}

}  // namespace

/// The values of numbers, symbols and steps.
template <typename Number>
struct AssemblyByNewton::Values {
  std::vector<Number> numbers;
  std::vector<Number> symbols;
  std::vector<Number> sizes;  ///< of the variables; equations and steps are measured in these units
  std::vector<Number> steps;

  void compute(const std::vector<Step>& list) {
    steps.clear();
    for (const Step& step : list) {
      Number value = 0;
      switch (step.kind) {
        case Step::Kind::number:
          value = numbers[step.place];
          break;
        case Step::Kind::symbol:
          value = symbols[step.place];
          break;
        case Step::Kind::sum:
          for (const std::size_t operand : step.operands) {
            value = value + steps[operand];
          }
          break;
        case Step::Kind::product:
          value = 1;
          for (const std::size_t operand : step.operands) {
            value = value * steps[operand];
          }
          break;
        case Step::Kind::power:
          value = power_of(steps[step.operands[0]], step.exponent);
          break;
      }
      steps.push_back(value);
    }
  }
};

AssemblyByNewton::AssemblyByNewton(const std::vector<GiNaC::ex>& equations,
                                   std::vector<Variable> variables)
    : variables_(std::move(variables)), equation_count_(equations.size()) {
  const equations::MoreDigits digits(solution_digits);
  for (const Variable& variable : variables_) {
    symbols_.emplace_back(variable.symbol);
  }
  for (const GiNaC::ex& equation : equations) {
    equations_.push_back(step_of(equation));
  }
  for (const GiNaC::numeric& number : numbers_) {
    if (GiNaC::abs(number) > size_) {
      size_ = GiNaC::abs(number);
    }
  }
  for (const GiNaC::ex& equation : equations) {
    for (const Variable& variable : variables_) {
      slopes_.push_back(step_of(equation.diff(variable.symbol)));
    }
  }
}

std::size_t AssemblyByNewton::added(const GiNaC::ex& expression, Step step) {
  steps_.push_back(std::move(step));
  return known_[expression] = steps_.size() - 1;
}

std::size_t AssemblyByNewton::step_of(const GiNaC::ex& expression) {
  if (const auto found = known_.find(expression); found != known_.end()) {
    return found->second;
  }
  using Kind = Step::Kind;
  if (GiNaC::is_a<GiNaC::symbol>(expression)) {
    const auto place = std::ranges::find_if(
        symbols_, [&](const GiNaC::ex& known) { return known.is_equal(expression); });
    const auto number = static_cast<std::size_t>(place - symbols_.begin());
    if (place == symbols_.end()) {
      symbols_.push_back(expression);
    }
    return added(expression, {Kind::symbol, number});
  }
  if (equations::symbols_of(expression).empty()) {
    const GiNaC::ex value =
        GiNaC::is_a<GiNaC::numeric>(expression) ? expression : expression.evalf();
    if (!GiNaC::is_a<GiNaC::numeric>(value) || !GiNaC::ex_to<GiNaC::numeric>(value).is_real()) {
      throw NotAlgebraic("a number that has no real value");
    }
    numbers_.push_back(GiNaC::ex_to<GiNaC::numeric>(value));
    return added(expression, {Kind::number, numbers_.size() - 1});
  }
  if (GiNaC::is_a<GiNaC::power>(expression) && expression.op(1).info(GiNaC::info_flags::integer)) {
    const std::size_t base = step_of(expression.op(0));
    const int exponent = GiNaC::ex_to<GiNaC::numeric>(expression.op(1)).to_int();
    return added(expression, {Kind::power, 0, exponent, {base}});
  }
  if (GiNaC::is_a<GiNaC::add>(expression) || GiNaC::is_a<GiNaC::mul>(expression)) {
    std::vector<std::size_t> operands;
    for (const GiNaC::ex& operand : expression) {
      operands.push_back(step_of(operand));
    }
    return added(expression, {GiNaC::is_a<GiNaC::add>(expression) ? Kind::sum : Kind::product, 0, 0,
                              std::move(operands)});
  }
  throw NotAlgebraic("an equation is no quotient of polynomials");
}

template <typename Number>
bool AssemblyByNewton::correction(Values<Number>& values, std::vector<Number>& step) const {
  values.compute(steps_);
  const std::size_t columns = variables_.size();
  const auto slope = [&](std::size_t row, std::size_t column) -> Number {
    return values.steps[slopes_[row * columns + column]] * values.sizes[column];
  };
  // The shortest solution of J x = -f is J^T (J J^T)^-1 (-f). Rows of J are of similar sizes.
  std::vector<std::vector<Number>> rows(equation_count_, std::vector<Number>(equation_count_ + 1));
  std::vector<Number> scales;
  for (std::size_t row = 0; row < equation_count_; ++row) {
    double steepest = 0;
    for (std::size_t column = 0; column < columns; ++column) {
      steepest = std::max(steepest, std::abs(as_double(slope(row, column))));
    }
    scales.push_back(Number(steepest > 0 ? std::exp2(-std::ilogb(steepest)) : 1.0));
  }
  for (std::size_t row = 0; row < equation_count_; ++row) {
    for (std::size_t other = 0; other < equation_count_; ++other) {
      Number sum = 0;
      for (std::size_t column = 0; column < columns; ++column) {
        sum = sum + slope(row, column) * slope(other, column);
      }
      rows[row][other] = scales[row] * scales[other] * sum;
    }
    rows[row][equation_count_] = -scales[row] * values.steps[equations_[row]];
  }
  if (!solve(rows)) {
    return false;
  }
  step.assign(columns, Number(0));
  for (std::size_t column = 0; column < columns; ++column) {
    for (std::size_t row = 0; row < equation_count_; ++row) {
      step[column] = step[column] + scales[row] * slope(row, column) * rows[row][equation_count_];
    }
    step[column] = step[column] * values.sizes[column];
  }
  return true;
}

bool AssemblyByNewton::converges(Values<double>& values) const {
  std::vector<double> step;
  for (int count = 0; count < most_steps; ++count) {
    if (!correction(values, step)) {
      return false;
    }
    double length = 0;
    double whole = 1;
    for (std::size_t place = 0; place < step.size(); ++place) {
      length = std::max(length, std::abs(step[place]) / values.sizes[place]);
      whole = std::max(whole, std::abs(values.symbols[place]) / values.sizes[place]);
    }
    if (!std::isfinite(length)) {
      return false;
    }
    const double factor = std::min(1.0, whole / length);  // limits the step
    for (std::size_t place = 0; place < step.size(); ++place) {
      values.symbols[place] += factor * step[place];
    }
    if (length <= 1e-11 * whole) {
      return true;
    }
  }
  return false;
}

bool AssemblyByNewton::polish(Values<GiNaC::numeric>& values) const {
  constexpr int most = 6;  // each step doubles the number of digits
  std::vector<GiNaC::numeric> step;
  double last = 1;
  for (int count = 0; count < most; ++count) {
    if (!correction(values, step)) {
      return false;
    }
    last = 0;
    for (std::size_t place = 0; place < step.size(); ++place) {
      values.symbols[place] += step[place];
      last = std::max(last, std::abs(step[place].to_double()));
    }
  }
  const double whole = std::max(1.0, size_.to_double());
  return last <= std::pow(10.0, 10 - solution_digits) * whole;
}

std::vector<GiNaC::exmap> AssemblyByNewton::solutions(const GiNaC::exmap& given,
                                                      unsigned seed) const {
  const equations::MoreDigits digits(solution_digits);
  Values<double> rough;
  Values<GiNaC::numeric> exact;
  for (const GiNaC::numeric& number : numbers_) {
    exact.numbers.push_back(number);
    rough.numbers.push_back(number.to_double());
  }
  double size = 2;
  for (const GiNaC::ex& symbol : symbols_) {
    const auto value = given.find(symbol);
    const bool is_given = value != given.end() && exact.symbols.size() >= variables_.size();
    exact.symbols.push_back(is_given ? GiNaC::ex_to<GiNaC::numeric>(value->second) : 0);
    rough.symbols.push_back(exact.symbols.back().to_double());
    size = std::max(size, std::abs(rough.symbols.back()));
  }
  size = std::max(size, size_.to_double());
  const auto size_of = [&](std::size_t place) {
    return variables_[place].is_direction ? 1.0 : size;
  };
  for (std::size_t place = 0; place < variables_.size(); ++place) {
    rough.sizes.push_back(size_of(place));
    exact.sizes.emplace_back(std::exp2(std::ilogb(size_of(place))));
  }
  const GiNaC::numeric least = GiNaC::numeric(size) / GiNaC::numeric(10).power(zero_digits);
  std::mt19937 engine(seed);
  std::vector<std::vector<double>> found;
  std::vector<GiNaC::exmap> list;
  for (int start = 0; start < starts && list.size() < most_solutions; ++start) {
    for (std::size_t place = 0; place < variables_.size(); ++place) {
      const double number = static_cast<double>(engine()) / 0x1p31 - 1;
      rough.symbols[place] =
          size_of(place) * (variables_[place].is_root ? std::abs(number) : number);
    }
    if (!converges(rough)) {
      continue;
    }
    const auto is_same = [&](const std::vector<double>& other) {
      for (std::size_t place = 0; place < variables_.size(); ++place) {
        if (std::abs(other[place] - rough.symbols[place]) > same * size_of(place)) {
          return false;
        }
      }
      return true;
    };
    const bool is_negative = std::ranges::any_of(variables_, [&](const Variable& variable) {
      return variable.is_root &&
             rough.symbols[static_cast<std::size_t>(&variable - variables_.data())] <= same;
    });
    if (is_negative || std::ranges::any_of(found, is_same)) {
      continue;
    }
    found.push_back(rough.symbols);
    for (std::size_t place = 0; place < variables_.size(); ++place) {
      exact.symbols[place] = GiNaC::numeric(rough.symbols[place]);
    }
    if (!polish(exact)) {
      continue;
    }
    GiNaC::exmap solution;
    for (std::size_t place = 0; place < variables_.size(); ++place) {
      const GiNaC::numeric& value = exact.symbols[place];
      solution[variables_[place].symbol] = GiNaC::abs(value) < least ? GiNaC::numeric(0) : value;
    }
    list.push_back(std::move(solution));
  }
  return list;
}

}  // namespace assur::generator::closures
