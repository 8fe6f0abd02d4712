#include "emission/scene/scene_movers.hpp"

#include <algorithm>

namespace assur::generator::emission::scene {

bool SceneMovers::move(const GiNaC::ex& formula) const {
  const GiNaC::ex whole = symbols_.written_out(formula);
  return std::ranges::any_of(movers_,
                             [&](const Mover& mover) { return whole.has(mover.position); });
}

bool SceneMovers::names_rates(const Root& root) const {
  const GiNaC::ex whole = symbols_.written_out(root.radicand);
  return std::ranges::any_of(movers_, [&](const Mover& mover) {
    return !mover.parameter.exists() && whole.has(mover.position);
  });
}

/// Roots without names for their rates are differentiated through their radicands.
template <typename Visit>
void SceneMovers::visit(const GiNaC::ex& formula, const Visit& visit) const {
  GiNaC::exmap standing;  // named roots to symbols without movers
  for (const Root& root : symbols_.roots()) {
    if (formula.has(root.symbol) && names_rates(root)) {
      visit(formula.diff(root.symbol), root.velocity, root.acceleration);
      standing[root.symbol] = GiNaC::symbol();
    }
  }
  GiNaC::exmap back;
  for (const auto& [root, stand_in] : standing) {
    back[stand_in] = root;
  }
  const GiNaC::ex rest = formula.subs(standing);
  const GiNaC::ex whole = symbols_.written_out(rest);
  for (const Mover& mover : movers_) {
    if (whole.has(mover.position)) {
      visit(symbols_.derivative(rest, mover.position).subs(back), mover.velocity,
            mover.acceleration);
    }
  }
}

GiNaC::ex SceneMovers::rate(const GiNaC::ex& formula) const {
  GiNaC::ex sum;
  visit(formula, [&sum](const GiNaC::ex& slope, const GiNaC::symbol& velocity,
                        const GiNaC::symbol&) { sum += slope * velocity; });
  return sum;
}

GiNaC::ex SceneMovers::second_rate(const GiNaC::ex& formula) const {
  GiNaC::ex sum = rate(rate(formula));
  visit(formula, [&sum](const GiNaC::ex& slope, const GiNaC::symbol&,
                        const GiNaC::symbol& acceleration) { sum += slope * acceleration; });
  return sum;
}

GiNaC::ex SceneMovers::slope(const GiNaC::ex& formula, std::size_t column) const {
  GiNaC::ex sum;
  for (const Mover& mover : movers_) {
    if (!mover.gradient.empty()) {
      sum += symbols_.derivative(formula, mover.position) * mover.gradient[column];
    }
  }
  return sum;
}

}  // namespace assur::generator::emission::scene
