#include "emission/scene/listing_statements.hpp"

#include "emission/scene/carried_links.hpp"

namespace assur::generator::emission::scene {

namespace {

/// The values of the wanted members of a part of a state: `{pose, velocity}`.
cpp::Expression state_of(const mechanism::Want& want, const cpp::Expression& position,
                         const cpp::Expression& rates,
                         const std::vector<cpp::Expression>& more = {}) {
  std::vector<cpp::Expression> values;
  const auto rate = [&](std::size_t order) { return rates.at({cpp::word(order)}); };
  if (want.position) {
    values.push_back(position);
  }
  if (want.velocity) {
    values.push_back(rate(0));
  }
  if (want.acceleration) {
    values.push_back(rate(1));
  }
  values.insert(values.end(), more.begin(), more.end());
  return cpp::braces("", std::move(values));
}

}  // namespace

cpp::Block listing_statements(const SolverScene& solver, const std::vector<std::string>& slides) {
  const mechanism::Want& want = solver.plan.request().want;
  const cpp::Expression state = cpp::variable("state");
  FunctionBody body = solver.body();
  for (const mechanism::LinkIndex link : solver.mechanism().links().keys()) {
    if (solver.reports(link)) {
      const std::string& member = solver.members.links[link];
      const cpp::Expression frame = cpp::variable("placed").member(member);
      body.add(
          cpp::assigned(state.member("links").member(member),
                        state_of(want, frame.member("pose"), frame.member("rates").member("col"))));
    }
  }
  for (const std::string& slide : slides) {
    const cpp::Expression placed = placed_slide(slide);
    body.add(cpp::assigned(state.member("slides").member(slide),
                           state_of(want, placed.member("displacement"), placed.member("rates"))));
  }
  const bool is_sensitive = solver.parameters.count() > 0 || solver.has_tolerances();
  if (!want.position && !want.velocity && !want.acceleration && !is_sensitive) {
    return body.block();
  }
  for (const mechanism::OutputIndex index : solver.mechanism().outputs().keys()) {
    const mechanism::FeatureIndex output = solver.mechanism().outputs()[index].point;
    const mechanism::Feature& feature = solver.mechanism().features()[output];
    const LinkFeature<SceneNumber> place = solver.numbers.feature(output, false);
    const cpp::Expression value = body.point(feature_name(solver, feature.name, feature.link),
                                             solver.placed(feature.link), place.x, place.y);
    const cpp::Expression point = body.local("point_" + solver.members.outputs[index]);
    body.add(cpp::declared({"const LinkPoint", "LinkPoint"}, point, value));
    std::vector<cpp::Expression> sensitive;
    const cpp::Expression gradient = point.member("gradient");
    if (solver.parameters.count() > 0) {
      sensitive.push_back(gradient);
    }
    if (solver.has_tolerances()) {
      for (const char* bound : {"support::worst_case", "support::root_sum_square"}) {
        sensitive.push_back(cpp::call(bound, {gradient, cpp::variable("tolerances")}));
      }
    }
    body.add(cpp::assigned(state.member("outputs").member(solver.members.outputs[index]),
                           state_of(want, cpp::braces("", {point.member("x"), point.member("y")}),
                                    point.member("rates").member("col"), sensitive)));
  }
  return body.block();
}

}  // namespace assur::generator::emission::scene
