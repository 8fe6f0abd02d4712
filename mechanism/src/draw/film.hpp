// Frames of an animation over the sweep of a request.
#pragma once

#include <assur/mechanism/drawing.hpp>
#include <optional>

namespace assur::mechanism::draw {

/// A branch of the sweep, step by step. Numbers are NaN at steps at which it does not exist, and
/// for unknown rates.
struct FilmedBranch {
  int number;                   ///< as in `assur solve --format csv`
  std::vector<double> points;   ///< for each step x and y of each point of the shapes
  std::vector<double> outputs;  ///< for each step x, y, vx, vy, ax, ay of each output
  /// For each step the variances of x and y of each output and, between them, their covariance;
  /// empty without variation.
  std::vector<double> spreads;
  /// For each step the angle of each filmed link, its first and its second rate, in radians; empty
  /// without details.
  std::vector<double> angles;
  /// For each step the transmission angle of each filmed dyad, in radians.
  std::vector<double> transmissions;
  /// For each step the efforts of the drivers, then x and y of each filmed force in a joint; NaN
  /// where they are not determined, and empty if no forces are requested.
  std::vector<double> forces;
  int circuit = 0;  ///< 0 without a sweep
  int next = 0;     ///< the branch that continues it at the first step; 0 if none does
};

/// A force in a joint, on one of its links.
struct FilmedForce {
  std::string joint, link;
};

/// An event of the sweep: its kind, the numbers of its branches, and the value of the swept
/// parameter.
struct FilmedEvent {
  std::string event;
  std::vector<int> branches;
  double parameter;
};

/// The branches and events of a sweep, for an animation.
struct Film {
  double from = 0, to = 0;  ///< of the swept parameter
  int count = 1;            ///< number of steps, both ends included
  std::vector<Shape> shapes;
  std::size_t points = 0;  ///< number at each step
  std::vector<FilmedBranch> branches;
  std::vector<FilmedEvent> events;
  std::vector<std::string> links;          ///< with filmed angles
  std::vector<std::string> transmissions;  ///< the inner pins of the filmed dyads
  std::vector<std::string> efforts;        ///< the joints of the drivers, if forces are requested
  std::vector<FilmedForce> forces;         ///< of the reported joints
  std::vector<double> parameters;          ///< the values of the mechanism's parameters
  int chosen = 1;                          ///< the branch shown first
  std::optional<int> nearest;              ///< the branch nearest to the reference, if there is one
  bool is_followed = true;                 ///< whether a given pose is on the chosen branch
  std::size_t left_out = 0;                ///< number of branches that are not in the film
};

/// A pose of an earlier film, whose branch is to be followed.
struct SeenPose {
  double part = 0;             ///< fraction of the sweep, from 0 to 1
  std::vector<double> points;  ///< x and y of each point of the shapes
};

/// Options of a film.
struct Filming {
  std::size_t most_numbers;
  int chosen = 0;                ///< the number of the branch to show; 0 if none is given
  bool details = true;           ///< whether to film angles and forces
  std::optional<SeenPose> seen;  ///< selects the branch nearest to it
};

/// The branches of the sweep, at steps that include those of the scene, unless that takes more than
/// `most_numbers`; without a sweep, the configurations. There are at most `most_drawn` of them, and
/// always the chosen one: that whose points are nearest to the given pose, or that with the given
/// number, or the one nearest to the reference, or else the first. Spreads follow from the
/// request's covariance or, without one, from the tolerances, each taken as the standard deviation
/// of its parameter, so that the roots of the variances are the `rss`; they exist if sensitivities
/// are requested. Angles are those of the reported links except the ground; the force in a joint is
/// that on the last of its links, or for several links that on each. The transmission angle of a
/// dyad with three pins is the angle at its inner pin between the lines to the outer ones, from 0
/// to pi. Throws MechanismError as `sweep` does and if no step has a configuration, and
/// NoSuchConfiguration if no branch has the given number.
[[nodiscard]] Film film_of(const Mechanism& mechanism, const Request& request,
                           const Filming& filming);

}  // namespace assur::mechanism::draw
