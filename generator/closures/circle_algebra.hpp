// Polynomials with side relations in place of sines, cosines and square roots.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "equations/variable.hpp"

namespace assur::generator::closures {

/// The largest integer multiple of an angle that is written as a polynomial in its cosine and sine.
inline constexpr int max_multiple = 64;

/// Thrown for an expression without a form in c and s, c^2 + s^2 = 1, and r, r^2 = radicand.
class NotAlgebraic : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Whether an expression contains roots, or angles whose cosine or sine is a root.
[[nodiscard]] bool makes_roots(const GiNaC::ex& expression);

/// A direction rotated by an integer multiple of an angle with the cosine and sine `step`,
/// multiplied out. Throws NotAlgebraic if that has too many terms.
[[nodiscard]] equations::Vector2 turned_by_multiple(const equations::Vector2& direction,
                                                    equations::Vector2 step, int factor);

/// The ring of polynomials in lengths, in the cosine c and sine s of each angle, c^2 + s^2 = 1, and
/// in square roots r, r^2 = radicand. An expression that is zero in it is zero at every point.
class CircleAlgebra {
 public:
  void add_angle(const GiNaC::symbol& angle);

  /// The expression with c, s and r in place of sines, cosines and roots, possibly a quotient of
  /// polynomials. Throws NotAlgebraic.
  [[nodiscard]] GiNaC::ex algebraic(const GiNaC::ex& expression);
  /// Whether the algebraic form is zero modulo the relations. False proves nothing if roots depend
  /// on each other, or if there are too many terms to multiply out.
  [[nodiscard]] bool vanishes(const GiNaC::ex& algebraic) const;
  /// The algebraic form at a point that gives values to lengths, cosines and sines. Throws
  /// NotAlgebraic where a radicand is negative or a denominator vanishes. `reversed` has a bit for
  /// each root, set for the negative root.
  [[nodiscard]] GiNaC::ex at(const GiNaC::ex& algebraic, const GiNaC::exmap& point,
                             unsigned reversed = 0) const;

  /// Whether all roots have rational values at a point. Throws NotAlgebraic as `at` does.
  [[nodiscard]] bool roots_are_rational(const GiNaC::exmap& point) const;

  /// (c, s) of an angle that was added.
  [[nodiscard]] const equations::Vector2& direction(const GiNaC::symbol& angle) const;
  /// An algebra with the same angles and roots, to which one expression may add its own roots.
  [[nodiscard]] CircleAlgebra extended() const;
  [[nodiscard]] std::size_t root_count() const { return roots_.size(); }
  /// The symbols of the roots with their radicands: algebraic, in earlier roots.
  [[nodiscard]] std::vector<std::pair<GiNaC::symbol, GiNaC::ex>> roots() const;
  /// Whether a symbol occurs in a radicand.
  [[nodiscard]] bool under_a_root(const GiNaC::symbol& symbol) const;

 private:
  [[nodiscard]] bool has_no_rest(const GiNaC::ex& algebraic) const;
  struct Root {
    GiNaC::symbol symbol{};
    GiNaC::ex radicand{};  ///< algebraic, in earlier roots
  };

  [[nodiscard]] GiNaC::ex converted(const GiNaC::ex& expression);
  [[nodiscard]] std::vector<GiNaC::ex> operands(const GiNaC::ex& expression) const;
  /// The direction of an angle that was added; nullptr for anything else.
  [[nodiscard]] const equations::Vector2* find_direction(const GiNaC::ex& angle) const;
  [[nodiscard]] equations::Vector2 direction_of(const GiNaC::ex& angle);
  [[nodiscard]] equations::Vector2 direction_of_term(const GiNaC::ex& base);
  [[nodiscard]] GiNaC::exmap with_roots(const GiNaC::exmap& point, unsigned reversed) const;
  [[nodiscard]] GiNaC::ex root_of(const GiNaC::ex& radicand);

  std::map<std::string, equations::Vector2> directions_;  ///< by the names of the angles
  std::vector<Root> roots_;
  bool in_order_ = false;  ///< operands are visited in canonical order, not in GiNaC's
  /// The algebraic forms of expressions; they are the same at every point.
  std::map<GiNaC::ex, GiNaC::ex, GiNaC::ex_is_less> known_;
};

}  // namespace assur::generator::closures
