// Configurations lost and invented by each method, family and distance.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "positions/position_methods.hpp"
#include "truth.hpp"

namespace assur::stability {

/// Whether the library reports that its list may be incomplete. The peers have no such report.
template <typename Model>
[[nodiscard]] bool declares(const speed::PositionSample<Model>& sample) {
  return assemblies<Model>(sample.d, sample.u).status != AssemblyStatus::ok;
}

template <typename Model>
struct ListingMethod {
  const char* name;
  speed::Found<Model> (*list)(const speed::PositionSample<Model>&);
};

/// One method on all members of one family at one distance.
struct ListingRow {
  std::string family;
  std::string title;
  std::string kind;
  std::string method;
  double distance = 0;
  int configurations = 0;  ///< without those that have run to infinity
  int far = 0;             ///< configurations that have run to infinity; not counted as lost
  int lost = 0;
  int invented = 0;  ///< listed twice, or not a configuration
  int far_listed = 0;
  int declared = 0;  ///< groups whose status reports a list that may be incomplete
  double error = 0;  ///< the largest among configurations listed correctly and not at infinity
};

template <typename Configuration>
[[nodiscard]] bool is_finite_list_entry(const Configuration& q) {
  bool finite = true;
  for_each_member(q, [&finite](const auto& member, std::size_t) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
      finite = finite && std::isfinite(member);
    } else {
      finite = finite && std::isfinite(member.cos) && std::isfinite(member.sin);
    }
  });
  return finite;
}

/// Matches each configuration with the nearest listed one not yet taken, if within its tolerance.
template <typename Model>
void tally(const speed::Found<Model>& found, const ConfigurationMember<Model>& member,
           ListingRow& row) {
  std::vector<bool> taken(found.count, false);
  for (std::size_t place = 0; place < member.truth.list.size(); ++place) {
    double best = std::numeric_limits<double>::infinity();
    std::size_t chosen = 0;
    for (std::size_t index = 0; index < found.count; ++index) {
      if (!taken[index] && is_finite_list_entry(found.list[index])) {
        const double away = speed::apart(found.list[index], member.truth.list[place]);
        if (away < best) {
          best = away;
          chosen = index;
        }
      }
    }
    const bool is_listed = best < member.truth.tolerances[place];
    if (is_listed) {
      taken[chosen] = true;
    }
    if (member.is_far[place]) {
      ++row.far;
      row.far_listed += is_listed ? 1 : 0;
    } else {
      ++row.configurations;
      row.lost += is_listed ? 0 : 1;
      row.error = is_listed ? std::max(row.error, best) : row.error;
    }
  }
  row.invented += static_cast<int>(std::count(taken.begin(), taken.end(), false));
}

/// Appends the rows of a family, with a number of members at each distance. The first method is the
/// library. Returns false if the reference of some member is not certified.
template <typename Family>
[[nodiscard]] bool append_listing_rows(
    const std::vector<ListingMethod<typename Family::Model>>& list, std::vector<ListingRow>& rows,
    int members = members_per_distance) {
  using Model = typename Family::Model;
  bool is_vouched = true;
  for (const double distance : configuration_distances()) {
    std::vector<ListingRow> of_methods(list.size());
    for (int number = 0; number < members; ++number) {
      const auto member = make_configuration_member<Family>(number, distance);
      is_vouched = is_vouched && member.is_vouched;
      for (std::size_t method = 0; method < list.size(); ++method) {
        tally(list[method].list(member.given), member, of_methods[method]);
      }
      of_methods[0].declared += declares<Model>(member.given) ? 1 : 0;
    }
    for (std::size_t method = 0; method < list.size(); ++method) {
      ListingRow& row = of_methods[method];
      row.family = Family::name;
      row.title = Family::title;
      row.kind = Family::kind;
      row.method = list[method].name;
      row.distance = distance;
      rows.push_back(row);
    }
  }
  return is_vouched;
}

}  // namespace assur::stability
