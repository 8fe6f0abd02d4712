// Points on all branches of expressions with roots of their own, and values there.
#include <algorithm>

#include "closures/closure_points.hpp"
#include "closures/formula_text.hpp"
#include "closures/numeric_matrix.hpp"
#include "equations/symbols.hpp"

namespace assur::generator::closures {

std::optional<ClosurePoints::Rooted> ClosurePoints::rooted(const GiNaC::ex& expression) {
  follow_system();
  const GiNaC::ex whole = system_.expanded(expression);
  if (!makes_roots(whole)) {
    return std::nullopt;
  }
  Rooted rooted{algebra_.extended(), whole, {}, algebra_.root_count()};
  rooted.form = rooted.algebra.algebraic(whole);
  if (rooted.algebra.root_count() == rooted.first_own) {
    return std::nullopt;
  }
  return rooted;
}

GiNaC::ex ClosurePoints::value(const Rooted& rooted, Point& point, unsigned reversed) {
  solve_for(rooted.whole, point);
  return value_of_form(rooted.algebra, rooted.form, point, reversed);
}

bool ClosurePoints::takes_either_sign(const AuditSymbol& symbol) {
  return symbol.unknown ||
         std::any_of(system_.closures().begin(), system_.closures().end(),
                     [&](const ClosureSystem::Closure& closure) {
                       const GiNaC::ex slope = system_.slope(closure.expression, symbol.symbol);
                       return GiNaC::is_a<GiNaC::numeric>(slope) && !slope.is_zero();
                     });
}

std::vector<ClosurePoints::Telling> ClosurePoints::telling(const GiNaC::ex& expression) const {
  const GiNaC::exset occurring = equations::symbols_of(system_.expanded(expression));
  std::vector<GiNaC::ex> angles;
  std::vector<GiNaC::ex> lengths;
  for (const bool occurs : {true, false}) {
    for (const AuditSymbol& symbol : system_.symbols()) {
      if (occurring.contains(symbol.symbol) == occurs) {
        (symbol.angle ? angles : lengths).emplace_back(symbol.symbol);
      }
    }
  }
  std::vector<Telling> list;
  const auto add = [&](const GiNaC::ex& quantity) {
    const bool negative = formula_text(quantity).starts_with('-');
    const GiNaC::ex shown = negative ? -quantity : quantity;
    list.push_back({formula_text(shown), shown});
  };
  for (const GiNaC::ex& angle : angles) {
    add(GiNaC::cos(angle));
    add(GiNaC::sin(angle));
  }
  std::ranges::for_each(lengths, add);
  std::map<std::string, GiNaC::ex> derivatives;  // sorted by name, since GiNaC's order varies
  for (const GiNaC::ex& symbol : occurring) {
    if (system_.derivative_of(symbol) != nullptr || system_.moved_by(symbol) != nullptr) {
      derivatives.emplace(GiNaC::ex_to<GiNaC::symbol>(symbol).get_name(), symbol);
    }
  }
  for (const auto& [name, symbol] : derivatives) {
    add(symbol);
  }
  for (const std::vector<GiNaC::ex>* several : {&angles, &lengths}) {
    for (std::size_t one = 0; one < several->size(); ++one) {
      const GiNaC::ex first = (*several)[one];
      for (std::size_t other = 0; other < one; ++other) {
        const GiNaC::ex second = (*several)[other];
        if (several == &lengths) {
          add(first - second);
          add(first + second);
          continue;
        }
        for (const GiNaC::ex& angle : {first - second, first + second}) {
          add(GiNaC::sin(angle));
          add(GiNaC::cos(angle));
        }
        add(GiNaC::sin(first) * GiNaC::sin(second));
        add(GiNaC::cos(first) * GiNaC::cos(second));
        add(GiNaC::sin(first) * GiNaC::cos(second));
        add(GiNaC::cos(first) * GiNaC::sin(second));
      }
      if (several == &angles) {
        add(GiNaC::sin(2 * first));
        add(GiNaC::cos(2 * first));
      }
    }
  }
  return list;
}

bool ClosurePoints::make_zero(const GiNaC::ex& telling, GiNaC::exmap& values) const {
  const bool has_sign = GiNaC::is_a<GiNaC::mul>(telling) && telling.nops() == 2 &&
                        GiNaC::is_a<GiNaC::numeric>(telling.op(1));
  const GiNaC::ex quantity = has_sign ? telling.op(0) : telling;
  if (GiNaC::is_a<GiNaC::symbol>(quantity)) {
    const auto length = values.find(quantity);
    if (length != values.end()) {
      length->second = 0;
    }
    return length != values.end();
  }
  if (!GiNaC::is_a<GiNaC::function>(quantity)) {
    return false;
  }
  const bool is_cosine = GiNaC::ex_to<GiNaC::function>(quantity).get_name() == "cos";
  const GiNaC::ex angle = quantity.op(0);
  std::vector<std::pair<const AuditSymbol*, GiNaC::ex>> terms;
  for (const AuditSymbol& symbol : system_.symbols()) {
    const GiNaC::ex factor = angle.coeff(symbol.symbol);
    if (symbol.angle && !factor.is_zero()) {
      terms.emplace_back(&symbol, factor);
    }
  }
  const auto is_single = [](const auto& term) {
    return term.second.is_equal(1) || term.second.is_equal(-1);
  };
  if (terms.empty() || !std::ranges::all_of(terms, is_single)) {
    return false;
  }
  // The first angle is chosen so that the whole sum is zero, or a quarter turn.
  equations::Vector2 rest{1, 0};
  for (const auto& [symbol, factor] : std::vector(terms.begin() + 1, terms.end())) {
    const equations::Vector2& of = algebra_.direction(symbol->symbol);
    const equations::Vector2 turn{values.at(of.x), -factor * values.at(of.y)};
    rest = {rest.x * turn.x - rest.y * turn.y, rest.x * turn.y + rest.y * turn.x};
  }
  if (is_cosine) {
    rest = {-rest.y, rest.x};
  }
  const equations::Vector2& first = algebra_.direction(terms.front().first->symbol);
  values[first.x] = rest.x;
  values[first.y] = terms.front().second * rest.y;
  return true;
}

bool ClosurePoints::is_singular_with(const Telling& telling) {
  constexpr unsigned tried = 3;
  follow_system();
  for (unsigned seed = 1; seed <= tried; ++seed) {
    Point point{random_values(seed), {}};
    try {
      if (!telling.quantity || !make_zero(*telling.quantity, point.values)) {
        return false;
      }
      const std::optional<GiNaC::matrix> values = jacobian(point);
      if (!values || determinant_sign(*values) != 0) {
        return false;
      }
    } catch (const std::runtime_error&) {  // no real root at this point
      return false;
    }
  }
  return true;
}

ClosurePoints::Telling ClosurePoints::determinant() const {
  std::string closures;
  for (const ClosureSystem::Closure& closure : system_.closures()) {
    closures += (closures.empty() ? "" : ", ") + closure.name;
  }
  std::string unknowns;
  for (const AuditSymbol* unknown : system_.unknowns()) {
    unknowns += (unknowns.empty() ? "" : ", ") + unknown->name;
  }
  return {"det d(" + closures + ")/d(" + unknowns + ")", std::nullopt};
}

int ClosurePoints::sign(const Telling& telling, Point& point) {
  constexpr double nothing = 1e-30;  // far above the error of a computed point
  GiNaC::ex value;
  try {
    if (telling.quantity) {
      value = this->value(*telling.quantity, point);
    } else {
      const std::optional<GiNaC::matrix> values = jacobian(point);
      return values ? determinant_sign(*values) : 0;
    }
  } catch (const std::runtime_error&) {
    return 0;
  }
  const GiNaC::ex number = value.evalf();
  if (!GiNaC::is_a<GiNaC::numeric>(number) || !number.info(GiNaC::info_flags::real)) {
    return 0;
  }
  const double size = GiNaC::ex_to<GiNaC::numeric>(number).to_double();
  return size > nothing ? 1 : size < -nothing ? -1 : 0;
}

std::deque<ClosurePoints::Point> ClosurePoints::rational_points_on_all_branches(
    const Rooted& rooted, bool assembled) {
  constexpr unsigned most_draws = 400;
  // Rates and total derivatives cost a linear system at each point.
  const bool follows = system_.follows_closures(rooted.whole);
  const std::size_t wanted = follows ? 16 : 64;
  std::vector<const AuditSymbol*> angles;  // those of the expression come first
  std::vector<const AuditSymbol*> signed_lengths;
  std::vector<const AuditSymbol*> positive;
  for (const bool occurs : {true, false}) {
    for (const AuditSymbol& symbol : system_.symbols()) {
      if (symbol.angle && rooted.whole.has(symbol.symbol) == occurs) {
        angles.push_back(&symbol);
      } else if (!symbol.angle && occurs) {
        (takes_either_sign(symbol) ? signed_lengths : positive).push_back(&symbol);
      }
    }
  }
  std::deque<Point> points;
  for (const bool insists : {true, false}) {  // first with positive lengths only
    for (unsigned seed = 1; seed <= most_draws && points.size() < wanted; ++seed) {
      Point point{random_values(seed), {}};
      // The first three angles go through all their quadrants, the others through random ones.
      unsigned pattern = (seed & 63U) | (seed * 2654435761U >> 8U) << 6U;
      for (const AuditSymbol* angle : angles) {
        const equations::Vector2& direction = algebra_.direction(angle->symbol);
        for (const GiNaC::ex& part : {direction.x, direction.y}) {
          GiNaC::ex& value = point.values[part];
          const GiNaC::ex size = GiNaC::abs(value);
          value = (pattern & 1U) != 0 ? -size : size;
          pattern = pattern >> 1U | pattern << 31U;
        }
      }
      for (const AuditSymbol* length : signed_lengths) {
        pattern = pattern >> 1U | pattern << 31U;
        point.values[length->symbol] *= (pattern & 1U) != 0 ? -1 : 1;
      }
      try {
        if (assembled) {
          if (!closures_are_rational_ || !assemble(point.values)) {
            return {};
          }
          if (is_special(point.values, insists)) {
            continue;
          }
          if (follows) {
            invert_jacobian(point);
          }
        }
        const bool admitted =
            !insists ||
            std::all_of(positive.begin(), positive.end(), [&](const AuditSymbol* length) {
              return point.values.at(length->symbol).info(GiNaC::info_flags::positive);
            });
        if (admitted) {
          static_cast<void>(value(rooted, point));
          points.push_back(std::move(point));
        }
      } catch (const std::runtime_error&) {  // no real root, or a singular Jacobian, at this point
        continue;
      }
    }
    if (!points.empty()) {
      break;
    }
  }
  return points;
}

std::deque<ClosurePoints::Point> ClosurePoints::points_on_all_branches(const Rooted& rooted,
                                                                       bool assembled) {
  constexpr std::size_t fewest = 3;
  std::deque<Point> points = rational_points_on_all_branches(rooted, assembled);
  if (!assembled || points.size() >= fewest) {
    return points;
  }
  points.clear();
  for (std::size_t index = 0; points.size() < computed_points; ++index) {
    const Point* const drawn = point(index, true);
    if (drawn == nullptr) {
      break;
    }
    if (!drawn->is_computed) {
      continue;
    }
    Point copy = *drawn;
    try {
      static_cast<void>(value(rooted, copy));
      points.push_back(std::move(copy));
    } catch (const std::runtime_error&) {  // no real root at this point
      continue;
    }
  }
  return points;
}

}  // namespace assur::generator::closures
