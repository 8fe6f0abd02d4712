#include "emission/closures/emit_closures.hpp"

#include <algorithm>
#include <assur/text/counts.hpp>
#include <assur/text/error.hpp>
#include <assur/text/identifiers.hpp>

#include "closures/implicit_form.hpp"
#include "derivatives/differentiate.hpp"
#include "derivatives/generic_rank.hpp"
#include "emission/model/model_view.hpp"

namespace assur::generator::emission::closures {

namespace {

/// Identifiers of the template that no type and no member of the user's may hide ...
const std::vector<std::string> types = {"Scalar",     "Dimensions", "Inputs", "Configuration",
                                        "Direction",  "Vector",     "Matrix", "ModelVariable",
                                        "SolvedByLu", "members",    "std",    "support"};
/// ... and identifiers that no local variable of a function may hide.
const std::vector<std::string> names_in_functions = {"q",
                                                     "d",
                                                     "u",
                                                     "f",
                                                     "J",
                                                     "F_d",
                                                     "F_u",
                                                     "rhs",
                                                     "q_rate",
                                                     "q_second_rate",
                                                     "u_rate",
                                                     "u_second_rate",
                                                     "u_third_rate",
                                                     "d_rate",
                                                     "abs",
                                                     "sqrt",
                                                     "constant",
                                                     "rigid",
                                                     "equation_count",
                                                     "unknown_count",
                                                     "dimension_count",
                                                     "input_count",
                                                     "unknowns",
                                                     "dimensions",
                                                     "inputs",
                                                     "pivot_count",
                                                     "core_pivot_count",
                                                     "pivots"};

equations::ImplicitEquations equations_of(const generator::closures::TypedClosures& closures) {
  try {
    return generator::closures::implicit_form(closures.system, types, names_in_functions);
  } catch (const generator::closures::NotAlgebraic& error) {
    throw text::InputError(closures.file + ": " + error.what());
  }
}

}  // namespace

cpp::EmittedFile emit_closures(const generator::closures::TypedClosures& closures) {
  const equations::ImplicitEquations equations = equations_of(closures);
  const derivatives::ResidualDerivatives derivatives =
      derivatives::differentiate_residuals(equations);
  const model::ModelSpelling spelling(equations.unknowns, equations.dimensions, equations.inputs);
  const program::SymbolOrder order = program::symbol_order(equations, equations.vocabulary);
  const std::filesystem::path file = std::filesystem::path(closures.file).filename();

  cpp::View view;
  cpp::View::List functions;
  bool has_roots = false;
  for (const model::ModelFunction& function : model::residual_functions(equations, derivatives)) {
    const program::Program program(order, equations.vocabulary.quantities(), function.results);
    has_roots = has_roots || std::ranges::any_of(program.steps(), [](const auto& step) {
                  return step.form == equations::NamedQuantity::Form::square_root &&
                         !step.degeneracy.empty();
                });
    functions.push_back(
        model::function_view(function, program, spelling, model::ZeroResults::assigned));
  }
  std::vector<std::string> lines;
  for (const std::string& line : closures.lines) {
    lines.push_back(cpp::comment_text(line));
  }
  view.set("functions", functions);
  view.set("has_roots", has_roots);
  view.set("file", cpp::comment_text(file.string()));
  view.set("source", closures.source.empty() ? "" : ": " + cpp::comment_text(closures.source));
  view.set("lines", cpp::line_list(lines, ""));
  view.set("struct",
           text::member_names({text::struct_name(file.stem().string(), "Closures")}, types)[0]);
  view.set("dimensions_doc", "Dimensions d: the parameters that are held.");
  view.set("inputs_doc", "Inputs u: the parameters that move.");
  view.set("equation_count", std::to_string(equations.residuals.size()));
  view.set("rigid", cpp::boolean(equations.residuals.size() == equations.unknowns.size() &&
                                 derivatives::generic_rank(equations, derivatives.jacobian) ==
                                     equations.unknowns.size()));
  model::show_variables(equations.unknowns, "unknown", view);
  model::show_variables(equations.dimensions, "dimension", view);
  model::show_variables(equations.inputs, "input", view);
  return {std::filesystem::path("assur") / "closures" /
              (text::header_name(file.stem().string()) + ".hpp"),
          cpp::page("closures.hpp", view)};
}

std::vector<std::string> closure_warnings(const generator::closures::TypedClosures& closures) {
  const equations::ImplicitEquations equations = equations_of(closures);
  const std::size_t unknowns = equations.unknowns.size();
  const std::size_t count = equations.residuals.size();
  const std::size_t rank =
      derivatives::generic_rank(equations, derivatives::closure_jacobian(equations));
  if (rank == unknowns) {
    return {};
  }
  const std::string lost = "; no rates and no sensitivities can be solved for";
  if (count < unknowns) {
    return {text::with_noun(count, "closure") + (count == 1 ? " does" : " do") + " not determine " +
            text::with_noun(unknowns, "unknown") + lost};
  }
  return {"the Jacobian is singular everywhere: its rank is " + std::to_string(rank) + ", and " +
          text::with_noun(unknowns, "unknown") + (unknowns == 1 ? " needs " : " need ") +
          std::to_string(unknowns) + lost};
}

}  // namespace assur::generator::emission::closures
