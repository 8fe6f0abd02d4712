#include "audit/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "audit/branch_condition.hpp"
#include "audit/rounding_bound.hpp"
#include "closures/formula_text.hpp"
#include "equations/more_digits.hpp"

namespace assur::generator::audit {

namespace {

/// The most roots whose other signs are tried: the number of choices doubles with each.
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
  if (value.info(GiNaC::info_flags::rational) &&
      GiNaC::ex_to<GiNaC::numeric>(value).numer().int_length() < 40) {
    return closures::formula_text(value);
  }
  // More digits than are printed, since rounding depends on GiNaC's order of the terms.
  const equations::MoreDigits digits;
  const GiNaC::ex decimal = value.evalf();
  if (!decimal.info(GiNaC::info_flags::real) || !GiNaC::is_a<GiNaC::numeric>(decimal)) {
    return closures::formula_text(value);  // an angle may occur outside sines and cosines
  }
  std::ostringstream text;
  text.precision(12);
  text << GiNaC::ex_to<GiNaC::numeric>(decimal).to_double();
  return text.str();
}

/// Difference and sum of the two sides; for angles, of cosines, so that whole turns do not count.
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

/// Whether an expression with this value vanishes at the point; empty if rounding leaves it open.
/// The value at a computed point is judged by a running bound of its rounding error.
std::optional<bool> vanishes_at(closures::ClosurePoints& points, const GiNaC::ex& expression,
                                const GiNaC::ex& value, closures::ClosurePoints::Point& point) {
  if (!point.is_computed) {
    return is_nothing(value);
  }
  constexpr double rounding = 1e-40;
  constexpr double certain = 1e-30;
  constexpr double of_roots = 1e-10;  // a root near zero has half of the digits, or fewer
  const double bound =
      rounded_value(points.system().expanded(expression), symbol_values(points, point)).error;
  if (!GiNaC::is_a<GiNaC::numeric>(value)) {
    return std::nullopt;
  }
  const double size = GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(value)).to_double();
  if (!std::isfinite(bound)) {
    return size == 0 ? std::optional(true) : size > of_roots ? std::optional(false) : std::nullopt;
  }
  if (size <= bound * rounding || size > bound * certain) {
    return size <= bound * rounding;
  }
  return std::nullopt;
}

/// Whether the sides are opposite; false if their sum has no algebraic form.
bool are_opposite(closures::ClosurePoints& points, const Sides& sides,
                  closures::ClosurePoints::Point& point) {
  try {
    return vanishes_at(points, sides.sum, points.value(sides.sum, point), point).value_or(false);
  } catch (const closures::NotAlgebraic&) {
    return false;
  }
}

/// Compares two expressions at one point after the other.
class PointwiseComparison {
 public:
  PointwiseComparison(closures::ClosurePoints& points, const Sides& sides,
                      const std::vector<GiNaC::ex>& shown, bool assembled)
      : points_(points), sides_(sides), shown_(shown), assembled_(assembled) {}

  /// An expression without roots of its own.
  Comparison run() {
    for (std::size_t index = 0; tested_.size() < wanted(); ++index) {
      closures::ClosurePoints::Point* const point = points_.point(index, assembled_);
      if (point == nullptr) {
        break;
      }
      try {
        add(*point, points_.value(sides_.difference, *point));
      } catch (const closures::NotAlgebraic& error) {
        obstacle_ = error.what();
      }
    }
    if (tested_.size() < fewest) {
      return {Verdict::undecided,
              obstacle_.empty() ? "no point was found where the closures hold" : obstacle_, "", ""};
    }
    // Rational points are of one family: what holds at random ones of them holds at all.
    if (assembled_ && !is_computed()) {
      add_other_factors();
    }
    Comparison comparison = verdict(is_computed(), "");
    comparison.is_computed = is_computed();
    return comparison;
  }

  Comparison run(const closures::ClosurePoints::Rooted& rooted) {
    drawn_ = points_.points_on_all_branches(rooted, assembled_);
    bool explained = true;
    for (closures::ClosurePoints::Point& point : drawn_) {
      add(point, points_.value(rooted, point));
      const bool is_added = !tested_.empty() && tested_.back().point == &point;
      explained = explained && (!is_added || tested_.back().holds || would_hold(rooted, point));
    }
    if (tested_.size() < fewest) {
      return {Verdict::undecided, "no rational points were found where its roots are real", "", ""};
    }
    const std::size_t roots = rooted.algebra.root_count() - rooted.first_own;
    explained_by_roots_ = explained;
    Comparison comparison =
        verdict(true, (explained ? "; it holds with the other sign of a root" : "") +
                          (roots > most_roots ? "; the other signs of its " +
                                                    std::to_string(roots) + " roots were not tried"
                                              : std::string()));
    comparison.is_computed = is_computed();
    return comparison;
  }

 private:
  static constexpr std::size_t fewest = 3;

  [[nodiscard]] bool is_computed() const {
    return std::ranges::any_of(tested_,
                               [](const TestedPoint& one) { return one.point->is_computed; });
  }
  [[nodiscard]] std::size_t wanted() const {
    return is_computed() ? closures::computed_points : fewest;
  }

  void add(closures::ClosurePoints::Point& point, const GiNaC::ex& value) {
    if (const auto holds = vanishes_at(points_, sides_.difference, value, point)) {
      tested_.push_back({&point, *holds});
      values_.push_back(value);
    } else {
      obstacle_ = "rounding hides whether it holds";
    }
  }

  /// Adds points of all factors of the closures, if a statement that holds at all other points
  /// fails at one of them.
  void add_other_factors() {
    if (!std::ranges::all_of(tested_, &TestedPoint::holds)) {
      return;
    }
    const std::size_t known = tested_.size();
    for (closures::ClosurePoints::Point& point : points_.points_of_all_factors()) {
      try {
        const GiNaC::ex value = points_.value(sides_.difference, point);
        if (const auto holds = vanishes_at(points_, sides_.difference, value, point)) {
          tested_.push_back({&point, *holds});
          values_.push_back(value);
        }
      } catch (const closures::NotAlgebraic&) {
        continue;  // a side has no value there
      }
    }
    if (std::ranges::all_of(tested_, &TestedPoint::holds)) {
      tested_.resize(known);
      values_.resize(known);
    }
  }

  [[nodiscard]] std::string where() const {
    const std::string count = "at " + std::to_string(tested_.size()) + " ";
    if (is_computed()) {
      return count + closures::computed_sort + " where the closures hold";
    }
    return count + "random rational points" + (assembled_ ? " where the closures hold" : "") +
           (drawn_.empty() ? "" : ", in all quadrants of its angles");
  }

  bool would_hold(const closures::ClosurePoints::Rooted& rooted,
                  closures::ClosurePoints::Point& point) {
    const std::size_t own = rooted.algebra.root_count() - rooted.first_own;
    if (own > most_roots || rooted.algebra.root_count() > 31) {
      return false;
    }
    for (unsigned signs = 1; signs < 1U << own; ++signs) {
      try {
        const GiNaC::ex value = points_.value(rooted, point, signs << rooted.first_own);
        if (vanishes_at(points_, sides_.difference, value, point).value_or(false)) {
          return true;
        }
      } catch (const closures::NotAlgebraic&) {
        continue;  // with these signs another root is not real
      }
    }
    return false;
  }

  Comparison verdict(bool has_branches, const std::string& remark) {
    const auto holding =
        std::ranges::count_if(tested_, [](const TestedPoint& one) { return one.holds; });
    if (holding == std::ssize(tested_)) {
      const bool proved = !points_.system().follows_closures(sides_.difference) &&
                          points_.vanishes(sides_.difference);
      return {Verdict::agrees, proved ? "identically" : where(), "", ""};
    }
    if (holding > 0 && has_branches) {
      const BranchCondition condition = branch_condition(points_, sides_.difference, tested_);
      if (!condition.empty() || explained_by_roots_) {
        return on_one_branch(condition);
      }
      Comparison comparison = different("; " + branch_text(tested_, condition) + remark);
      comparison.branch = branch_text(tested_, condition);
      return comparison;
    }
    return different(remark);
  }

  Comparison different(const std::string& remark) {
    const bool negated = std::ranges::all_of(
        tested_, [&](const TestedPoint& one) { return are_opposite(points_, sides_, *one.point); });
    const std::size_t failing = first(false);
    return {negated ? Verdict::differs_by_sign : Verdict::differs, where() + remark,
            text_of(failing), amount(values_[failing])};
  }

  Comparison on_one_branch(const BranchCondition& condition) {
    const std::string branch = branch_text(tested_, condition);
    const std::size_t failing = first(false);
    const std::string fails = condition.empty() ? "" : " where " + condition.where_it_fails;
    return {Verdict::on_one_branch,
            branch + ", as at " + text_of(first(true)) + "; not" + fails + ", as at " +
                text_of(failing),
            text_of(failing), amount(values_[failing]), branch};
  }

  [[nodiscard]] std::size_t first(bool holds) const {
    const auto found =
        std::ranges::find_if(tested_, [&](const TestedPoint& one) { return one.holds == holds; });
    return static_cast<std::size_t>(found - tested_.begin());
  }
  [[nodiscard]] std::string text_of(std::size_t index) {
    return points_.point_text(*tested_[index].point, shown_, assembled_);
  }

  closures::ClosurePoints& points_;
  const Sides& sides_;
  const std::vector<GiNaC::ex>& shown_;
  bool assembled_;
  bool explained_by_roots_ = false;
  std::string obstacle_;
  std::deque<closures::ClosurePoints::Point> drawn_;
  std::vector<TestedPoint> tested_;
  std::vector<GiNaC::ex> values_;  ///< of the difference, at these points
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
  const std::vector<GiNaC::ex> shown = {printed, derived};
  PointwiseComparison comparison(points, sides, shown, assembled);
  if (const auto with_roots = rooted(points, difference)) {
    return comparison.run(*with_roots);
  }
  if (const std::optional<std::string> obstacle = points.obstacle(difference)) {
    return {Verdict::undecided, *obstacle, "", ""};
  }
  return comparison.run();
}

}  // namespace assur::generator::audit
