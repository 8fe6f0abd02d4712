#include "command/stretches.hpp"

#include <algorithm>
#include <assur/mechanism/report.hpp>
#include <assur/text/numbers.hpp>

#include "command/output.hpp"

namespace assur::generator::command {

namespace {

constexpr const char* beyond = "beyond the limits of joints";
constexpr const char* incomplete = "incomplete";

/// Why a step counts as one without configurations; empty if it has all of them.
std::string what_is_missing(const mechanism::Solution& solution) {
  using mechanism::SolutionStatus;
  const bool all_beyond =
      std::ranges::none_of(solution.configurations,
                           [](const mechanism::Configuration& one) { return one.within_limits; });
  return solution.status == SolutionStatus::degenerate    ? "degenerate"
         : solution.status == SolutionStatus::no_assembly ? "no-assembly"
         : all_beyond                                     ? beyond
         : solution.incomplete.empty()                    ? ""
                                                          : incomplete;
}

}  // namespace

std::string shown_value(double number) { return text::short_number(number, 6); }

StretchTeller::StretchTeller(const mechanism::Plan& plan)
    : plan_(plan),
      values_(plan.values()),
      begin_(values_.value_of(plan.request().sweep->from)),
      range_(values_.value_of(plan.request().sweep->to) - begin_) {}

const mechanism::Values& StretchTeller::values_at(int step) {
  const mechanism::Sweep& sweep = *plan_.request().sweep;
  const int last = sweep.count - 1;
  values_.set(sweep.parameter,
              last == 0 ? begin_ : begin_ + range_ * (static_cast<double>(step) / last));
  return values_;
}

void StretchTeller::step(double parameter, const mechanism::Solution& solution) {
  const std::string what = what_is_missing(solution);
  const std::string& reason = what == incomplete ? solution.incomplete : solution.reason;
  if (what != what_ || reason != reason_) {
    finish();
    what_ = what;
    reason_ = reason;
    first_ = step_;
    from_ = parameter;
  }
  if (what == beyond) {
    for (const mechanism::LimitBreach& breach : solution.breaches) {
      add_breach(breach, breaches_);
    }
  }
  to_ = parameter;
  ++step_;
}

void StretchTeller::tell() {
  remarks() << text_;
  text_.clear();
}

void StretchTeller::finish() {
  if (what_.empty()) {
    return;
  }
  const int count = step_ - first_;
  const std::string& name = plan_.mechanism().parameters()[plan_.request().sweep->parameter].name;
  text_ += what_ +
           (count == 1 ? " at " + name + " = " + shown_value(from_)
                       : " from " + name + " = " + shown_value(from_) + " to " + shown_value(to_) +
                             " (" + std::to_string(count) + " steps)") +
           reason_of_stretch(count) + '\n';
  what_.clear();
  breaches_.clear();
}

/// The reason of a stretch. The distance by which links fail to close is measured at its middle.
std::string StretchTeller::reason_of_stretch(int count) {
  if (what_ == beyond) {
    return ": " + breaches_text(plan_.mechanism(), breaches_);
  }
  if (what_ != "no-assembly") {
    return reason_.empty() ? "" : ": " + reason_;
  }
  const mechanism::Values& values = values_at(first_ + count / 2);
  const double place = values.parameter(plan_.request().sweep->parameter);
  const std::string reason = plan_.obstacle(values);
  if (reason.empty()) {  // that step alone can be assembled
    return plan_.structure().reading.empty()
               ? ": at " + shown_value(place) + ", the links reach to within rounding"
               : ": laws read angles that count whole turns from the first step; solved alone, "
                 "with angles in (-pi, pi], the mechanism can be assembled at " +
                     shown_value(place);
  }
  return count == 1 ? ": " + reason : ": at " + shown_value(place) + ", " + reason;
}

}  // namespace assur::generator::command
