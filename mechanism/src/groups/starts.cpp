#include "groups/starts.hpp"

#include <algorithm>
#include <assur/loops/enclosure.hpp>

namespace assur::mechanism::groups {

namespace {

using Balls = std::vector<loops::Enclosed<loops::AnySizes>>;

/// Adds a configuration near `at` and returns true, unless it is known or not isolated.
bool add_near(const LoopEquations& equations,
              const loops::ComplexConfiguration<loops::AnySizes>& at, Balls& known) {
  loops::Enclosed<loops::AnySizes> ball{at, 0, 0, false};
  if (!loops::polish(equations, ball.at) || !loops::enclose(equations, ball)) {
    return false;
  }
  if (std::ranges::any_of(known, [&](const auto& other) {
        return loops::distance_between(ball.at, other.at) <= ball.holds + other.holds;
      })) {
    return false;
  }
  known.push_back(std::move(ball));
  return true;
}

}  // namespace

Starts::Starts(GeneralEquations& general) {
  const auto [equations, drawn] = general.next_closed();
  Balls known;
  if (!add_near(equations, drawn, known)) {
    return;
  }
  // Numbers and configurations together are one irreducible set, since the closures are linear in
  // the numbers. The configurations that closed paths permute are then one orbit, and if some are
  // unknown, at least half of all permutations lead to one of them.
  constexpr int most_quiet = 10;
  for (int quiet = 0; quiet < most_quiet; ++quiet) {
    const LoopEquations other = general.next();
    const loops::ParameterPath<loops::AnySizes> there(equations, other, general.next_turn());
    const loops::ParameterPath<loops::AnySizes> back(other, equations, general.next_turn());
    const std::size_t before = known.size();
    for (std::size_t one = 0; one < before; ++one) {
      loops::ComplexConfiguration<loops::AnySizes> at = known[one].at;
      if (there.follow(at) && back.follow(at) && add_near(equations, at, known)) {
        quiet = 0;
      }
    }
  }
  of_angles_.assign(equations.of_angles.data(),
                    equations.of_angles.data() + equations.of_angles.size());
  of_slides_.assign(equations.of_slides.data(),
                    equations.of_slides.data() + equations.of_slides.size());
  for (const auto& ball : known) {
    theta_.insert(theta_.end(), ball.at.theta.begin(), ball.at.theta.end());
    s_.insert(s_.end(), ball.at.s.begin(), ball.at.s.end());
  }
  constexpr int ways = 3;  // if some configurations are missed, paths may have been lost
  for (int way = 0; way < ways; ++way) {
    list_.push_back({static_cast<int>(known.size()), of_angles_.data(), of_slides_.data(),
                     theta_.data(), s_.data(), general.next_turn()});
  }
}

}  // namespace assur::mechanism::groups
