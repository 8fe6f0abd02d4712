#include "audit/closure_system.hpp"

#include <algorithm>
#include <random>

#include "audit/formula_text.hpp"

namespace assur::generator {

namespace {

/// Rational numbers of few digits, so that a point can be checked by hand.
class FewDigits {
 public:
  explicit FewDigits(unsigned seed) : engine_(seed) {}

  GiNaC::numeric length() { return GiNaC::numeric(integer(5, 30), 10); }
  GiNaC::numeric rate() { return GiNaC::numeric(integer(-20, 20), 10); }
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
  // std::uniform_int_distribution differs between libraries; the verdicts must not.
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
  }
  std::mt19937 engine_;
};

}  // namespace

AuditSymbol& ClosureSystem::declare(const std::string& name, bool angle,
                                    const std::string& meaning) {
  AuditSymbol& made = symbols_.emplace_back(name, angle, meaning);
  if (angle) {
    algebra_.add_angle(made.symbol);
  }
  points_.clear();
  return made;
}

void ClosureSystem::abbreviate(const std::string& name, const GiNaC::ex& definition) {
  abbreviations_.emplace_back(GiNaC::symbol(name), definition);
}

void ClosureSystem::close(const std::string& name, const GiNaC::ex& expression) {
  closures_.push_back({name, expression});
  points_.clear();
}

void ClosureSystem::negate_closure(const std::string& name) {
  for (Closure& closure : closures_) {
    if (closure.name == name) {
      closure.expression = -closure.expression;
      points_.clear();
    }
  }
}

AuditSymbol* ClosureSystem::symbol_named(const std::string& name) {
  const auto found = std::find_if(symbols_.begin(), symbols_.end(),
                                  [&](const AuditSymbol& symbol) { return symbol.name == name; });
  return found == symbols_.end() ? nullptr : &*found;
}

const GiNaC::ex* ClosureSystem::closure_named(const std::string& name) const {
  const auto found = std::find_if(closures_.begin(), closures_.end(),
                                  [&](const Closure& closure) { return closure.name == name; });
  return found == closures_.end() ? nullptr : &found->expression;
}

std::optional<GiNaC::ex> ClosureSystem::meaning_of(const std::string& name) const {
  for (const AuditSymbol& symbol : symbols_) {
    if (symbol.name == name) {
      return symbol.symbol;
    }
  }
  for (const auto& [symbol, definition] : abbreviations_) {
    if (symbol.get_name() == name) {
      return symbol;
    }
  }
  if (const GiNaC::ex* closure = closure_named(name)) {
    return *closure;
  }
  return std::nullopt;
}

const GiNaC::ex* ClosureSystem::definition_of(const GiNaC::ex& symbol) const {
  const auto found =
      std::find_if(abbreviations_.begin(), abbreviations_.end(),
                   [&](const auto& abbreviation) { return symbol.is_equal(abbreviation.first); });
  return found == abbreviations_.end() ? nullptr : &found->second;
}

bool ClosureSystem::is_known(const std::string& name) const { return meaning_of(name).has_value(); }

std::vector<std::string> ClosureSystem::names() const {
  std::vector<std::string> all;
  for (const AuditSymbol& symbol : symbols_) {
    all.push_back(symbol.name);
  }
  for (const auto& [symbol, definition] : abbreviations_) {
    all.push_back(symbol.get_name());
  }
  for (const Closure& closure : closures_) {
    all.push_back(closure.name);
  }
  return all;
}

GiNaC::ex ClosureSystem::partial(const GiNaC::ex& expression, const GiNaC::symbol& symbol) const {
  GiNaC::ex sum = expression.diff(symbol);
  for (const auto& [name, definition] : abbreviations_) {
    if (expression.has(name)) {
      sum += expression.diff(name) * partial(definition, symbol);
    }
  }
  return sum;
}

GiNaC::ex ClosureSystem::total(const GiNaC::ex& expression, const AuditSymbol& parameter) {
  GiNaC::ex sum = partial(expression, parameter.symbol);
  for (const AuditSymbol* unknown : unknowns()) {
    const GiNaC::ex slope = partial(expression, unknown->symbol);
    if (slope.is_zero()) {
      continue;
    }
    auto known = std::find_if(
        sensitivities_.begin(), sensitivities_.end(), [&](const Sensitivity& sensitivity) {
          return sensitivity.unknown == unknown && sensitivity.parameter == &parameter;
        });
    if (known == sensitivities_.end()) {
      const std::string name = "D(" + unknown->name + ", " + parameter.name + ")";
      sensitivities_.push_back({unknown, &parameter, GiNaC::symbol(name)});
      known = std::prev(sensitivities_.end());
    }
    sum += slope * known->symbol;
  }
  return sum;
}

GiNaC::ex ClosureSystem::rate(const GiNaC::ex& expression) const {
  GiNaC::ex sum;
  for (const AuditSymbol& symbol : symbols_) {
    if (symbol.unknown || symbol.moving) {
      sum += partial(expression, symbol.symbol) * symbol.rate;
      sum += partial(expression, symbol.rate) * symbol.second_rate;
    }
  }
  return sum;
}

GiNaC::ex ClosureSystem::expanded(const GiNaC::ex& expression) const {
  GiNaC::ex result = expression;
  for (auto entry = abbreviations_.rbegin(); entry != abbreviations_.rend(); ++entry) {
    result = result.subs(entry->first == entry->second);
  }
  return result;
}

bool ClosureSystem::follows_closures(const GiNaC::ex& expression) const {
  const GiNaC::ex whole = expanded(expression);
  return std::any_of(sensitivities_.begin(), sensitivities_.end(),
                     [&](const Sensitivity& entry) { return whole.has(entry.symbol); }) ||
         std::any_of(symbols_.begin(), symbols_.end(), [&](const AuditSymbol& symbol) {
           return whole.has(symbol.rate) || whole.has(symbol.second_rate);
         });
}

std::vector<const AuditSymbol*> ClosureSystem::unknowns() const {
  std::vector<const AuditSymbol*> list;
  for (const AuditSymbol& symbol : symbols_) {
    if (symbol.unknown) {
      list.push_back(&symbol);
    }
  }
  return list;
}

GiNaC::ex ClosureSystem::value(const GiNaC::ex& expression, Point& point) {
  const GiNaC::ex whole = expanded(expression);
  solve_sensitivities(whole, point);
  const bool moves = std::any_of(symbols_.begin(), symbols_.end(), [&](const AuditSymbol& symbol) {
    return symbol.unknown && (whole.has(symbol.rate) || whole.has(symbol.second_rate));
  });
  if (moves) {
    solve_rates(point);
  }
  return algebra_.at(algebra_.algebraic(whole), point.values);
}

bool ClosureSystem::vanishes(const GiNaC::ex& expression) {
  return algebra_.vanishes(algebra_.algebraic(expanded(expression)));
}

/// Gives the closures' value to lengths that occur in them linearly and in nothing under a root.
bool ClosureSystem::assemble(GiNaC::exmap& values) {
  std::vector<GiNaC::ex> equations;
  for (const Closure& closure : closures_) {
    equations.push_back(algebra_.algebraic(expanded(closure.expression)));
  }
  GiNaC::lst solved_for;
  const auto slopes = [&](const GiNaC::symbol& length) {
    std::vector<GiNaC::ex> list;
    for (const GiNaC::ex& equation : equations) {
      list.push_back(equation.diff(length));
    }
    return list;
  };
  const auto is_linear = [&](const std::vector<GiNaC::ex>& list, const GiNaC::symbol& length) {
    return std::all_of(list.begin(), list.end(), [&](const GiNaC::ex& slope) {
      return !slope.has(length) &&
             std::none_of(solved_for.begin(), solved_for.end(),
                          [&](const GiNaC::ex& other) { return slope.has(other); });
    });
  };
  std::vector<GiNaC::ex> columns;
  const auto try_length = [&](const AuditSymbol& symbol, bool constant_slopes) {
    if (symbol.angle || solved_for.nops() == equations.size() ||
        algebra_.under_a_root(symbol.symbol)) {
      return;
    }
    const std::vector<GiNaC::ex> list = slopes(symbol.symbol);
    const bool constant = std::all_of(list.begin(), list.end(), [](const GiNaC::ex& slope) {
      return GiNaC::is_a<GiNaC::numeric>(slope);
    });
    if (constant != constant_slopes || !is_linear(list, symbol.symbol)) {
      return;
    }
    std::vector<GiNaC::ex> more = columns;
    more.insert(more.end(), list.begin(), list.end());
    GiNaC::matrix matrix(static_cast<unsigned>(solved_for.nops() + 1),
                         static_cast<unsigned>(equations.size()));
    for (unsigned place = 0; place < more.size(); ++place) {
      matrix(place / matrix.cols(), place % matrix.cols()) = algebra_.at(more[place], values);
    }
    if (matrix.rank() == solved_for.nops() + 1) {
      columns = more;
      solved_for.append(symbol.symbol);
    }
  };
  for (const bool constant_slopes : {true, false}) {  // coordinates leave the roots rational
    for (const AuditSymbol& symbol : symbols_) {
      try_length(symbol, constant_slopes);
    }
  }
  if (solved_for.nops() != equations.size()) {
    return false;
  }
  GiNaC::exmap others = values;
  for (const GiNaC::ex& length : solved_for) {
    others.erase(length);
  }
  GiNaC::lst system;
  for (const GiNaC::ex& equation : equations) {
    system.append(algebra_.at(equation, others) == 0);
  }
  const GiNaC::ex solution = system.nops() == 0 ? GiNaC::lst() : GiNaC::lsolve(system, solved_for);
  for (const GiNaC::ex& assignment : solution) {
    values[assignment.lhs()] = assignment.rhs();
  }
  return true;
}

GiNaC::matrix ClosureSystem::values_of(const std::vector<GiNaC::ex>& expressions,
                                       const GiNaC::exmap& values) {
  GiNaC::matrix column(static_cast<unsigned>(expressions.size()), 1);
  for (unsigned row = 0; row < expressions.size(); ++row) {
    column(row, 0) = algebra_.at(algebra_.algebraic(expanded(expressions[row])), values);
  }
  return column;
}

void ClosureSystem::invert_jacobian(Point& point) {
  const std::vector<const AuditSymbol*> solved = unknowns();
  if (solved.empty() || solved.size() != closures_.size()) {
    return;
  }
  const auto size = static_cast<unsigned>(solved.size());
  GiNaC::matrix jacobian(size, size);
  for (unsigned column = 0; column < size; ++column) {
    std::vector<GiNaC::ex> slopes;
    for (const Closure& closure : closures_) {
      slopes.push_back(partial(closure.expression, solved[column]->symbol));
    }
    const GiNaC::matrix values = values_of(slopes, point.values);
    for (unsigned row = 0; row < size; ++row) {
      jacobian(row, column) = values(row, 0);
    }
  }
  point.inverse_jacobian = jacobian.inverse();
}

/// x of J x = -slopes.
GiNaC::matrix ClosureSystem::solution_of(const std::vector<GiNaC::ex>& slopes, const Point& point) {
  if (point.inverse_jacobian.rows() != slopes.size()) {
    throw NotAlgebraic("total derivatives need as many closures as unknowns");
  }
  return point.inverse_jacobian.mul(values_of(slopes, point.values)).mul_scalar(-1);
}

void ClosureSystem::solve_sensitivities(const GiNaC::ex& expression, Point& point) {
  const std::vector<const AuditSymbol*> solved = unknowns();
  for (const Sensitivity& asked : sensitivities_) {
    if (!expression.has(asked.symbol) || point.values.contains(asked.symbol)) {
      continue;
    }
    std::vector<GiNaC::ex> slopes;
    for (const Closure& closure : closures_) {
      slopes.push_back(partial(closure.expression, asked.parameter->symbol));
    }
    const GiNaC::matrix solution = solution_of(slopes, point);
    for (const Sensitivity& sensitivity : sensitivities_) {
      if (sensitivity.parameter == asked.parameter) {
        const auto place = std::find(solved.begin(), solved.end(), sensitivity.unknown);
        point.values[sensitivity.symbol] =
            solution(static_cast<unsigned>(place - solved.begin()), 0).expand();
      }
    }
  }
}

void ClosureSystem::solve_rates(Point& point) {
  const std::vector<const AuditSymbol*> solved = unknowns();
  if (solved.empty() || point.values.contains(solved[0]->rate)) {
    return;
  }
  for (const bool second : {false, true}) {
    std::vector<GiNaC::ex> slopes;
    for (const Closure& closure : closures_) {
      GiNaC::ex slope = rate(closure.expression);
      slope = second ? rate(slope) : slope;
      for (const AuditSymbol* unknown : solved) {
        slope = slope.subs((second ? unknown->second_rate : unknown->rate) == 0);
      }
      slopes.push_back(slope);
    }
    const GiNaC::matrix solution = solution_of(slopes, point);
    for (unsigned row = 0; row < solved.size(); ++row) {
      point.values[second ? solved[row]->second_rate : solved[row]->rate] =
          solution(row, 0).expand();
    }
  }
}

std::optional<ClosureSystem::Point> ClosureSystem::draw(unsigned seed, bool assembled,
                                                        bool rational_roots) {
  FewDigits random(seed);
  Point point;
  for (const AuditSymbol& symbol : symbols_) {
    if (symbol.angle) {
      const auto [cosine, sine] = random.direction();
      point.values[algebra_.direction(symbol.symbol).x] = cosine;
      point.values[algebra_.direction(symbol.symbol).y] = sine;
    } else {
      point.values[symbol.symbol] = random.length();
    }
    if (symbol.moving) {
      point.values[symbol.rate] = random.rate();
      point.values[symbol.second_rate] = random.rate();
    }
  }
  try {
    if (rational_roots && !algebra_.roots_are_rational(point.values)) {
      return std::nullopt;
    }
    if (assembled) {
      if (!assemble(point.values)) {
        return std::nullopt;
      }
      invert_jacobian(point);
    }
  } catch (const NotAlgebraic&) {
    return std::nullopt;
  } catch (const std::runtime_error&) {  // the Jacobian is singular there
    return std::nullopt;
  }
  return point;
}

ClosureSystem::Point* ClosureSystem::point(std::size_t index, bool assembled) {
  constexpr unsigned most_draws = 400;
  PointList& list = points_[assembled];
  while (list.drawn.size() <= index) {
    if (list.next_seed > most_draws) {
      if (!list.rational_roots) {
        return nullptr;
      }
      list.rational_roots = false;
      list.next_seed = 1;
    }
    if (std::optional<Point> point = draw(list.next_seed++, assembled, list.rational_roots)) {
      list.drawn.push_back(std::move(*point));
    }
  }
  return &list.drawn[index];
}

std::string ClosureSystem::point_text(const Point& point,
                                      const std::vector<GiNaC::ex>& shown) const {
  std::string text;
  for (const AuditSymbol& symbol : symbols_) {
    const bool occurs = std::any_of(shown.begin(), shown.end(), [&](const GiNaC::ex& expression) {
      return expanded(expression).has(symbol.symbol);
    });
    if (!occurs) {
      continue;
    }
    text += text.empty() ? "" : ", ";
    if (symbol.angle) {
      const Vector2& direction = algebra_.direction(symbol.symbol);
      text += "(cos, sin)(" + symbol.name + ") = (" + formula_text(point.values.at(direction.x)) +
              ", " + formula_text(point.values.at(direction.y)) + ")";
    } else {
      text += symbol.name + " = " + formula_text(point.values.at(symbol.symbol));
    }
  }
  return text;
}

}  // namespace assur::generator
