#include "listed_configuration.hpp"

#include "branch_motions.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

void write_configuration(const Placement& placement, Configuration& result) {
  const PlacedLinks& placed = placement.placed();
  const Values& values = placement.values();
  const Mechanism& mechanism = placement.plan().mechanism;
  result.links.resize(mechanism.links().size());
  for (const LinkIndex link : mechanism.links().keys()) {
    result.links[link] = placed.links[link];
  }
  result.slides = placed.slides;
  result.counted = placed.counted;
  result.outputs.resize(mechanism.outputs().size());
  for (const OutputIndex output : mechanism.outputs().keys()) {
    const FeatureIndex point = mechanism.outputs()[output].point;
    carry(placed.links[mechanism.features()[point].link], values.frame(point),
          result.outputs[output]);
  }
  result.regularity = placed.regularity;
  result.derivatives_known = placed.derivatives_known;
  result.rates_known = placed.rates_known;
  result.path_known = placed.path_known;
  result.residual = placed.residual;
  result.branches.clear();
  result.determinants = placed.determinants;
  result.plan = placement.shared_plan();
  const Request& request = placement.plan().request;
  if (!result.rates_known && placed.is_crossing &&
      (request.want.velocity || request.want.acceleration)) {
    find_branches(values, placed, result);
  }
  if (!result.derivatives_known && request.sweep) {
    find_derivatives(values, placed, request.sweep->parameter, result);
  }
}

}  // namespace assur::mechanism::solve
