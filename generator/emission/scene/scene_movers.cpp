#include "emission/scene/scene_movers.hpp"

#include <algorithm>

namespace assur::generator::emission::scene {

bool SceneMovers::move(const GiNaC::ex& formula) const {
  const GiNaC::ex whole = symbols_.written_out(formula);
  return std::ranges::any_of(movers_,
                             [&](const Mover& mover) { return whole.has(mover.position); });
}

GiNaC::ex SceneMovers::rate(const GiNaC::ex& formula) const {
  GiNaC::ex sum;
  for (const Mover& mover : movers_) {
    sum += symbols_.derivative(formula, mover.position) * mover.velocity;
  }
  return sum;
}

GiNaC::ex SceneMovers::second_rate(const GiNaC::ex& formula) const {
  GiNaC::ex sum = rate(rate(formula));
  for (const Mover& mover : movers_) {
    sum += symbols_.derivative(formula, mover.position) * mover.acceleration;
  }
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
