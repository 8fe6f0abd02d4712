#include "emission/model/shared_terms.hpp"

#include <algorithm>
#include <assur/text/names.hpp>
#include <iterator>
#include <set>

#include "emission/cpp/cpp_text.hpp"

namespace assur::generator::emission::model {

namespace {

/// The indentation of the body of a member function of a member struct.
constexpr std::size_t inner_indentation = cpp::body_indentation + 2;

program::Program part_of(const program::Program& whole, const ModelFunction& function) {
  std::set<program::Place> targets;
  for (const program::Result& result : function.results) {
    targets.insert(result.target);
  }
  return whole.part(targets);
}

/// The outputs of a function to which a program assigns.
std::vector<Parameter> assigned(const ModelFunction& function, const program::Program& program) {
  std::vector<Parameter> outputs;
  std::copy_if(function.outputs.begin(), function.outputs.end(), std::back_inserter(outputs),
               [&](const Parameter& output) {
                 return std::any_of(program.assignments().begin(), program.assignments().end(),
                                    [&](const program::Program::Assignment& assignment) {
                                      return assignment.target.argument == output.name;
                                    });
               });
  return outputs;
}

cpp::View terms_view(const SharedTerms& terms, const ModelFunction& function,
                     const program::Program& common, const std::vector<Parameter>& outputs,
                     const ModelSpelling& spelling) {
  const auto spell = [&](const std::string& name) { return spelling.spell(name); };
  cpp::FilledLines members;
  cpp::add_steps(common, spell, members);
  cpp::FilledLines assignments(inner_indentation);
  for (const Parameter& output : outputs) {
    if (is_cleared(function, output)) {
      assignments.add(output.name + ".setZero();");
    }
  }
  cpp::add_assignments(common, spell, assignments);
  cpp::View view;
  view.set("name", terms.name);
  view.set("doc", cpp::line_list(terms.doc));
  view.set("members", cpp::line_list(members.lines(), std::string(cpp::body_indentation, ' ')));
  view.set("outputs", text::joined(outputs, ", ", [](const Parameter& output) {
             return output.type + " " + output.name;
           }));
  view.set("assignments", cpp::line_list(assignments.lines(), std::string(inner_indentation, ' ')));
  return view;
}

}  // namespace

SharedTermsViews shared_terms_views(const SharedTerms& terms,
                                    const std::vector<NamingFunction>& functions,
                                    const program::SymbolOrder& order,
                                    const std::vector<equations::NamedQuantity>& known,
                                    const ModelSpelling& spelling) {
  const program::Program whole(order, functions.back().vocabulary.quantities(),
                               functions.back().function.results, known);
  program::Program common = whole;
  for (const NamingFunction& function : functions) {
    common = common.common(part_of(whole, function.function));
  }
  const std::vector<Parameter> outputs = assigned(functions.front().function, common);
  SharedTermsViews views;
  views.terms = terms_view(terms, functions.front().function, common, outputs, spelling);

  const FirstStatements first = {
      {"const " + terms.name + "<Scalar> " + terms.variable + "{d, u, q};",
       terms.variable + ".put(" +
           text::joined(outputs, ", ", [](const Parameter& output) { return output.name; }) + ");"},
      {"d", "u", "q"}};
  ModelSpelling by_member = spelling;
  for (const program::Program::Step& step : common.steps()) {
    by_member.put_in(step.name, {terms.variable, "." + step.name});
  }
  for (const NamingFunction& entry : functions) {
    const program::Program part = part_of(whole, entry.function);
    ModelFunction rest = entry.function;
    std::erase_if(rest.results, [&](const program::Result& result) {
      return std::any_of(outputs.begin(), outputs.end(), [&](const Parameter& output) {
        return result.target.argument == output.name;
      });
    });
    cpp::View& view = views.functions.emplace_back(
        function_view(rest, part.without(common), by_member, ZeroResults::left_out, first));
    show_operations(entry.function.name, part.count(), view);
  }
  return views;
}

}  // namespace assur::generator::emission::model
