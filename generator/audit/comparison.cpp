#include "audit/comparison.hpp"

#include <algorithm>
#include <sstream>

#include "closures/formula_text.hpp"
#include "equations/more_digits.hpp"

namespace assur::generator::audit {

namespace {

constexpr int wanted_points = 3;
/// The other signs of roots are not tried for more roots than this: too many would have to be.
constexpr std::size_t most_roots = 6;
/// The number of decimal digits that must agree where roots of numbers are irrational.
constexpr int agreeing_digits = 40;

bool is_nothing(const GiNaC::ex& value) {
  const GiNaC::ex exact = value.normal();
  if (exact.is_zero() || exact.info(GiNaC::info_flags::rational)) {
    return exact.is_zero();
  }
  const equations::MoreDigits digits;
  const GiNaC::ex decimal = value.evalf();
  return GiNaC::is_a<GiNaC::numeric>(decimal) &&
         abs(GiNaC::ex_to<GiNaC::numeric>(decimal)) <
             GiNaC::pow(GiNaC::numeric(10), GiNaC::numeric(-agreeing_digits));
}

std::string amount(const GiNaC::ex& value) {
  if (GiNaC::is_a<GiNaC::numeric>(value) &&
      GiNaC::ex_to<GiNaC::numeric>(value).numer().int_length() < 40) {
    return closures::formula_text(value);
  }
  // More digits than are shown, since rounding depends on GiNaC's order of the terms.
  const equations::MoreDigits digits;
  const GiNaC::ex decimal = value.evalf();
  if (!decimal.info(GiNaC::info_flags::real) || !GiNaC::is_a<GiNaC::numeric>(decimal)) {
    return closures::formula_text(value);  // an angle may stand outside sines and cosines
  }
  std::ostringstream text;
  text.precision(12);
  text << GiNaC::ex_to<GiNaC::numeric>(decimal).to_double();
  return text.str();
}

/// How the two sides compare; for angles, by cosines, so that whole turns do not count.
struct Sides {
  GiNaC::ex difference;  ///< zero where they agree
  GiNaC::ex sum;         ///< zero where they are opposite
};

Sides sides_of(closures::ClosurePoints& points, const GiNaC::ex& printed,
               const GiNaC::ex& derived) {
  const GiNaC::ex difference = printed - derived;
  const GiNaC::ex turn = GiNaC::cos(difference) - 1;
  if (points.obstacle(difference) && !points.obstacle(turn)) {
    return {turn, GiNaC::cos(printed + derived) - 1};
  }
  return {difference, printed + derived};
}

/// Whether the sides are opposite; false where their sum has no algebraic form.
bool are_opposite(closures::ClosurePoints& points, const Sides& sides,
                  closures::ClosurePoints::Point& point) {
  try {
    return is_nothing(points.value(sides.sum, point));
  } catch (const closures::NotAlgebraic&) {
    return false;
  }
}

/// Whether a statement holds at one point, and whether that depends on the signs of its roots.
struct Branch {
  closures::ClosurePoints::Point* point;
  GiNaC::ex value;
  bool holds;
  bool would_hold;  ///< with other signs of the roots
};

class BranchComparison {
 public:
  BranchComparison(closures::ClosurePoints& points, const Sides& sides,
                   const std::vector<GiNaC::ex>& shown, bool assembled)
      : points_(points), sides_(sides), shown_(shown), assembled_(assembled) {}

  Comparison run(const closures::ClosurePoints::Rooted& rooted) {
    drawn_ = points_.points_on_all_branches(rooted, assembled_);
    if (drawn_.size() < static_cast<std::size_t>(wanted_points)) {
      return {Verdict::undecided, "no rational points were found where its roots are real", "", ""};
    }
    for (closures::ClosurePoints::Point& point : drawn_) {
      const GiNaC::ex value = points_.value(rooted, point);
      const bool holds = is_nothing(value);
      branches_.push_back({&point, value, holds, !holds && would_hold(rooted, point)});
    }
    const auto holds = [](const Branch& branch) { return branch.holds; };
    if (std::all_of(branches_.begin(), branches_.end(), holds)) {
      const bool proved = !points_.system().follows_closures(sides_.difference) &&
                          points_.vanishes(sides_.difference);
      return {Verdict::agrees, proved ? "identically" : where(), "", ""};
    }
    const bool explained = std::all_of(branches_.begin(), branches_.end(), [](const Branch& each) {
      return each.holds || each.would_hold;
    });
    if (explained && std::any_of(branches_.begin(), branches_.end(), holds)) {
      return on_one_branch();
    }
    return different(explained, rooted.algebra.root_count() - rooted.first_own);
  }

 private:
  [[nodiscard]] std::string where() const {
    return "at " + std::to_string(branches_.size()) + " random rational points" +
           (assembled_ ? " where the closures hold" : "") + ", in all quadrants of its angles";
  }

  bool would_hold(const closures::ClosurePoints::Rooted& rooted,
                  closures::ClosurePoints::Point& point) {
    const std::size_t own = rooted.algebra.root_count() - rooted.first_own;
    if (own > most_roots || rooted.algebra.root_count() > 31) {
      return false;
    }
    for (unsigned signs = 1; signs < 1U << own; ++signs) {
      try {
        if (is_nothing(points_.value(rooted, point, signs << rooted.first_own))) {
          return true;
        }
      } catch (const closures::NotAlgebraic&) {
        continue;  // with these signs another root is not real
      }
    }
    return false;
  }

  Comparison different(bool other_signs, std::size_t roots) {
    const auto failing = std::find_if(branches_.begin(), branches_.end(),
                                      [](const Branch& branch) { return !branch.holds; });
    const bool negated = std::all_of(branches_.begin(), branches_.end(), [&](const Branch& branch) {
      return are_opposite(points_, sides_, *branch.point);
    });
    return {negated ? Verdict::differs_by_sign : Verdict::differs,
            where() + (other_signs ? "; it holds with the other sign of a root" : "") +
                (roots > most_roots
                     ? "; the other signs of its " + std::to_string(roots) + " roots were not tried"
                     : ""),
            points_.point_text(*failing->point, shown_), amount(failing->value)};
  }

  Comparison on_one_branch() {
    const auto right = std::find_if(branches_.begin(), branches_.end(),
                                    [](const Branch& branch) { return branch.holds; });
    const auto wrong = std::find_if(branches_.begin(), branches_.end(),
                                    [](const Branch& branch) { return !branch.holds; });
    const auto [yes, no] = conditions();
    const std::string here = points_.point_text(*right->point, shown_);
    const std::string there = points_.point_text(*wrong->point, shown_);
    return {Verdict::on_one_branch,
            "holds where " + yes + (yes.empty() ? "" : ", as at ") + here + "; not where " + no +
                (no.empty() ? "" : ", as at ") + there,
            there, amount(wrong->value)};
  }

  /// The sign of one quantity where the statement holds, and where it does not; empty if the sign
  /// of no quantity tells.
  std::pair<std::string, std::string> conditions() {
    for (const GiNaC::ex& quantity : points_.telling(sides_.difference)) {
      int sense = 0;
      const bool tells = std::all_of(branches_.begin(), branches_.end(), [&](const Branch& branch) {
        const GiNaC::ex value = points_.value(quantity, *branch.point);
        const int sign = value.info(GiNaC::info_flags::positive)   ? 1
                         : value.info(GiNaC::info_flags::negative) ? -1
                                                                   : 0;
        const int here = branch.holds ? sign : -sign;
        sense = sense == 0 ? here : sense;
        return here == sense || (here == 0 && branch.holds);
      });
      if (tells && sense != 0) {
        const bool negative = closures::formula_text(quantity).starts_with('-');
        const std::string text = closures::formula_text(negative ? -quantity : quantity);
        const bool above = (sense > 0) != negative;
        return {text + (above ? " > 0" : " < 0"), text + (above ? " < 0" : " > 0")};
      }
    }
    return {};
  }

  closures::ClosurePoints& points_;
  const Sides& sides_;
  const std::vector<GiNaC::ex>& shown_;
  bool assembled_;
  std::deque<closures::ClosurePoints::Point> drawn_;
  std::vector<Branch> branches_;
};

std::optional<closures::ClosurePoints::Rooted> rooted(closures::ClosurePoints& points,
                                                      const GiNaC::ex& expression) {
  try {
    return points.rooted(expression);
  } catch (const closures::NotAlgebraic&) {
    return std::nullopt;  // the comparison says why
  }
}

}  // namespace

const char* verdict_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::agrees:
      return "agrees";
    case Verdict::differs_by_sign:
      return "differs by sign";
    case Verdict::differs:
      return "differs";
    case Verdict::on_one_branch:
      return "holds on one branch";
    case Verdict::unreadable:
      return "does not parse";
    case Verdict::fails:
      return "fails";
    case Verdict::undecided:
      break;
  }
  return "undecided";
}

Comparison compare(closures::ClosurePoints& points, const GiNaC::ex& printed,
                   const GiNaC::ex& derived, bool on_closures) {
  const Sides sides = sides_of(points, printed, derived);
  const GiNaC::ex& difference = sides.difference;
  const bool follows = points.system().follows_closures(difference);
  const bool assembled = on_closures || follows;
  if (const auto with_roots = rooted(points, difference)) {
    return BranchComparison(points, sides, {printed, derived}, assembled).run(*with_roots);
  }
  if (const std::optional<std::string> obstacle = points.obstacle(difference)) {
    return {Verdict::undecided, *obstacle, "", ""};
  }
  int compared = 0;
  bool agrees = true;
  bool negated = true;
  Comparison first{Verdict::differs, "", "", ""};
  for (std::size_t index = 0; compared < wanted_points; ++index) {
    closures::ClosurePoints::Point* const point = points.point(index, assembled);
    if (point == nullptr) {
      break;
    }
    try {
      const GiNaC::ex there = points.value(difference, *point);
      const bool zero = is_nothing(there);
      if (!zero && agrees) {
        first.point = points.point_text(*point, {printed, derived});
        first.difference = amount(there);
      }
      agrees = agrees && zero;
      negated = negated && are_opposite(points, sides, *point);
      ++compared;
    } catch (const closures::NotAlgebraic& error) {
      first.evidence = error.what();
    }
  }
  if (compared < wanted_points) {
    const std::string why =
        first.evidence.empty() ? "no assembled rational point was found" : first.evidence;
    return {Verdict::undecided, why, "", ""};
  }
  const std::string exactly = "at " + std::to_string(compared) + " random rational points" +
                              (assembled ? " where the closures hold" : "");
  if (agrees) {
    const bool proved = !follows && points.vanishes(difference);
    return {Verdict::agrees, proved ? "identically" : exactly, "", ""};
  }
  first.evidence = exactly;
  first.verdict = negated ? Verdict::differs_by_sign : Verdict::differs;
  return first;
}

}  // namespace assur::generator::audit
