// Whole turns of the angles that laws read, counted along branches.
#pragma once

#include <assur/mechanism/values.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "group_solver.hpp"
#include "nearby_configurations.hpp"

namespace assur::mechanism::solve {

/// Continues the angles that laws read from those of configurations nearby, and records doubts
/// about that. Without configurations nearby, angles are in (-pi, pi].
class TurnCount {
 public:
  /// Both must outlive it. Counted angles are noted in `placed`.
  TurnCount(const Values& values, PlacedLinks& placed);

  /// Resets the state of the last position.
  void begin();
  /// From now on, an angle that a law reads is continued from the same angle of the configuration
  /// nearby that leads to this one, so that whole turns are counted.
  void count_from(std::vector<NearbyConfigurations> nearby) { nearby_ = std::move(nearby); }

  /// Begins the evaluation of a law, by its number among the laws that read links, after `groups`
  /// groups are placed.
  void begin_law(std::size_t law, std::size_t groups);
  /// The coordinate of a joint that the law reads, an angle with its whole turns.
  [[nodiscard]] JointMotion coordinate(JointIndex joint);
  /// Records that the law has no value. With another count of turns it might have one, and the
  /// configuration might be listed.
  void lose_law() { note_doubts(countings_[law_].doubts); }
  /// Records that the placed links are a configuration of the mechanism.
  void note_listed();

  /// Whether, since `begin`, two configurations nearby with different counts continue equally well
  /// to the same one listed here, as where branches meet.
  [[nodiscard]] bool is_ambiguous() const { return listed_.is_ambiguous; }
  /// Whether a count is ambiguous, or one of these holds: a continuation leads across a place where
  /// branches seem to meet; a configuration nearby has no continuation, although its branch should
  /// go on; a configuration listed here continues none. These occur where a step crosses a place at
  /// which branches meet, nearly meet, end or begin, or at which a link turns suddenly.
  [[nodiscard]] bool is_in_doubt() const;

 private:
  /// Doubts about a count of whole turns.
  struct Doubts {
    bool is_ambiguous = false;
    bool leads_across = false;  ///< straight on where branches meet
    bool begins = false;        ///< whether some angle continues none nearby
  };
  /// How the angles that a law reads were counted from configurations nearby.
  struct Counting {
    Doubts doubts;
    /// The configurations nearby that may continue here, by set and place in the set.
    std::vector<std::pair<std::size_t, std::size_t>> continued = {};
  };
  /// The whole turns of a configuration nearby, with how well it continues here and whether signs
  /// agree.
  struct Count {
    double error;
    double turns;
    bool has_signs;
  };

  void note_doubts(const Doubts& doubts);
  [[nodiscard]] std::optional<double> turns_of(JointIndex joint, double angle, Counting& counting);
  [[nodiscard]] bool has_signs_of(const NearbyConfigurations& nearby,
                                  const Configuration& there) const;
  [[nodiscard]] double error_of_groups(const NearbyConfigurations& nearby,
                                       const Configuration& there) const;

  const Values& values_;
  PlacedLinks& placed_;
  const PlanData& plan_;
  const Structure& structure_;
  std::vector<NearbyConfigurations> nearby_;
  std::vector<Counting> countings_;  ///< of laws that read links, for the placed links
  Doubts listed_;  ///< of listed configurations, or of those where a law has no value
  std::vector<std::vector<bool>> is_continued_;  ///< whether nearby ones continue here
  std::vector<Count> counts_;                    ///< kept for its memory
  std::size_t law_ = 0;                          ///< under evaluation
  std::size_t placed_groups_ = 0;
};

}  // namespace assur::mechanism::solve
