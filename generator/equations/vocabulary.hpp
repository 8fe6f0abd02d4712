// Named quantities of equations for repeated geometry, such as link vectors and slide directions.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "equations/variable.hpp"

namespace assur::generator::equations {

/// Whether an expression is a number or plus or minus a single symbol, and so needs no name.
[[nodiscard]] bool is_plain(const GiNaC::ex& expression);

/// A named quantity: `BC_x`, the x-component of the vector from B to C.
struct NamedQuantity {
  /// Whether the quantity equals its definition, or the reciprocal or the square root of it.
  enum class Form : unsigned char { itself, reciprocal, square_root };

  GiNaC::symbol symbol;
  GiNaC::ex definition;  ///< in variables and quantities named earlier
  GiNaC::ex expanded;    ///< in variables only
  std::string meaning;
  Form form = Form::itself;
};

/// The names in the equations of one model. Since the derivative of a rotated vector is the same
/// vector rotated by a right angle, derivatives can be written in these names.
class Vocabulary {
 public:
  /// Names a quantity. A number, or plus or minus a single symbol, needs no name and is returned
  /// unchanged; an expression that has a name already is returned under that name.
  GiNaC::ex name(const std::string& name, const GiNaC::ex& definition, const std::string& meaning);
  /// Names both components `<name>_x` and `<name>_y` of a vector.
  Vector2 name(const std::string& name, const Vector2& definition, const std::string& meaning);

  /// Names a quantity by the caller's symbol, which `expand` keeps instead of its definition.
  void define(const GiNaC::symbol& symbol, const GiNaC::ex& definition, const std::string& meaning);
  /// Replaces the definition of a quantity by an equal one, if all names in it are defined earlier.
  /// Has no effect on other symbols.
  void rewrite(const GiNaC::symbol& symbol, const GiNaC::ex& definition);
  /// Removes a quantity whose value is given.
  void leave_out(const GiNaC::symbol& symbol);

  /// Names the reciprocal of a denominator. `degeneracy`: the meaning of a zero denominator; empty
  /// if it cannot vanish or its root has one. The reciprocal of a number is a number.
  GiNaC::ex name_reciprocal(const std::string& name, const GiNaC::ex& denominator,
                            const std::string& degeneracy);

  /// Names a square root and its reciprocal, which derivatives need. `degeneracy`: the meaning of a
  /// zero or negative radicand. A root that has a name already is returned under that name, and the
  /// root of a square number as a number.
  GiNaC::ex name_root(const std::string& name, const GiNaC::ex& radicand,
                      const std::string& degeneracy);

  /// The expression in variables only, expanded; reciprocals and roots keep their symbols.
  [[nodiscard]] GiNaC::ex expand(const GiNaC::ex& expression) const;
  /// The total derivative through the definitions, written in names where possible.
  [[nodiscard]] GiNaC::ex derivative(const GiNaC::ex& expression, const Variable& variable) const;
  /// The total derivatives with respect to several variables; each name is differentiated once.
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
  /// Total derivatives, found by the names of quantity and variable.
  mutable std::map<std::pair<std::string, std::string>, GiNaC::ex> slopes_;
};

}  // namespace assur::generator::equations
