// Turns a printed and a derived expression into a verdict, with the evidence for it.
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
  std::string evidence;    ///< how it was decided
  std::string point;       ///< where the two differ; empty where they agree
  std::string difference;  ///< printed less derived, there
};

/// Compares exactly, at random rational points. If both expressions agree at all of them, their
/// difference is reduced by the algebra's relations; zero is a proof. With roots, points go through
/// all quadrants of the angles, since the sign of a root may be right in some and wrong in others.
/// Angles are compared up to whole turns.
/// `on_closures` asks only for agreement at assembled configurations; expressions with total
/// derivatives are always compared there.
[[nodiscard]] Comparison compare(closures::ClosurePoints& points, const GiNaC::ex& printed,
                                 const GiNaC::ex& derived, bool on_closures);

}  // namespace assur::generator::audit
