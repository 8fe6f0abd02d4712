#include "report/drawn_configuration.hpp"

namespace assur::mechanism::report {

std::optional<DrawnConfiguration> drawn_configuration(const Report& report) {
  const Plan& plan = report.plan;
  if (!plan.request().drawn || plan.request().reference.empty()) {
    return std::nullopt;
  }
  const bool is_listed = plan.most_configurations() <= Plan::most_listed;
  Solution others;
  std::optional<Nearest> found;
  if (!report.alone) {
    found = plan.nearest(report.values, report.solution);
  } else if (is_listed) {  // the solution has one configuration, without its number
    plan.solve(report.values, others);
    found = plan.nearest(report.values, others);
  } else {
    found = report.nearest ? report.nearest : plan.solve_nearest(report.values, others);
  }
  return found ? std::optional(DrawnConfiguration{*found, is_listed}) : std::nullopt;
}

}  // namespace assur::mechanism::report
