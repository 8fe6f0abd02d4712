// Numbers of a scene with formulas in its variable parameters, and their arithmetic.
#pragma once

#include <ginac/ginac.h>

#include <assur/mechanism/dual.hpp>
#include <deque>

namespace assur::generator::emission::scene {

/// A square root in formulas, with its own symbol to keep them short.
struct Root {
  GiNaC::symbol symbol;
  GiNaC::ex radicand;                    ///< in symbols that were created earlier
  GiNaC::symbol velocity, acceleration;  ///< names of its rates, where used
};

/// The symbols of a scene's formulas, and their values at the scene's own numbers.
class SceneSymbols {
 public:
  void add(const GiNaC::symbol& symbol, const GiNaC::ex& value) { values_[symbol] = value; }
  /// The symbol of a root; the same for the same radicand.
  [[nodiscard]] GiNaC::ex root_of(const GiNaC::ex& radicand);
  /// The roots, each after those in its radicand.
  [[nodiscard]] const std::deque<Root>& roots() const { return roots_; }
  [[nodiscard]] GiNaC::ex value_of(const GiNaC::ex& formula) const;
  /// The formula with each symbol of a root replaced by the root.
  [[nodiscard]] GiNaC::ex written_out(const GiNaC::ex& formula) const;
  /// The derivative with respect to a symbol other than that of a root, through the roots.
  [[nodiscard]] GiNaC::ex derivative(const GiNaC::ex& formula, const GiNaC::symbol& symbol) const;

 private:
  GiNaC::exmap values_;
  std::deque<Root> roots_;
};

/// A number of a scene with its derivatives and, if it depends on symbols, its formula in them.
/// Values are those of mechanism::Dual, operation by operation, so that decisions by value are the
/// same as in `mechanism`.
///
/// The square root of a square is the base, with the sign that makes it positive at the scene's own
/// numbers. So a link's length is the parameter that gives it, and the link's normal frame turns by
/// pi where that parameter becomes negative.
/// round where that parameter becomes negative.
class SceneNumber {
 public:
  SceneNumber() = default;
  explicit SceneNumber(double value) : number_(value) {}
  explicit SceneNumber(mechanism::Dual number) : number_(std::move(number)) {}
  /// The symbols must outlive the number.
  SceneNumber(mechanism::Dual number, GiNaC::ex formula, SceneSymbols& symbols);

  [[nodiscard]] double value() const { return number_.value(); }
  /// The value and its derivatives at the scene's own numbers.
  [[nodiscard]] const mechanism::Dual& number() const { return number_; }
  /// The formula; the number itself, as a rational, if it depends on no symbol.
  [[nodiscard]] GiNaC::ex formula() const;
  [[nodiscard]] bool has_formula() const { return symbols_ != nullptr; }
  /// Null without a formula.
  [[nodiscard]] SceneSymbols* symbols() const { return symbols_; }

  friend bool operator==(const SceneNumber& a, const SceneNumber& b) {
    return a.value() == b.value();
  }
  /// Throws MechanismError where only the scene's own numbers make the two equal.
  friend bool operator>(const SceneNumber& a, const SceneNumber& b);

 private:
  mechanism::Dual number_;
  GiNaC::ex formula_;
  SceneSymbols* symbols_ = nullptr;
};

/// Whether the number may take other values.
[[nodiscard]] inline bool may_change(const SceneNumber& number) { return number.has_formula(); }

SceneNumber operator-(const SceneNumber& a);
SceneNumber operator+(const SceneNumber& a, const SceneNumber& b);
SceneNumber operator-(const SceneNumber& a, const SceneNumber& b);
SceneNumber operator*(const SceneNumber& a, const SceneNumber& b);
SceneNumber operator/(const SceneNumber& a, const SceneNumber& b);
SceneNumber operator/(const SceneNumber& a, double b);
SceneNumber sqrt(const SceneNumber& a);
SceneNumber sin(const SceneNumber& a);
SceneNumber cos(const SceneNumber& a);
SceneNumber tan(const SceneNumber& a);
SceneNumber asin(const SceneNumber& a);
SceneNumber acos(const SceneNumber& a);
SceneNumber atan(const SceneNumber& a);
SceneNumber atan2(const SceneNumber& y, const SceneNumber& x);
SceneNumber abs(const SceneNumber& a);
SceneNumber min(const SceneNumber& a, const SceneNumber& b);
SceneNumber max(const SceneNumber& a, const SceneNumber& b);
SceneNumber pow(const SceneNumber& a, double exponent);
SceneNumber pow(const SceneNumber& a, const SceneNumber& b);

/// The derivative of a^b, by a and by b as often as the third and fourth argument state; with a
/// constant exponent it is a power of GiNaC unless it is differentiated by the exponent.
// The macro is GiNaC's.
DECLARE_FUNCTION_4P(power_derivative)  // NOLINT

/// 1 for an argument that is not negative, else -1; corners choose their side by it.
DECLARE_FUNCTION_1P(sense_of)  // NOLINT
/// The absolute value, and the smaller and the larger of two numbers; if equal, the first.
DECLARE_FUNCTION_1P(absolute)    // NOLINT
DECLARE_FUNCTION_2P(smaller_of)  // NOLINT
DECLARE_FUNCTION_2P(larger_of)   // NOLINT

/// The formula with sin^2 x + cos^2 x = 1, if that makes it shorter.
[[nodiscard]] GiNaC::ex shortened(const GiNaC::ex& formula);

}  // namespace assur::generator::emission::scene
