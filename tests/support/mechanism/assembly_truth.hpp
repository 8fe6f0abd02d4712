// All assemblies of a chain of dyads, by successive intersections of circles.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mechanism/jet.hpp"

namespace assur::test {

using Points = std::map<std::string, JetPoint>;

/// One assembly of a mechanism, as it is known to be.
struct KnownAssembly {
  Points points;
  std::map<std::string, Jet> slides;
  bool regular = true;  ///< otherwise it is a fold or a change point, and has no rates
};

/// A group that moves freely.
struct KnownFamily {
  int mobility;
  std::vector<std::string> members;
};

/// All that is known of a mechanism at one place.
struct Known {
  std::vector<KnownAssembly> assemblies;
  std::vector<KnownFamily> families;
};

/// A point that follows from earlier ones. A pin of two bars is where two circles meet; other
/// points of a link lie beside two of its points.
struct Step {
  std::string name;
  std::string first, second;
  double first_radius = 0, second_radius = 0;  ///< of a pin
  std::vector<std::string> members;            ///< of a pin: its two links
  double along = 0, aside = 0;                 ///< of another point, relative to first to second
};

inline Step pin(const std::string& name, const std::string& first, double first_radius,
                const std::string& second, double second_radius,
                const std::vector<std::string>& members) {
  return {name, first, second, first_radius, second_radius, members};
}
inline Step beside(const std::string& name, const std::string& first, const std::string& second,
                   double along, double aside = 0) {
  return {name, first, second, 0, 0, {}, along, aside};
}

/// Adds all that follows from the points so far by the steps from `index` on. The numbers are
/// rational or square roots of such: rounding leaves far less than 1e-13 of an exact tangency.
inline void complete(const KnownAssembly& so_far, const std::vector<Step>& steps, std::size_t index,
                     Known& known) {
  if (index == steps.size()) {
    known.assemblies.push_back(so_far);
    return;
  }
  const Step& step = steps[index];
  const JetPoint& first = so_far.points.at(step.first);
  const JetPoint between = so_far.points.at(step.second) - first;
  const auto go_on = [&](const JetPoint& point, bool regular) {
    KnownAssembly next = so_far;
    next.points[step.name] = point;
    next.regular = next.regular && regular;
    complete(next, steps, index + 1, known);
  };
  if (step.members.empty()) {
    go_on(first + Jet(step.along) * between + Jet(step.aside) * between.turned(), true);
    return;
  }
  const double larger = step.first_radius * step.first_radius;
  const Jet square = dot(between, between);
  if (square.value < 1e-13 * larger) {
    if (step.first_radius == step.second_radius) {
      known.families.push_back({1, step.members});
    }
    return;
  }
  const Jet along =
      (square + Jet(larger - step.second_radius * step.second_radius)) / (Jet(2) * square);
  const Jet aside_squared = Jet(larger) / square - along * along;
  if (std::abs(aside_squared.value) < 1e-13) {
    go_on(first + along * between, false);
  } else if (aside_squared.value > 0) {
    const Jet aside = sqrt(aside_squared);
    go_on(first + along * between + aside * between.turned(), true);
    go_on(first + along * between - aside * between.turned(), true);
  }
}

inline Known assemblies_of(const Points& driven, const std::vector<Step>& steps) {
  Known known;
  complete({driven, {}, true}, steps, 0, known);
  return known;
}

}  // namespace assur::test
