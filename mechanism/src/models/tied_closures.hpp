// Decides whether the loop closures of a degenerate model, in which prismatic joints fix the angles
// of all links but at most one, hold anywhere, and with what mobility.
#pragma once

#include "models/model_kernel.hpp"

namespace assur::mechanism::models {

/// The closures of a group at given numbers, lengths near one: f(s, e) = slides s + turning e +
/// fixed, for displacements s and the direction e of the angle that no slide fixes. If the whole
/// group turns by that angle, they are expressed in the frame of a link that turns with it.
struct TiedClosures {
  SmallMatrix slides;   ///< a column per displacement; two rows per loop, a unit vector or zeros
  SmallMatrix turning;  ///< a column for the cosine, and one for the sine
  SmallVector fixed;
  bool turns = false;    ///< whether there is an angle
  double farthest = 0;   ///< the largest coordinate among the inputs
  double displaced = 0;  ///< bound on the displacement by rounding of the links that hold the group
  double turned = 0;     ///< bound on their turn by rounding, plus the misfit of the fixed angles
};

/// The solutions of the closures.
struct TiedVerdict {
  bool closes = false;
  int mobility = 0;  ///< if they hold
  double miss = 0;   ///< the least norm of the closures
};

/// In any direction e the closures are linear in the displacements. They hold for some
/// displacements if their value without displacements has no part along the directions that no
/// slide reaches. These directions are found first, by a decomposition with a bound on rounding,
/// and then the angles at which the parts along them vanish. The remaining displacements are free,
/// and so is the angle if no part depends on it.
[[nodiscard]] TiedVerdict verdict_on(const TiedClosures& closures);

}  // namespace assur::mechanism::models
