// Checks of the answers for a well-known mechanism against its known properties, in every listing.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mechanism/assembly_truth.hpp"
#include "mechanism/scene_maker.hpp"
#include "mechanism/solved.hpp"

namespace assur::test {

/// A theorem: an expression that vanishes, with its rates, in some assemblies of a mechanism.
struct Theorem {
  std::string says;
  int assemblies;  ///< how many it holds in; for a sweep, the number of branches
  std::function<Jet(const Points&)> vanishes;
};

/// Whether a place lies so close to a singular one at zero that its accelerations are in doubt.
inline bool is_close(double place) { return std::abs(place) < 2e-3; }

/// A mechanism at one place.
struct NamedPlace {
  std::string name;
  SceneMaker scene;
  Known known;
  std::vector<Theorem> theorems;
  double tolerance = 1e-9;  ///< of values, relative to lengths; for rates times 1e2 and 1e5
  /// Rounding may leave fewer than six digits of accelerations.
  bool in_doubt = false;

  friend std::ostream& operator<<(std::ostream& out, const NamedPlace& place) {
    return out << place.name;
  }
};

/// Rates that are not known become NaN.
inline Points points_of(const Plan& plan, const Configuration& configuration) {
  const double known = configuration.derivatives_known ? 1 : std::nan("");
  Points result;
  const auto& outputs = plan.mechanism().outputs();
  for (const mechanism::OutputIndex output : outputs.keys()) {
    const mechanism::Point& at = configuration.outputs[output];
    result[outputs[output].name] = {
        {at.position.x(), known * at.velocity.x(), known * at.acceleration.x()},
        {at.position.y(), known * at.velocity.y(), known * at.acceleration.y()}};
  }
  return result;
}

/// How far two numbers are apart, relative to the tolerance of positions, rates and second rates.
/// Positions are compared relative to the mechanism's size.
inline double apart(const Jet& one, const Jet& other, bool with_rates, double size = 1) {
  const auto difference = [](double a, double b, double scale) {
    const double distance = std::abs(a - b) / scale;
    return std::isfinite(distance) ? distance : 1e300;
  };
  double result = difference(one.value, other.value, std::max(1.0, size));
  if (with_rates) {
    result = std::max({result, difference(one.rate, other.rate, 1e2 * (1 + std::abs(other.rate))),
                       difference(one.second, other.second, 1e5 * (1 + std::abs(other.second)))});
  }
  return result;
}

/// The largest difference over the points that are known.
inline double apart(const Points& answered, const Points& known, bool with_rates) {
  double size = 0;
  for (const auto& [name, point] : known) {
    size = std::max({size, std::abs(point.x.value), std::abs(point.y.value)});
  }
  double result = 0;
  for (const auto& [name, point] : known) {
    const auto found = answered.find(name);
    if (found != answered.end()) {
      result = std::max({result, apart(found->second.x, point.x, with_rates, size),
                         apart(found->second.y, point.y, with_rates, size)});
    }
  }
  return result;
}

/// A solution in one listing.
struct Answer {
  Solved solved;
  std::vector<Points> points;

  explicit Answer(const SceneMaker::Json& scene)
      : solved(mechanism::parse_scene(scene.dump(), "scene")) {
    for (const Configuration& configuration : solved.configurations()) {
      points.push_back(points_of(solved.plan, configuration));
    }
  }
};

inline void expect_slides(const Answer& answer, const Configuration& configuration,
                          const KnownAssembly& known, double tolerance) {
  for (const mechanism::SlideState& slide : configuration.slides) {
    const auto found = known.slides.find(answer.solved.plan.mechanism().joints()[slide.joint].name);
    if (found != known.slides.end()) {
      const Jet answered{slide.displacement, slide.velocity, slide.acceleration};
      EXPECT_LT(apart(answered, found->second, known.regular), tolerance) << found->first;
    }
  }
}

/// Every known assembly is listed once, and nothing else is.
inline void expect_assemblies(const Answer& answer, const NamedPlace& place) {
  const auto& configurations = answer.solved.configurations();
  EXPECT_EQ(configurations.size(), place.known.assemblies.size());
  std::vector<bool> taken(configurations.size());
  for (const KnownAssembly& known : place.known.assemblies) {
    // Where a configuration is double, half of the digits are known.
    const double tolerance = known.regular ? place.tolerance : 1e-7;
    std::string listed;
    std::size_t found = configurations.size();
    for (std::size_t index = 0; index < configurations.size(); ++index) {
      const double distance = apart(answer.points[index], known.points, false);
      listed += " " + std::to_string(distance);
      if (!taken[index] && distance < tolerance) {
        found = index;
      }
    }
    if (found == configurations.size()) {
      ADD_FAILURE() << "an assembly that is known is not answered; the others are apart by"
                    << listed;
      continue;
    }
    taken[found] = true;
    const Configuration& configuration = configurations[found];
    const bool is_ok = configuration.regularity == Status::ok;
    EXPECT_TRUE(is_ok == known.regular || (known.regular && place.in_doubt));
    if (known.regular) {
      EXPECT_TRUE(configuration.derivatives_known);
      EXPECT_LT(apart(answer.points[found], known.points, true), tolerance);
    } else if (place.scene.json.contains("drivers")) {
      EXPECT_FALSE(configuration.derivatives_known);
    }
    expect_slides(answer, configuration, known, tolerance);
  }
}

inline void expect_families(const Answer& answer, const std::vector<KnownFamily>& known) {
  const auto described = [](int mobility, std::vector<std::string> members) {
    std::sort(members.begin(), members.end());
    std::string text = std::to_string(mobility);
    for (const std::string& member : members) {
      text += " " + member;
    }
    return text;
  };
  std::multiset<std::string> truly;
  std::multiset<std::string> answered;
  for (const KnownFamily& family : known) {
    truly.insert(described(family.mobility, family.members));
  }
  const mechanism::Structure& structure = answer.solved.plan.structure();
  for (const mechanism::Family& family : answer.solved.solution.families) {
    answered.insert(
        described(family.mobility, structure.names_of(structure.groups[family.group].links)));
  }
  EXPECT_EQ(answered, truly);
}

inline SolutionStatus status_of(const Known& known) {
  if (!known.assemblies.empty()) {
    return SolutionStatus::ok;
  }
  return known.families.empty() ? SolutionStatus::no_assembly : SolutionStatus::degenerate;
}

inline void expect_as_known(const NamedPlace& place) {
  std::vector<Points> first;
  for (int listing = 0; listing < listings; ++listing) {
    SCOPED_TRACE("listing " + std::to_string(listing));
    const Answer answer(scene_listed(place.scene.scene(), listing));
    EXPECT_EQ(answer.solved.solution.status, status_of(place.known));
    expect_assemblies(answer, place);
    expect_families(answer, place.known.families);
    for (const Theorem& theorem : place.theorems) {
      const auto holds =
          std::count_if(answer.points.begin(), answer.points.end(), [&](const Points& points) {
            return apart(theorem.vanishes(points), Jet(0), true) < place.tolerance;
          });
      EXPECT_EQ(holds, theorem.assemblies) << theorem.says;
    }
    if (listing == 0) {
      first = answer.points;
    }
    for (std::size_t index = 0; index < std::min(first.size(), answer.points.size()); ++index) {
      EXPECT_LT(apart(answer.points[index], first[index], false), 1e-7) << "number " << index;
    }
  }
}

/// Where a sweep has events, and which.
struct KnownEvent {
  std::vector<std::string> kinds;  ///< sorted: those at one value of the parameter
  double parameter;
};

/// A mechanism along one of its parameters.
struct NamedSweep {
  std::string name;
  SceneMaker scene;
  std::vector<int> counts;  ///< of steps
  std::vector<KnownEvent> events;
  int throughout;  ///< branches that live from the first step to the last
  std::vector<Theorem> theorems;
  double tolerance = 1e-9;

  friend std::ostream& operator<<(std::ostream& out, const NamedSweep& sweep) {
    return out << sweep.name;
  }
};

/// What a sweep reports.
struct Swept {
  struct Row {
    int step, branch;
    Points points;
    bool regular;
  };
  struct Event {
    std::string text;
    double parameter;
  };
  std::vector<Row> rows;
  std::vector<Event> events;

  explicit Swept(const SceneMaker::Json& scene) {
    const Plan plan(mechanism::parse_scene(scene.dump(), "scene"));
    const auto record = [&](const mechanism::SweepRecord& at) {
      if (at.event.empty()) {
        rows.push_back(
            {at.step, at.branch, points_of(plan, *at.state), at.state->regularity == Status::ok});
      } else {
        events.push_back({at.event, at.parameter});
      }
    };
    mechanism::sweep(plan, {record, {}, {}});
  }
};

/// Compares the events, those at one value together.
inline void expect_events(const Swept& swept, const NamedSweep& named) {
  std::vector<std::vector<std::string>> kinds(named.events.size());
  for (const Swept::Event& event : swept.events) {
    const auto nearest =
        std::find_if(named.events.begin(), named.events.end(), [&](const KnownEvent& known) {
          return std::abs(known.parameter - event.parameter) < 1e-9;
        });
    if (nearest == named.events.end()) {
      ADD_FAILURE() << "no event is known at " << event.parameter << ": " << event.text;
      continue;
    }
    kinds[static_cast<std::size_t>(nearest - named.events.begin())].push_back(
        event.text.substr(0, event.text.find(' ')));
  }
  for (std::size_t index = 0; index < kinds.size(); ++index) {
    std::sort(kinds[index].begin(), kinds[index].end());
    EXPECT_EQ(kinds[index], named.events[index].kinds) << "at " << named.events[index].parameter;
  }
}

/// A theorem that holds somewhere on a branch holds all along it.
inline void expect_theorem(const Swept& swept, const Theorem& theorem, double tolerance) {
  std::map<int, std::pair<int, int>> holds;  // by branch: where it does, where it does not
  for (const Swept::Row& row : swept.rows) {
    if (row.regular && row.branch > 0) {
      const bool here = apart(theorem.vanishes(row.points), Jet(0), true) < tolerance;
      ++(here ? holds[row.branch].first : holds[row.branch].second);
    }
  }
  int branches = 0;
  for (const auto& [branch, count] : holds) {
    EXPECT_TRUE(count.first == 0 || count.second == 0)
        << theorem.says << ": at " << count.first << " places of branch " << branch << ", not at "
        << count.second;
    branches += count.first > 0 ? 1 : 0;
  }
  EXPECT_EQ(branches, theorem.assemblies) << theorem.says;
}

inline void expect_swept_as_known(const NamedSweep& named) {
  for (const int count : named.counts) {
    for (int listing = 0; listing < listings; ++listing) {
      SCOPED_TRACE(std::to_string(count) + " steps, listing " + std::to_string(listing));
      SceneMaker::Json scene = scene_listed(named.scene.scene(), listing);
      scene["sweep"]["count"] = count;
      const Swept swept(scene);
      expect_events(swept, named);
      std::map<int, std::set<int>> steps;
      for (const Swept::Row& row : swept.rows) {
        if (row.branch > 0) {
          steps[row.branch].insert(row.step);
        }
      }
      const auto throughout = std::count_if(steps.begin(), steps.end(), [&](const auto& branch) {
        return branch.second.count(0) == 1 && branch.second.count(count - 1) == 1;
      });
      EXPECT_EQ(throughout, named.throughout);
      for (const Theorem& theorem : named.theorems) {
        expect_theorem(swept, theorem, named.tolerance);
      }
    }
  }
}

}  // namespace assur::test
