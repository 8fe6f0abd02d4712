// Emits the header of a model, or of every model of every group.
#include <assur/text/error.hpp>
#include <assur/text/names.hpp>
#include <cctype>
#include <optional>

#include "derivatives/mobility.hpp"
#include "emission/model/closed_form.hpp"
#include "emission/model/emit.hpp"
#include "emission/model/force_function.hpp"
#include "emission/model/model_view.hpp"
#include "emission/model/rigid_functions.hpp"
#include "emission/model/shared_terms.hpp"
#include "emission/model/special_point_functions.hpp"

namespace assur::generator::emission::model {

namespace {

std::string padded(int number) { return (number < 10 ? "0" : "") + std::to_string(number); }
std::string struct_name(const structure::Model& model) { return "Model" + padded(model.number); }
std::string file_name(const structure::Model& model) {
  return "model_" + padded(model.number) + ".hpp";
}

std::string capitalised(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

cpp::View::List joint_list(const structure::Model& model) {
  cpp::View::List list;
  for (const structure::JointIndex index : model.group->joints().keys()) {
    const structure::Joint& joint = model.group->joints()[index];
    cpp::View entry;
    entry.set("name", std::string(1, joint.name));
    entry.set("first", joint.external() ? "base_link" : std::to_string(joint.first.place()));
    entry.set("second", std::to_string(joint.second.place()));
    entry.set("prismatic",
              cpp::boolean(model.representative[index] == structure::JointType::prismatic));
    list.push_back(entry);
  }
  return list;
}

cpp::View::List kind_list(const structure::Model& model) {
  cpp::View::List list;
  for (const structure::Relabelling& member : model.members) {
    cpp::View entry;
    entry.set("kind", structure::spell(*model.group, member.kind));
    entry.set("role_list", text::joined(member.role, ", ", [](structure::JointIndex joint) {
                return std::to_string(joint.place());
              }));
    list.push_back(entry);
  }
  return list;
}

/// ` --with jerk,rates`, the option of the command that reproduces the text.
std::string with_option(const std::set<std::string>& with) {
  return with.empty()
             ? ""
             : " --with " + text::joined(with, ",", [](const std::string& word) { return word; });
}

cpp::EmittedFile emit_model_list(const structure::Group& group, const std::set<std::string>& with) {
  cpp::View view;
  view.set("options", with_option(with));
  view.set("group", group.name());
  cpp::View::List models;
  bool first = true;
  for (const structure::Model& model : structure::models_of(group)) {
    cpp::View entry;
    entry.set("file", file_name(model));
    entry.set("struct", struct_name(model));
    entry.set("separator", first ? "" : ", ");
    models.push_back(entry);
    first = false;
  }
  view.set("models", models);
  return {std::filesystem::path("assur") / group.name() / "models.hpp",
          cpp::page("models.hpp", view)};
}

const SharedTerms sensitivity_terms = {
    "SensitivityTerms",
    "s",
    {"Terms that `sensitivities` and `sensitivities_and_motion` share."},
    {"sensitivities", "sensitivities_and_motion"}};

/// The header of a model, without the forces of a degenerate one.
struct ModelHeader {
  cpp::EmittedFile file;
  bool is_rigid;
};

ModelHeader header_of(const structure::Model& model, std::set<std::string> with) {
  const equations::ClosureEquations equations = equations::closure_equations(model);
  const derivatives::Derivatives derivatives = derivatives::differentiate(equations);
  const derivatives::Mobility mobility = derivatives::mobility_of(equations, derivatives.jacobian);
  if (!mobility.rigid) {
    with.erase("forces");
  }
  std::set<std::string> left_out;
  for (const auto& [word, names] : functions_on_request()) {
    if (!with.contains(word)) {
      left_out.insert(names.begin(), names.end());
    }
  }
  ModelSpelling spelling(equations.unknowns, equations.dimensions, equations.inputs);
  SpecialPointFunctions special_functions;
  special_points::SpecialPoints special{{}, false, "the group is no structure"};
  const bool shows_special_points = with.contains("special-points");
  if (mobility.rigid && shows_special_points) {
    special = special_points::special_points(equations, derivatives);
  }
  if (special.defined) {
    special_functions = special_point_functions(equations, special);
    for (const auto& [symbol, entry] : special_functions.symbols) {
      spelling.take_out(symbol, entry);
    }
  }

  std::optional<pivoting::StructuredJacobian> structured;
  std::optional<elimination::Elimination> elimination;
  RigidFunctions rigid;
  if (mobility.rigid) {
    structured.emplace(equations);
    elimination.emplace(elimination::eliminate(equations));
    rigid = rigid_functions(equations, *structured, *elimination);
  } else {
    rigid.known = known_quantities(equations, {&equations.vocabulary});
  }

  cpp::View view;
  cpp::View::List functions;
  const auto add_functions = [&](const std::vector<ModelFunction>& list,
                                 const equations::Vocabulary& vocabulary) {
    program::SymbolOrder order = program::symbol_order(equations, vocabulary, rigid.known);
    for (const auto& [symbol, entry] : special_functions.symbols) {
      order.declare(symbol);
    }
    for (const ModelFunction& function : list) {
      if (left_out.contains(function.name)) {
        continue;
      }
      const program::Program program(order, vocabulary.quantities(), function.results, rigid.known);
      functions.push_back(function_view(function, program, spelling));
      if (function.name == "position_polynomial") {
        show_closed_form(equations, *elimination, *structured, program, GroupRange(), view);
      }
    }
  };
  add_functions(model_functions(equations, derivatives), equations.vocabulary);
  add_functions(special_functions.functions, equations.vocabulary);

  view.set("dimensions_doc", "Link dimensions d.");
  view.set("inputs_doc", "Inputs u: where the base holds the external joints.");
  view.set("group", model.group->name());
  view.set("options", with_option(with));
  view.set("title", capitalised(model.title()));
  view.set("struct", struct_name(model));
  view.set("number", std::to_string(model.number));
  view.set("kinds", text::joined(model.members, ", ", [&](const structure::Relabelling& member) {
             return structure::spell(*model.group, member.kind);
           }));
  view.set("verdict", mobility.rigid ? "rigid"
                                     : "degenerate, mobility " + std::to_string(mobility.freedom) +
                                           " where it can be assembled");
  view.set("reason", mobility.reason);
  view.set("rigid", cpp::boolean(mobility.rigid));
  view.set("mobility", std::to_string(mobility.freedom));
  std::vector<std::string> closure = closure_lines(equations);
  view.set("frames", link_list(equations));
  view.set("special_points", cpp::line_list(special_point_lines(equations, special), ""));
  view.set("closure_link_list",
           text::joined(special_points::closure_links(*model.group), ", ",
                        [](structure::LinkIndex link) { return std::to_string(link.place()); }));
  view.set("shows_special_points", shows_special_points);
  view.set("has_special_points", cpp::boolean(special.defined));
  view.set("has_positions", mobility.rigid);
  if (mobility.rigid) {
    std::vector<NamingFunction> sharing;
    for (const NamingFunction& function : rigid.solutions) {
      if (sensitivity_terms.functions.contains(function.function.name)) {
        sharing.push_back(function);
      } else {
        add_functions({function.function}, function.vocabulary);
      }
    }
    const SharedTermsViews shared =
        shared_terms_views(sensitivity_terms, sharing,
                           program::symbol_order(equations, sharing.back().vocabulary, rigid.known),
                           rigid.known, spelling);
    functions.insert(functions.end(), shared.functions.begin(), shared.functions.end());
    view.set("shared_terms", cpp::View::List{shared.terms});
    add_functions(rigid.positions, elimination->vocabulary);
    if (with.contains("forces")) {
      const ForceFunction forces =
          force_function(forces::group_forces(equations, derivatives, &*structured));
      for (const auto& [symbol, entry] : forces.given) {
        spelling.take_out(symbol, entry);
      }
      const program::SymbolOrder order = forces.order(equations, rigid.known);
      const program::Program program(order, forces.naming.vocabulary.quantities(),
                                     forces.naming.function.results, rigid.known);
      functions.push_back(function_view(forces.naming.function, program, spelling));
    }
    show_solution(*structured, equations, *elimination, view);
    const std::vector<std::string> steps = elimination_steps(*elimination);
    closure.insert(closure.end(), steps.begin(), steps.end());
  }
  view.set("closure", cpp::line_list(closure, ""));
  view.set("functions", functions);
  const auto count = [&view](const std::string& name, std::size_t size) {
    view.set(name, std::to_string(size));
  };
  count("link_count", equations.poses.size());
  count("joint_count", model.group->joints().size());
  count("equation_count", 2 * equations.loops.size());
  count("compatibility_count", equations.compatibility.size());
  count("closure_link_count", special_points::closure_links(*model.group).size());
  count("kind_count", model.members.size());
  show_variables(equations.unknowns, "unknown", view, equations.owners);
  show_variables(equations.dimensions, "dimension", view);
  show_variables(equations.inputs, "input", view);
  view.set("joints", joint_list(model));
  view.set("kind_roles", kind_list(model));
  return {{std::filesystem::path("assur") / model.group->name() / file_name(model),
           cpp::page("model.hpp", view)},
          mobility.rigid};
}

}  // namespace

const std::map<std::string, std::set<std::string>>& functions_on_request() {
  static const std::map<std::string, std::set<std::string>> functions = {
      {"forces", {"forces"}},
      {"jerk", {"jerk_rhs"}},
      {"rates", {"velocity_rhs", "acceleration_rhs", "velocity"}},
      {"special-points",
       {"special_point_lines", "special_point_lengths", "special_point_velocities",
        "special_point_accelerations"}}};
  return functions;
}

cpp::EmittedFile emit_model(const structure::Model& model, const std::set<std::string>& with) {
  ModelHeader header = header_of(model, with);
  if (with.contains("forces") && !header.is_rigid) {
    throw text::InputError("--with forces: " + model.title() +
                           " is degenerate, so that the equilibrium of its links determines no "
                           "forces; leave it out, or give a rigid model");
  }
  return std::move(header.file);
}

std::vector<cpp::EmittedFile> emit_all(const std::set<std::string>& with,
                                       const text::Progress& progress) {
  std::uint64_t count = 0;
  for (const structure::Group& group : structure::known_groups()) {
    count += structure::models_of(group).size();
  }
  std::vector<cpp::EmittedFile> files;
  std::uint64_t done = 0;
  for (const structure::Group& group : structure::known_groups()) {
    for (const structure::Model& model : structure::models_of(group)) {
      files.push_back(header_of(model, with).file);
      if (progress) {
        progress(++done, count);
      }
    }
    files.push_back(emit_model_list(group, with));
  }
  return files;
}

}  // namespace assur::generator::emission::model
