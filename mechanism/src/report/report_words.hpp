// Turns the states of a solution into the words that every report uses.
#pragma once

#include <assur/mechanism/followed_parts.hpp>
#include <assur/mechanism/report.hpp>
#include <assur/variables.hpp>
#include <limits>
#include <utility>

namespace assur::mechanism::report {

[[nodiscard]] inline const char* status_text(SolutionStatus status) {
  switch (status) {
    case SolutionStatus::ok:
      return "ok";
    case SolutionStatus::no_assembly:
      return "no-assembly";
    case SolutionStatus::degenerate:
      return "degenerate";
  }
  return "unknown";
}

/// Why there are no configurations; nothing if there are.
[[nodiscard]] inline std::string reason_text(const Report& report) {
  const Solution& solution = report.solution;
  return solution.status == SolutionStatus::no_assembly ? report.plan.obstacle(report.values)
                                                        : solution.reason;
}

[[nodiscard]] inline const char* regularity_text(Status regularity) {
  return regularity == Status::ok ? "regular" : "near-singular";
}

/// A configuration without the rates and the derivatives that are not known: those of links that
/// drivers place are.
[[nodiscard]] inline Configuration without_derivatives(const Plan& plan,
                                                       Configuration configuration) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const double of_rates = configuration.rates_known ? 1 : unknown;
  const double of_derivatives = configuration.derivatives_known ? 1 : unknown;
  const auto forget = [=](auto& item) {
    item.velocity *= of_rates;
    item.acceleration *= of_rates;
    item.follows.first *= of_derivatives;
    for (auto& second : item.follows.second) {
      second *= of_derivatives;
    }
  };
  for_each_followed(plan.mechanism(), plan.structure(), configuration, forget);
  configuration.derivatives_known = true;
  configuration.rates_known = true;
  return configuration;
}

/// Of what is wanted, that in which the branches through one configuration differ.
[[nodiscard]] inline Want rates_alone(const Want& want) {
  return {false, want.velocity, want.acceleration, false};
}

/// The links that are reported, in the mechanism's order.
[[nodiscard]] inline std::vector<LinkIndex> reported_links(const Plan& plan, bool with_ground) {
  std::vector<LinkIndex> links;
  for (const LinkIndex link : plan.mechanism().links().keys()) {
    if (plan.request().reported.has(link) && (with_ground || link != plan.mechanism().ground())) {
      links.push_back(link);
    }
  }
  return links;
}

/// The slides of a configuration that are reported.
[[nodiscard]] inline std::vector<const SlideState*> reported_slides(
    const Plan& plan, const Configuration& configuration) {
  std::vector<const SlideState*> slides;
  for (const SlideState& slide : configuration.slides) {
    if (plan.request().reported.has(slide.joint) && !plan.is_stand_in(slide.joint)) {
      slides.push_back(&slide);
    }
  }
  return slides;
}

[[nodiscard]] inline bool is_reported(const Report& report, std::size_t configuration) {
  return report.alone || report.branch == 0 || std::cmp_equal(configuration + 1, report.branch);
}

}  // namespace assur::mechanism::report
