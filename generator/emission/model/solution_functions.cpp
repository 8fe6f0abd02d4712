#include "emission/model/solution_functions.hpp"

#include <utility>

namespace assur::generator::emission::model {

namespace {

using Rows = std::vector<GiNaC::ex>;

std::string letters_of(const equations::Variable& variable) {
  const std::string prefix = "theta_";
  return variable.name.starts_with(prefix) ? variable.name.substr(prefix.size()) : variable.name;
}

GiNaC::symbol symbol(const std::string& name) { return GiNaC::symbol(name); }

/// Inputs that move the closures in one direction, such as x_B and, with opposite sense, x_E.
struct InputDirection {
  const equations::Variable* variable;                             ///< the first of them
  std::vector<std::pair<const equations::Variable*, int>> inputs;  ///< with their senses
  Rows column;                                                     ///< d(closures)/d(variable)
};

/// Builds the functions of one model; each function names its own quantities after the common ones.
class SolutionFunctions {
 public:
  explicit SolutionFunctions(const pivoting::StructuredJacobian& jacobian)
      : jacobian_(jacobian),
        closures_(jacobian.closures()),
        equations_(closures_.equations()),
        gain_names_(jacobian.vocabulary()) {
    find_gains();
    find_input_directions();
  }

  [[nodiscard]] std::vector<NamingFunction> run() const {
    return {degeneracies(),  inverse_jacobian(), sensitivities(),
            velocity(false), velocity(true),     everything()};
  }

 private:
  /// The inverse of the framed Jacobian, with a name for each entry.
  void find_gains() {
    for (std::size_t row = 0; row < closures_.row_count(); ++row) {
      Rows unit(closures_.row_count());
      unit[row] = 1;
      std::vector<GiNaC::symbol> symbols;
      for (const equations::Variable& unknown : equations_.unknowns) {
        symbols.push_back(symbol(letters_of(unknown) + "_per_" + closures_.row_name(row)));
      }
      gains_.push_back(jacobian_.solve(unit, symbols, "entry of the inverse", gain_names_));
    }
  }

  void find_input_directions() {
    for (const equations::Variable& input : equations_.inputs) {
      const Rows column = closures_.derivative(input);
      int sense = 0;
      for (InputDirection& known : input_directions_) {
        for (const int candidate : {1, -1}) {
          bool same = true;
          for (std::size_t row = 0; row < column.size(); ++row) {
            same = same && (column[row] - candidate * known.column[row]).expand().is_zero();
          }
          if (same && sense == 0) {
            sense = candidate;
            known.inputs.emplace_back(&input, sense);
          }
        }
      }
      if (sense == 0) {
        input_directions_.push_back({&input, {{&input, 1}}, column});
      }
    }
  }

  /// One unknown of the solution for a right-hand side in the frames of the loops.
  [[nodiscard]] GiNaC::ex gained(std::size_t unknown, const Rows& rhs) const {
    GiNaC::ex sum;
    for (std::size_t row = 0; row < rhs.size(); ++row) {
      sum += gains_[row][unknown] * rhs[row];
    }
    return sum.expand();
  }

  [[nodiscard]] Rows input_terms(GiNaC::symbol equations::Variable::*rate) const {
    Rows rows(closures_.row_count());
    for (const InputDirection& direction : input_directions_) {
      for (std::size_t row = 0; row < rows.size(); ++row) {
        for (const auto& [input, sense] : direction.inputs) {
          rows[row] += sense * direction.column[row] * (input->*rate);
        }
      }
    }
    return rows;
  }

  [[nodiscard]] Rows named_rhs(const Rows& rows, const std::string& prefix,
                               equations::Vocabulary& names) const {
    Rows rhs;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const GiNaC::symbol name(prefix + closures_.row_name(row));
      const GiNaC::ex value = (-rows[row]).expand();
      if (value.is_zero()) {
        rhs.emplace_back(0);
        continue;
      }
      names.define(name, value, "right-hand side");
      rhs.emplace_back(name);
    }
    return rhs;
  }

  [[nodiscard]] std::vector<GiNaC::symbol> rates(GiNaC::symbol equations::Variable::*rate) const {
    std::vector<GiNaC::symbol> symbols;
    for (const equations::Variable& unknown : equations_.unknowns) {
      symbols.push_back(unknown.*rate);
    }
    return symbols;
  }

  [[nodiscard]] static std::vector<Parameter> parameters(std::vector<Parameter> more) {
    more.insert(more.begin(), {{"const Dimensions<Scalar>&", "d"},
                               {"const Inputs<Scalar>&", "u"},
                               {"const Configuration<Scalar>&", "q"}});
    return more;
  }

  [[nodiscard]] NamingFunction degeneracies() const {
    NamingFunction result{
        {"degeneracies",
         {"The divisors p of the elimination, pivots of the core first; the size that "
          "each could",
          "have in these loops; and the size of the terms of the determinant of the "
          "core.",
          "det J = " + jacobian_.determinant_text()},
         parameters({}),
         {{"Vector<Scalar, pivot_count>&", "p"},
          {"Vector<Scalar, pivot_count>&", "size"},
          {"Scalar&", "terms"}},
         {}},
        jacobian_.vocabulary()};
    std::vector<program::Result>& results = result.function.results;
    for (std::size_t index = 0; index < jacobian_.pivots().size(); ++index) {
      results.push_back({program::entry("p", index), jacobian_.pivots()[index].value});
    }
    for (std::size_t index = 0; index < jacobian_.pivots().size(); ++index) {
      results.push_back({program::entry("size", index), jacobian_.pivots()[index].bound});
    }
    results.push_back({{"terms"}, jacobian_.core_terms()});
    return result;
  }

  [[nodiscard]] NamingFunction inverse_jacobian() const {
    NamingFunction result{{"inverse_jacobian",
                           {"The inverse of J, for right-hand sides of every sort."},
                           parameters({}),
                           {{"Matrix<Scalar, unknown_count, equation_count>&", "J_inverse"}},
                           {}},
                          gain_names_};
    for (std::size_t unknown = 0; unknown < equations_.unknowns.size(); ++unknown) {
      for (std::size_t loop = 0; loop < equations_.loops.size(); ++loop) {
        const equations::Vector2& frame = closures_.frame_direction(loop);
        const GiNaC::ex& along = gains_[2 * loop][unknown];
        const GiNaC::ex& across = gains_[2 * loop + 1][unknown];
        result.function.results.push_back(
            {program::entry("J_inverse", unknown, 2 * loop), along * frame.x - across * frame.y});
        result.function.results.push_back({program::entry("J_inverse", unknown, 2 * loop + 1),
                                           along * frame.y + across * frame.x});
      }
    }
    return result;
  }

  void add_sensitivities(std::vector<program::Result>& results) const {
    const auto add = [&](const std::deque<equations::Variable>& variables,
                         const std::string& target) {
      for (std::size_t unknown = 0; unknown < equations_.unknowns.size(); ++unknown) {
        for (std::size_t index = 0; index < variables.size(); ++index) {
          results.push_back({program::entry(target, unknown, index),
                             -gained(unknown, closures_.derivative(variables[index]))});
        }
      }
    };
    add(equations_.dimensions, "S_d");
    add(equations_.inputs, "S_u");
  }

  [[nodiscard]] static std::vector<Parameter> sensitivity_outputs() {
    return {{"Matrix<Scalar, unknown_count, dimension_count>&", "S_d"},
            {"Matrix<Scalar, unknown_count, input_count>&", "S_u"}};
  }

  [[nodiscard]] NamingFunction sensitivities() const {
    NamingFunction result{{"sensitivities",
                           {"S_d = dq/dd and S_u = dq/du of an assembled configuration."},
                           parameters({}),
                           sensitivity_outputs(),
                           {}},
                          gain_names_};
    add_sensitivities(result.function.results);
    return result;
  }

  static void add_rates(std::vector<program::Result>& results, const std::string& target,
                        const Rows& values) {
    for (std::size_t unknown = 0; unknown < values.size(); ++unknown) {
      results.push_back({program::entry(target, unknown), values[unknown]});
    }
  }

  /// Velocity only, or velocity and acceleration, by substitution.
  [[nodiscard]] NamingFunction velocity(bool and_acceleration) const {
    NamingFunction result{
        {and_acceleration ? "motion" : "velocity",
         {and_acceleration ? "dq/dt and d2q/dt2 for the first and second rates of the inputs."
                           : "dq/dt for the rates du/dt of the inputs."},
         parameters({{"const Vector<Scalar, input_count>&", "u_rate"}}),
         {{"Vector<Scalar, unknown_count>&", "q_rate"}},
         {}},
        jacobian_.vocabulary()};
    ModelFunction& function = result.function;
    const Rows rates_1 = jacobian_.solve(
        named_rhs(input_terms(&equations::Variable::rate), "velocity_", result.vocabulary),
        rates(&equations::Variable::rate), "first rate", result.vocabulary);
    add_rates(function.results, "q_rate", rates_1);
    if (and_acceleration) {
      function.inputs.push_back({"const Vector<Scalar, input_count>&", "u_second_rate"});
      function.outputs.push_back({"Vector<Scalar, unknown_count>&", "q_second_rate"});
      Rows rows = closures_.quadratic_rates();
      const Rows inputs = input_terms(&equations::Variable::second_rate);
      for (std::size_t row = 0; row < rows.size(); ++row) {
        rows[row] += inputs[row];
      }
      const Rows rates_2 = jacobian_.solve(named_rhs(rows, "acceleration_", result.vocabulary),
                                           rates(&equations::Variable::second_rate), "second rate",
                                           result.vocabulary);
      add_rates(function.results, "q_second_rate", rates_2);
    }
    return result;
  }

  /// The part of an unknown's rate that is due to the inputs' rates, by the sensitivities to them.
  [[nodiscard]] GiNaC::ex followed(std::size_t unknown, GiNaC::symbol equations::Variable::*rate,
                                   const std::vector<Rows>& sensitivities) const {
    GiNaC::ex sum;
    for (std::size_t index = 0; index < input_directions_.size(); ++index) {
      for (const auto& [input, sense] : input_directions_[index].inputs) {
        sum += sense * sensitivities[index][unknown] * (input->*rate);
      }
    }
    return sum.expand();
  }

  [[nodiscard]] NamingFunction everything() const {
    NamingFunction result{
        {"sensitivities_and_motion",
         {"All of the above at once: S_d = dq/dd, S_u = dq/du, dq/dt and d2q/dt2."},
         parameters({{"const Vector<Scalar, input_count>&", "u_rate"},
                     {"const Vector<Scalar, input_count>&", "u_second_rate"}}),
         sensitivity_outputs(),
         {}},
        gain_names_};
    ModelFunction& function = result.function;
    equations::Vocabulary& names = result.vocabulary;
    function.outputs.push_back({"Vector<Scalar, unknown_count>&", "q_rate"});
    function.outputs.push_back({"Vector<Scalar, unknown_count>&", "q_second_rate"});
    add_sensitivities(function.results);

    std::vector<Rows> sensitivities;
    for (const InputDirection& direction : input_directions_) {
      Rows& values = sensitivities.emplace_back();
      for (std::size_t unknown = 0; unknown < equations_.unknowns.size(); ++unknown) {
        const GiNaC::symbol name(letters_of(equations_.unknowns[unknown]) + "_per_" +
                                 direction.variable->name);
        names.define(name, -gained(unknown, direction.column), "sensitivity");
        values.emplace_back(name);
      }
    }
    Rows rates_1;
    Rows rates_2;
    for (std::size_t unknown = 0; unknown < equations_.unknowns.size(); ++unknown) {
      const GiNaC::symbol& rate = equations_.unknowns[unknown].rate;
      names.define(rate, followed(unknown, &equations::Variable::rate, sensitivities),
                   "first rate");
      rates_1.emplace_back(rate);
    }
    const Rows rhs = named_rhs(closures_.quadratic_rates(), "centripetal_", names);
    for (std::size_t unknown = 0; unknown < equations_.unknowns.size(); ++unknown) {
      rates_2.push_back(gained(unknown, rhs) +
                        followed(unknown, &equations::Variable::second_rate, sensitivities));
    }
    add_rates(function.results, "q_rate", rates_1);
    add_rates(function.results, "q_second_rate", rates_2);
    return result;
  }

  const pivoting::StructuredJacobian& jacobian_;
  const pivoting::FramedClosures& closures_;
  const equations::ClosureEquations& equations_;
  equations::Vocabulary gain_names_;
  std::vector<Rows> gains_;  ///< [row][unknown]
  std::vector<InputDirection> input_directions_;
};

}  // namespace

std::vector<NamingFunction> solution_functions(const pivoting::StructuredJacobian& jacobian) {
  return SolutionFunctions(jacobian).run();
}

}  // namespace assur::generator::emission::model
