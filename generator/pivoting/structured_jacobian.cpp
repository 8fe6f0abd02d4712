#include "pivoting/structured_jacobian.hpp"

#include <algorithm>
#include <assur/text/names.hpp>
#include <numeric>

#include "error.hpp"
#include "pivoting/trigonometric_factors.hpp"

namespace assur::generator::pivoting {

namespace {

using Matrix = std::vector<std::vector<GiNaC::ex>>;

Matrix without(const Matrix& matrix, std::size_t row, std::size_t column) {
  Matrix rest;
  for (std::size_t index = 0; index < matrix.size(); ++index) {
    if (index == row) {
      continue;
    }
    std::vector<GiNaC::ex>& line = rest.emplace_back();
    for (std::size_t place = 0; place < matrix[index].size(); ++place) {
      if (place != column) {
        line.push_back(matrix[index][place]);
      }
    }
  }
  return rest;
}

/// Sum over the permutations; `alternating` makes it the determinant, otherwise the permanent.
GiNaC::ex expansion(const Matrix& matrix, bool alternating) {
  if (matrix.empty()) {
    return 1;
  }
  GiNaC::ex sum;
  for (std::size_t column = 0; column < matrix.size(); ++column) {
    const GiNaC::ex part = matrix[0][column] * expansion(without(matrix, 0, column), alternating);
    sum += alternating && column % 2 == 1 ? -part : part;
  }
  return sum.expand();
}

bool is_unit(const GiNaC::ex& value) { return value.is_equal(1) || value.is_equal(-1); }

bool is_negated(const GiNaC::ex& value) {
  return !GiNaC::is_a<GiNaC::symbol>(value) && GiNaC::is_a<GiNaC::symbol>(-value);
}

/// The text of a value without minus signs.
std::string text_of(const GiNaC::ex& value) {
  std::ostringstream text;
  text << value;
  std::string name = text.str();
  std::erase(name, '-');
  return name;
}

bool needs_name(const GiNaC::ex& value) {
  return !GiNaC::is_a<GiNaC::numeric>(value) && !GiNaC::is_a<GiNaC::symbol>(value) &&
         !GiNaC::is_a<GiNaC::symbol>(-value);
}

int sign_of(std::vector<std::size_t> permutation) {
  int sign = 1;
  for (std::size_t place = 0; place < permutation.size(); ++place) {
    while (permutation[place] != place) {
      std::swap(permutation[place], permutation[permutation[place]]);
      sign = -sign;
    }
  }
  return sign;
}

}  // namespace

StructuredJacobian::StructuredJacobian(const equations::ClosureEquations& equations)
    : closures_(equations), vocabulary_(closures_.vocabulary()) {
  fill_entries();
  order_elimination();
  name_pivots();
  divide_once();
}

void StructuredJacobian::fill_entries() {
  const equations::ClosureEquations& equations = closures_.equations();
  entries_.resize(closures_.row_count());
  for (const equations::Variable& unknown : equations.unknowns) {
    const std::vector<GiNaC::ex> column = closures_.derivative(unknown);
    for (std::size_t row = 0; row < entries_.size(); ++row) {
      entries_[row].push_back(column[row]);
    }
  }
  if (equations.unknowns.size() != entries_.size()) {
    throw GeneratorError("pivoting", equations.model->title(), "the Jacobian is not square");
  }
}

void StructuredJacobian::order_elimination() {
  std::vector<std::size_t> rows(entries_.size());
  std::iota(rows.begin(), rows.end(), 0);
  std::vector<std::size_t> unknowns = rows;
  const auto not_zero = [&](std::size_t row, std::size_t unknown) {
    return !entry(row, unknown).is_zero();
  };
  const auto take = [&](std::size_t row, std::size_t unknown) {
    std::erase(rows, row);
    std::erase(unknowns, unknown);
    return EliminationStep{row, unknown};
  };
  const auto peel = [&] {
    for (const std::size_t unknown : unknowns) {
      const auto holds = [&](std::size_t row) { return not_zero(row, unknown); };
      if (std::count_if(rows.begin(), rows.end(), holds) == 1) {
        last_.insert(last_.begin(), take(*std::find_if(rows.begin(), rows.end(), holds), unknown));
        return true;
      }
    }
    for (const std::size_t row : rows) {
      const auto held = [&](std::size_t unknown) { return not_zero(row, unknown); };
      if (std::count_if(unknowns.begin(), unknowns.end(), held) == 1) {
        first_.push_back(take(row, *std::find_if(unknowns.begin(), unknowns.end(), held)));
        return true;
      }
    }
    return false;
  };
  // The last row remains as a core: its pivot shows where the group as a whole is singular.
  while (rows.size() > 1 && peel()) {
  }
  core_rows_ = rows;
  core_unknowns_ = unknowns;

  std::vector<std::size_t> row_order;
  std::vector<std::size_t> unknown_order;
  const auto append = [&](const std::vector<EliminationStep>& steps) {
    for (const EliminationStep& step : steps) {
      row_order.push_back(step.row);
      unknown_order.push_back(step.unknown);
    }
  };
  append(first_);
  row_order.insert(row_order.end(), core_rows_.begin(), core_rows_.end());
  unknown_order.insert(unknown_order.end(), core_unknowns_.begin(), core_unknowns_.end());
  append(last_);
  sign_ = sign_of(row_order) * sign_of(unknown_order);
}

std::string StructuredJacobian::readable(const GiNaC::ex& value) const {
  for (const equations::Variable& dimension : closures_.equations().dimensions) {
    if (value.is_equal(dimension.sine) || value.is_equal(-dimension.sine)) {
      return "sin(" + dimension.name + ")";
    }
  }
  return text_of(value);
}

/// The determinant of a core of one or two rows in its entries; of a larger core only its size.
std::string StructuredJacobian::core_text() const {
  const Core matrix = core();
  const auto product = [](const std::vector<GiNaC::ex>& factors, int sign) {
    std::string text;
    for (const GiNaC::ex& factor : factors) {
      sign *= is_negated(factor) || factor.is_equal(-1) ? -1 : 1;
      text += (text.empty() ? "" : " ") + text_of(factor);
    }
    return (sign < 0 ? "-" : "") + text;
  };
  if (matrix.size() == 1) {
    return product({matrix[0][0]}, 1);
  }
  if (matrix.size() > 2) {
    return "det(core of " + std::to_string(matrix.size()) + ")";
  }
  const std::string first = product({matrix[0][0], matrix[1][1]}, 1);
  const std::string second = product({matrix[0][1], matrix[1][0]}, -1);
  return "(" + first + (second[0] == '-' ? " - " + second.substr(1) : " + " + second) + ")";
}

std::string StructuredJacobian::determinant_text() const {
  int sign = sign_;
  std::string text;
  for (const Pivot& pivot : pivots_) {
    const bool negative = pivot.text[0] == '-';
    sign *= negative ? -1 : 1;
    text += (text.empty() ? "" : " ") + pivot.text.substr(negative ? 1 : 0);
  }
  return (sign < 0 ? "-" : "") + text;
}

StructuredJacobian::Core StructuredJacobian::core() const {
  Core matrix;
  for (const std::size_t row : core_rows_) {
    std::vector<GiNaC::ex>& line = matrix.emplace_back();
    for (const std::size_t unknown : core_unknowns_) {
      line.push_back(entry(row, unknown));
    }
  }
  return matrix;
}

void StructuredJacobian::name_pivots() {
  const equations::ClosureEquations& equations = closures_.equations();
  const std::vector<GiNaC::ex> sizes = closures_.row_size();
  std::vector<std::vector<GiNaC::ex>> bounds;
  for (const equations::Variable& unknown : equations.unknowns) {
    bounds.push_back(closures_.derivative_bound(unknown));
  }
  const auto unit = [&](std::size_t row, std::size_t unknown) {
    return equations.unknowns[unknown].is_angle() ? sizes[row] : GiNaC::ex(1);
  };
  Core terms;
  Core units;
  for (const std::size_t row : core_rows_) {
    terms.emplace_back();
    units.emplace_back();
    for (const std::size_t unknown : core_unknowns_) {
      const bool zero = entry(row, unknown).is_zero();
      terms.back().push_back(zero ? GiNaC::ex(0) : bounds[unknown][row]);
      units.back().push_back(zero ? GiNaC::ex(0) : unit(row, unknown));
    }
  }
  core_terms_ = expansion(terms, false);
  const GiNaC::ex determinant = expansion(core(), true);
  if (determinant.is_zero()) {
    throw GeneratorError("pivoting", equations.model->title(), "the Jacobian has no pivot");
  }
  name_core_pivots(determinant, expansion(units, false));
  for (const auto* steps : {&first_, &last_}) {
    for (const EliminationStep& step : *steps) {
      const GiNaC::ex& value = entry(step.row, step.unknown);
      if (is_unit(value)) {
        sign_ *= value.is_equal(-1) ? -1 : 1;
      } else {
        const equations::Variable& unknown = equations.unknowns[step.unknown];
        const std::string text = readable(value);
        pivots_.push_back({value, unit(step.row, step.unknown),
                           (is_negated(value) ? "-" : "") + text, text + " = 0",
                           text + " = 0: " + unknown.name + " free to first order"});
      }
    }
  }
}

void StructuredJacobian::name_core_pivots(const GiNaC::ex& determinant, const GiNaC::ex& size) {
  const equations::ClosureEquations& equations = closures_.equations();
  const std::string names = text::joined(
      core_unknowns_, ", ", [&](std::size_t unknown) { return equations.unknowns[unknown].name; });
  const std::string meaning = ": " + names + " free to first order";
  const std::optional<TrigonometricProduct> product =
      trigonometric_product(vocabulary_.expand(determinant), equations);
  if (product) {
    int sign = product->sign;
    for (const TrigonometricFactor& factor : product->factors) {
      const equations::Vector2 direction = named_direction(factor.angle, vocabulary_);
      const std::string text = (factor.sine ? "sin(" : "cos(") + factor.angle.text() + ")";
      pivots_.push_back({sign * (factor.sine ? direction.y : direction.x), 1,
                         (sign < 0 ? "-" : "") + text, text + " = 0", text + " = 0" + meaning});
      sign = 1;
    }
  } else {
    GiNaC::ex value = determinant;
    if (needs_name(determinant)) {
      const GiNaC::symbol symbol("determinant");
      vocabulary_.define(symbol, determinant, "determinant of the core");
      value = symbol;
    }
    const std::string cause =
        core_rows_.size() == 1 ? text_of(determinant) + " = 0" : std::string("a dead centre");
    pivots_.push_back({value, size, core_text(), cause, cause + meaning});
  }
  core_pivot_count_ = pivots_.size();
}

/// One division serves all pivots: 1/p = (1/product) * product of the others.
void StructuredJacobian::divide_once() {
  std::vector<GiNaC::ex> values;
  std::string degeneracies;
  for (const Pivot& pivot : pivots_) {
    const bool known = std::any_of(values.begin(), values.end(), [&](const GiNaC::ex& value) {
      return (value - pivot.value).is_zero() || (value + pivot.value).is_zero();
    });
    if (!known) {
      values.push_back(pivot.value);
    }
    degeneracies += (degeneracies.empty() ? "" : ", or ") + pivot.cause;
  }
  GiNaC::ex product = 1;
  for (const GiNaC::ex& value : values) {
    product *= value;
  }
  if (needs_name(product)) {
    const GiNaC::symbol symbol("pivot_product");
    vocabulary_.define(symbol, product, "product of the pivots");
    product = symbol;
  }
  const GiNaC::ex reciprocal = vocabulary_.name_reciprocal("inverse", product, degeneracies);
  for (const GiNaC::ex& value : values) {
    GiNaC::ex others = 1;
    for (const GiNaC::ex& other : values) {
      others *= &other == &value ? GiNaC::ex(1) : other;
    }
    GiNaC::ex inverse = reciprocal * others;
    if (needs_name(inverse)) {
      const GiNaC::symbol symbol("inverse_" + text_of(value));
      vocabulary_.define(symbol, inverse, "one over the pivot");
      inverse = symbol;
    }
    inverses_.emplace_back(value, inverse);
  }
}

GiNaC::ex StructuredJacobian::inverse_of(const GiNaC::ex& pivot) const {
  if (is_unit(pivot)) {
    return pivot;
  }
  for (const auto& [value, inverse] : inverses_) {
    if ((value - pivot).is_zero()) {
      return inverse;
    }
    if ((value + pivot).is_zero()) {
      return -inverse;
    }
  }
  throw GeneratorError("pivoting", closures_.equations().model->title(), "unknown pivot");
}

std::vector<GiNaC::ex> StructuredJacobian::solve_core(const std::vector<GiNaC::ex>& rhs) const {
  const Core matrix = core();
  std::vector<GiNaC::ex> solution;
  for (std::size_t place = 0; place < matrix.size(); ++place) {
    GiNaC::ex sum;
    for (std::size_t equation = 0; equation < matrix.size(); ++equation) {
      const GiNaC::ex minor = expansion(without(matrix, equation, place), true);
      sum += ((equation + place) % 2 == 0 ? 1 : -1) * minor * rhs[equation];
    }
    for (std::size_t pivot = 0; pivot < core_pivot_count_; ++pivot) {
      sum *= inverse_of(pivots_[pivot].value);
    }
    solution.push_back(sum);
  }
  return solution;
}

std::vector<GiNaC::ex> StructuredJacobian::solve(const std::vector<GiNaC::ex>& rhs,
                                                 const std::vector<GiNaC::symbol>& symbols,
                                                 const std::string& meaning,
                                                 equations::Vocabulary& names) const {
  return solve(rhs, symbols, meaning, names,
               [&](std::size_t row, const std::vector<GiNaC::ex>& solved) {
                 GiNaC::ex sum;
                 for (std::size_t unknown = 0; unknown < solved.size(); ++unknown) {
                   sum += entry(row, unknown) * solved[unknown];
                 }
                 return sum;
               });
}

std::vector<GiNaC::ex> StructuredJacobian::solve(const std::vector<GiNaC::ex>& rhs,
                                                 const std::vector<GiNaC::symbol>& symbols,
                                                 const std::string& meaning,
                                                 equations::Vocabulary& names,
                                                 const KnownPart& known_part) const {
  std::vector<GiNaC::ex> solved(entries_.size());
  const auto rest_of = [&](std::size_t row) {
    return (rhs[row] - known_part(row, solved)).expand();
  };
  const auto keep = [&](std::size_t unknown, const GiNaC::ex& value) {
    solved[unknown] = value.expand();
    if (needs_name(solved[unknown])) {
      names.define(symbols[unknown], solved[unknown], meaning);
      solved[unknown] = symbols[unknown];
    }
  };
  const auto step_through = [&](const std::vector<EliminationStep>& steps) {
    for (const EliminationStep& step : steps) {
      keep(step.unknown, rest_of(step.row) * inverse_of(entry(step.row, step.unknown)));
    }
  };
  step_through(first_);
  std::vector<GiNaC::ex> rests;
  for (const std::size_t row : core_rows_) {
    rests.push_back(rest_of(row));
  }
  const std::vector<GiNaC::ex> core_solution = solve_core(rests);
  for (std::size_t place = 0; place < core_solution.size(); ++place) {
    keep(core_unknowns_[place], core_solution[place]);
  }
  step_through(last_);
  return solved;
}

StructuredJacobian StructuredJacobian::transposed() const {
  const auto backwards = [](const std::vector<EliminationStep>& steps) {
    std::vector<EliminationStep> result;
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
      result.push_back({step->unknown, step->row});
    }
    return result;
  };
  StructuredJacobian result = *this;
  for (std::size_t row = 0; row < entries_.size(); ++row) {
    for (std::size_t unknown = 0; unknown < entries_.size(); ++unknown) {
      result.entries_[unknown][row] = entries_[row][unknown];
    }
  }
  result.first_ = backwards(last_);
  result.last_ = backwards(first_);
  std::swap(result.core_rows_, result.core_unknowns_);
  return result;
}

}  // namespace assur::generator::pivoting
