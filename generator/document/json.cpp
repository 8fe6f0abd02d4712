// Renders a derivation as JSON.
#include <assur/text/json.hpp>

#include "document/render.hpp"

namespace assur::generator::document {

namespace {

using text::Json;

template <typename Items, typename Text>
Json array_of(const Items& items, const Text& text) {
  Json array = Json::array();
  for (const auto& item : items) {
    array.push_back(text(item));
  }
  return array;
}

Json variables(const std::vector<DerivedVariable>& list) {
  return array_of(list, [](const DerivedVariable& variable) {
    return Json{{"name", variable.name},
                {"quantity", variable.is_angle ? "angle" : "length"},
                {"rate", variable.rate},
                {"second_rate", variable.second_rate},
                {"meaning", variable.meaning}};
  });
}

Json quantities(const std::vector<DerivedQuantity>& list) {
  return array_of(list, [](const DerivedQuantity& quantity) {
    Json entry{{"name", quantity.name}, {"value", quantity.value}, {"meaning", quantity.meaning}};
    if (quantity.vanishes) {
      entry["vanishes"] = true;
    }
    return entry;
  });
}

Json closures(const Derivation& derivation) {
  return array_of(derivation.closures, [](const DerivedClosure& closure) {
    return Json{{"loop", closure.loop},
                {"vector", closure.equation},
                {"names", closure.names},
                {"scalars", closure.values}};
  });
}

std::string without_marks(std::string prose) {
  std::erase(prose, '`');
  return prose;
}

Json step_json(const DerivedStep& step) {
  return Json{{"title", step.title},
              {"rule", without_marks(step.rule)},
              {"formulas", step.formulas},
              {"eliminated", step.eliminated},
              {"quantities", quantities(step.quantities)},
              {"series", array_of(step.series, [](const DerivedSeries& series) {
                 return Json{
                     {"name", series.name},
                     {"formula", series.formula},
                     {"base", series.base},
                     {"terms", array_of(series.terms, [](const DerivedTerm& term) {
                        return Json{{"power", term.power}, {"re", term.re}, {"im", term.im}};
                      })}};
               })}};
}

Json elimination_json(const DerivedElimination& elimination) {
  return Json{{"steps", array_of(elimination.steps, step_json)},
              {"unknown", elimination.unknown},
              {"polynomial", elimination.polynomial},
              {"degree", elimination.degree},
              {"max_configurations", elimination.max_configurations},
              {"back_substitution",
               array_of(elimination.back_substitution, [](const DerivedBackSubstitution& back) {
                 return Json{{"unknown", back.unknown},
                             {"numerators", back.numerators},
                             {"denominator", back.denominator},
                             {"denominator_vanishes", back.degeneracy}};
               })}};
}

Json reactions(const std::vector<DerivedReaction>& list) {
  return array_of(list, [](const DerivedReaction& reaction) {
    Json entry{{"joint", reaction.joint}, {"on", reaction.on}, {"force", reaction.force}};
    if (!reaction.couple.empty()) {
      entry["couple"] = reaction.couple;
    }
    return entry;
  });
}

Json operations(const program::OperationCount& count) {
  return Json{{"multiplications", count.multiplications},
              {"additions", count.additions},
              {"divisions", count.divisions}};
}

Json forces_json(const DerivedForces& forces) {
  return Json{{"loads", array_of(forces.loads, [](const auto& load) { return Json(load); })},
              {"generalised", quantities(forces.generalised)},
              {"multipliers", quantities(forces.multipliers)},
              {"equations", forces.equations},
              {"reactions", quantities(forces.reactions)},
              {"couples", quantities(forces.couples)},
              {"joints", reactions(forces.joints)},
              {"neighbours", reactions(forces.neighbours)},
              {"operations", operations(forces.operations)},
              {"operations_of_loads", operations(forces.of_loads)}};
}

Json roles(const Derivation& derivation) {
  Json map = Json::object();
  for (const structure::JointIndex joint : derivation.roles.keys()) {
    map[std::string(1, derivation.model->group->joints()[joint].name)] = derivation.roles[joint];
  }
  return map;
}

Json eigenproblem_json(const DerivedEigenproblem& eigenproblem) {
  return Json{{"configurations", eigenproblem.configurations},
              {"ground", eigenproblem.ground},
              {"hidden", eigenproblem.hidden},
              {"size", eigenproblem.size},
              {"degree", eigenproblem.degree},
              {"choices", eigenproblem.choices},
              {"equations", eigenproblem.equations}};
}

}  // namespace

std::string derivation_json(const Derivation& derivation) {
  const structure::Model& model = *derivation.model;
  Json root;
  root["model"] = model.is_numbered() ? Json(model.number) : Json();
  root["group"] = model.group->name();
  root["kind"] = structure::spell(*model.group, model.representative);
  root["asked"] = structure::spell(*model.group, derivation.kind);
  root["plays"] = roles(derivation);
  root["unknowns"] = variables(derivation.unknowns);
  root["dimensions"] = variables(derivation.dimensions);
  root["inputs"] = variables(derivation.inputs);
  root["quantities"] = quantities(derivation.quantities);
  root["closures"] = closures(derivation);
  root["compatibility"] = derivation.compatibility;
  root["jacobian"] = derivation.jacobian.entries;
  root["dimension_jacobian"] = derivation.dimension_jacobian.entries;
  root["input_jacobian"] = derivation.input_jacobian.entries;
  root["velocity_rhs"] = derivation.velocity_rhs;
  root["acceleration_rhs"] = derivation.acceleration_rhs;
  root["mobility"] = derivation.mobility;
  root["rank"] = derivation.rank;
  root["verdict"] = derivation.rigid ? "rigid" : "degenerate";
  root["reason"] = derivation.reason;
  if (derivation.determinant) {
    const DerivedDeterminant& determinant = *derivation.determinant;
    root["determinant"] = determinant.value;
    root["determinant_text"] = determinant.text;
    root["determinant_quantities"] = quantities(determinant.quantities);
    root["framed_jacobian"] = {{"rows", determinant.framed.rows},
                               {"entries", determinant.framed.entries}};
    root["singularities"] = array_of(determinant.pivots, [](const DerivedPivot& pivot) {
      return Json{{"factor", pivot.value}, {"where", pivot.zero}, {"meaning", pivot.meaning}};
    });
  }
  if (derivation.elimination) {
    root["elimination"] = elimination_json(*derivation.elimination);
    root["forces"] = forces_json(*derivation.forces);
  }
  if (derivation.eigenproblem) {
    root["eigenproblem"] = eigenproblem_json(*derivation.eigenproblem);
  }
  return root.dump() + "\n";
}

}  // namespace assur::generator::document
