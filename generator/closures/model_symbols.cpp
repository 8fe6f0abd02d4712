#include "closures/model_symbols.hpp"

#include <assur/text/error.hpp>

#include "equations/closure.hpp"
#include "structure/kind.hpp"

namespace assur::generator::closures {

namespace {

const structure::Model& model_that_has(const std::string& text) {
  for (const structure::Group& group : structure::known_groups()) {
    if (const std::optional<structure::Kind> kind = structure::parse_kind(group, text)) {
      return structure::model_of(group, *kind);
    }
  }
  throw text::InputError("no group has a kind '" + text + "'; a tetrad's is spelled like RRP-RRR");
}

}  // namespace

void declare_model(const std::string& kind, ClosureSystem& system) {
  const equations::ClosureEquations equations = equations::closure_equations(model_that_has(kind));
  GiNaC::exmap in_angles;
  for (const auto* list : {&equations.unknowns, &equations.dimensions, &equations.inputs}) {
    for (const equations::Variable& variable : *list) {
      if (system.is_known(variable.name)) {
        throw text::InputError("the model's '" + variable.name + "' is declared already");
      }
      AuditSymbol& symbol = system.declare(variable.name, variable.is_angle());
      symbol.unknown = list == &equations.unknowns;
      symbol.moving = list == &equations.inputs;
      if (variable.is_angle()) {
        in_angles[variable.cosine] = GiNaC::cos(symbol.symbol);
        in_angles[variable.sine] = GiNaC::sin(symbol.symbol);
      } else {
        in_angles[variable.value] = symbol.symbol;
      }
    }
  }
  int number = 0;
  for (const GiNaC::ex& residual : equations.residuals) {
    system.close("f" + std::to_string(++number),
                 equations.vocabulary.expand(residual).subs(in_angles));
  }
}

}  // namespace assur::generator::closures
