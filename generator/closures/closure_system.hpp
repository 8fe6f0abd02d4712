// Symbols, closure equations, and derivatives of any order along their solutions.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "closures/extent.hpp"
#include "equations/variable.hpp"

namespace assur::generator::closures {

/// A symbol of an audit file or of its model.
struct AuditSymbol {
  AuditSymbol(const std::string& name_in, bool angle_in, std::string meaning_in)
      : name(name_in),
        angle(angle_in),
        meaning(std::move(meaning_in)),
        symbol(name_in),
        rate("rate(" + name_in + ")"),
        second_rate("rate2(" + name_in + ")") {}

  std::string name;
  bool angle;
  std::string meaning;   ///< its description in the file
  bool unknown = false;  ///< determined by the closures
  bool moving = false;   ///< a parameter with rates of its own
  bool steady = false;   ///< its rate is constant
  GiNaC::symbol symbol;
  GiNaC::symbol rate;
  GiNaC::symbol second_rate;
};

/// A derivative of all unknowns q along the solutions of the closures, with a symbol for each: D_a1
/// D_a2 ... d^k/dt^k of the unknowns, or of a partial derivative of an earlier derivative. Total
/// derivatives with respect to parameters and to time commute, since rates of parameters do not
/// depend on parameters, so that symbols exist for one order only.
struct ClosureDerivative {
  const ClosureDerivative* of = nullptr;   ///< its partial derivative is taken; null: q itself
  const AuditSymbol* partly_by = nullptr;  ///< the variable of that partial derivative
  std::vector<const AuditSymbol*> by;      ///< parameters of D, in order of declaration
  int times = 0;                           ///< number of time derivatives, taken last
};

/// f(q, a) = 0 with unknowns q and parameters a, and expressions in them. Expressions contain sines
/// and cosines, abbreviations as symbols of their own, and derivatives of unknowns as symbols whose
/// values belong to a point (ClosurePoints). Each such derivative x solves equations J x + r = 0
/// with J = df/dq, which follow by differentiating f, or the equations of a lower derivative: J
/// dq/da = -df/da, J q' = -(df/da) a', and so on.
class ClosureSystem {
 public:
  struct Closure {
    std::string name;
    GiNaC::ex expression;
    bool turned = false;  ///< all its signs are reversed
  };

  AuditSymbol& declare(const std::string& name, bool angle, const std::string& meaning = "");
  /// Defines an abbreviation; the expression may contain earlier ones.
  void abbreviate(const std::string& name, const GiNaC::ex& definition);
  void close(const std::string& name, const GiNaC::ex& expression);
  /// Reverses all signs of a closure.
  void negate_closure(const std::string& name);

  [[nodiscard]] AuditSymbol* symbol_named(const std::string& name);
  [[nodiscard]] const AuditSymbol* symbol_named(const std::string& name) const;
  [[nodiscard]] const GiNaC::ex* closure_named(const std::string& name) const;
  /// The closure with its signs as typed.
  [[nodiscard]] GiNaC::ex closure_as_typed(const std::string& name) const;
  [[nodiscard]] bool is_known(const std::string& name) const;
  /// The meaning of a name in a formula; empty if there is none.
  [[nodiscard]] std::optional<GiNaC::ex> meaning_of(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] const std::vector<Closure>& closures() const { return closures_; }
  [[nodiscard]] const std::deque<AuditSymbol>& symbols() const { return symbols_; }
  /// The definition of an abbreviation; nullptr for anything else.
  [[nodiscard]] const GiNaC::ex* definition_of(const GiNaC::ex& symbol) const;
  [[nodiscard]] const Extents& extents() const { return extents_; }
  /// The number of parts of all abbreviations, with abbreviations expanded.
  [[nodiscard]] std::size_t part_count() const { return parts_; }

  /// de/dx with all other symbols held, also rates of parameters; abbreviations are differentiated
  /// through, and so are derivatives, as functions of unknowns, parameters and rates.
  [[nodiscard]] GiNaC::ex partial(const GiNaC::ex& expression, const AuditSymbol& by);
  /// de/da along the solutions of the closures, with the rates of parameters held.
  [[nodiscard]] GiNaC::ex total(const GiNaC::ex& expression, const AuditSymbol& parameter);
  /// de/da' or de/da'' for the first or second rate of a parameter, with the rates of the unknowns
  /// from the closures: dq'/da' is dq/da, dq''/da' is 2 d/dt(dq/da). Empty if e contains partial
  /// derivatives of derivatives.
  [[nodiscard]] std::optional<GiNaC::ex> by_rate(const GiNaC::ex& expression,
                                                 const AuditSymbol& parameter, int order);
  /// de/dt from the rates of unknowns and moving parameters.
  [[nodiscard]] GiNaC::ex rate(const GiNaC::ex& expression);
  /// de/dx with all other symbols in the expression held, also those of derivatives.
  [[nodiscard]] GiNaC::ex slope(const GiNaC::ex& expression, const GiNaC::symbol& symbol) const;

  /// The derivative that a symbol belongs to; nullptr for other symbols.
  [[nodiscard]] const ClosureDerivative* derivative_of(const GiNaC::ex& symbol) const;
  /// The symbols of a derivative, in the order of the unknowns.
  [[nodiscard]] std::vector<GiNaC::symbol> symbols_of(const ClosureDerivative& derivative);
  /// J x + r, zero for the symbols x of a derivative, one for each closure.
  [[nodiscard]] std::vector<GiNaC::ex> equations_of(const ClosureDerivative& derivative);
  /// The parameter of which a symbol is a rate of any order; nullptr for other symbols.
  [[nodiscard]] const AuditSymbol* moved_by(const GiNaC::ex& symbol) const;

  /// The expression with abbreviations replaced by their definitions.
  [[nodiscard]] GiNaC::ex expanded(const GiNaC::ex& expression) const;
  /// Whether an expression contains total derivatives or rates, which have values only at points.
  [[nodiscard]] bool follows_closures(const GiNaC::ex& expression) const;

  [[nodiscard]] std::vector<const AuditSymbol*> unknowns() const;
  /// A number that changes whenever symbols or closures change.
  [[nodiscard]] unsigned revision() const { return revision_; }

 private:
  /// The symbol of a derivative for one unknown.
  struct Component {
    const ClosureDerivative* derivative;
    const AuditSymbol* unknown;
    GiNaC::symbol symbol;
  };
  /// A rate of a parameter, or a higher one.
  struct Rate {
    const AuditSymbol* symbol;
    int order;
  };

  [[nodiscard]] const ClosureDerivative& derivative(const ClosureDerivative& wanted);
  [[nodiscard]] const GiNaC::symbol& component(const ClosureDerivative& derivative,
                                               const AuditSymbol& unknown);
  [[nodiscard]] const Component* component_of(const GiNaC::ex& symbol) const;
  [[nodiscard]] GiNaC::symbol rate_symbol(const AuditSymbol& symbol, int order);
  /// The sum of de/ds ds over the symbols s of derivatives in an expression, where ds is the same
  /// component of a further derivative.
  template <typename Further>
  [[nodiscard]] GiNaC::ex through_derivatives(const GiNaC::ex& expression, const Further& further);

  std::deque<AuditSymbol> symbols_;
  std::vector<GiNaC::symbol> abbreviations_;  ///< in order of definition
  std::map<std::string, GiNaC::symbol> abbreviation_names_;
  GiNaC::exmap definitions_;  ///< of abbreviations, each in earlier ones only
  GiNaC::exmap whole_;        ///< definitions with all abbreviations expanded
  Extents extents_;
  std::size_t parts_ = 0;
  std::vector<Closure> closures_;
  std::deque<ClosureDerivative> derivatives_;
  std::map<GiNaC::ex, Component, GiNaC::ex_is_less> components_;
  std::map<std::pair<const ClosureDerivative*, const AuditSymbol*>, GiNaC::symbol>
      component_symbols_;
  std::map<std::pair<const AuditSymbol*, int>, GiNaC::symbol> higher_rates_;
  unsigned revision_ = 0;
};

}  // namespace assur::generator::closures
