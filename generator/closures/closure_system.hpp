// Turns declared symbols and closure equations into derivatives.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
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
  GiNaC::symbol symbol;
  GiNaC::symbol rate;
  GiNaC::symbol second_rate;
};

/// f(q, a) = 0 with unknowns q and parameters a, and expressions in them. Expressions hold sines
/// and cosines as such, abbreviations as symbols of their own, and total derivatives dq/da, q' and
/// q'' as symbols whose values belong to a point (ClosurePoints): J dq/da = -df/da, J q' = -(df/da)
/// a', and so on.
class ClosureSystem {
 public:
  struct Closure {
    std::string name;
    GiNaC::ex expression;
    bool turned = false;  ///< all its signs are reversed
  };

  /// D(unknown, parameter), as a symbol.
  struct Sensitivity {
    const AuditSymbol* unknown;
    const AuditSymbol* parameter;
    GiNaC::symbol symbol;
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

  /// de/dx with all other symbols held; abbreviations are differentiated through.
  [[nodiscard]] GiNaC::ex partial(const GiNaC::ex& expression, const GiNaC::symbol& symbol) const;
  /// de/da where the unknowns follow the closures.
  [[nodiscard]] GiNaC::ex total(const GiNaC::ex& expression, const AuditSymbol& parameter);
  /// de/dt by the rates of unknowns and moving parameters; for an expression in rates, by the
  /// second rates, too.
  [[nodiscard]] GiNaC::ex rate(const GiNaC::ex& expression) const;

  /// Abbreviations replaced by what they stand for.
  [[nodiscard]] GiNaC::ex expanded(const GiNaC::ex& expression) const;
  /// Whether an expression holds total derivatives or rates, which have values only at points.
  [[nodiscard]] bool follows_closures(const GiNaC::ex& expression) const;

  [[nodiscard]] std::vector<const AuditSymbol*> unknowns() const;
  /// The sensitivities that total derivatives so far contain.
  [[nodiscard]] const std::deque<Sensitivity>& sensitivities() const { return sensitivities_; }
  /// A number that changes whenever symbols or closures change.
  [[nodiscard]] unsigned revision() const { return revision_; }

 private:
  std::deque<AuditSymbol> symbols_;
  std::vector<GiNaC::symbol> abbreviations_;  ///< in their order
  std::map<std::string, GiNaC::symbol> abbreviation_names_;
  GiNaC::exmap definitions_;  ///< of abbreviations, each in earlier ones only
  GiNaC::exmap whole_;        ///< each abbreviation without abbreviations
  Extents extents_;
  std::size_t parts_ = 0;
  std::vector<Closure> closures_;
  std::deque<Sensitivity> sensitivities_;
  unsigned revision_ = 0;
};

}  // namespace assur::generator::closures
