// Turns polar loop closures into the Jacobian's entries as projections along and across each
// loop's closing vector.
#pragma once

#include <string>
#include <vector>

#include "solution/polar_closure.hpp"

namespace assur::generator {

/// (cos, sin) of a sum of angles, named; sums are built up from shorter sums that have names.
[[nodiscard]] Vector2 named_direction(const AngleSum& angle, Vocabulary& vocabulary);

/// The closures and their derivatives, loop by loop in the loop's frame: a row along the frame's
/// direction, then a row across it. Rotating two rows changes neither solutions nor determinant.
class FramedClosures {
 public:
  explicit FramedClosures(const ClosureEquations& equations);

  [[nodiscard]] const ClosureEquations& equations() const { return *equations_; }
  [[nodiscard]] const Vocabulary& vocabulary() const { return vocabulary_; }
  [[nodiscard]] int row_count() const { return 2 * static_cast<int>(loops_.size()); }
  /// `along_CD`, `across_CD`, ...
  [[nodiscard]] std::string row_name(int row) const;

  /// (cos, sin) of the frame of a loop.
  [[nodiscard]] const Vector2& frame_direction(int loop) const {
    return frame_directions_[static_cast<std::size_t>(loop)];
  }

  /// d(closures)/d(variable), a component a row, in names of the vocabulary.
  [[nodiscard]] std::vector<GiNaC::ex> derivative(const Variable& variable) const;
  /// d2(closures)/dt2 for constant rates of the unknowns and the inputs: centripetal and Coriolis
  /// terms.
  [[nodiscard]] std::vector<GiNaC::ex> quadratic_rates() const;
  /// An upper bound of a derivative's size, from the lengths alone: sums of |length|, one for a
  /// direction.
  [[nodiscard]] std::vector<GiNaC::ex> derivative_bound(const Variable& variable) const;
  /// An upper bound of each row's largest vector.
  [[nodiscard]] std::vector<GiNaC::ex> row_size() const;

 private:
  /// Vectors of one loop that turn at one rate.
  struct Turning {
    AngleSum moving;  ///< the unknown and input angles by which they turn
    Vector2 vector;   ///< their sum in the loop's frame
  };

  void name_directions();
  void name_turning_vectors();
  [[nodiscard]] AngleSum moving_part(const AngleSum& angle) const;

  const ClosureEquations* equations_;
  Vocabulary vocabulary_;
  std::vector<PolarLoop> loops_;
  std::vector<Vector2> frame_directions_;
  std::vector<std::vector<Vector2>> directions_;  ///< of each loop's terms, in its frame
  std::vector<std::vector<Turning>> turnings_;
};

}  // namespace assur::generator
