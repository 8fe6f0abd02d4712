#include "pivoting/polar_closure.hpp"

#include <algorithm>

#include "error.hpp"

namespace assur::generator::pivoting {

namespace {

equations::Vector2 quarter_turned(const equations::Vector2& vector, int quarter_turns) {
  equations::Vector2 result = vector;
  for (int turn = 0; turn < quarter_turns; ++turn) {
    result = {-result.y, result.x};
  }
  return result;
}

bool equal(const equations::Vector2& one, const equations::Vector2& other) {
  return (one.x - other.x).expand().is_zero() && (one.y - other.y).expand().is_zero();
}

std::vector<const equations::Variable*> variables_of(const equations::ClosureEquations& equations,
                                                     bool angles) {
  std::vector<const equations::Variable*> list;
  for (const auto* variables : {&equations.unknowns, &equations.dimensions, &equations.inputs}) {
    for (const equations::Variable& variable : *variables) {
      if (variable.is_angle() == angles) {
        list.push_back(&variable);
      }
    }
  }
  return list;
}

/// The direction equal to a coefficient. An angle has the factor k in it if rotating the angle
/// rotates the coefficient k times as fast.
PolarTerm recognised_term(const equations::ClosureEquations& equations,
                          const equations::Variable& length,
                          const equations::Vector2& coefficient) {
  PolarTerm term{&length, {}, 0};
  for (const equations::Variable* angle : variables_of(equations, true)) {
    const equations::Vector2 change{equations::partial(coefficient.x, *angle),
                                    equations::partial(coefficient.y, *angle)};
    const equations::Vector2 normal = quarter_turned(coefficient, 1);
    for (const int factor : {1, -1, 2, -2}) {
      if (equal(change, {factor * normal.x, factor * normal.y})) {
        term.angle.add(*angle, factor);
      }
    }
  }
  const equations::Vector2 direction = term.angle.direction();
  while (!equal(coefficient, quarter_turned(direction, term.quarter_turns))) {
    if (++term.quarter_turns == 4) {
      throw GeneratorError("pivoting", equations.model->title(),
                           "the coefficient of " + length.name + " is no direction");
    }
  }
  return term;
}

PolarLoop polar_loop(const equations::ClosureEquations& equations,
                     const equations::LoopClosure& loop) {
  PolarLoop result;
  equations::Vector2 rest{equations.vocabulary.expand(loop.residual.x),
                          equations.vocabulary.expand(loop.residual.y)};
  for (const equations::Variable* length : variables_of(equations, false)) {
    const equations::Vector2 coefficient{rest.x.diff(length->value), rest.y.diff(length->value)};
    if (coefficient.x.is_zero() && coefficient.y.is_zero()) {
      continue;
    }
    result.terms.push_back(recognised_term(equations, *length, coefficient));
    rest = {(rest.x - length->value * coefficient.x).expand(),
            (rest.y - length->value * coefficient.y).expand()};
  }
  if (!rest.x.is_zero() || !rest.y.is_zero()) {
    throw GeneratorError("pivoting", equations.model->title(),
                         "closure " + loop.name + " is not linear in lengths");
  }
  return result;
}

bool occurs(const equations::Variable& unknown, const PolarLoop& loop) {
  return std::any_of(loop.terms.begin(), loop.terms.end(), [&](const PolarTerm& term) {
    return term.length == &unknown || term.angle.factor(unknown) != 0;
  });
}

/// Takes the frame of a slide or link whose unknown occurs in no other loop. Slides come first,
/// since the column of a displacement contains no length.
void choose_frame(const equations::ClosureEquations& equations, std::vector<PolarLoop>& loops,
                  std::size_t index) {
  PolarLoop& loop = loops[index];
  for (const bool angles : {false, true}) {
    for (const equations::Variable& unknown : equations.unknowns) {
      bool here_alone = unknown.is_angle() == angles && occurs(unknown, loop);
      for (std::size_t other = 0; other < loops.size(); ++other) {
        here_alone = here_alone && (other == index || !occurs(unknown, loops[other]));
      }
      if (!here_alone) {
        continue;
      }
      const auto term =
          std::find_if(loop.terms.begin(), loop.terms.end(), [&](const PolarTerm& candidate) {
            return candidate.length == &unknown || candidate.angle.factor(unknown) != 0;
          });
      loop.frame = term->angle;
      const std::string letters = unknown.name.substr(unknown.name.find('_') + 1);
      loop.frame_name = unknown.is_angle() ? letters : "slide_" + letters;
      return;
    }
  }
  throw GeneratorError("pivoting", equations.model->title(),
                       "closure " + equations.loops[index].name + " has no unknown of its own");
}

}  // namespace

std::vector<PolarLoop> polar_loops(const equations::ClosureEquations& equations) {
  std::vector<PolarLoop> loops;
  for (const equations::LoopClosure& loop : equations.loops) {
    loops.push_back(polar_loop(equations, loop));
  }
  for (std::size_t index = 0; index < loops.size(); ++index) {
    choose_frame(equations, loops, index);
  }
  return loops;
}

}  // namespace assur::generator::pivoting
