// Rates and derivatives of formulas through the quantities that move a solver's links.
#pragma once

#include <ginac/ginac.h>

#include <assur/mechanism/mechanism.hpp>
#include <vector>

#include "emission/scene/scene_number.hpp"

namespace assur::generator::emission::scene {

/// A driver whose position is an argument, a joint that a law reads and groups place, a coordinate
/// of a link in the frame relative to which its group is solved, a parameter with rates, or a law
/// that reads joints and has rates of its own.
struct Mover {
  GiNaC::symbol position, velocity, acceleration;
  mechanism::ParameterIndex parameter;  ///< exists only for a parameter with rates
  std::vector<GiNaC::ex> gradient;      ///< by the modelled parameters; empty if rates are given
};

class SceneMovers {
 public:
  /// The symbols must outlive the movers.
  explicit SceneMovers(const SceneSymbols& symbols) : symbols_(symbols) {}

  void add(const Mover& mover) { movers_.push_back(mover); }
  [[nodiscard]] const std::vector<Mover>& list() const { return movers_; }

  /// Whether the movers change the value of a formula.
  [[nodiscard]] bool move(const GiNaC::ex& formula) const;
  /// Whether a root moves with more than parameters, so that its rates are not numbers. They then
  /// have names: formulas of nested roots would grow with the square of their number.
  [[nodiscard]] bool names_rates(const Root& root) const;
  /// The time derivatives.
  [[nodiscard]] GiNaC::ex rate(const GiNaC::ex& formula) const;
  [[nodiscard]] GiNaC::ex second_rate(const GiNaC::ex& formula) const;
  /// The derivative with respect to a modelled parameter, given by its column, through the movers.
  [[nodiscard]] GiNaC::ex slope(const GiNaC::ex& formula, std::size_t column) const;

 private:
  /// visit(derivative of the formula, velocity, acceleration) for each mover, and for each root
  /// with names for its rates.
  template <typename Visit>
  void visit(const GiNaC::ex& formula, const Visit& visit) const;

  const SceneSymbols& symbols_;
  std::vector<Mover> movers_;
};

}  // namespace assur::generator::emission::scene
