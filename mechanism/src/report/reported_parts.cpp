// Selection of the reported parts and known numbers of a configuration.
#include <algorithm>
#include <assur/mechanism/followed_parts.hpp>
#include <assur/mechanism/reported_parts.hpp>
#include <limits>

namespace assur::mechanism {

Configuration without_derivatives(const Plan& plan, Configuration configuration) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const auto forget = [=](auto& item) {
    item.follows.first *= unknown;
    for (auto& second : item.follows.second) {
      second *= unknown;
    }
  };
  for_each_followed(plan.mechanism(), plan.structure(), configuration, forget);
  configuration.derivatives_known = true;
  return configuration;
}

std::vector<LinkIndex> reported_links(const Plan& plan, bool with_ground) {
  std::vector<LinkIndex> links;
  for (const LinkIndex link : plan.mechanism().links().keys()) {
    if (plan.request().reported.has(link) && (with_ground || link != plan.mechanism().ground())) {
      links.push_back(link);
    }
  }
  return links;
}

std::vector<JointIndex> reported_slides(const Plan& plan) {
  std::vector<JointIndex> slides;
  for (const JointIndex index : plan.mechanism().joints().keys()) {
    if (plan.mechanism().joints()[index].type != JointType::revolute &&
        plan.request().reported.has(index) && !plan.is_stand_in(index)) {
      slides.push_back(index);
    }
  }
  return slides;
}

std::vector<const SlideState*> reported_slides(const Plan& plan,
                                               const Configuration& configuration) {
  std::vector<const SlideState*> slides;
  const std::vector<JointIndex> reported = reported_slides(plan);
  for (const SlideState& slide : configuration.slides) {
    if (std::ranges::find(reported, slide.joint) != reported.end()) {
      slides.push_back(&slide);
    }
  }
  return slides;
}

}  // namespace assur::mechanism
