// Declared symbols, closure equations, and derivatives of any order along their solutions.
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

/// A symbol that an audit file declares, or that its model has.
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
  std::string meaning;   ///< what the file says of it, for people
  bool unknown = false;  ///< determined by the closures
  bool moving = false;   ///< a parameter with rates of its own
  bool steady = false;   ///< its rate is constant
  GiNaC::symbol symbol;
  GiNaC::symbol rate;
  GiNaC::symbol second_rate;
};

/// A derivative of all unknowns q along the solutions of the closures, which has a symbol for each
/// of them: D_a1 D_a2 ... d^k/dt^k of the unknowns, or of a partial derivative of an earlier
/// derivative. Total derivatives by parameters and by time may be taken in any order, since rates
/// of parameters do not depend on parameters, so that one order has the symbols.
struct ClosureDerivative {
  const ClosureDerivative* of = nullptr;   ///< has the partial derivative; null: q itself
  const AuditSymbol* partly_by = nullptr;  ///< what that is by
  std::vector<const AuditSymbol*> by;      ///< parameters of D, in the order of their declaration
  int times = 0;                           ///< how often by time, last
};

/// f(q, a) = 0 with unknowns q and parameters a, and expressions in them. Expressions hold sines
/// and cosines as such, abbreviations as symbols of their own, and derivatives of unknowns as
/// symbols whose values belong to a point (ClosurePoints). Each such derivative x solves equations
/// J x + r = 0 with J = df/dq, which are the derivatives of f, or of those of the derivative that
/// it is a derivative of: J dq/da = -df/da, J q' = -(df/da) a', and so on.
class ClosureSystem {
 public:
  struct Closure {
    std::string name;
    GiNaC::ex expression;
    bool turned = false;  ///< all its signs are reversed
  };

  AuditSymbol& declare(const std::string& name, bool angle, const std::string& meaning = "");
  /// Lets the name stand for the expression, in which earlier abbreviations may occur.
  void abbreviate(const std::string& name, const GiNaC::ex& definition);
  void close(const std::string& name, const GiNaC::ex& expression);
  /// Reverses all signs of a closure.
  void negate_closure(const std::string& name);

  [[nodiscard]] AuditSymbol* symbol_named(const std::string& name);
  [[nodiscard]] const AuditSymbol* symbol_named(const std::string& name) const;
  [[nodiscard]] const GiNaC::ex* closure_named(const std::string& name) const;
  /// The closure with its signs as they were typed.
  [[nodiscard]] GiNaC::ex closure_as_typed(const std::string& name) const;
  [[nodiscard]] bool is_known(const std::string& name) const;
  /// What a name stands for in a formula, or nothing.
  [[nodiscard]] std::optional<GiNaC::ex> meaning_of(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] const std::vector<Closure>& closures() const { return closures_; }
  [[nodiscard]] const std::deque<AuditSymbol>& symbols() const { return symbols_; }
  /// What an abbreviation stands for; nullptr for all else.
  [[nodiscard]] const GiNaC::ex* definition_of(const GiNaC::ex& symbol) const;
  [[nodiscard]] const Extents& extents() const { return extents_; }
  /// The number of parts of all abbreviations, each without abbreviations.
  [[nodiscard]] std::size_t part_count() const { return parts_; }

  /// de/dx with all other symbols held, rates of parameters among them; abbreviations are
  /// differentiated through, and so are derivatives, as functions of unknowns, parameters and
  /// rates.
  [[nodiscard]] GiNaC::ex partial(const GiNaC::ex& expression, const AuditSymbol& by);
  /// de/da where the unknowns follow the closures, with the rates of parameters held.
  [[nodiscard]] GiNaC::ex total(const GiNaC::ex& expression, const AuditSymbol& parameter);
  /// de/da' by the rate of a parameter, or by its second rate, where the rates of the unknowns
  /// follow the closures: dq'/da' is dq/da, dq''/da' is 2 d/dt(dq/da). Nothing where e has partial
  /// derivatives of derivatives.
  [[nodiscard]] std::optional<GiNaC::ex> by_rate(const GiNaC::ex& expression,
                                                 const AuditSymbol& parameter, int order);
  /// de/dt by the rates of unknowns and moving parameters.
  [[nodiscard]] GiNaC::ex rate(const GiNaC::ex& expression);
  /// de/dx with all symbols in the expression held, also those of derivatives.
  [[nodiscard]] GiNaC::ex slope(const GiNaC::ex& expression, const GiNaC::symbol& symbol) const;

  /// What a symbol is a derivative of; nullptr for other symbols.
  [[nodiscard]] const ClosureDerivative* derivative_of(const GiNaC::ex& symbol) const;
  /// The symbols of a derivative, in the order of the unknowns.
  [[nodiscard]] std::vector<GiNaC::symbol> symbols_of(const ClosureDerivative& derivative);
  /// J x + r, which vanish for the symbols x of a derivative, one for each closure.
  [[nodiscard]] std::vector<GiNaC::ex> equations_of(const ClosureDerivative& derivative);
  /// Whether a symbol is a rate, of any order, of a parameter, and of which one; else nullptr.
  [[nodiscard]] const AuditSymbol* moved_by(const GiNaC::ex& symbol) const;

  /// Abbreviations replaced by what they stand for.
  [[nodiscard]] GiNaC::ex expanded(const GiNaC::ex& expression) const;
  /// Whether an expression holds total derivatives or rates, which have values only at points.
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
  /// A rate of a parameter, or one of its rates.
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
  std::vector<GiNaC::symbol> abbreviations_;  ///< in their order
  std::map<std::string, GiNaC::symbol> abbreviation_names_;
  GiNaC::exmap definitions_;  ///< of abbreviations, each in earlier ones only
  GiNaC::exmap whole_;        ///< each abbreviation without abbreviations
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
