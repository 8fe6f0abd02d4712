// Special Assur points: points of closure links that the unknowns of a side move in one known
// direction, so that velocities follow from vector diagrams.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "derivatives/differentiate.hpp"

namespace assur::generator::special_points {

/// The motion of a point S of a closure link, reached by one of its neighbours:
///   velocity      known_velocity + sum over k of contributions[k] dq_k/dt,
///   acceleration  known_acceleration + sum over k of contributions[k] d2q_k/dt2.
/// On the line normal . S = offset all contributions are parallel to the normal.
struct SpecialPointSide {
  structure::LinkIndex by;                        ///< the neighbour
  std::vector<equations::Vector2> contributions;  ///< for each unknown, in the coordinates of S
  std::vector<std::size_t> moving;  ///< the unknowns whose contribution is not always zero
  equations::Vector2 normal;        ///< not of unit length
  GiNaC::ex offset;
  equations::Vector2 known_velocity;      ///< in S and the inputs' rates
  equations::Vector2 known_acceleration;  ///< in S, all rates, and the inputs' second rates
};

/// The special point of one closure link: the intersection of the lines of its two sides.
struct SpecialPoint {
  structure::LinkIndex link;
  GiNaC::symbol x, y;  ///< of S in the fixed directions, from the origin of the link's frame
  std::array<SpecialPointSide, 2> sides;
};

/// The special points of a model, one for each closure link: a link with internal joints only.
struct SpecialPoints {
  std::vector<SpecialPoint> points;
  bool defined = true;  ///< whether every side of every closure link has its line
  std::string reason;   ///< the reason if not
};

/// The links with internal joints only, in ascending order.
[[nodiscard]] std::vector<structure::LinkIndex> closure_links(const structure::Group& group);

/// Derives the method of Quintero, Calle, Diaz and Henao (2011). The sides of a closure link are
/// the walk along the spanning tree and the walk through the loop's chord. If the method is not
/// defined, `points` may be incomplete.
[[nodiscard]] SpecialPoints special_points(const equations::ClosureEquations& equations,
                                           const derivatives::Derivatives& derivatives);

}  // namespace assur::generator::special_points
