// Turns what moves a solver's links into the rates and derivatives of formulas.
#pragma once

#include <ginac/ginac.h>

#include <assur/mechanism/mechanism.hpp>
#include <vector>

#include "emission/scene/scene_number.hpp"

namespace assur::generator::emission::scene {

/// A driver whose position is an argument, a joint that a law reads where groups place it, a
/// coordinate of a link in the frame of the link relative to which its group is solved, or a
/// parameter with rates.
struct Mover {
  GiNaC::symbol position, velocity, acceleration;
  mechanism::ParameterIndex parameter;  ///< none of the others
  std::vector<GiNaC::ex> gradient;      ///< to the modelled parameters; empty of a parameter
};

class SceneMovers {
 public:
  /// The symbols must outlive what moves.
  explicit SceneMovers(const SceneSymbols& symbols) : symbols_(symbols) {}

  void add(const Mover& mover) { movers_.push_back(mover); }
  [[nodiscard]] const std::vector<Mover>& list() const { return movers_; }

  /// Whether they move what a formula stands for.
  [[nodiscard]] bool move(const GiNaC::ex& formula) const;
  /// Whether a root moves with more than parameters, so that its rates are no numbers: they have
  /// names of their own, or formulas of nested roots would grow with the square of their number.
  [[nodiscard]] bool names_rates(const Root& root) const;
  /// The derivatives in time.
  [[nodiscard]] GiNaC::ex rate(const GiNaC::ex& formula) const;
  [[nodiscard]] GiNaC::ex second_rate(const GiNaC::ex& formula) const;
  /// The derivative to a modelled parameter by way of them, by its column.
  [[nodiscard]] GiNaC::ex slope(const GiNaC::ex& formula, std::size_t column) const;

 private:
  /// Every mover, and root with names for its rates, as position, velocity, acceleration.
  template <typename Visit>
  void visit(const GiNaC::ex& formula, const Visit& visit) const;

  const SceneSymbols& symbols_;
  std::vector<Mover> movers_;
};

}  // namespace assur::generator::emission::scene
