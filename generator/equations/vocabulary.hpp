// Turns repeated geometry (link vectors, slide directions) into named quantities of the equations.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "equations/variable.hpp"

namespace assur::generator::equations {

/// Whether an expression is a number or plus or minus a single symbol, and so needs no name.
[[nodiscard]] bool is_plain(const GiNaC::ex& expression);

/// A quantity with a name of its own: `BC_x`, the x-component of the vector from B to C.
struct NamedQuantity {
  /// Whether the quantity equals its definition, or the reciprocal or the square root of it.
  enum class Form : unsigned char { itself, reciprocal, square_root };

  GiNaC::symbol symbol;
  GiNaC::ex definition;  ///< in variables and quantities named earlier
  GiNaC::ex expanded;    ///< in variables alone
  std::string meaning;
  Form form = Form::itself;
};

/// The names that the equations of one model use. Because a rotated vector differentiates to the
/// same vector turned by a right angle, derivatives stay within the vocabulary.
class Vocabulary {
 public:
  /// Names a quantity. An expression that is a number or plus or minus a single symbol needs no
  /// name and is returned as it is; one that has a name already is returned under that name.
  GiNaC::ex name(const std::string& name, const GiNaC::ex& definition, const std::string& meaning);
  /// Names both components `<name>_x` and `<name>_y` of a vector.
  Vector2 name(const std::string& name, const Vector2& definition, const std::string& meaning);

  /// Gives a quantity the caller's symbol. `expand` keeps the symbol instead of the definition.
  void define(const GiNaC::symbol& symbol, const GiNaC::ex& definition, const std::string& meaning);
  /// Writes a quantity that equals its definition in another way, if all names in that come before
  /// it. Other symbols are left alone.
  void rewrite(const GiNaC::symbol& symbol, const GiNaC::ex& definition);
  /// Leaves out a quantity whose value is given.
  void leave_out(const GiNaC::symbol& symbol);

  /// Names one over a denominator; `degeneracy` says what its vanishing means, and is empty if it
  /// cannot vanish or its root says so. The reciprocal of a number is returned as a number.
  GiNaC::ex name_reciprocal(const std::string& name, const GiNaC::ex& denominator,
                            const std::string& degeneracy);

  /// Names a square root and one over it, which its derivatives need; `degeneracy` says what it
  /// means that the radicand vanishes or is negative. A root that has a name already is returned
  /// under that name, and the root of a square number as a number.
  GiNaC::ex name_root(const std::string& name, const GiNaC::ex& radicand,
                      const std::string& degeneracy);

  /// The expression in variables alone, expanded; reciprocals and roots stay as they are.
  [[nodiscard]] GiNaC::ex expand(const GiNaC::ex& expression) const;
  /// The total derivative, through the definitions, written in names where possible.
  [[nodiscard]] GiNaC::ex derivative(const GiNaC::ex& expression, const Variable& variable) const;
  /// The total derivatives by several variables; the derivative by each name is computed only once.
  [[nodiscard]] std::vector<GiNaC::ex> gradient(const GiNaC::ex& expression,
                                                const VariableList& variables) const;

  [[nodiscard]] const std::vector<NamedQuantity>& quantities() const { return quantities_; }

 private:
  [[nodiscard]] const NamedQuantity* find(NamedQuantity::Form form,
                                          const GiNaC::ex& expanded) const;
  /// The total derivative of a named quantity.
  [[nodiscard]] const GiNaC::ex& slope(const NamedQuantity& quantity,
                                       const Variable& variable) const;
  [[nodiscard]] GiNaC::ex recognise(const GiNaC::ex& expression) const;

  std::vector<NamedQuantity> quantities_;
  GiNaC::exmap expansions_;
  /// Total derivatives by the names of quantity and variable, so that each is computed only once.
  mutable std::map<std::pair<std::string, std::string>, GiNaC::ex> slopes_;
};

}  // namespace assur::generator::equations
