#include "emission/emit_closures.hpp"

#include "closures/implicit_form.hpp"
#include "derivatives/differentiate.hpp"
#include "emission/model_view.hpp"
#include "emission/scene_names.hpp"
#include "emission/templates.hpp"
#include "error.hpp"

namespace assur::generator {

namespace {

namespace mustache = kainjow::mustache;

/// The words of the template that no type and no member of the user's may hide ...
const std::vector<std::string> types = {"Scalar",     "Dimensions", "Inputs", "Configuration",
                                        "Direction",  "Vector",     "Matrix", "ModelVariable",
                                        "SolvedByLu", "members",    "std"};
/// ... and those that no local variable of a function may hide.
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

ImplicitEquations equations_of(const TypedClosures& closures) {
  try {
    return implicit_form(closures.system, types, names_in_functions);
  } catch (const NotAlgebraic& error) {
    throw InputError(closures.file + ": " + error.what());
  }
}

}  // namespace

EmittedFile emit_closures(const TypedClosures& closures) {
  const ImplicitEquations equations = equations_of(closures);
  const ResidualDerivatives derivatives = differentiate_residuals(equations);
  const ModelSpelling spelling(equations.unknowns, equations.dimensions, equations.inputs);
  const SymbolOrder order = symbol_order(equations, equations.vocabulary);
  const std::filesystem::path file = std::filesystem::path(closures.file).filename();

  mustache::data view;
  mustache::data functions{mustache::data::type::list};
  bool has_roots = false;
  for (const ModelFunction& function : residual_functions(equations, derivatives)) {
    const Program program(order, equations.vocabulary.quantities(), function.results);
    has_roots = has_roots || program.count().square_roots > 0;
    functions << function_view(function, program, spelling, ZeroResults::assigned);
  }
  std::vector<std::string> lines;
  for (const std::string& line : closures.lines) {
    lines.push_back(comment_text(line));
  }
  show_partials(view);
  view.set("functions", functions);
  view.set("has_roots", has_roots);
  view.set("file", comment_text(file.string()));
  view.set("source", closures.source.empty() ? "" : ": " + comment_text(closures.source));
  view.set("lines", line_list(lines, ""));
  view.set("struct", member_names({struct_name(file.stem().string(), "Closures")}, types)[0]);
  view.set("dimensions_doc", "Dimensions d: the parameters that are held.");
  view.set("inputs_doc", "Inputs u: the parameters that move.");
  view.set("equation_count", std::to_string(equations.residuals.size()));
  view.set("rigid", boolean(equations.residuals.size() == equations.unknowns.size()));
  show_variables(equations.unknowns, "unknown", view);
  show_variables(equations.dimensions, "dimension", view);
  show_variables(equations.inputs, "input", view);
  return {
      std::filesystem::path("assur") / "closures" / (c_identifier(file.stem().string()) + ".hpp"),
      rendered(without_tag_lines(templates::closures_hpp), view)};
}

}  // namespace assur::generator
