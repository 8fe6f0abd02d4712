#include "closures/angle_terms.hpp"

#include "closures/circle_algebra.hpp"
#include "closures/extent.hpp"
#include "closures/formula_text.hpp"

namespace assur::generator::closures {

namespace {

void add_terms(const GiNaC::ex& angle, int factor, const ClosureSystem& system, AngleTerms& sum) {
  if (!can_be_multiplied_out(angle)) {
    throw NotAlgebraic("an angle has too many terms to be a sum of multiples of declared angles");
  }
  const GiNaC::ex expanded = angle.expand();
  if (GiNaC::is_a<GiNaC::add>(expanded)) {
    for (const GiNaC::ex& term : expanded) {
      add_terms(term, factor, system, sum);
    }
    return;
  }
  GiNaC::numeric multiple = factor;
  GiNaC::ex base = 1;
  for (const GiNaC::ex& part :
       GiNaC::is_a<GiNaC::mul>(expanded) ? expanded : GiNaC::ex(GiNaC::lst{expanded})) {
    if (GiNaC::is_a<GiNaC::numeric>(part)) {
      multiple *= GiNaC::ex_to<GiNaC::numeric>(part);
    } else {
      base *= part;
    }
  }
  const bool turns = base.is_equal(GiNaC::Pi);
  multiple *= turns ? 2 : 1;
  if (multiple.is_zero()) {
    return;
  }
  if (base.is_equal(1) || !multiple.is_integer() || abs(multiple) > max_multiple) {
    throw NotAlgebraic("the angle '" + formula_text(expanded) +
                       "' is not a whole multiple of a declared angle; declare an angle for it");
  }
  const int count = multiple.to_int();
  const GiNaC::ex* definition = system.definition_of(base);
  if (turns) {
    sum.quarter_turns += count;
  } else if (definition != nullptr && !GiNaC::is_a<GiNaC::function>(*definition)) {
    add_terms(*definition, count, system, sum);
  } else {
    const std::string text = formula_text(base);
    AngleTerm& term = sum.terms.try_emplace(text, AngleTerm{base, 0}).first->second;
    term.factor += count;
    if (term.factor == 0) {
      sum.terms.erase(text);
    }
  }
}

}  // namespace

AngleTerms angle_terms(const GiNaC::ex& angle, const ClosureSystem& system) {
  AngleTerms sum;
  add_terms(angle, 1, system, sum);
  return sum;
}

}  // namespace assur::generator::closures
