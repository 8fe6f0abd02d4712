#include "turn_count.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limits.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

TurnCount::TurnCount(const Values& values, PlacedLinks& placed)
    : values_(values), placed_(placed), plan_(values.plan()), structure_(values.plan().structure) {}

void TurnCount::begin() {
  countings_.assign(structure_.reading.size(), {});
  listed_ = {};
  is_continued_.resize(nearby_.size());
  for (std::size_t set = 0; set < nearby_.size(); ++set) {
    is_continued_[set].assign(nearby_[set].configurations->size(), false);
  }
}

void TurnCount::begin_law(std::size_t law, std::size_t groups) {
  law_ = law;
  placed_groups_ = groups;
  countings_[law] = {};
}

JointMotion TurnCount::coordinate(JointIndex joint) {
  Counting& counting = countings_[law_];
  JointMotion motion = coordinate_of(values_, placed_.links, placed_.slides, joint);
  if (plan_.mechanism.joints()[joint].type == JointType::revolute) {
    const std::optional<double> turns = turns_of(joint, motion.position.value(), counting);
    counting.doubts.begins = counting.doubts.begins || !turns;
    motion.position = motion.position + values_.constant(2 * std::numbers::pi * turns.value_or(0));
    const double angle = motion.position.value();
    const auto known = std::ranges::find(placed_.counted, joint, &CountedAngle::joint);
    if (known == placed_.counted.end()) {
      placed_.counted.push_back({joint, angle});
    } else {
      known->angle = angle;
    }
  }
  return motion;
}

/// Whether the loop Jacobians of the groups placed so far have the same signs as in a configuration
/// nearby. Along a branch, signs change in singular configurations only.
bool TurnCount::has_signs_of(const NearbyConfigurations& nearby, const Configuration& there) const {
  for (GroupIndex group(0); group.place() < placed_groups_; group = GroupIndex(group.place() + 1)) {
    if (values_.group(group).roles == (*nearby.roles)[group] &&
        there.determinants[group] * placed_.determinants[group] < 0) {
      return false;
    }
  }
  return true;
}

/// The whole turns to add to an angle: those of the configuration nearby that the joint's links and
/// all links placed before continue best. Returns nothing if the joint's links continue none: a
/// configuration that continues no branch, such as a mirror image, has a count of its own. If a
/// change of sign shows that branches have met, the continuation leads straight on; a step across
/// such a place is too wide to tell whether branches meet there or miss one another.
std::optional<double> TurnCount::turns_of(JointIndex joint, double angle, Counting& counting) {
  constexpr double clearly = 4;
  constexpr double indistinct = 1e-6;  // where branches meet, rounding moves links by less
  counts_.clear();
  for (std::size_t set = 0; set < nearby_.size(); ++set) {
    const NearbyConfigurations& nearby = nearby_[set];
    for (std::size_t place = 0; place < nearby.configurations->size(); ++place) {
      const Configuration& there = (*nearby.configurations)[place];
      const auto counted = std::ranges::find(there.counted, joint, &CountedAngle::joint);
      if (counted == there.counted.end()) {
        continue;
      }
      Continuation continuation;
      for (const FeatureIndex feature : plan_.mechanism.joints()[joint].between) {
        const LinkIndex link = plan_.mechanism.features()[feature].link;
        continuation.add(nearby, there, link, placed_.links[link].pose.direction);
      }
      if (std::min(continuation.error, continuation.away) < continuation.reach) {
        counting.continued.emplace_back(set, place);
        counts_.push_back({continuation.error + error_of_groups(nearby, there),
                           std::round((counted->angle - angle) / (2 * std::numbers::pi)),
                           has_signs_of(nearby, there)});
      }
    }
  }
  if (counts_.empty()) {
    return std::nullopt;
  }
  const Count best = *std::ranges::min_element(counts_, {}, &Count::error);
  Doubts& doubts = counting.doubts;
  doubts.leads_across = doubts.leads_across || !best.has_signs;
  for (const Count& other : counts_) {
    doubts.is_ambiguous = doubts.is_ambiguous || (other.turns != best.turns &&
                                                  other.error <= indistinct + clearly * best.error);
  }
  return best.turns;
}

double TurnCount::error_of_groups(const NearbyConfigurations& nearby,
                                  const Configuration& there) const {
  Continuation continuation;
  for (GroupIndex group(0); group.place() < placed_groups_; group = GroupIndex(group.place() + 1)) {
    for (const LinkIndex link : structure_.groups[group].links) {
      if (link.place() < there.links.size()) {
        continuation.add(nearby, there, link, placed_.links[link].pose.direction);
      }
    }
  }
  return continuation.error;
}

void TurnCount::note_listed() {
  for (const auto& [doubts, continued] : countings_) {
    note_doubts(doubts);
    listed_.begins = listed_.begins || doubts.begins;
    for (const auto& [set, place] : continued) {
      is_continued_[set][place] = true;
    }
  }
}

void TurnCount::note_doubts(const Doubts& doubts) {
  listed_.is_ambiguous = listed_.is_ambiguous || doubts.is_ambiguous;
  listed_.leads_across = listed_.leads_across || doubts.leads_across;
}

bool TurnCount::is_in_doubt() const {
  if (listed_.is_ambiguous || listed_.leads_across || (listed_.begins && !nearby_.empty())) {
    return true;
  }
  for (std::size_t set = 0; set < nearby_.size(); ++set) {
    const std::vector<bool>& is_continued = is_continued_[set];
    if (nearby_[set].go_on && std::ranges::find(is_continued, false) != is_continued.end()) {
      return true;
    }
  }
  return false;
}

}  // namespace assur::mechanism::solve
