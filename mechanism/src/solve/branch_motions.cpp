#include "branch_motions.hpp"

#include <algorithm>
#include <array>
#include <assur/mechanism/followed_parts.hpp>
#include <assur/numeric/order.hpp>
#include <cmath>
#include <limits>

#include "branch_walk.hpp"
#include "plan/plan_data.hpp"
#include "precision.hpp"
#include "redundant_joints.hpp"

namespace assur::mechanism::solve {

namespace {

/// What an order of branches that does not depend on the listing can rely on, by the names of links
/// and slides: angular velocities, velocities of slides, and their accelerations.
using Rates = std::array<std::vector<double>, 4>;

Rates rates_of(const Configuration& configuration, const NamedParts& parts) {
  Rates rates;
  for (const LinkIndex link : parts.links) {
    rates[0].push_back(configuration.links[link].velocity(2));
    rates[2].push_back(configuration.links[link].acceleration(2));
  }
  for (const NamedSlide& named : parts.slides) {
    for (const SlideState& slide : configuration.slides) {
      if (slide.joint == named.joint) {
        rates[1].push_back(named.sense * slide.velocity);
        rates[3].push_back(named.sense * slide.acceleration);
      }
    }
  }
  return rates;
}

/// By the first rates that differ by more than rounding leaves of the largest.
bool goes_before(const Rates& one, const Rates& other) {
  constexpr double rounding = 1e-4;
  for (std::size_t kind = 0; kind < one.size(); ++kind) {
    double largest = 0;
    for (const std::vector<double>* of : {&one[kind], &other[kind]}) {
      for (const double rate : *of) {
        largest = std::max(largest, std::abs(rate));
      }
    }
    for (std::size_t place = 0; place < one[kind].size(); ++place) {
      const double difference = one[kind][place] - other[kind][place];
      if (std::abs(difference) > rounding * largest) {
        return difference < 0;
      }
    }
  }
  return false;
}

/// Where the first order determines velocities to two digits, but not what follows from it.
void forget_accelerations(const PlanData& plan, Configuration& configuration) {
  for_each_followed(plan.mechanism, plan.structure, configuration, [](auto& part) {
    part.acceleration *= std::numeric_limits<double>::quiet_NaN();
  });
  configuration.rates_known = true;
}

Motions in_time(const Values& values) {
  Motions motions{{}, true};
  for (const DriverIndex driver : values.plan().mechanism.drivers().keys()) {
    models::Series motion;
    motion.c[1] = values.motion(driver).velocity;
    motion.c[2] = values.motion(driver).acceleration / 2;
    motions.drivers.add(motion);
  }
  return motions;
}

/// Along the parameter of a column, to first order: of the motions that go through a configuration
/// as one parameter moves, no higher rate of that parameter changes the first rates.
Motions along_parameter(const Values& values, Eigen::Index column) {
  Motions motions{{}, false};
  for (const DriverIndex driver : values.plan().mechanism.drivers().keys()) {
    const Dual& position = values.motion(driver).position;
    models::Series motion;
    motion.c[1] = position.derivatives().size() > 0 ? position.derivatives()(column) : 0;
    motions.drivers.add(motion);
  }
  return motions;
}

/// Whether what drives the mechanism is known; a law that reads a singular group's links is not,
/// nor is how such a group shapes others, nor how a driver changes a link whose features hardly
/// define its frame.
bool are_known(const Motions& motions, const Values& values, const PlacedLinks& placed) {
  for (const ReadingDriver& reading : values.plan().structure.reading) {
    if (reading.groups_before > 0 &&
        !placed.groups[GroupIndex(reading.groups_before - 1)].rates_known) {
      return false;
    }
  }
  for (const GroupIndex group : values.plan().structure.groups.keys()) {
    const Values::GroupNumbers& numbers = values.numbers_of(group);
    if (!precision_of_shape(numbers.firmness).second_rates_known || !numbers.d_rate.allFinite() ||
        !numbers.d_second_rate.allFinite()) {
      return false;
    }
  }
  return std::ranges::all_of(motions.drivers, [](const models::Series& motion) {
    return std::isfinite(motion.c[1]) && std::isfinite(motion.c[2]);
  });
}

/// Whether a parameter moves drivers alone, and neither links nor the dimensions of groups.
bool moves_drivers_alone(const Values& values, Eigen::Index column) {
  const PlanData& plan = values.plan();
  for (const FeatureIndex feature : plan.mechanism.features().keys()) {
    const auto& follows = values.frame(feature).follows.first;
    if (follows.cols() > column && !follows.col(column).isZero(0)) {
      return false;
    }
  }
  for (const GroupIndex group : plan.structure.groups.keys()) {
    for (const values::DimensionDerivative& entry : values.numbers_of(group).nonzero_of_d) {
      if (entry.parameter == column && entry.value != 0) {
        return false;
      }
    }
  }
  return true;
}

/// The derivatives to a parameter, from a motion along it.
void take_derivatives(const Configuration& motion, Eigen::Index column,
                      Configuration& configuration) {
  const auto take = [column](const auto& from, auto& to) {
    to.follows.first.col(column) << from.velocity;
  };
  for (const LinkIndex link : configuration.links.keys()) {
    take(motion.links[link], configuration.links[link]);
  }
  for (const OutputIndex output : configuration.outputs.keys()) {
    take(motion.outputs[output], configuration.outputs[output]);
  }
  for (std::size_t slide = 0; slide < configuration.slides.size(); ++slide) {
    configuration.slides[slide].follows.first(column) = motion.slides[slide].velocity;
  }
}

}  // namespace

void find_derivatives(const Values& values, const PlacedLinks& placed, ParameterIndex parameter,
                      Configuration& configuration) {
  const Eigen::Index column = values.plan().evaluation.column_of[parameter];
  if (!moves_drivers_alone(values, column)) {
    return;
  }
  const Motions motions = along_parameter(values, column);
  if (!are_known(motions, values, placed)) {
    return;
  }
  const std::vector<Configuration> found = motions_through(values, placed, configuration, motions);
  if (found.size() == 1) {
    take_derivatives(found.front(), column, configuration);
    configuration.path_known = true;
  }
}

void find_branches(const Values& values, const PlacedLinks& placed, Configuration& configuration) {
  const Motions motions = in_time(values);
  if (!are_known(motions, values, placed)) {
    return;
  }
  std::vector<Configuration> found = motions_through(values, placed, configuration, motions);
  // What the constraints that were left out stop is no motion of the mechanism.
  std::erase_if(
      found, [&](const Configuration& branch) { return !moves_redundantly(values, branch.links); });
  if (found.size() == 1) {
    configuration = std::move(found.front());
    return;
  }
  if (found.empty() && configuration.derivatives_known) {
    forget_accelerations(values.plan(), configuration);
    return;
  }
  const NamedParts& parts = values.plan().named_parts;
  std::vector<Rates> rates;
  rates.reserve(found.size());
  for (const Configuration& branch : found) {
    rates.push_back(rates_of(branch, parts));
  }
  // What is equal but for rounding is no order that a faster sort could rely on.
  numeric::insertion_sort(
      found.size(),
      [&](std::size_t one, std::size_t other) { return goes_before(rates[one], rates[other]); },
      [&](std::size_t one, std::size_t other) {
        std::swap(found[one], found[other]);
        std::swap(rates[one], rates[other]);
      });
  configuration.branches = std::move(found);
}

}  // namespace assur::mechanism::solve
