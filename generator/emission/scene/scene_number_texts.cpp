// Expressions that compute numbers of a scene, their rates and their derivatives.
#include <algorithm>

#include "emission/scene/formula_expression.hpp"
#include "emission/scene/scene_numbers.hpp"

namespace assur::generator::emission::scene {

bool SceneNumbers::moves(const SceneNumber& number) const {
  return number.has_formula() && movers_.move(number.formula());
}

cpp::Expression SceneNumbers::expression(const GiNaC::ex& formula) const {
  return expression_of(formula.subs(directions_), expressions_);
}

std::vector<cpp::Expression> SceneNumbers::rates(const SceneNumber& number, int order) const {
  const GiNaC::ex formula = number.formula();
  std::vector<cpp::Expression> rates;
  for (const GiNaC::ex& one : {movers_.rate(formula), movers_.second_rate(formula)}) {
    rates.push_back(expression(shortened(at_run_time(one))));
  }
  rates.resize(static_cast<std::size_t>(order));
  return rates;
}

std::vector<cpp::Expression> SceneNumbers::rates(const Direction<SceneNumber>& direction,
                                                 int order) const {
  const auto [x, y, square] = lengthened(direction);
  const GiNaC::ex first = (x * movers_.rate(y) - y * movers_.rate(x)) / square;
  const GiNaC::ex second = (x * movers_.second_rate(y) - y * movers_.second_rate(x)) / square -
                           movers_.rate(square) / square * first;
  std::vector<cpp::Expression> rates;
  for (const GiNaC::ex& one : {first, second}) {
    rates.push_back(expression(shortened(at_run_time(one.expand()))));
  }
  rates.resize(static_cast<std::size_t>(order));
  return rates;
}

bool SceneNumbers::varies(const GiNaC::ex& formula) const {
  const GiNaC::ex whole = symbols_.written_out(formula);
  return std::any_of(variables_.begin(), variables_.end(),
                     [&](const GiNaC::symbol& variable) { return whole.has(variable); });
}

bool SceneNumbers::varies(const SceneNumber& number) const {
  return number.has_formula() && varies(number.formula());
}

/// With r^2 = R: r' = R' / (2 r) and r'' = (R'' / 2 - r'^2) / r.
const std::vector<SceneNumbers::NamedStep>& SceneNumbers::steps(int order) const {
  const auto add = [&](const GiNaC::symbol& symbol, const GiNaC::ex& formula) {
    steps_.push_back({symbol.get_name(), expression(shortened(at_run_time(formula)))});
  };
  while (roots_in_steps_ < symbols_.roots().size()) {
    const Root& root = symbols_.roots()[roots_in_steps_++];
    if (!varies(root.radicand)) {
      continue;
    }
    steps_.push_back({root.symbol.get_name(), cpp::call(cpp::scalar_only("std::sqrt"),
                                                        {expression(at_run_time(root.radicand))})});
    if (!movers_.names_rates(root)) {
      continue;
    }
    if (order > 0) {
      add(root.velocity, movers_.rate(root.radicand) / (2 * root.symbol));
    }
    if (order > 1) {
      add(root.acceleration,
          (movers_.second_rate(root.radicand) / 2 - GiNaC::pow(root.velocity, 2)) / root.symbol);
    }
  }
  return steps_;
}

cpp::Expression SceneNumbers::expression(const SceneNumber& number) const {
  return expression(at_run_time(number.formula()));
}

GiNaC::ex SceneNumbers::at_run_time(const GiNaC::ex& formula) const {
  GiNaC::ex result = formula;
  for (GiNaC::ex before = result + 1; !result.is_equal(before);) {
    before = result;  // given rates may contain the rates of others
    result = result.subs(own_rates_);
  }
  const std::deque<Root>& roots = symbols_.roots();
  for (auto root = roots.rbegin(); root != roots.rend(); ++root) {
    if (!varies(root->radicand)) {
      result = result.subs(root->symbol == GiNaC::sqrt(root->radicand));
    }
  }
  return result.subs(deviations_);
}

GiNaC::ex SceneNumbers::derivative(const GiNaC::ex& formula, const GiNaC::ex& symbol) const {
  const auto to = GiNaC::ex_to<GiNaC::symbol>(symbol);
  GiNaC::ex slope = symbols_.derivative(formula, to);
  const auto column = std::ranges::find_if(
      modelled_, [&](const GiNaC::ex& modelled) { return modelled.is_equal(symbol); });
  slope += movers_.slope(formula, static_cast<std::size_t>(column - modelled_.begin()));
  return at_run_time(slope);
}

Gradient SceneNumbers::gradient(const SceneNumber& number) const {
  Gradient gradient;
  for (const GiNaC::ex& symbol : modelled_) {
    const GiNaC::ex slope = derivative(number.formula(), symbol);
    gradient.push_back(slope.is_zero() ? std::nullopt : std::optional(expression(slope)));
  }
  return gradient;
}

SceneNumbers::LongDirection SceneNumbers::lengthened(
    const Direction<SceneNumber>& direction) const {
  LongDirection result{direction.cos.formula(), direction.sin.formula(), 1};
  for (const Root& root : symbols_.roots()) {
    const bool occurs = result.x.has(root.symbol) || result.y.has(root.symbol);
    const GiNaC::ex longer_x = result.x * root.symbol;
    const GiNaC::ex longer_y = result.y * root.symbol;
    if (occurs && !longer_x.has(root.symbol) && !longer_y.has(root.symbol)) {
      result = {longer_x, longer_y, result.square * GiNaC::pow(root.symbol, 2)};
    }
  }
  return result;
}

/// The angle of (x, y) / r has the slope (x dy - y dx) / r^2, whatever r is.
Gradient SceneNumbers::gradient(const Direction<SceneNumber>& direction) const {
  const auto [x, y, square] = lengthened(direction);
  Gradient gradient;
  for (const GiNaC::ex& symbol : modelled_) {
    const GiNaC::ex slope =
        shortened(at_run_time((x * derivative(y, symbol) - y * derivative(x, symbol)) / square));
    gradient.push_back(slope.is_zero() ? std::nullopt : std::optional(expression(slope)));
  }
  return gradient;
}

}  // namespace assur::generator::emission::scene
