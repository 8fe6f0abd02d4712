// The verdict on a printed expression by comparison with the derived one, and its evidence.
#pragma once

#include "closures/closure_points.hpp"

namespace assur::generator::audit {

enum class Verdict : unsigned char {
  agrees,
  differs_by_sign,
  differs,
  on_one_branch,  ///< right for some signs of roots and wrong for others
  unreadable,
  fails,  ///< a program has no value at some point
  undecided
};

[[nodiscard]] const char* verdict_text(Verdict verdict);

struct Comparison {
  Verdict verdict;
  std::string evidence;      ///< the way in which it was decided
  std::string point;         ///< where the two differ; empty where they agree
  std::string difference;    ///< printed minus derived, at the point
  std::string branch{};      ///< `agrees at 20 of 40 points, all those where cos(ph) > 0`
  bool is_computed = false;  ///< compared at computed points, since no rational ones were found
};

/// Compares exactly, at random rational points. If both expressions agree at all of them, their
/// difference is reduced by the algebra's relations; zero is a proof. With roots, the points lie in
/// all quadrants of the angles, since the sign of a root may be right in some and wrong in others.
/// Where no rational points are assembled, points of many digits on all branches are used, and a
/// difference counts if it is far above its rounding error. Angles are compared up to whole turns.
/// `on_closures` requires agreement at assembled configurations only; expressions with total
/// derivatives are always compared there.
[[nodiscard]] Comparison compare(closures::ClosurePoints& points, const GiNaC::ex& printed,
                                 const GiNaC::ex& derived, bool on_closures);

}  // namespace assur::generator::audit
