#include "emission/model/force_function.hpp"

namespace assur::generator::emission::model {

namespace {

const std::vector<Parameter> place_and_loads = {{"const Dimensions<Scalar>&", "d"},
                                                {"const Inputs<Scalar>&", "u"},
                                                {"const Configuration<Scalar>&", "q"},
                                                {"const Matrix<Scalar, link_count, 3>&", "loads"}};

ForceFunction of_loads(const forces::GroupForces& forces, ModelFunction function) {
  ForceFunction result{{std::move(function), forces.vocabulary}, {}};
  std::size_t row = 0;
  for (const forces::LinkLoad& load : forces.loads) {
    result.given.emplace_back(load.x, program::entry("loads", row, 0));
    result.given.emplace_back(load.y, program::entry("loads", row, 1));
    result.given.emplace_back(load.moment, program::entry("loads", row, 2));
    ++row;
  }
  // Quantities of the vocabulary keep their meanings in every function.
  row = 0;
  for (const GiNaC::symbol& component : forces.given) {
    result.given.emplace_back(component, program::entry("lambda", row++));
  }
  return result;
}

}  // namespace

void ForceFunction::take_reciprocals(const std::vector<GiNaC::symbol>& reciprocals) {
  if (reciprocals.empty()) {
    return;
  }
  naming.function.doc.emplace_back("The `reciprocals` come from the rates.");
  naming.function.inputs.push_back({"const Vector<Scalar, reciprocal_count>&", "reciprocals"});
  std::size_t row = 0;
  for (const GiNaC::symbol& reciprocal : reciprocals) {
    naming.vocabulary.leave_out(reciprocal);
    given.emplace_back(reciprocal, program::entry("reciprocals", row++));
  }
}

void tell_reciprocals(const std::vector<GiNaC::symbol>& reciprocals, ModelFunction& function) {
  if (reciprocals.empty()) {
    return;
  }
  function.doc.emplace_back("The forces need the `reciprocals`.");
  function.outputs.push_back({"Vector<Scalar, reciprocal_count>&", "reciprocals"});
  std::size_t row = 0;
  for (const GiNaC::symbol& reciprocal : reciprocals) {
    function.results.push_back({program::entry("reciprocals", row++), reciprocal});
  }
}

ForceFunction force_function(const forces::GroupForces& forces) {
  ForceFunction result = of_loads(
      forces,
      {"forces",
       {"The forces F in the joints, rows (F_x, F_y, couple) joint by joint, under the given",
        "loads, rows (x, y, moment about the origin of the link's frame) link by link, all in the",
        "directions of the fixed frame. A force acts on the joint's second link, and the opposite",
        "one on its first: at the joint, or at a slide at the foot on the second link of the",
        "perpendicular from the origin of that link's frame, with the couple."},
       place_and_loads,
       {{"Matrix<Scalar, joint_count, 3>&", "F"}},
       {}});
  ModelFunction& function = result.naming.function;
  if (!forces.given.empty()) {
    function.name = "forces_with_multipliers";
    function.doc.emplace_back("`lambda` holds the forces in the joints that close the loops.");
    function.inputs.push_back({"const Vector<Scalar, equation_count>&", "lambda"});
  }
  std::size_t row = 0;
  for (const forces::JointReaction& joint : forces.joints) {
    function.results.push_back({program::entry("F", row, 0), joint.force.x});
    function.results.push_back({program::entry("F", row, 1), joint.force.y});
    function.results.push_back({program::entry("F", row, 2), joint.couple.value_or(0)});
    ++row;
  }
  return result;
}

ForceFunction load_function(const forces::GroupForces& forces) {
  ForceFunction result = of_loads(
      forces, {"generalised_loads",
               {"Q: what the loads do per unit of each unknown, where the joints that close",
                "the loops are cut."},
               place_and_loads,
               {{"Vector<Scalar, unknown_count>&", "Q"}},
               {}});
  std::size_t row = 0;
  for (const GiNaC::ex& load : forces.generalised) {
    result.naming.function.results.push_back({program::entry("Q", row++), load});
  }
  return result;
}

program::SymbolOrder ForceFunction::order(
    const equations::ClosureEquations& equations,
    const std::vector<equations::NamedQuantity>& known) const {
  std::vector<GiNaC::symbol> symbols;
  for (const auto& [symbol, entry] : given) {
    symbols.push_back(symbol);
  }
  return program::symbol_order(equations, naming.vocabulary, known, symbols);
}

}  // namespace assur::generator::emission::model
