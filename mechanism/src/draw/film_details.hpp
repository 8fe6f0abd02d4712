// Turns configurations into the angles, transmission angles and forces of a film.
#pragma once

#include <assur/mechanism/plan.hpp>

#include "draw/film.hpp"
#include "draw/transmission_angles.hpp"

namespace assur::mechanism::draw {

/// The numbers of one configuration, in the order of the names in a film.
struct DetailRow {
  std::vector<double> angles;         ///< theta, omega, alpha of each link
  std::vector<double> transmissions;  ///< of each dyad
  std::vector<double> forces;         ///< efforts, then x and y of each force
};

/// What of a plan is filmed beside the outputs.
class FilmDetails {
 public:
  explicit FilmDetails(const Plan& plan);

  /// Gives a film the names of what is filmed: those of forces once a row has been made.
  void name(Film& film) const;
  /// `values` are those with which the configuration was solved.
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
