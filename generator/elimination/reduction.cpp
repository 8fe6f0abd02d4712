#include "elimination/reduction.hpp"

#include <algorithm>
#include <utility>

#include "error.hpp"

namespace assur::generator::elimination {

namespace {

/// One vector loop equation, linear in displacements and in the (cos, sin) of each angle.
struct LoopVector {
  std::string name;
  equations::Vector2 closure;
};

bool depends_on(const GiNaC::ex& expression, const equations::Variable& variable) {
  return variable.is_angle() ? expression.has(variable.cosine) || expression.has(variable.sine)
                             : expression.has(variable.value);
}
bool depends_on(const equations::Vector2& vector, const equations::Variable& variable) {
  return depends_on(vector.x, variable) || depends_on(vector.y, variable);
}

GiNaC::ex dot(const equations::Vector2& a, const equations::Vector2& b) {
  return a.x * b.x + a.y * b.y;
}
GiNaC::ex cross(const equations::Vector2& a, const equations::Vector2& b) {
  return a.x * b.y - a.y * b.x;
}

/// d(vector)/d(displacement): the direction of the slide, with its sign in the loop.
equations::Vector2 direction(const equations::Vector2& vector,
                             const equations::Variable& displacement) {
  return {vector.x.diff(displacement.value), vector.y.diff(displacement.value)};
}
equations::Vector2 without(const equations::Vector2& vector,
                           const equations::Variable& displacement) {
  return {vector.x.subs(displacement.value == 0), vector.y.subs(displacement.value == 0)};
}

class LoopReduction {
 public:
  LoopReduction(const equations::ClosureEquations& equations, equations::Vocabulary& vocabulary)
      : equations_(equations), vocabulary_(vocabulary) {}

  Reduction run() {
    put_origin_at_last_joint();
    for (const LoopVector& loop : loops_) {
      reduce_loop(loop);
    }
    for (const bool angles : {true, false}) {
      for (const equations::Variable& unknown : equations_.unknowns) {
        if (unknown.is_angle() == angles && !is_eliminated(unknown)) {
          result_.remaining.push_back(&unknown);
        }
      }
    }
    if (result_.equations.size() != result_.remaining.size() || result_.remaining.empty() ||
        result_.remaining.size() > 2) {
      throw GeneratorError("elimination", equations_.model->title(),
                           "the reduction leaves neither one equation nor two in as many unknowns");
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_eliminated(const equations::Variable& unknown) const {
    return std::any_of(result_.steps.begin(), result_.steps.end(),
                       [&](const BackSubstitution& step) { return step.unknown == &unknown; });
  }
  [[nodiscard]] GiNaC::ex on_circle(const GiNaC::ex& expression) const {
    return elimination::on_circle(expression, equations_);
  }

  void finish(RecordedStep step) {
    step.vocabulary_size = vocabulary_.quantities().size();
    result_.record.push_back(std::move(step));
  }
  /// `g1`, `g2`: the name of the last equation.
  [[nodiscard]] std::string equation_name() const {
    return "g" + std::to_string(result_.equations.size());
  }

  void put_origin_at_last_joint() {
    std::vector<std::string> external;
    for (const structure::Joint& joint : equations_.model->group->joints()) {
      if (joint.external()) {
        external.emplace_back(1, joint.name);
      }
    }
    const auto input = [&](const std::string& name) -> const equations::Variable& {
      return *std::find_if(
          equations_.inputs.begin(), equations_.inputs.end(),
          [&](const equations::Variable& variable) { return variable.name == name; });
    };
    GiNaC::exmap shift;
    for (const std::string axis : {"x", "y"}) {
      const equations::Variable& origin = input(axis + "_" + external.back());
      shift[origin.value] = 0;
      for (const std::string& joint : external) {
        if (joint != external.back()) {
          const equations::Variable& place = input(axis + "_" + joint);
          shift[place.value] =
              vocabulary_.name(external.back() + joint + "_" + axis, place.value - origin.value,
                               "from joint " + external.back() + " to " + joint);
        }
      }
    }
    RecordedStep step{"joint " + external.back() + " as the origin",
                      "closure is the same wherever the origin is, so the external joints enter by "
                      "their differences alone",
                      {},
                      {}};
    for (const equations::LoopClosure& loop : equations_.loops) {
      const auto shifted = [&](const GiNaC::ex& component) {
        return equations_.vocabulary.expand(component).subs(shift).expand();
      };
      loops_.push_back({loop.name, {shifted(loop.residual.x), shifted(loop.residual.y)}});
    }
    finish(std::move(step));
  }

  /// Unknown angles, or else displacements, that occur only in this loop.
  [[nodiscard]] std::vector<const equations::Variable*> own_unknowns(const LoopVector& loop,
                                                                     bool angles) const {
    std::vector<const equations::Variable*> own;
    for (const equations::Variable& unknown : equations_.unknowns) {
      const bool elsewhere =
          std::any_of(loops_.begin(), loops_.end(), [&](const LoopVector& other) {
            return &other != &loop && depends_on(other.closure, unknown);
          });
      if (unknown.is_angle() == angles && !elsewhere && depends_on(loop.closure, unknown)) {
        own.push_back(&unknown);
      }
    }
    return own;
  }

  void reduce_loop(const LoopVector& loop) {
    const std::vector<const equations::Variable*> slides = own_unknowns(loop, false);
    // If two displacements are the only unknowns, one remains for the final polynomial.
    if (slides.size() == 2 && equations_.unknowns.size() > 2) {
      solve_two_slides(loop, *slides[0], *slides[1]);
    } else if (!slides.empty()) {
      project(loop, *slides[0]);
    } else {
      square(loop);
    }
  }

  /// Loop . normal = 0 is free of the displacement, which follows from loop . direction = 0.
  void project(const LoopVector& loop, const equations::Variable& slide) {
    const equations::Vector2 along = direction(loop.closure, slide);
    const equations::Vector2 rest = without(loop.closure, slide);
    result_.equations.push_back(on_circle(2 * cross(along, rest)));
    result_.steps.push_back({&slide, {on_circle(-dot(along, rest))}, 1, ""});

    RecordedStep step{
        loop.name + " across the slide: free of " + slide.name,
        "the loop is `r + " + slide.name +
            "*e = 0` with the unit vector `e` of its slide: its part across `e` is free of " +
            slide.name + ", its part along `e` gives it back",
        {"cross(e, r) = 0", slide.name + " = -dot(e, r)"},
        {&slide}};
    const equations::Vector2 e =
        step.record("e_" + loop.name, along, "direction of the slide in the loop");
    const equations::Vector2 r =
        step.record("r_" + loop.name, rest, "the other vectors of loop " + loop.name);
    step.record_equation(equation_name(), 2 * cross(e, r), "twice the part across the slide");
    finish(std::move(step));
  }

  /// Solves the two components of the loop for its two displacements.
  void solve_two_slides(const LoopVector& loop, const equations::Variable& first,
                        const equations::Variable& second) {
    const equations::Vector2 first_along = direction(loop.closure, first);
    const equations::Vector2 second_along = direction(loop.closure, second);
    const equations::Vector2 rest = without(without(loop.closure, first), second);
    const GiNaC::ex determinant = on_circle(cross(first_along, second_along));
    const std::string degeneracy =
        "the slides of " + first.name + " and " + second.name + " are parallel";
    result_.steps.push_back(
        {&first, {on_circle(cross(second_along, rest))}, determinant, degeneracy});
    result_.steps.push_back(
        {&second, {on_circle(cross(rest, first_along))}, determinant, degeneracy});

    RecordedStep step{loop.name + ": solved for " + first.name + " and " + second.name,
                      "the loop is `r + " + first.name + "*e1 + " + second.name +
                          "*e2 = 0` with the unit vectors of its two slides: two linear equations",
                      {first.name + " = cross(e2, r)/cross(e1, e2)",
                       second.name + " = cross(r, e1)/cross(e1, e2)"},
                      {&first, &second}};
    const std::string slide = "direction of the slide of ";
    step.record("e1_" + loop.name, first_along, slide + first.name);
    step.record("e2_" + loop.name, second_along, slide + second.name);
    step.record("r_" + loop.name, rest, "the other vectors of loop " + loop.name);
    finish(std::move(step));
  }

  /// |rest|^2 - |v|^2 = 0, where the loop is rest + R(theta) v and theta occurs nowhere else.
  void square(const LoopVector& loop) {
    for (const equations::Variable* angle : own_unknowns(loop, true)) {
      const equations::Vector2 vector{loop.closure.x.diff(angle->cosine),
                                      loop.closure.y.diff(angle->cosine)};
      const bool is_single = std::none_of(
          equations_.unknowns.begin(), equations_.unknowns.end(),
          [&](const equations::Variable& unknown) { return depends_on(vector, unknown); });
      if (!is_single) {
        continue;
      }
      const GiNaC::lst erased{angle->cosine == 0, angle->sine == 0};
      const equations::Vector2 rest{loop.closure.x.subs(erased), loop.closure.y.subs(erased)};
      result_.equations.push_back(on_circle(dot(rest, rest) - dot(vector, vector)));
      // R(theta) v = -rest, so exp(i theta) = -rest conj(v) / |v|^2; for v = (L, 0) it is -rest /
      // L.
      const bool on_axis = vector.y.is_zero();
      const equations::Vector2 by = on_axis ? equations::Vector2{1, 0} : vector;
      result_.steps.push_back({angle,
                               {on_circle(-dot(rest, by)), on_circle(-cross(by, rest))},
                               on_axis ? vector.x : on_circle(dot(vector, vector)),
                               "the link that turns by " + angle->name + " has no length"});

      RecordedStep step{
          loop.name + " squared: free of " + angle->name,
          "the loop is `r` + (`v` turned by " + angle->name + ") = 0, and " + angle->name +
              " occurs nowhere else: `r` and `v` are of one length, and their "
              "directions give the angle back",
          {"dot(r, r) - dot(v, v) = 0", "cos(" + angle->name + ") = -dot(v, r)/dot(v, v)",
           "sin(" + angle->name + ") = -cross(v, r)/dot(v, v)"},
          {angle}};
      const equations::Vector2 r =
          step.record("r_" + loop.name, rest, "the other vectors of loop " + loop.name);
      const equations::Vector2 v =
          step.record("v_" + loop.name, vector, "the vector that turns, in its link");
      step.record_equation(equation_name(), dot(r, r) - dot(v, v), "difference of the squares");
      finish(std::move(step));
      return;
    }
    throw GeneratorError("elimination", equations_.model->title(),
                         "loop " + loop.name + " has no slide and no single vector of its own");
  }

  const equations::ClosureEquations& equations_;
  equations::Vocabulary& vocabulary_;
  std::vector<LoopVector> loops_;
  Reduction result_;
};

}  // namespace

GiNaC::ex on_circle(const GiNaC::ex& expression, const equations::ClosureEquations& equations) {
  GiNaC::ex result = expression.expand();
  for (const std::deque<equations::Variable>* list :
       {&equations.unknowns, &equations.dimensions, &equations.inputs}) {
    for (const equations::Variable& variable : *list) {
      if (!variable.is_angle()) {
        continue;
      }
      const GiNaC::ex square = 1 - variable.sine * variable.sine;
      GiNaC::ex reduced;
      const int degree = result.degree(variable.cosine);
      for (int power = 0; power <= degree; ++power) {
        reduced += result.coeff(variable.cosine, power) * GiNaC::pow(square, power / 2) *
                   GiNaC::pow(variable.cosine, power % 2);
      }
      result = reduced.expand();
    }
  }
  return result;
}

Reduction reduce(const equations::ClosureEquations& equations, equations::Vocabulary& vocabulary) {
  return LoopReduction(equations, vocabulary).run();
}

}  // namespace assur::generator::elimination
