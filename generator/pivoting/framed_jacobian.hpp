// The Jacobian by projections of the loop closures along and across each loop's closing vector.
#pragma once

#include <string>
#include <vector>

#include "pivoting/polar_closure.hpp"

namespace assur::generator::pivoting {

/// (cos, sin) of a sum of angles, named; sums are built from shorter named sums.
[[nodiscard]] equations::Vector2 named_direction(const equations::AngleSum& angle,
                                                 equations::Vocabulary& vocabulary);

/// The closures and their derivatives, loop by loop in the loop's frame: a row along the frame's
/// direction, then a row across it. Rotating two rows changes neither solutions nor determinant.
class FramedClosures {
 public:
  explicit FramedClosures(const equations::ClosureEquations& equations);

  [[nodiscard]] const equations::ClosureEquations& equations() const { return *equations_; }
  [[nodiscard]] const equations::Vocabulary& vocabulary() const { return vocabulary_; }
  [[nodiscard]] std::size_t row_count() const { return 2 * loops_.size(); }
  /// `along_CD`, `across_CD`, ...
  [[nodiscard]] std::string row_name(std::size_t row) const;

  /// (cos, sin) of the frame of a loop.
  [[nodiscard]] const equations::Vector2& frame_direction(std::size_t loop) const {
    return frame_directions_[loop];
  }

  /// d(closures)/d(variable), one component per row, in names of the vocabulary.
  [[nodiscard]] std::vector<GiNaC::ex> derivative(const equations::Variable& variable) const;
  /// d2(closures)/dt2 for constant rates of the unknowns and the inputs: centripetal and Coriolis
  /// terms.
  [[nodiscard]] std::vector<GiNaC::ex> quadratic_rates() const;
  /// An upper bound of each component of a derivative: for an angle, the sum of |length| over the
  /// vectors that turn with it; for a length, the number of vectors that have it.
  [[nodiscard]] std::vector<GiNaC::ex> derivative_bound(const equations::Variable& variable) const;
  /// For each row, the sum of |length| over its loop's vectors that have an angle.
  [[nodiscard]] std::vector<GiNaC::ex> row_size() const;

 private:
  /// Vectors of one loop that turn at one rate.
  struct Turning {
    equations::AngleSum moving;  ///< the unknown and input angles by which they turn
    equations::Vector2 vector;   ///< their sum in the loop's frame
  };

  void name_directions();
  void name_turning_vectors();
  [[nodiscard]] equations::AngleSum moving_part(const equations::AngleSum& angle) const;

  const equations::ClosureEquations* equations_;
  equations::Vocabulary vocabulary_;
  std::vector<PolarLoop> loops_;
  std::vector<equations::Vector2> frame_directions_;
  std::vector<std::vector<equations::Vector2>> directions_;  ///< of each loop's terms, in its frame
  std::vector<std::vector<Turning>> turnings_;
};

}  // namespace assur::generator::pivoting
