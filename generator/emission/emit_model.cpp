#include <cctype>

#include "derivatives/mobility.hpp"
#include "emission/emit.hpp"
#include "emission/model_view.hpp"
#include "emission/solution_functions.hpp"
#include "emission/special_point_functions.hpp"
#include "emission/templates.hpp"

namespace assur::generator {

namespace {

namespace mustache = kainjow::mustache;

std::string padded(int number) { return (number < 10 ? "0" : "") + std::to_string(number); }
std::string struct_name(const Model& model) { return "Model" + padded(model.number); }
std::string file_name(const Model& model) { return "model_" + padded(model.number) + ".hpp"; }

std::string capitalised(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

mustache::data joint_list(const Model& model) {
  mustache::data list{mustache::data::type::list};
  for (int index = 0; index < model.group->joint_count(); ++index) {
    const auto slot = static_cast<std::size_t>(index);
    const Joint& joint = model.group->joints()[slot];
    mustache::data entry;
    entry.set("name", std::string(1, joint.name));
    entry.set("first", joint.external() ? std::string("base_link") : std::to_string(joint.first));
    entry.set("second", std::to_string(joint.second));
    entry.set("prismatic", boolean(model.representative[slot] == JointType::prismatic));
    list << entry;
  }
  return list;
}

mustache::data kind_list(const Model& model) {
  mustache::data list{mustache::data::type::list};
  for (const Relabelling& member : model.members) {
    mustache::data entry;
    entry.set("kind", spell(*model.group, member.kind));
    entry.set("role_list",
              joined(member.role, ", ", [](int joint) { return std::to_string(joint); }));
    list << entry;
  }
  return list;
}

EmittedFile emit_model_list(const Group& group) {
  mustache::data view;
  view.set("group", group.name());
  mustache::data models{mustache::data::type::list};
  bool first = true;
  for (const Model& model : models_of(group)) {
    mustache::data entry;
    entry.set("file", file_name(model));
    entry.set("struct", struct_name(model));
    entry.set("separator", first ? "" : ", ");
    models << entry;
    first = false;
  }
  view.set("models", models);
  return {std::filesystem::path("assur") / group.name() / "models.hpp",
          rendered(templates::models_hpp, view)};
}

}  // namespace

EmittedFile emit_model(const Model& model) {
  const ClosureEquations equations = closure_equations(model);
  const Derivatives derivatives = differentiate(equations);
  const Mobility mobility = mobility_of(equations, derivatives.jacobian);
  ModelSpelling spelling(equations.unknowns, equations.dimensions, equations.inputs);
  SpecialPointFunctions special_functions;
  SpecialPoints special{{}, false, "the group is no structure"};
  if (mobility.rigid) {
    special = special_points(equations, derivatives);
  }
  if (special.defined) {
    special_functions = special_point_functions(equations, special);
    for (const auto& [symbol, entry] : special_functions.symbols) {
      spelling.take_out(symbol, entry);
    }
  }

  mustache::data functions{mustache::data::type::list};
  const auto add_functions = [&](const std::vector<ModelFunction>& list,
                                 const Vocabulary& vocabulary) {
    SymbolOrder order = symbol_order(equations, vocabulary);
    for (const auto& [symbol, entry] : special_functions.symbols) {
      order.declare(symbol);
    }
    for (const ModelFunction& function : list) {
      const Program program(order, vocabulary.quantities(), function.results);
      functions << function_view(function, program, spelling);
    }
  };
  add_functions(model_functions(equations, derivatives), equations.vocabulary);
  add_functions(special_functions.functions, equations.vocabulary);

  mustache::data view;
  view.set("general", true);
  show_partials(view);
  view.set("dimensions_doc", "Link dimensions d.");
  view.set("inputs_doc", "Inputs u: where the base holds the external joints.");
  view.set("group", model.group->name());
  view.set("title", capitalised(model.title()));
  view.set("struct", struct_name(model));
  view.set("number", std::to_string(model.number));
  view.set("kinds", joined(model.members, ", ", [&](const Relabelling& member) {
             return spell(*model.group, member.kind);
           }));
  view.set("verdict", mobility.rigid ? "rigid"
                                     : "degenerate, mobility " + std::to_string(mobility.freedom) +
                                           " where it can be assembled");
  view.set("reason", mobility.reason);
  view.set("rigid", boolean(mobility.rigid));
  view.set("mobility", std::to_string(mobility.freedom));
  std::vector<std::string> closure = closure_lines(equations);
  view.set("frames", link_list(equations));
  view.set("special_points", line_list(special_point_lines(equations, special), ""));
  view.set("closure_link_list", joined(closure_links(*model.group), ", ",
                                       [](int link) { return std::to_string(link); }));
  view.set("has_special_points", boolean(special.defined));
  view.set("has_positions", mobility.rigid);
  if (mobility.rigid) {
    const StructuredJacobian structured(equations);
    for (const NamingFunction& naming : solution_functions(structured)) {
      add_functions({naming.function}, naming.vocabulary);
    }
    Elimination elimination = eliminate(equations);
    const std::vector<ModelFunction> list = position_functions(equations, elimination);
    add_functions(list, elimination.vocabulary);
    show_solution(structured, equations, elimination, view);
    const std::vector<std::string> steps = elimination_steps(elimination);
    closure.insert(closure.end(), steps.begin(), steps.end());
  }
  view.set("closure", line_list(closure, ""));
  view.set("functions", functions);
  const auto count = [&view](const std::string& name, std::size_t size) {
    view.set(name, std::to_string(size));
  };
  count("link_count", equations.poses.size());
  count("joint_count", model.group->joints().size());
  count("equation_count", 2 * equations.loops.size());
  count("compatibility_count", equations.compatibility.size());
  count("closure_link_count", closure_links(*model.group).size());
  count("kind_count", model.members.size());
  show_variables(equations.unknowns, "unknown", view, equations.owners);
  show_variables(equations.dimensions, "dimension", view);
  show_variables(equations.inputs, "input", view);
  view.set("joints", joint_list(model));
  view.set("kind_roles", kind_list(model));
  return {std::filesystem::path("assur") / model.group->name() / file_name(model),
          rendered(without_tag_lines(templates::model_hpp), view)};
}

std::vector<EmittedFile> emit_all() {
  std::vector<EmittedFile> files;
  for (const Group& group : known_groups()) {
    for (const Model& model : models_of(group)) {
      files.push_back(emit_model(model));
    }
    files.push_back(emit_model_list(group));
  }
  return files;
}

}  // namespace assur::generator
