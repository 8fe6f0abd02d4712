#include "audit/comparison.hpp"

#include <algorithm>
#include <sstream>

#include "closures/formula_text.hpp"

namespace assur::generator::audit {

namespace {

constexpr int wanted_points = 3;
/// Roots of numbers that are no squares are compared as decimals of so many digits ...
constexpr int decimal_digits = 60;
/// ... of which so many must agree.
constexpr int agreeing_digits = 40;

/// Raises the number of digits of evaluation for as long as it lives.
class MoreDigits {
 public:
  MoreDigits() : before_(GiNaC::Digits) { GiNaC::Digits = decimal_digits; }
  ~MoreDigits() { GiNaC::Digits = before_; }
  MoreDigits(const MoreDigits&) = delete;
  MoreDigits& operator=(const MoreDigits&) = delete;

 private:
  long before_;
};

bool is_nothing(const GiNaC::ex& value) {
  if (value.is_zero() || value.normal().is_zero()) {
    return true;
  }
  const MoreDigits digits;
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
  // More digits than are shown: the terms are summed in GiNaC's order, and so rounded.
  const MoreDigits digits;
  const GiNaC::ex decimal = value.evalf();
  if (!decimal.info(GiNaC::info_flags::real) || !GiNaC::is_a<GiNaC::numeric>(decimal)) {
    return closures::formula_text(value);  // an angle may stand outside sines and cosines
  }
  std::ostringstream text;
  text.precision(12);
  text << GiNaC::ex_to<GiNaC::numeric>(decimal).to_double();
  return text.str();
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
    case Verdict::unreadable:
      return "does not parse";
    case Verdict::undecided:
      break;
  }
  return "undecided";
}

Comparison compare(closures::ClosurePoints& points, const GiNaC::ex& printed,
                   const GiNaC::ex& derived, bool on_closures) {
  const GiNaC::ex difference = printed - derived;
  const bool follows = points.system().follows_closures(difference);
  const bool assembled = on_closures || follows;
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
      negated = negated && is_nothing(points.value(printed + derived, *point));
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
