// Angles, transmission angles and forces in the configurations of a film.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/structure.hpp>
#include <assur/mechanism/values.hpp>
#include <vector>

#include "draw/film.hpp"

namespace assur::mechanism::draw {

/// Two links joined by a pin, each with another pin on the links that hold the dyad.
struct PinnedDyad {
  ElementaryJoint inner, one, other;
};

/// The groups of two links and three pins, in the order in which they are placed.
[[nodiscard]] std::vector<PinnedDyad> dyads_of_pins(const Structure& structure);

/// The angle at the inner pin between the lines to the outer pins, in radians from 0 to pi: force
/// transmission is best at pi/2, and impossible at 0 and pi.
[[nodiscard]] double transmission_angle(const PinnedDyad& dyad, const Values& values,
                                        const Configuration& configuration);

/// The numbers of one configuration, in the order of the names in a film.
struct DetailRow {
  std::vector<double> angles;         ///< theta, omega, alpha of each link
  std::vector<double> transmissions;  ///< of each dyad
  std::vector<double> forces;         ///< efforts, then x and y of each force
};

/// The quantities of a plan that are filmed beside the outputs.
class FilmDetails {
 public:
  explicit FilmDetails(const Plan& plan);

  /// Sets the names of the filmed quantities in a film: those of forces once a row has been
  /// computed.
  void name(Film& film) const;
  /// `values` are those at which the configuration was solved.
  [[nodiscard]] DetailRow row_of(const Values& values, const Configuration& configuration);

 private:
  [[nodiscard]] std::vector<double> forces_in(const Values& values,
                                              const Configuration& configuration);

  const Plan& plan_;
  std::vector<LinkIndex> links_;
  std::vector<PinnedDyad> dyads_;
  std::vector<FilmedForce> forces_;
};

}  // namespace assur::mechanism::draw
