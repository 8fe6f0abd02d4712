#include "listed_configuration.hpp"

#include <algorithm>
#include <cmath>

#include "branch_motions.hpp"
#include "plan/plan_data.hpp"
#include "relative_frames.hpp"

namespace assur::mechanism::solve {

namespace {

bool are_finite(double rate) { return std::isfinite(rate); }
template <typename Vector>
bool are_finite(const Vector& rates) {
  return rates.allFinite();
}

/// Whether the requested velocities and accelerations are within the range of double.
bool are_rates_finite(const Request& request, const Configuration& configuration) {
  const auto is_finite = [&](const auto& item) {
    return (!request.want.velocity || are_finite(item.velocity)) &&
           (!request.want.acceleration || are_finite(item.acceleration));
  };
  bool finite = std::ranges::all_of(configuration.outputs.items(), is_finite);
  for (const LinkIndex link : configuration.links.keys()) {
    finite = finite && (!request.reported.has(link) || is_finite(configuration.links[link]));
  }
  for (const SlideState& slide : configuration.slides) {
    finite = finite && (!request.reported.has(slide.joint) || is_finite(slide));
  }
  return finite;
}

}  // namespace

void write_configuration(const Placement& placement, bool finds_motions, Configuration& result) {
  const PlacedLinks& placed = placement.placed();
  const Values& values = placement.values();
  const Mechanism& mechanism = placement.plan().mechanism;
  result.links.resize(mechanism.links().size());
  for (const LinkIndex link : mechanism.links().keys()) {
    result.links[link] = placed.links[link];
  }
  result.slides = placed.slides;
  const Linkage& linkage = placement.structure().linkage;
  if (!linkage.second_pins.empty()) {
    std::erase_if(result.slides, [](const SlideState& slide) { return !slide.joint.exists(); });
    for (const JointIndex pin : linkage.second_pins) {
      result.slides.push_back(measured_slide(values, placed.links, pin));
    }
  }
  result.counted = placed.counted;
  result.regularity = placed.regularity;
  result.derivatives_known = placed.derivatives_known;
  result.rates_known = placed.rates_known;
  result.path_known = placed.path_known;
  const Request& request = placement.plan().request;
  if (!result.derivatives_known && request.sweep) {
    find_derivatives(values, placed, request.sweep->parameter, result);
  }
  result.outputs.resize(mechanism.outputs().size());
  for (const OutputIndex output : mechanism.outputs().keys()) {
    const FeatureIndex point = mechanism.outputs()[output].point;
    carry(result.links[mechanism.features()[point].link], values.frame(point),
          result.outputs[output]);
  }
  result.residual = placed.residual;
  if (!are_rates_finite(placement.plan().request, result)) {
    result.regularity = Status::near_singular;
  }
  result.branches.clear();
  result.determinants = placed.determinants;
  result.plan = placement.shared_plan();
  result.proofs.resize(0);
  for (const GroupIndex group : placement.structure().groups.keys()) {
    if (request.prove) {
      result.proofs.add(placement.solver(group).proof(placed.links));
    }
  }
  if (finds_motions && !result.rates_known && placed.is_crossing &&
      (request.want.velocity || request.want.acceleration || request.want.loaded())) {
    find_branches(values, result);
  }
}

}  // namespace assur::mechanism::solve
