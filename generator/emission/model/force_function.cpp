#include "emission/model/force_function.hpp"

namespace assur::generator::emission::model {

ForceFunction force_function(const forces::GroupForces& forces) {
  ForceFunction result{
      {{"forces",
        {"The forces F in the joints, rows (F_x, F_y, couple) joint by joint, under the given",
         "loads, rows (x, y, moment about the origin of the link's frame) link by link, all in the",
         "directions of the fixed frame. A force acts on the joint's second link, and the opposite",
         "one on its first: at the joint, or at a slide at the foot on the second link of the",
         "perpendicular from the origin of that link's frame, with the couple."},
        {{"const Dimensions<Scalar>&", "d"},
         {"const Inputs<Scalar>&", "u"},
         {"const Configuration<Scalar>&", "q"},
         {"const Matrix<Scalar, link_count, 3>&", "loads"}},
        {{"Matrix<Scalar, joint_count, 3>&", "F"}},
        {}},
       forces.vocabulary},
      {}};
  std::size_t row = 0;
  for (const forces::LinkLoad& load : forces.loads) {
    result.loads.emplace_back(load.x, entry("loads", row, 0));
    result.loads.emplace_back(load.y, entry("loads", row, 1));
    result.loads.emplace_back(load.moment, entry("loads", row, 2));
    ++row;
  }
  std::vector<program::Result>& results = result.naming.function.results;
  row = 0;
  for (const forces::JointReaction& joint : forces.joints) {
    results.push_back({entry("F", row, 0), joint.force.x});
    results.push_back({entry("F", row, 1), joint.force.y});
    results.push_back({entry("F", row, 2), joint.couple.value_or(0)});
    ++row;
  }
  return result;
}

program::SymbolOrder ForceFunction::order(
    const equations::ClosureEquations& equations,
    const std::vector<equations::NamedQuantity>& known) const {
  std::vector<GiNaC::symbol> given;
  for (const auto& [symbol, entry] : loads) {
    given.push_back(symbol);
  }
  return program::symbol_order(equations, naming.vocabulary, known, given);
}

}  // namespace assur::generator::emission::model
