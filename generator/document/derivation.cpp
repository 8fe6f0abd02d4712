#include "document/derivation.hpp"

#include <algorithm>
#include <assur/text/names.hpp>
#include <set>

#include "derivatives/mobility.hpp"
#include "document/formula_writer.hpp"
#include "document/phrases.hpp"
#include "elimination/eliminate.hpp"
#include "equations/symbols.hpp"
#include "forces/group_forces.hpp"
#include "pivoting/structured_jacobian.hpp"
#include "program/program.hpp"

namespace assur::generator::document {

namespace {

std::vector<std::string> names_of(const std::vector<DerivedVariable>& variables) {
  std::vector<std::string> names;
  names.reserve(variables.size());
  for (const DerivedVariable& variable : variables) {
    names.push_back(variable.name);
  }
  return names;
}

std::vector<DerivedVariable> described(const std::deque<equations::Variable>& variables) {
  std::vector<DerivedVariable> list;
  list.reserve(variables.size());
  for (const equations::Variable& variable : variables) {
    list.push_back({variable.name, variable.is_angle(), variable.rate.get_name(),
                    variable.second_rate.get_name(), variable.meaning});
  }
  return list;
}

/// Builds the derivation of one model in reading order.
class DerivationGatherer {
 public:
  DerivationGatherer(const structure::Model& model, const structure::Kind& kind)
      : equations_(equations::closure_equations(model)), write_(equations_) {
    result_.model = &model;
    result_.kind = kind;
  }

  Derivation run() {
    gather_structure();
    const derivatives::Derivatives derivatives = derivatives::differentiate(equations_);
    gather_closures(derivatives);
    if (!equations_.model->is_numbered()) {
      return std::move(result_);
    }
    const derivatives::Mobility mobility =
        derivatives::mobility_of(equations_, derivatives.jacobian);
    result_.rigid = mobility.rigid;
    result_.rank = mobility.rank;
    result_.mobility = mobility.freedom;
    result_.reason = mobility.reason;
    if (mobility.rigid) {
      const pivoting::StructuredJacobian structured(equations_);
      gather_determinant(structured);
      gather_elimination();
      gather_forces(derivatives, structured);
    }
    return std::move(result_);
  }

 private:
  void gather_structure() {
    const structure::Group& group = *equations_.model->group;
    const auto member = std::find_if(
        equations_.model->members.begin(), equations_.model->members.end(),
        [&](const structure::Relabelling& candidate) { return candidate.kind == result_.kind; });
    for (const structure::JointIndex joint : group.joints().keys()) {
      const bool is_member = member != equations_.model->members.end();
      result_.roles.add({group.joints()[is_member ? member->role[joint] : joint].name});
    }
    for (const structure::LinkIndex link : group.links().keys()) {
      result_.frames.add(equations_.frames[link].description);
      result_.angles.add(equations_.poses[link].angle.text());
    }
    result_.unknowns = described(equations_.unknowns);
    result_.dimensions = described(equations_.dimensions);
    result_.inputs = described(equations_.inputs);
    for (const equations::AngleSum& sum : equations_.compatibility) {
      result_.compatibility.push_back(sum.text());
    }
  }

  void gather_closures(const derivatives::Derivatives& derivatives) {
    const std::vector<GiNaC::ex> residuals = equations_.residuals;
    std::vector<std::string> rows;
    for (std::size_t loop = 0; loop < equations_.loops.size(); ++loop) {
      DerivedClosure closure{equations_.loops[loop].name, equations_.loops[loop].equation, {}, {}};
      for (std::size_t axis = 0; axis < 2; ++axis) {
        rows.push_back("f" + std::to_string(2 * loop + axis + 1));
        closure.names[axis] = rows.back();
        closure.values[axis] = write_(residuals[2 * loop + axis]);
      }
      result_.closures.push_back(closure);
    }
    std::vector<GiNaC::ex> used = residuals;
    const auto matrix = [&](const std::string& name, const derivatives::ExpressionMatrix& entries,
                            const std::vector<DerivedVariable>& columns) {
      for (const auto& row : entries) {
        used.insert(used.end(), row.begin(), row.end());
      }
      return DerivedMatrix{name, rows, names_of(columns), written(entries)};
    };
    result_.jacobian = matrix("J", derivatives.jacobian, result_.unknowns);
    result_.dimension_jacobian = matrix("F_d", derivatives.dimension_jacobian, result_.dimensions);
    result_.input_jacobian = matrix("F_u", derivatives.input_jacobian, result_.inputs);
    for (const auto* rhs : {&derivatives.velocity_rhs, &derivatives.acceleration_rhs}) {
      used.insert(used.end(), rhs->begin(), rhs->end());
    }
    result_.velocity_rhs = written(derivatives.velocity_rhs);
    result_.acceleration_rhs = written(derivatives.acceleration_rhs);
    result_.quantities = newly_used(equations_.vocabulary, used);
  }

  void gather_determinant(const pivoting::StructuredJacobian& structured) {
    const pivoting::FramedClosures& framed = structured.closures();
    DerivedDeterminant& result = result_.determinant.emplace();
    std::vector<GiNaC::ex> used;
    for (const equations::NamedQuantity& quantity : structured.vocabulary().quantities()) {
      write_.declare(quantity.symbol);
    }
    derivatives::ExpressionMatrix entries(framed.row_count());
    for (const equations::Variable& unknown : equations_.unknowns) {
      const std::vector<GiNaC::ex> column = framed.derivative(unknown);
      used.insert(used.end(), column.begin(), column.end());
      for (std::size_t row = 0; row < entries.size(); ++row) {
        entries[row].push_back(column[row]);
      }
    }
    result.framed = {"K", {}, names_of(result_.unknowns), written(entries)};
    for (std::size_t row = 0; row < framed.row_count(); ++row) {
      result.framed.rows.push_back(framed.row_name(row));
    }
    GiNaC::ex product = structured.sign();
    for (const pivoting::Pivot& pivot : structured.pivots()) {
      used.push_back(pivot.value);
      product *= pivot.value;
      result.pivots.push_back({write_(pivot.value), pivot.cause, pivot.degeneracy});
    }
    result.value = write_(product);
    result.text = structured.determinant_text();
    result.quantities = newly_used(structured.vocabulary(), used);
  }

  void gather_elimination() {
    const elimination::Elimination elimination = elimination::eliminate(equations_);
    const std::vector<equations::NamedQuantity>& names = elimination.vocabulary.quantities();
    DerivedElimination& result = result_.elimination.emplace();
    std::size_t known = 0;
    for (const elimination::RecordedStep& step : elimination.record) {
      result.steps.push_back({step.title, step.rule, step.formulas, {}, {}, {}});
      DerivedStep& text = result.steps.back();
      for (const equations::Variable* unknown : step.eliminated) {
        text.eliminated.push_back(unknown->name);
      }
      for (; known < step.vocabulary_size; ++known) {
        write_.declare(names[known].symbol);
        text.quantities.push_back({names[known].symbol.get_name(), write_(names[known].definition),
                                   names[known].meaning, false});
      }
      for (const elimination::RecordedQuantity& quantity : step.quantities) {
        write_.declare(quantity.symbol);
        text.quantities.push_back({quantity.symbol.get_name(), write_(quantity.value),
                                   quantity.meaning, quantity.vanishes});
      }
      for (const elimination::RecordedSeries& series : step.series) {
        text.series.push_back({series.name,
                               series.formula,
                               elimination.first->is_angle() ? "w" : elimination.first->name,
                               {}});
        for (const auto& [power, coefficient] : series.value.coefficients()) {
          text.series.back().terms.push_back(
              {power, write_(coefficient.re), write_(coefficient.im)});
        }
      }
    }
    for (const elimination::BackSubstitution& step : elimination.reduction.steps) {
      result.back_substitution.push_back({step.unknown->name, step.unknown->is_angle(),
                                          written(step.numerators), write_(step.denominator),
                                          step.degeneracy});
    }
    result.unknown = elimination.first->name;
    result.is_angle = elimination.first->is_angle();
    result.polynomial = elimination.polynomial_text;
    result.degree = elimination.degree;
    result.max_configurations = elimination.max_configurations;
  }

  void gather_forces(const derivatives::Derivatives& derivatives,
                     const pivoting::StructuredJacobian& structured) {
    const forces::GroupForces forces = forces::group_forces(equations_, derivatives, &structured);
    DerivedForces& result = result_.forces.emplace();
    std::vector<GiNaC::symbol> given;
    for (const forces::LinkLoad& load : forces.loads) {
      given.insert(given.end(), {load.x, load.y, load.moment});
      result.loads.add({load.x.get_name(), load.y.get_name(), load.moment.get_name()});
    }
    for (const GiNaC::symbol& symbol : given) {
      write_.declare(symbol);
    }
    for (const equations::NamedQuantity& quantity : forces.vocabulary.quantities()) {
      write_.declare(quantity.symbol);
    }
    std::vector<GiNaC::ex> multipliers;
    for (const equations::Vector2& force : forces.multipliers) {
      multipliers.insert(multipliers.end(), {force.x, force.y});
    }
    std::vector<GiNaC::ex> reactions;
    std::vector<GiNaC::ex> couples;
    for (const forces::JointReaction& joint : forces.joints) {
      reactions.insert(reactions.end(), {joint.force.x, joint.force.y});
      couples.push_back(joint.couple.value_or(0));
    }
    result.generalised = newly_used(forces.vocabulary, forces.generalised);
    result.multipliers = newly_used(forces.vocabulary, multipliers);
    result.reactions = newly_used(forces.vocabulary, reactions);
    result.couples = newly_used(forces.vocabulary, couples);
    for (std::size_t unknown = 0; unknown < forces.generalised.size(); ++unknown) {
      GiNaC::ex sum = forces.generalised[unknown];
      for (std::size_t row = 0; row < multipliers.size(); ++row) {
        sum += derivatives.jacobian[row][unknown] * multipliers[row];
      }
      result.equations.push_back(write_(sum));
    }
    gather_reactions(forces, result);
    count_operations(forces, given, result);
  }

  /// The reactions on the second links, and on the neighbours that hold the external joints.
  void gather_reactions(const forces::GroupForces& forces, DerivedForces& result) const {
    const structure::Group& group = *equations_.model->group;
    const auto reaction = [&](structure::JointIndex index, const std::string& on, int sign) {
      const forces::JointReaction& joint = forces.joints[index];
      return DerivedReaction{{group.joints()[index].name},
                             on,
                             {write_(sign * joint.force.x), write_(sign * joint.force.y)},
                             joint.couple ? write_(sign * *joint.couple) : ""};
    };
    for (const structure::JointIndex index : group.joints().keys()) {
      const structure::Joint& joint = group.joints()[index];
      const bool is_second = joint.second == structure::base_link;
      if (is_second || joint.first == structure::base_link) {
        result.neighbours.push_back(
            reaction(index, "neighbour at " + std::string(1, joint.name), is_second ? 1 : -1));
      }
      result.joints.push_back(reaction(index, is_second ? "base" : group.links()[joint.second], 1));
    }
  }

  void count_operations(const forces::GroupForces& forces, const std::vector<GiNaC::symbol>& given,
                        DerivedForces& result) const {
    const std::vector<equations::NamedQuantity>& quantities = forces.vocabulary.quantities();
    const program::SymbolOrder order =
        program::symbol_order(equations_, equations_.vocabulary, quantities, given);
    std::vector<program::Result> results;
    const auto add = [&](const GiNaC::ex& value) {
      results.push_back({program::entry("results", results.size()), value});
    };
    std::ranges::for_each(forces.generalised, add);
    result.of_loads = program::Program(order, quantities, results).count();
    for (const forces::JointReaction& joint : forces.joints) {
      add(joint.force.x);
      add(joint.force.y);
      add(joint.couple.value_or(0));
    }
    result.operations = program::Program(order, quantities, results).count();
  }

  [[nodiscard]] std::vector<std::string> written(const std::vector<GiNaC::ex>& list) const {
    std::vector<std::string> texts;
    texts.reserve(list.size());
    for (const GiNaC::ex& expression : list) {
      texts.push_back(write_(expression));
    }
    return texts;
  }
  [[nodiscard]] TextMatrix written(const derivatives::ExpressionMatrix& matrix) const {
    TextMatrix texts;
    for (const std::vector<GiNaC::ex>& row : matrix) {
      texts.push_back(written(row));
    }
    return texts;
  }

  [[nodiscard]] DerivedQuantity quantity_of(const equations::NamedQuantity& quantity) const {
    const std::string definition = write_(quantity.definition);
    const std::string name = quantity.symbol.get_name();
    return quantity.form == equations::NamedQuantity::Form::reciprocal
               ? DerivedQuantity{name, "1/" + bracketed(definition),
                                 "a zero divisor means " + quantity.meaning, false}
               : DerivedQuantity{name, definition, quantity.meaning, false};
  }

  /// The quantities that expressions need, in order of definition, except those shown before.
  std::vector<DerivedQuantity> newly_used(const equations::Vocabulary& vocabulary,
                                          const std::vector<GiNaC::ex>& used) {
    GiNaC::exset occurring;
    for (const GiNaC::ex& expression : used) {
      occurring.merge(equations::symbols_of(expression));
    }
    std::vector<DerivedQuantity> list;
    const std::vector<equations::NamedQuantity>& quantities = vocabulary.quantities();
    for (std::size_t at = quantities.size(); at-- > 0;) {
      const equations::NamedQuantity& quantity = quantities[at];
      if (occurring.contains(quantity.symbol) && given_.insert(quantity.symbol.get_name()).second) {
        occurring.merge(equations::symbols_of(quantity.definition));
        list.push_back(quantity_of(quantity));
      }
    }
    std::reverse(list.begin(), list.end());
    return list;
  }

  equations::ClosureEquations equations_;
  FormulaWriter write_;
  Derivation result_{};
  std::set<std::string> given_;
};

/// A product of the names of some angles, or of t of each.
std::string product_of(loops::AngleSet set, const std::vector<std::string>& names) {
  std::string product;
  for (std::size_t angle = 0; angle < names.size(); ++angle) {
    if (loops::holds(set, static_cast<std::ptrdiff_t>(angle))) {
      product += (product.empty() ? "t(" : "*t(") + names[angle] + ")";
    }
  }
  return product.empty() ? "1" : product;
}

/// The equation of a set of angles; `[e]` is the determinant of the column of e beside those that
/// are eliminated.
std::string equation_of(const loops::Elimination& by, loops::AngleSet set,
                        const std::vector<std::string>& names) {
  const std::string& hidden = names[static_cast<std::size_t>(by.hidden)];
  std::vector<std::string> terms;
  if (by.column_of(set) < by.size) {
    terms.push_back("([1] + [e(" + hidden + ")]*x + [t(" + hidden + ")]/x)*" +
                    product_of(set, names));
  }
  for (int angle = 0; angle < std::ssize(names); ++angle) {
    const loops::AngleSet other = set ^ loops::bit(angle);
    if (angle != by.ground && angle != by.hidden && by.column_of(other) < by.size) {
      terms.push_back(std::string("[") + (loops::holds(set, angle) ? "e(" : "t(") +
                      names[static_cast<std::size_t>(angle)] + ")]*" + product_of(other, names));
    }
  }
  return text::joined(terms, " + ") + " = 0";
}

}  // namespace

Derivation derive(const structure::Model& model, int configurations,
                  const std::vector<loops::Elimination>& eliminations) {
  Derivation result = DerivationGatherer(model, model.representative).run();
  result.rigid = true;
  result.rank = static_cast<unsigned>(result.unknowns.size());
  result.reason = "in general position it has " + std::to_string(configurations) +
                  " configurations in complex numbers, each by itself";
  std::vector<std::string> names = {"0"};
  for (const DerivedVariable& unknown : result.unknowns) {
    if (unknown.is_angle) {
      names.push_back(unknown.name);
    }
  }
  if (eliminations.empty()) {
    result.reason +=
        "; slides lie in more than two directions, so that no elimination leaves one "
        "unknown: they are continued from those of the same group with other numbers";
    return result;
  }
  const loops::Elimination& first = eliminations.front();
  const auto name_of = [&](int angle) {
    return angle == 0 || angle == loops::Elimination::none ? std::string("the base's")
                                                           : names[static_cast<std::size_t>(angle)];
  };
  DerivedEigenproblem& eigenproblem =
      result.eigenproblem.emplace(DerivedEigenproblem{configurations,
                                                      name_of(first.ground),
                                                      name_of(first.hidden),
                                                      static_cast<std::size_t>(first.size),
                                                      static_cast<std::size_t>(first.degree),
                                                      eliminations.size(),
                                                      {}});
  for (int row = 0; row < first.size; ++row) {
    eigenproblem.equations.push_back(equation_of(first, first.sets[row], names));
  }
  return result;
}

Derivation derive(const structure::Group& group, const structure::Kind& kind) {
  return DerivationGatherer(structure::model_of(group, kind), kind).run();
}

}  // namespace assur::generator::document
