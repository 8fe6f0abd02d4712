#include <algorithm>
#include <cstdio>
#include <kainjow/mustache.hpp>
#include <map>
#include <set>
#include <sstream>

#include "derivatives/mobility.hpp"
#include "emission/cpp_text.hpp"
#include "emission/emit.hpp"
#include "emission/model_functions.hpp"
#include "emission/solution_functions.hpp"
#include "emission/special_point_functions.hpp"
#include "emission/templates.hpp"
#include "error.hpp"

namespace assur::generator {

namespace {

namespace mustache = kainjow::mustache;

std::string padded(int number) { return (number < 10 ? "0" : "") + std::to_string(number); }
std::string struct_name(const Model& model) { return "Model" + padded(model.number); }
std::string file_name(const Model& model) { return "model_" + padded(model.number) + ".hpp"; }
std::string boolean(bool value) { return value ? "true" : "false"; }

template <typename Items, typename Text>
std::string joined(const Items& items, const std::string& separator, Text text) {
  std::string result;
  for (const auto& item : items) {
    result += (result.empty() ? "" : separator) + text(item);
  }
  return result;
}

std::string capitalised(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string rendered(const char* text, const mustache::data& view) {
  mustache::mustache page{text};
  page.set_custom_escape([](const std::string& raw) { return raw; });
  if (!page.is_valid()) {
    throw GeneratorError("emission", "template", page.error_message());
  }
  return fitted_to_width(page.render(view));
}

/// C++ spellings of the symbols that a model's programs read. Rates keep their own names: the
/// function's first lines take them out of the vectors.
class ModelSpelling {
 public:
  explicit ModelSpelling(const ClosureEquations& equations) {
    add(equations.unknowns, "q");
    add(equations.dimensions, "d");
    add(equations.inputs, "u");
  }

  /// A symbol that is an entry of a parameter and is taken out of it, as rates are.
  void take_out(const GiNaC::symbol& symbol, const std::string& entry) {
    rates_[symbol.get_name()] = entry;
  }

  [[nodiscard]] std::string spell(const std::string& symbol) const {
    const auto found = members_.find(symbol);
    return found == members_.end() ? symbol : found->second;
  }
  /// `const Scalar omega_BCG = q_rate(0);`, or nothing for a symbol that is no entry.
  [[nodiscard]] std::string taken_out(const std::string& symbol) const {
    const auto found = rates_.find(symbol);
    return found == rates_.end() ? "" : "const Scalar " + symbol + " = " + found->second + ";";
  }

 private:
  void add(const std::deque<Variable>& variables, const std::string& argument) {
    for (std::size_t index = 0; index < variables.size(); ++index) {
      const Variable& variable = variables[index];
      const std::string member = argument + "." + variable.name;
      members_[variable.value.get_name()] = member;
      members_[variable.size.get_name()] = "abs(" + member + ")";
      members_[variable.cosine.get_name()] = member + ".cos";
      members_[variable.sine.get_name()] = member + ".sin";
      const std::string place = "(" + std::to_string(index) + ")";
      rates_[variable.rate.get_name()] = argument + "_rate" + place;
      rates_[variable.second_rate.get_name()] = argument + "_second_rate" + place;
      rates_[variable.third_rate.get_name()] = argument + "_third_rate" + place;
    }
  }

  std::map<std::string, std::string> members_;
  std::map<std::string, std::string> rates_;
};

mustache::data variable_list(const std::deque<Variable>& variables,
                             const std::vector<int>& owners = {}) {
  mustache::data list{mustache::data::type::list};
  for (std::size_t index = 0; index < variables.size(); ++index) {
    const Variable& variable = variables[index];
    mustache::data entry;
    if (!owners.empty()) {
      entry.set("owner", std::to_string(owners[index]));
    }
    entry.set("type", variable.is_angle() ? "Direction<Scalar>" : "Scalar");
    entry.set("name", variable.name);
    entry.set("meaning", variable.meaning);
    entry.set("is_angle", boolean(variable.is_angle()));
    list << entry;
  }
  return list;
}

std::string names_of(const std::deque<Variable>& variables) {
  return joined(variables, ", ", [](const Variable& variable) { return variable.name; });
}

mustache::data line_list(const std::vector<std::string>& lines, const std::string& indentation) {
  mustache::data list{mustache::data::type::list};
  for (const std::string& line : lines) {
    list << mustache::data{"line", indentation + line};
  }
  return list;
}

/// Outputs most of whose entries are zero are cleared before the others are assigned.
bool mostly_zero(const ModelFunction& function, const Parameter& output) {
  const std::string entries = output.name + "(";
  return std::any_of(function.results.begin(), function.results.end(), [&](const Result& result) {
    return result.target.starts_with(entries) && result.value.is_zero();
  });
}

mustache::data function_view(const ModelFunction& function, const Program& program,
                             const ModelSpelling& spelling) {
  const auto spell = [&](const std::string& symbol) { return spelling.spell(symbol); };
  std::vector<std::string> body;
  std::set<std::string> used;
  bool sizes = false;
  for (const std::string& symbol : program.reads()) {
    const std::string alias = spelling.taken_out(symbol);
    const std::string source = alias.empty() ? spell(symbol) : alias.substr(alias.find('=') + 2);
    const bool size = source.starts_with("abs(");
    const std::size_t start = size ? source.find('(') + 1 : 0;
    used.insert(source.substr(start, source.find_first_of(".(", start) - start));
    sizes = sizes || size;
    if (!alias.empty()) {
      body.push_back(alias);
    }
  }
  if (sizes) {
    body.insert(body.begin(), "using std::abs;");
  }
  for (const Parameter& output : function.outputs) {
    if (mostly_zero(function, output)) {
      body.push_back(output.name + ".setZero();");
    }
  }
  const std::vector<std::string> lines = cpp_lines(program, spell);
  body.insert(body.end(), lines.begin(), lines.end());

  const auto input_text = [&](const Parameter& parameter) {
    return parameter.type + (used.contains(parameter.name) ? " " + parameter.name : "");
  };
  const auto output_text = [](const Parameter& parameter) {
    return parameter.type + " " + parameter.name;
  };
  mustache::data view;
  view.set("name", function.name);
  view.set("doc", line_list(function.doc, ""));
  view.set("parameters", joined(function.inputs, ", ", input_text) + ", " +
                             joined(function.outputs, ", ", output_text));
  view.set("body", line_list(body, "    "));
  const OperationCount count = program.count();
  view.set("padded_name", function.name + ":" + std::string(28 - function.name.size(), ' '));
  view.set("multiplications", std::to_string(count.multiplications));
  view.set("additions", std::to_string(count.additions));
  view.set("divisions", std::to_string(count.divisions));
  return view;
}

mustache::data link_list(const ClosureEquations& equations) {
  const Group& group = *equations.model->group;
  mustache::data list{mustache::data::type::list};
  for (int link = 0; link < group.link_count(); ++link) {
    const auto slot = static_cast<std::size_t>(link);
    std::vector<int> joints = group.joints_of(link);
    joints.resize(3, -1);
    mustache::data entry;
    entry.set("link", group.links()[slot]);
    entry.set("text",
              equations.frames[slot].description + ", angle " + equations.poses[slot].angle.text());
    entry.set("joint_list", joined(joints, ", ", [](int joint) { return std::to_string(joint); }));
    list << entry;
  }
  return list;
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

mustache::data pivot_list(const StructuredJacobian& jacobian) {
  mustache::data list{mustache::data::type::list};
  for (const Pivot& pivot : jacobian.pivots()) {
    list << mustache::data{"meaning", pivot.degeneracy};
  }
  return list;
}

/// The vector equations, and what the angles must satisfy beside them.
std::vector<std::string> closure_lines(const ClosureEquations& equations) {
  std::vector<std::string> lines;
  for (const LoopClosure& loop : equations.loops) {
    lines.push_back(loop.name + ":  " + loop.equation);
  }
  for (const AngleSum& sum : equations.compatibility) {
    lines.push_back("angles that prismatic joints alone close:  " + sum.text() + " = 0");
  }
  return lines;
}

/// How the closed form comes about, a line a step.
std::vector<std::string> elimination_steps(const Elimination& elimination) {
  std::vector<std::string> steps = elimination.reduction.text;
  const std::string first = elimination.first->name;
  if (elimination.second != nullptr) {
    steps.push_back("Bezout determinant in " + elimination.second->name);
  }
  const std::string degree = std::to_string(elimination.degree);
  steps.push_back(elimination.first->is_angle()
                      ? "trigonometric polynomial of degree " + degree + " in " + first
                      : "polynomial of degree " + degree + " in " + first);
  steps.push_back("at most " + std::to_string(elimination.max_configurations) +
                  (elimination.max_configurations == 1 ? " configuration" : " configurations"));
  return steps;
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
  const Mobility mobility = mobility_of(equations, derivatives);
  ModelSpelling spelling(equations);
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
    view.set("pivots", pivot_list(structured));
    view.set("pivot_count", std::to_string(structured.pivots().size()));
    view.set("core_pivot_count", std::to_string(structured.core_pivot_count()));
    view.set("determinant_sign", std::to_string(structured.sign()));
    Elimination elimination = eliminate(equations);
    const std::vector<ModelFunction> list = position_functions(equations, elimination);
    add_functions(list, elimination.vocabulary);
    const auto index_of = [&](const Variable* unknown) {
      int index = 0;
      for (const Variable& candidate : equations.unknowns) {
        if (&candidate == unknown) {
          return index;
        }
        ++index;
      }
      return -1;
    };
    view.set("max_configurations", std::to_string(elimination.max_configurations));
    view.set("polynomial_degree", std::to_string(elimination.degree));
    view.set("first_unknown", std::to_string(index_of(elimination.first)));
    view.set("second_unknown", std::to_string(index_of(elimination.second)));
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
  count("unknown_count", equations.unknowns.size());
  count("dimension_count", equations.dimensions.size());
  count("input_count", equations.inputs.size());
  count("compatibility_count", equations.compatibility.size());
  count("closure_link_count", closure_links(*model.group).size());
  count("kind_count", model.members.size());
  view.set("unknowns", variable_list(equations.unknowns, equations.owners));
  view.set("dimensions", variable_list(equations.dimensions));
  view.set("inputs", variable_list(equations.inputs));
  view.set("unknown_names", names_of(equations.unknowns));
  view.set("dimension_names", names_of(equations.dimensions));
  view.set("input_names", names_of(equations.inputs));
  view.set("joints", joint_list(model));
  view.set("kind_roles", kind_list(model));
  return {std::filesystem::path("assur") / model.group->name() / file_name(model),
          rendered(templates::model_hpp, view)};
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
