// Turns the sweep of a request into the frames of an animation.
#pragma once

#include <assur/mechanism/drawing.hpp>

namespace assur::mechanism::draw {

/// A branch of the sweep, step by step. Numbers are NaN at steps at which it does not exist, and
/// for rates that are not known.
struct FilmedBranch {
  int number;                   ///< as in `assur solve --format csv`
  std::vector<double> points;   ///< for each step x and y of each point of the shapes
  std::vector<double> outputs;  ///< for each step x, y, vx, vy, ax, ay of each output
  /// For each step the variances of x and y of each output and, between them, their covariance;
  /// empty where nothing varies.
  std::vector<double> spreads;
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
  int count = 1;            ///< of steps, both ends among them
  std::vector<Shape> shapes;
  std::size_t points = 0;  ///< in each step
  std::vector<FilmedBranch> branches;
  std::vector<FilmedEvent> events;
  int chosen = 1;            ///< the branch that is looked at first
  std::size_t left_out = 0;  ///< branches that are not in the film
};

/// The branches of the sweep, at steps that include those of the scene, unless that takes more than
/// `most_numbers`; without a sweep, the configurations. There are `most_drawn` of them at most, and
/// always the chosen one: by its number, or for 0 the one nearest to the reference, or else the
/// first. Spreads follow from the request's covariance or, without one, from the tolerances, each
/// taken as the standard deviation of its parameter, so that the roots of the variances are the
/// `rss`; they exist where sensitivities are wanted. Throws MechanismError as `sweep` does, and
/// where there is no configuration at any step.
[[nodiscard]] Film film_of(const Mechanism& mechanism, const Request& request,
                           std::size_t most_numbers, int chosen = 0);

}  // namespace assur::mechanism::draw
