#include "closures/closure_points.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "closures/formula_text.hpp"
#include "closures/numeric_matrix.hpp"
#include "equations/more_digits.hpp"
#include "equations/seeded_numbers.hpp"
#include "equations/symbols.hpp"

namespace assur::generator::closures {

namespace {

/// Rational numbers of few digits, so that a point can be checked by hand.
class FewDigits {
 public:
  explicit FewDigits(unsigned seed) : numbers_(seed) {}

  GiNaC::numeric length() { return {integer(5, 30), 10}; }
  GiNaC::numeric rate() {
    const int tenths = integer(-20, 20);
    return {tenths == 0 ? 21 : tenths, 10};  // statements about rest must not hold by chance
  }
  /// A rational point of the unit circle off the axes.
  std::pair<GiNaC::numeric, GiNaC::numeric> direction() {
    const int n = integer(2, 7);
    const int m = integer(1, n - 1);
    const GiNaC::numeric size(n * n + m * m);
    const GiNaC::numeric one = (integer(0, 1) == 0 ? -1 : 1) * GiNaC::numeric(n * n - m * m) / size;
    const GiNaC::numeric other = (integer(0, 1) == 0 ? -1 : 1) * GiNaC::numeric(2 * n * m) / size;
    return integer(0, 1) == 0 ? std::pair(one, other) : std::pair(other, one);
  }

 private:
  int integer(int low, int high) { return numbers_.integer(low, high); }

  equations::SeededNumbers numbers_;
};

/// Whether a solved length is so small that the closures may hold because of it.
bool vanishes_nearly(const GiNaC::ex& length) {
  return GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(length)) < GiNaC::numeric(1, 1000);
}

/// A length unlike all others: statements for equal lengths must not hold by chance.
GiNaC::numeric another(GiNaC::numeric length, std::vector<GiNaC::numeric>& lengths) {
  while (std::ranges::find(lengths, length) != lengths.end()) {
    length += GiNaC::numeric(1, 10);
  }
  lengths.push_back(length);
  return length;
}

/// A value as text: exact, or twelve digits of a decimal or of a long number.
std::string value_text(const GiNaC::ex& value) {
  if (value.info(GiNaC::info_flags::rational) || !GiNaC::is_a<GiNaC::numeric>(value)) {
    return formula_text(value);
  }
  std::ostringstream text;
  text.precision(12);
  text << GiNaC::ex_to<GiNaC::numeric>(value).to_double();
  return text.str();
}

}  // namespace

void ClosurePoints::follow_system() {
  if (revision_ == system_.revision()) {
    return;
  }
  revision_ = system_.revision();
  for (; angles_ < system_.symbols().size(); ++angles_) {
    if (const AuditSymbol& symbol = system_.symbols()[angles_]; symbol.angle) {
      algebra_.add_angle(symbol.symbol);
    }
  }
  lists_.clear();
  assembly_.reset();
  newton_.reset();
  of_all_factors_.reset();
  open_parts_.clear();
  closures_are_algebraic_ = true;
  closures_are_rational_ = true;
  for (const ClosureSystem::Closure& closure : system_.closures()) {
    try {  // the roots of closures get numbers before those of expressions
      const GiNaC::ex form = algebraic(closure.expression);
      closures_are_rational_ =
          closures_are_rational_ && !makes_roots(form) && algebra_.root_count() == 0;
    } catch (const NotAlgebraic&) {
      closures_are_algebraic_ = false;  // reported when it is needed
    }
  }
}

GiNaC::ex ClosurePoints::algebraic(const GiNaC::ex& expression) {
  follow_system();
  return algebra_.algebraic(system_.expanded(expression));
}

void ClosurePoints::solve_for(const GiNaC::ex& whole, Point& point) {
  for (const GiNaC::ex& symbol : equations::symbols_of(whole)) {
    if (point.values.contains(symbol)) {
      continue;
    }
    if (const ClosureDerivative* const derivative = system_.derivative_of(symbol)) {
      solve(*derivative, point);
    } else if (const AuditSymbol* const moved = system_.moved_by(symbol)) {
      // A rate of third or higher order may be any number, a different one at each point.
      point.values[symbol] = moved->steady ? GiNaC::numeric(0) : FewDigits(++rates_drawn_).rate();
    }
  }
}

GiNaC::ex ClosurePoints::value(const GiNaC::ex& expression, Point& point) {
  const GiNaC::ex whole = system_.expanded(expression);
  solve_for(whole, point);
  if (!makes_roots(whole)) {
    return value_of_form(algebra_, algebra_.algebraic(whole), point);
  }
  // Roots of one expression must not make another undecidable.
  CircleAlgebra own = algebra_.extended();
  const GiNaC::ex form = own.algebraic(whole);
  return value_of_form(own, form, point);
}

GiNaC::ex ClosurePoints::value_of_form(const CircleAlgebra& algebra, const GiNaC::ex& form,
                                       const Point& point, unsigned reversed) {
  const GiNaC::ex value = algebra.at(form, point.values, reversed);
  if (!point.is_computed || GiNaC::is_a<GiNaC::numeric>(value)) {
    return value;
  }
  const equations::MoreDigits digits(solution_digits);  // for roots of numbers
  return value.evalf();
}

std::optional<std::string> ClosurePoints::obstacle(const GiNaC::ex& expression) {
  follow_system();
  const GiNaC::ex whole = system_.expanded(expression);
  try {
    if (makes_roots(whole)) {
      CircleAlgebra own = algebra_.extended();
      static_cast<void>(own.algebraic(whole));
    } else {
      static_cast<void>(algebra_.algebraic(whole));
    }
    return std::nullopt;
  } catch (const NotAlgebraic& error) {
    return error.what();
  }
}

bool ClosurePoints::vanishes(const GiNaC::ex& expression) {
  follow_system();
  const GiNaC::ex whole = system_.expanded(expression);
  CircleAlgebra own = algebra_.extended();
  const GiNaC::ex form = own.algebraic(whole);
  return own.vanishes(form);
}

bool ClosurePoints::assemble(GiNaC::exmap& values) {
  follow_system();
  if (!assembly_) {
    std::vector<GiNaC::ex> equations;
    for (const ClosureSystem::Closure& closure : system_.closures()) {
      equations.push_back(algebraic(closure.expression));
    }
    GiNaC::lst lengths;
    for (const AuditSymbol& symbol : system_.symbols()) {
      if (!symbol.angle && !algebra_.under_a_root(symbol.symbol)) {
        lengths.append(symbol.symbol);
      }
    }
    assembly_.emplace(std::move(equations), lengths);
  }
  return assembly_->assemble(algebra_, values);
}

GiNaC::matrix ClosurePoints::values_of(const std::vector<GiNaC::ex>& expressions,
                                       const Point& point) {
  GiNaC::matrix column(static_cast<unsigned>(expressions.size()), 1);
  for (unsigned row = 0; row < expressions.size(); ++row) {
    column(row, 0) = value_of_form(algebra_, algebraic(expressions[row]), point);
  }
  return column;
}

std::optional<GiNaC::matrix> ClosurePoints::jacobian(const Point& point) {
  const std::vector<const AuditSymbol*> solved = system_.unknowns();
  if (solved.empty() || solved.size() != system_.closures().size()) {
    return std::nullopt;
  }
  const auto size = static_cast<unsigned>(solved.size());
  GiNaC::matrix jacobian(size, size);
  for (unsigned column = 0; column < size; ++column) {
    std::vector<GiNaC::ex> slopes;
    for (const ClosureSystem::Closure& closure : system_.closures()) {
      slopes.push_back(system_.slope(closure.expression, solved[column]->symbol));
    }
    const GiNaC::matrix values = values_of(slopes, point);
    for (unsigned row = 0; row < size; ++row) {
      jacobian(row, column) = values(row, 0);
    }
  }
  return jacobian;
}

void ClosurePoints::invert_jacobian(Point& point) {
  if (const std::optional<GiNaC::matrix> values = jacobian(point)) {
    point.inverse_jacobian = inverse_of(*values);
  }
}

const std::vector<GiNaC::ex>& ClosurePoints::open_parts(const ClosureDerivative& derivative) {
  follow_system();
  std::vector<GiNaC::ex>& open = open_parts_[&derivative];
  if (open.empty()) {
    GiNaC::exmap at_rest;
    for (const GiNaC::symbol& symbol : system_.symbols_of(derivative)) {
      at_rest[symbol] = 0;
    }
    for (const GiNaC::ex& equation : system_.equations_of(derivative)) {
      open.push_back(equation.subs(at_rest, GiNaC::subs_options::no_pattern));
    }
  }
  return open;
}

void ClosurePoints::solve(const ClosureDerivative& derivative, Point& point) {
  const std::vector<GiNaC::ex>& open = open_parts(derivative);
  for (const GiNaC::ex& part : open) {
    solve_for(system_.expanded(part), point);
  }
  if (point.inverse_jacobian.rows() != open.size()) {
    throw NotAlgebraic("total derivatives need as many closures as unknowns");
  }
  const GiNaC::matrix solution = point.inverse_jacobian.mul(values_of(open, point)).mul_scalar(-1);
  unsigned row = 0;
  for (const GiNaC::symbol& symbol : system_.symbols_of(derivative)) {
    point.values[symbol] = solution(row++, 0).expand();
  }
}

GiNaC::exmap ClosurePoints::random_values(unsigned seed) const {
  FewDigits random(seed);
  std::vector<GiNaC::numeric> lengths;
  GiNaC::exmap values;
  for (const AuditSymbol& symbol : system_.symbols()) {
    if (symbol.angle) {
      const auto [cosine, sine] = random.direction();
      values[algebra_.direction(symbol.symbol).x] = cosine;
      values[algebra_.direction(symbol.symbol).y] = sine;
    } else {
      values[symbol.symbol] = another(random.length(), lengths);
    }
    if (symbol.moving) {
      values[symbol.rate] = random.rate();
      values[symbol.second_rate] = random.rate();
      if (symbol.steady) {
        values[symbol.second_rate] = 0;
      }
    }
  }
  return values;
}

std::optional<ClosurePoints::Point> ClosurePoints::draw(unsigned seed, bool assembled,
                                                        bool different_lengths) {
  Point point{random_values(seed), {}};
  if (!assembled) {
    return point;
  }
  try {
    if (!closures_are_rational_ || !assemble(point.values) ||
        is_special(point.values, different_lengths)) {
      return std::nullopt;
    }
    invert_jacobian(point);
  } catch (const std::runtime_error&) {  // a singular Jacobian
    return std::nullopt;
  }
  return point;
}

bool ClosurePoints::is_special(const GiNaC::exmap& values, bool different_lengths) const {
  GiNaC::exset sizes = {0};
  return std::ranges::any_of(system_.symbols(), [&](const AuditSymbol& symbol) {
    if (symbol.angle) {
      return false;
    }
    const GiNaC::ex& value = values.at(symbol.symbol);
    return value.is_zero() || (different_lengths && !sizes.insert(GiNaC::abs(value)).second);
  });
}

std::vector<ClosurePoints::Point> ClosurePoints::solved_points(unsigned seed) {
  if (!newton_) {
    newton_.emplace(newton());
  }
  GiNaC::exmap values = random_values(seed);
  if (seed % 2 == 0) {  // lengths of the magnitude of the numbers in the closures
    for (const AuditSymbol& symbol : system_.symbols()) {
      if (!symbol.angle) {
        values[symbol.symbol] *= newton_->size();
      }
    }
  }
  unsigned quadrant = seed;  // each quadrant in turn
  for (const AuditSymbol& symbol : system_.symbols()) {
    if (symbol.angle && !symbol.unknown) {
      const equations::Vector2& direction = algebra_.direction(symbol.symbol);
      values[direction.x] = GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(values[direction.x])) *
                            (quadrant % 4 < 2 ? 1 : -1);
      values[direction.y] = GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(values[direction.y])) *
                            (quadrant % 2 == 0 ? 1 : -1);
      quadrant = quadrant / 4 + seed / 3;
    }
  }
  std::vector<Point> points;
  for (const GiNaC::exmap& solution : newton_->solutions(values, seed)) {
    Point point{values, {}, true};
    for (const auto& [symbol, value] : solution) {
      point.values[symbol] = value;
    }
    const bool is_degenerate = std::ranges::any_of(system_.symbols(), [&](const AuditSymbol& one) {
      return !one.angle && !one.unknown && vanishes_nearly(point.values.at(one.symbol));
    });
    if (is_degenerate) {
      continue;
    }
    try {
      invert_jacobian(point);
      points.push_back(std::move(point));
    } catch (const std::runtime_error&) {  // the Jacobian is singular
      continue;
    }
  }
  return points;
}

std::deque<ClosurePoints::Point>& ClosurePoints::points_of_all_factors() {
  constexpr unsigned draws = 4;
  follow_system();
  if (!of_all_factors_) {
    of_all_factors_.emplace();
    try {
      for (unsigned seed = 1; seed <= draws; ++seed) {
        std::ranges::move(solved_points(seed), std::back_inserter(*of_all_factors_));
      }
    } catch (const NotAlgebraic&) {
      of_all_factors_->clear();
    }
  }
  return *of_all_factors_;
}

AssemblyByNewton ClosurePoints::newton() {
  std::vector<GiNaC::ex> equations;
  for (const ClosureSystem::Closure& closure : system_.closures()) {
    equations.push_back(algebraic(closure.expression));
  }
  // If the numbers of unknowns and closures differ, any symbol may be solved for.
  const bool square = system_.unknowns().size() == equations.size();
  std::vector<AssemblyByNewton::Variable> variables;
  for (const AuditSymbol& symbol : system_.symbols()) {
    if (square && !symbol.unknown) {
      continue;
    }
    if (!symbol.angle) {
      variables.push_back({symbol.symbol});
      continue;
    }
    const equations::Vector2& direction = algebra_.direction(symbol.symbol);
    equations.push_back(direction.x * direction.x + direction.y * direction.y - 1);
    variables.push_back({GiNaC::ex_to<GiNaC::symbol>(direction.x), false, true});
    variables.push_back({GiNaC::ex_to<GiNaC::symbol>(direction.y), false, true});
  }
  for (const auto& [root, radicand] : algebra_.roots()) {
    equations.push_back(root * root - radicand);
    variables.push_back({root, true});
  }
  return {equations, std::move(variables)};
}

std::optional<ClosurePoints::Point> ClosurePoints::assembled_from(const GiNaC::exmap& values) {
  follow_system();
  Point point{values, {}};
  try {
    const auto is_rational = [](const auto& value) {
      return value.second.info(GiNaC::info_flags::rational);
    };
    if (!algebra_.roots_are_rational(point.values) || !assemble(point.values) ||
        !std::ranges::all_of(point.values, is_rational)) {
      return std::nullopt;
    }
    invert_jacobian(point);
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
  return point;
}

equations::Vector2 ClosurePoints::direction(const GiNaC::symbol& angle) {
  follow_system();
  return algebra_.direction(angle);
}

ClosurePoints::Point* ClosurePoints::point(std::size_t index, bool assembled) {
  constexpr unsigned most_draws = 400;
  constexpr unsigned most_solved = 100;
  follow_system();
  if (assembled && !closures_are_algebraic_) {
    return nullptr;
  }
  PointList& list = lists_[assembled];
  while (list.drawn.size() <= index) {
    if (list.next_seed > most_draws) {
      if (!list.different_lengths) {
        if (!assembled || list.next_solved > most_solved) {
          return nullptr;
        }
        std::ranges::move(solved_points(list.next_solved++), std::back_inserter(list.drawn));
        continue;
      }
      list.different_lengths = false;
      list.next_seed = 1;
    }
    if (std::optional<Point> point = draw(list.next_seed++, assembled, list.different_lengths)) {
      list.drawn.push_back(std::move(*point));
    }
  }
  return &list.drawn[index];
}

GiNaC::exset ClosurePoints::needed_symbols(const std::vector<GiNaC::ex>& shown, bool assembled) {
  GiNaC::exset needed;
  const auto add = [&](std::vector<GiNaC::ex> open) {
    while (!open.empty()) {
      const GiNaC::ex next = system_.expanded(open.back());
      open.pop_back();
      for (const GiNaC::ex& symbol : equations::symbols_of(next)) {
        if (!needed.insert(symbol).second) {
          continue;
        }
        if (const ClosureDerivative* const derivative = system_.derivative_of(symbol)) {
          std::ranges::move(system_.equations_of(*derivative), std::back_inserter(open));
        }
      }
    }
  };
  add(shown);
  const auto is_needed_unknown = [&](const AuditSymbol& symbol) {
    return symbol.unknown && needed.contains(symbol.symbol);
  };
  if (assembled && std::ranges::any_of(system_.symbols(), is_needed_unknown)) {
    for (const ClosureSystem::Closure& closure : system_.closures()) {
      add({closure.expression});
    }
  }
  return needed;
}

std::string ClosurePoints::point_text(const Point& point, const std::vector<GiNaC::ex>& shown,
                                      bool assembled) {
  const GiNaC::exset needed = needed_symbols(shown, assembled);
  std::string text;
  const auto add = [&](const std::string& name, const std::string& value) {
    text += (text.empty() ? "" : ", ") + name + " = " + value;
  };
  for (const AuditSymbol& symbol : system_.symbols()) {
    if (!needed.contains(symbol.symbol)) {
      continue;
    }
    if (symbol.angle) {
      const equations::Vector2& direction = algebra_.direction(symbol.symbol);
      add("(cos, sin)(" + symbol.name + ")", "(" + value_text(point.values.at(direction.x)) + ", " +
                                                 value_text(point.values.at(direction.y)) + ")");
    } else {
      add(symbol.name, value_text(point.values.at(symbol.symbol)));
    }
  }
  for (const bool given : {true, false}) {  // rates of parameters, then derivatives of unknowns
    std::map<std::string, std::string> values;
    for (const GiNaC::ex& symbol : needed) {
      const bool is_rate = system_.moved_by(symbol) != nullptr;
      const bool is_derivative = system_.derivative_of(symbol) != nullptr;
      const auto value = point.values.find(symbol);
      if (value != point.values.end() && (given ? is_rate : is_derivative)) {
        values[GiNaC::ex_to<GiNaC::symbol>(symbol).get_name()] = value_text(value->second);
      }
    }
    for (const auto& [name, value] : values) {
      add(name, value);
    }
  }
  return text;
}

}  // namespace assur::generator::closures
