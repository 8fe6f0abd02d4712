#include "settled_redundancy.hpp"

#include <algorithm>
#include <assur/local/close.hpp>
#include <assur/support/redundant.hpp>
#include <cmath>
#include <limits>

#include "plan/plan_data.hpp"
#include "redundant_joints.hpp"
#include "relative_frames.hpp"

namespace assur::mechanism::solve {

namespace {

/// Larger mechanisms are not settled, since the work grows as the cube of the number of links.
constexpr std::size_t most_links = 100;
}  // namespace

std::optional<SettledRedundancy> SettledRedundancy::made_for(const Values& values) {
  const PlanData& plan = values.plan();
  const bool is_usable =
      !plan.redundant.empty() && can_close(plan) && plan.mechanism.links().size() <= most_links;
  return is_usable ? std::optional(SettledRedundancy(values)) : std::nullopt;
}

bool SettledRedundancy::can_close(const PlanData& plan) {
  return !plan.request.redundancy_tolerance.exists() && plan.structure.reading.empty();
}

double SettledRedundancy::missed(const AllConstraints::Poses& links) const {
  return constraints_.misses(links).cwiseAbs().maxCoeff();
}

double SettledRedundancy::settle(PlacedLinks& placed) {
  if (!placed.path_known) {  // Their signs may not belong to one configuration.
    std::ranges::fill(placed.determinants, std::numeric_limits<double>::quiet_NaN());
  }
  const double without = gap_of_redundant(values_, placed.links, Status::ok);
  AllConstraints::Poses poses = poses_of(placed.links);
  constraints_.measure(poses);
  AllConstraints::Body::Poses moved = constraints_.moving_poses(poses);
  local::close(constraints_.body(), moved);
  constraints_.place(moved, poses);
  for (const LinkIndex link : values_.plan().mechanism.links().keys()) {
    placed.links[link].pose = poses[link];
  }
  find_rates(poses, placed);
  for (SlideState& slide : placed.slides) {
    if (slide.joint.exists() && !values_.plan().mechanism.driver_of(slide.joint).exists()) {
      slide = measured_slide(values_, placed.links, slide.joint);
    }
  }
  const double open = missed(poses);
  placed.residual = std::max(placed.residual, open * constraints_.size());
  if (open <= support::redundancy_slack(constraints_.reach(), Status::ok)) {
    return 0;
  }
  return without > 0 ? without : open * constraints_.size();
}

void SettledRedundancy::find_rates(const AllConstraints::Poses& poses, PlacedLinks& placed) {
  const Eigen::MatrixXd jacobian = constraints_.jacobian(poses);
  const auto factors = local::factors_of<AllConstraints::Body>(jacobian);
  const support::RateDigits<double> digits(constraints_.rounding(), local::firmness_of(factors), 2);
  placed.is_crossing = !(digits.error < 1);
  goes_on_ = true;
  // Where all constraints together do not determine the rates, those of the remaining ones belong
  // to only one of several motions.
  placed.rates_known = placed.derivatives_known = false;
  AllConstraints::Links links = placed.links;
  const auto parameters = static_cast<Eigen::Index>(values_.columns().size());
  for (const LinkIndex link : values_.plan().mechanism.links().keys()) {
    links[link].velocity.setZero();
    links[link].acceleration.setZero();
    links[link].follows.set_zero(parameters, values_.second_order());
  }
  const Eigen::MatrixXd open = constraints_.first_rates(links);
  // With nothing that moves, the links are at rest even where rates are not determined.
  const bool is_at_rest =
      open.col(0).isZero(0) && constraints_.second_rates(links).col(0).isZero(0);
  if (!digits.are_known() || !open.allFinite()) {
    forget_rates(is_at_rest, placed);
    return;
  }
  const Eigen::MatrixXd rates = -factors.solve(open);
  constraints_.add_first(rates, links);
  const auto of_column = [&](const Eigen::MatrixXd& solved, const Eigen::MatrixXd& from,
                             Eigen::Index column) -> support::SolvedRates<double> {
    return {solved.col(column).norm(), from.col(column).norm(),
            (jacobian * solved.col(column) + from.col(column)).norm()};
  };
  const Eigen::MatrixXd open_twice = constraints_.second_rates(links);
  const bool is_known_twice = digits.are_all_known() && open_twice.allFinite();
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  Eigen::MatrixXd twice = is_known_twice
                              ? Eigen::MatrixXd(-factors.solve(open_twice))
                              : Eigen::MatrixXd::Constant(rates.rows(), open_twice.cols(), unknown);
  if (is_at_rest) {
    twice.col(0).setZero();
  }
  constraints_.add_second(twice, links);
  const Table<LinkIndex, bool> is_driven = values_.plan().structure.placed_by_drivers();
  for (const LinkIndex link : values_.plan().mechanism.links().keys()) {
    if (is_driven[link]) {  // their motion is known everywhere
      links[link].velocity = placed.links[link].velocity;
      links[link].acceleration = placed.links[link].acceleration;
    }
  }
  placed.links = std::move(links);
  placed.regularity = is_known_twice ? digits.regularity() : Status::near_singular;
  const support::SolvedRates<double> first = of_column(rates, open, 0);
  goes_on_ = !first.contradict() && (placed.regularity != Status::ok ||
                                     !of_column(twice, open_twice, 0).contradict_twice(first));
  placed.rates_known = true;
  placed.derivatives_known = is_known_twice || !values_.second_order();
  for (Eigen::Index column = 1; column < open.cols(); ++column) {
    placed.derivatives_known =
        placed.derivatives_known && !of_column(rates, open, column).contradict();
  }
  placed.path_known = placed.derivatives_known;
}

void SettledRedundancy::forget_rates(bool is_at_rest, PlacedLinks& placed) const {
  const Table<LinkIndex, bool> is_driven = values_.plan().structure.placed_by_drivers();
  const double rate = is_at_rest ? 0 : std::numeric_limits<double>::quiet_NaN();
  for (const LinkIndex link : values_.plan().mechanism.links().keys()) {
    if (placed.forgets_unknown_rates && !is_driven[link]) {
      placed.links[link].velocity.setConstant(rate);
      placed.links[link].acceleration.setConstant(rate);
    }
  }
}

SettledRedundancy::Comparison SettledRedundancy::compared(const AllConstraints::Poses& first,
                                                          const AllConstraints::Poses& second) {
  constexpr double near = 0.01;
  constexpr double much_better = 16;
  constexpr double alike = 4;  // roundings: halfway has those of both places, and one more
  constraints_.measure(first);
  const Eigen::VectorXd apart = constraints_.step(first, second);
  if (!(apart.cwiseAbs().maxCoeff() < near)) {
    return Comparison::differ;
  }
  const double rounding = constraints_.rounding();
  const double of_first = missed(first);
  const double of_second = missed(second);
  const auto is_much_better = [&](double one, double other) {
    return other > (one > rounding ? much_better * one : rounding);
  };
  if (is_much_better(of_second, of_first)) {
    return Comparison::first_is_none;
  }
  if (is_much_better(of_first, of_second)) {
    return Comparison::second_is_none;
  }
  AllConstraints::Poses halfway = first;
  constraints_.move(apart / 2, halfway);
  if (missed(halfway) <= alike * std::max({of_first, of_second, rounding})) {
    return of_second < of_first ? Comparison::first_is_none : Comparison::second_is_none;
  }
  return Comparison::differ;
}

}  // namespace assur::mechanism::solve
