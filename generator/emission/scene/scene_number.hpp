// Turns arithmetic on the numbers of a scene into numbers with formulas in its variable parameters.
#pragma once

#include <ginac/ginac.h>

#include <assur/mechanism/dual.hpp>

namespace assur::generator::emission::scene {

/// A number of a scene with its derivatives and, where it depends on symbols, its formula in them.
/// Values are those of mechanism::Dual, operation by operation, so that whatever is decided by them
/// is decided alike.
///
/// A square root of a square is what was squared, with the sign that makes it positive at the
/// scene's own numbers: a link's length then is the parameter that says so, and turns the link's
/// normal frame round where that becomes negative.
class SceneNumber {
 public:
  explicit SceneNumber(double value = 0) : number_(value) {}
  explicit SceneNumber(mechanism::Dual number) : number_(std::move(number)) {}
  /// `symbols`: what the symbols are at the scene's own numbers; it must outlive the number.
  SceneNumber(mechanism::Dual number, GiNaC::ex formula, const GiNaC::exmap& symbols);

  [[nodiscard]] double value() const { return number_.value(); }
  /// At the scene's own numbers.
  [[nodiscard]] const mechanism::Dual& number() const { return number_; }
  /// The number itself, as a rational, where it depends on no symbol.
  [[nodiscard]] GiNaC::ex formula() const;
  [[nodiscard]] bool has_formula() const { return symbols_ != nullptr; }
  /// Null without a formula.
  [[nodiscard]] const GiNaC::exmap* symbols() const { return symbols_; }

  friend bool operator==(const SceneNumber& a, const SceneNumber& b) {
    return a.value() == b.value();
  }
  /// Throws MechanismError where only the scene's own numbers make the two equal.
  friend bool operator>(const SceneNumber& a, const SceneNumber& b);

 private:
  mechanism::Dual number_;
  GiNaC::ex formula_;
  const GiNaC::exmap* symbols_ = nullptr;
};

SceneNumber operator-(const SceneNumber& a);
SceneNumber operator+(const SceneNumber& a, const SceneNumber& b);
SceneNumber operator-(const SceneNumber& a, const SceneNumber& b);
SceneNumber operator*(const SceneNumber& a, const SceneNumber& b);
SceneNumber operator/(const SceneNumber& a, const SceneNumber& b);
SceneNumber operator/(const SceneNumber& a, double b);
SceneNumber sqrt(const SceneNumber& a);
SceneNumber exp(const SceneNumber& a);
SceneNumber log(const SceneNumber& a);
SceneNumber sin(const SceneNumber& a);
SceneNumber cos(const SceneNumber& a);
SceneNumber tan(const SceneNumber& a);
SceneNumber asin(const SceneNumber& a);
SceneNumber acos(const SceneNumber& a);
SceneNumber atan(const SceneNumber& a);
SceneNumber atan2(const SceneNumber& y, const SceneNumber& x);
SceneNumber pow(const SceneNumber& a, double exponent);

/// The formula with sin^2 x + cos^2 x = 1, if that makes it shorter.
[[nodiscard]] GiNaC::ex shortened(const GiNaC::ex& formula);

}  // namespace assur::generator::emission::scene
