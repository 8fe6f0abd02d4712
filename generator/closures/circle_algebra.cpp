#include "closures/circle_algebra.hpp"

#include <algorithm>
#include <cstdlib>

#include "closures/extent.hpp"
#include "closures/formula_text.hpp"

namespace assur::generator::closures {

namespace {

/// Symbols are replaced without pattern matching, which would take much longer.
constexpr unsigned unmatched = GiNaC::subs_options::no_pattern;

/// The direction of the sum of two angles.
equations::Vector2 multiplied_out(const equations::Vector2& first,
                                  const equations::Vector2& second) {
  return {(first.x * second.x - first.y * second.y).expand(),
          (first.x * second.y + first.y * second.x).expand()};
}

/// The direction of a multiple of pi whose cosine and sine are known as roots of numbers, a
/// multiple of pi/12. Throws NotAlgebraic for others.
equations::Vector2 direction_of_number(const GiNaC::ex& angle) {
  const equations::Vector2 direction{GiNaC::cos(angle), GiNaC::sin(angle)};
  for (const GiNaC::ex& part : {direction.x, direction.y}) {
    if (std::any_of(part.preorder_begin(), part.preorder_end(),
                    [](const GiNaC::ex& each) { return GiNaC::is_a<GiNaC::function>(each); })) {
      throw NotAlgebraic("the angle " + formula_text(angle) +
                         " has no cosine in roots; declare an angle for it");
    }
  }
  return direction;
}

}  // namespace

bool makes_roots(const GiNaC::ex& expression) {
  return std::any_of(expression.preorder_begin(), expression.preorder_end(), is_root);
}

equations::Vector2 turned_by_multiple(const equations::Vector2& direction, equations::Vector2 step,
                                      int factor) {
  step.y = factor < 0 ? -step.y : step.y;
  if (!can_be_multiplied_out(direction.x * GiNaC::pow(step.x + step.y, std::abs(factor)),
                             max_terms_of_direction)) {
    throw NotAlgebraic("an angle has too many terms when its cosine is multiplied out");
  }
  // The multiple of one angle has few terms, which meet those of the direction only once.
  equations::Vector2 multiple{1, 0};
  for (int count = std::abs(factor); count > 0; --count) {
    multiple = multiplied_out(multiple, step);
  }
  return multiplied_out(direction, multiple);
}

void CircleAlgebra::add_angle(const GiNaC::symbol& angle) {
  directions_[angle.get_name()] = {GiNaC::symbol("cos_" + angle.get_name()),
                                   GiNaC::symbol("sin_" + angle.get_name())};
}

const equations::Vector2& CircleAlgebra::direction(const GiNaC::symbol& angle) const {
  return directions_.at(angle.get_name());
}

const equations::Vector2* CircleAlgebra::find_direction(const GiNaC::ex& angle) const {
  if (!GiNaC::is_a<GiNaC::symbol>(angle)) {
    return nullptr;
  }
  const auto known = directions_.find(GiNaC::ex_to<GiNaC::symbol>(angle).get_name());
  return known == directions_.end() ? nullptr : &known->second;
}

std::vector<std::pair<GiNaC::symbol, GiNaC::ex>> CircleAlgebra::roots() const {
  std::vector<std::pair<GiNaC::symbol, GiNaC::ex>> list;
  for (const Root& root : roots_) {
    list.emplace_back(root.symbol, root.radicand);
  }
  return list;
}

bool CircleAlgebra::under_a_root(const GiNaC::symbol& symbol) const {
  return std::any_of(roots_.begin(), roots_.end(),
                     [&](const Root& root) { return root.radicand.has(symbol); });
}

GiNaC::ex CircleAlgebra::algebraic(const GiNaC::ex& expression) {
  if (const auto known = known_.find(expression); known != known_.end()) {
    return known->second;
  }
  const std::size_t known_roots = roots_.size();
  in_order_ = false;
  try {
    return known_[expression] = converted(expression);
  } catch (const NotAlgebraic&) {
    // Of several errors the first is reported, in an order independent of GiNaC's.
    roots_.resize(known_roots);
    in_order_ = true;
    return converted(expression);
  }
}

GiNaC::ex CircleAlgebra::converted(const GiNaC::ex& expression) {
  if (GiNaC::is_a<GiNaC::function>(expression)) {
    const auto& function = GiNaC::ex_to<GiNaC::function>(expression);
    if (function.get_name() == "cos") {
      return direction_of(expression.op(0)).x;
    }
    if (function.get_name() == "sin") {
      return direction_of(expression.op(0)).y;
    }
    if (function.get_name() == "tan") {
      const equations::Vector2 direction = direction_of(expression.op(0));
      return direction.y / direction.x;
    }
    throw NotAlgebraic("'" + function.get_name() + "' stands outside a sine or cosine");
  }
  if (GiNaC::is_a<GiNaC::power>(expression)) {
    const GiNaC::ex& exponent = expression.op(1);
    if (exponent.info(GiNaC::info_flags::integer)) {
      return GiNaC::pow(converted(expression.op(0)), exponent);
    }
    if ((2 * exponent).info(GiNaC::info_flags::integer)) {
      return GiNaC::pow(root_of(converted(expression.op(0))), 2 * exponent);
    }
    throw NotAlgebraic("the power " + formula_text(exponent) + " is not a whole or half number");
  }
  if (GiNaC::is_a<GiNaC::constant>(expression)) {
    throw NotAlgebraic("pi stands outside a sine or cosine");
  }
  if (GiNaC::is_a<GiNaC::add>(expression) || GiNaC::is_a<GiNaC::mul>(expression)) {
    const bool sum = GiNaC::is_a<GiNaC::add>(expression);
    GiNaC::ex result = sum ? 0 : 1;
    for (const GiNaC::ex& part : operands(expression)) {
      result = sum ? result + converted(part) : result * converted(part);
    }
    return result;
  }
  if (find_direction(expression) != nullptr) {
    throw NotAlgebraic("the angle '" + formula_text(expression) +
                       "' stands outside a sine or cosine");
  }
  return expression;
}

std::vector<GiNaC::ex> CircleAlgebra::operands(const GiNaC::ex& expression) const {
  std::vector<GiNaC::ex> list(expression.begin(), expression.end());
  // GiNaC's order serves if at most one part makes roots, which are numbered, and nothing fails.
  const bool matters = in_order_ || std::count_if(list.begin(), list.end(), makes_roots) > 1;
  return matters ? ordered_operands(expression) : list;
}

equations::Vector2 CircleAlgebra::direction_of(const GiNaC::ex& angle) {
  if (!can_be_multiplied_out(angle)) {
    throw NotAlgebraic("an angle has too many terms to be a sum of multiples of declared angles");
  }
  const GiNaC::ex expanded = angle.expand();
  equations::Vector2 direction{1, 0};
  const auto add = [&](const GiNaC::ex& term) {
    if (term.is_zero()) {
      return;
    }
    GiNaC::numeric factor = 1;
    GiNaC::ex base = 1;
    const bool product = GiNaC::is_a<GiNaC::mul>(term);
    for (std::size_t place = 0; place < (product ? term.nops() : 1); ++place) {
      const GiNaC::ex part = product ? term.op(place) : term;
      if (GiNaC::is_a<GiNaC::numeric>(part)) {
        factor *= GiNaC::ex_to<GiNaC::numeric>(part);
      } else {
        base *= part;
      }
    }
    if (base.is_equal(GiNaC::Pi)) {
      direction = multiplied_out(direction, direction_of_number(term));
      return;
    }
    if (!factor.is_integer() || abs(factor) > max_multiple) {
      throw NotAlgebraic("the angle " + formula_text(term) +
                         " is not a whole multiple of a declared angle");
    }
    direction = turned_by_multiple(direction, direction_of_term(base), factor.to_int());
  };
  if (GiNaC::is_a<GiNaC::add>(expanded)) {
    for (const GiNaC::ex& term : operands(expanded)) {
      add(term);
    }
  } else {
    add(expanded);
  }
  return direction;
}

equations::Vector2 CircleAlgebra::direction_of_term(const GiNaC::ex& base) {
  if (const equations::Vector2* known = find_direction(base)) {
    return *known;
  }
  if (GiNaC::is_a<GiNaC::function>(base)) {
    const std::string name = GiNaC::ex_to<GiNaC::function>(base).get_name();
    const GiNaC::ex first = converted(base.op(0));
    if (name == "acos") {
      return {first, root_of(1 - first * first)};
    }
    if (name == "asin") {
      return {root_of(1 - first * first), first};
    }
    if (name == "atan") {
      const GiNaC::ex size = root_of(1 + first * first);
      return {1 / size, first / size};
    }
    if (name == "atan2") {
      const GiNaC::ex second = converted(base.op(1));
      const GiNaC::ex size = root_of(first * first + second * second);
      return {second / size, first / size};
    }
  }
  throw NotAlgebraic("'" + formula_text(base) + "' is used as an angle and is not declared as one");
}

GiNaC::ex CircleAlgebra::root_of(const GiNaC::ex& radicand) {
  if (!can_be_multiplied_out(radicand)) {
    throw NotAlgebraic("a radicand has too many terms when it is multiplied out");
  }
  const GiNaC::ex normal = radicand.normal();
  if (GiNaC::is_a<GiNaC::numeric>(normal)) {
    return GiNaC::sqrt(normal);
  }
  for (const Root& root : roots_) {
    if (vanishes(root.radicand - normal)) {
      return root.symbol;
    }
  }
  roots_.push_back({GiNaC::symbol("root_" + std::to_string(roots_.size() + 1)), normal});
  return roots_.back().symbol;
}

bool CircleAlgebra::vanishes(const GiNaC::ex& algebraic) const {
  if (!can_be_multiplied_out(algebraic)) {
    return false;
  }
  try {
    return has_no_rest(algebraic);
  } catch (const std::invalid_argument&) {
    return false;  // GiNaC cannot divide polynomials with irrational numbers
  }
}

bool CircleAlgebra::has_no_rest(const GiNaC::ex& algebraic) const {
  GiNaC::ex rest = algebraic.normal().numer().expand();
  for (auto root = roots_.rbegin(); root != roots_.rend() && !rest.is_zero(); ++root) {
    if (rest.has(root->symbol)) {
      const GiNaC::ex fraction = root->radicand.normal().numer_denom();
      const GiNaC::ex relation = fraction.op(1) * GiNaC::pow(root->symbol, 2) - fraction.op(0);
      rest = GiNaC::prem(rest, relation.expand(), root->symbol).expand();
    }
  }
  for (const auto& [name, direction] : directions_) {
    if (rest.is_zero()) {
      return true;
    }
    if (rest.has(direction.y)) {
      const GiNaC::ex relation = direction.x * direction.x + direction.y * direction.y - 1;
      rest = GiNaC::rem(rest, relation, direction.y).expand();
    }
  }
  return rest.is_zero();
}

CircleAlgebra CircleAlgebra::extended() const {
  CircleAlgebra copy;
  copy.directions_ = directions_;
  copy.roots_ = roots_;
  return copy;
}

GiNaC::exmap CircleAlgebra::with_roots(const GiNaC::exmap& point, unsigned reversed) const {
  GiNaC::exmap values = point;
  for (std::size_t place = 0; place < roots_.size(); ++place) {
    const Root& root = roots_[place];
    const GiNaC::ex radicand = root.radicand.subs(values, unmatched).expand();
    const GiNaC::ex number = radicand.evalf();
    if (!GiNaC::is_a<GiNaC::numeric>(number)) {
      continue;  // it contains symbols that the point leaves free
    }
    if (GiNaC::ex_to<GiNaC::numeric>(number).is_negative()) {
      throw NotAlgebraic("the root of a negative number");
    }
    const bool negative = place < 32 && (reversed >> place & 1U) != 0;
    values[root.symbol] = negative ? -GiNaC::sqrt(radicand) : GiNaC::sqrt(radicand);
  }
  return values;
}

GiNaC::ex CircleAlgebra::at(const GiNaC::ex& algebraic, const GiNaC::exmap& point,
                            unsigned reversed) const {
  try {
    const GiNaC::ex value = algebraic.subs(with_roots(point, reversed), unmatched);
    if (!can_be_multiplied_out(value, max_terms_of_value)) {  // powers of sums of roots
      throw NotAlgebraic("a power of roots has too many terms when it is multiplied out");
    }
    return value.expand();
  } catch (const GiNaC::pole_error&) {
    throw NotAlgebraic("division by zero");
  }
}

bool CircleAlgebra::roots_are_rational(const GiNaC::exmap& point) const {
  const GiNaC::exmap values = with_roots(point, 0);
  return std::all_of(roots_.begin(), roots_.end(), [&](const Root& root) {
    const auto value = values.find(root.symbol);
    return value == values.end() || value->second.info(GiNaC::info_flags::rational);
  });
}

}  // namespace assur::generator::closures
