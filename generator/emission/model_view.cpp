#include "emission/model_view.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "emission/cpp_text.hpp"
#include "emission/templates.hpp"
#include "error.hpp"

namespace assur::generator {

namespace mustache = kainjow::mustache;

namespace {

/// Stands on blank lines until a template is filled in: a blank line behind a tag must not become
/// a line of that tag alone.
const std::string blank_line = "\x01";

/// Outputs most of whose entries are zero are cleared before the others are assigned.
bool mostly_zero(const ModelFunction& function, const Parameter& output) {
  const std::string entries = output.name + "(";
  return std::any_of(function.results.begin(), function.results.end(), [&](const Result& result) {
    return result.target.starts_with(entries) && result.value.is_zero();
  });
}

mustache::data pivot_list(const StructuredJacobian& jacobian) {
  mustache::data list{mustache::data::type::list};
  for (const Pivot& pivot : jacobian.pivots()) {
    list << mustache::data{"meaning", pivot.degeneracy};
  }
  return list;
}

mustache::data variable_list(const std::deque<Variable>& variables,
                             const std::vector<int>& owners) {
  mustache::data list{mustache::data::type::list};
  for (std::size_t index = 0; index < variables.size(); ++index) {
    const Variable& variable = variables[index];
    mustache::data entry;
    if (!owners.empty()) {
      entry.set("owner", std::to_string(owners[index]));
    }
    entry.set("type", variable.is_angle() ? "Direction<Scalar>" : "Scalar");
    entry.set("name", variable.name);
    entry.set("meaning", comment_text(variable.meaning));
    entry.set("is_angle", boolean(variable.is_angle()));
    list << entry;
  }
  return list;
}

std::string names_of(const std::deque<Variable>& variables) {
  return joined(variables, ", ", [](const Variable& variable) { return variable.name; });
}

}  // namespace

std::string boolean(bool value) { return value ? "true" : "false"; }

std::string comment_text(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  std::replace(text.begin(), text.end(), '\\', '/');
  return text;
}

std::string without_tag_lines(const char* text) {
  std::istringstream in(text);
  std::string joined;
  std::string line;
  while (std::getline(in, line)) {
    const bool tag = line.starts_with("{{") && line.find("}}") == line.size() - 2 &&
                     std::string("#^/>").find(line[2]) != std::string::npos;
    joined += tag ? line : (line.empty() ? blank_line : line) + "\n";
  }
  return joined;
}

std::string rendered(const std::string& text, const mustache::data& view) {
  mustache::mustache page{text};
  page.set_custom_escape([](const std::string& raw) { return raw; });
  if (!page.is_valid()) {
    throw GeneratorError("emission", "template", page.error_message());
  }
  std::string result = page.render(view);
  std::erase(result, blank_line.front());
  return fitted_to_width(result);
}

void show_partials(mustache::data& view) {
  const std::map<std::string, const char*> partials = {
      {"model_struct", templates::model_struct_hpp},
      {"model_variables", templates::model_variables_hpp},
      {"model_functions", templates::model_functions_hpp}};
  for (const auto& [name, text] : partials) {
    view.set(name, mustache::partial([text = text] { return without_tag_lines(text); }));
  }
}

void ModelSpelling::add(const std::deque<Variable>& variables, const std::string& argument) {
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

void show_variables(const std::deque<Variable>& variables, const std::string& kind,
                    mustache::data& view, const std::vector<int>& owners) {
  view.set(kind + "s", variable_list(variables, owners));
  view.set(kind + "_names", names_of(variables));
  view.set(kind + "_count", std::to_string(variables.size()));
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

mustache::data line_list(const std::vector<std::string>& lines, const std::string& indentation) {
  mustache::data list{mustache::data::type::list};
  for (const std::string& line : lines) {
    list << mustache::data{"line", indentation + line};
  }
  return list;
}

mustache::data function_view(const ModelFunction& function, const Program& program,
                             const ModelSpelling& spelling, ZeroResults zeros) {
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
  const OperationCount count = program.count();
  if (sizes) {
    body.insert(body.begin(), "using std::abs;");
  }
  if (count.square_roots > 0) {
    body.insert(body.begin(), "using std::sqrt;");
  }
  for (const Parameter& output : function.outputs) {
    if (mostly_zero(function, output)) {
      body.push_back(output.name + ".setZero();");
    }
  }
  if (zeros == ZeroResults::assigned) {
    for (const Result& result : function.results) {
      if (result.value.is_zero() && result.target.find('(') == std::string::npos) {
        body.push_back(result.target + " = Scalar(0);");
      }
    }
  }
  const std::vector<std::string> lines = cpp_lines(program, spell);
  body.insert(body.end(), lines.begin(), lines.end());

  const auto input_text = [&](const Parameter& parameter) {
    return parameter.type + (used.contains(parameter.name) ? " " + parameter.name : "");
  };
  const auto output_text = [&](const Parameter& parameter) {
    const bool assigned =
        zeros == ZeroResults::left_out ||
        std::any_of(function.results.begin(), function.results.end(), [&](const Result& result) {
          return result.target.starts_with(parameter.name);
        });
    return parameter.type + (assigned ? " " + parameter.name : "");
  };
  mustache::data view;
  view.set("name", function.name);
  view.set("doc", line_list(function.doc, ""));
  view.set("parameters", joined(function.inputs, ", ", input_text) + ", " +
                             joined(function.outputs, ", ", output_text));
  view.set("body", line_list(body, "    "));
  view.set("padded_name", function.name + ":" + std::string(28 - function.name.size(), ' '));
  view.set("multiplications", std::to_string(count.multiplications));
  view.set("additions", std::to_string(count.additions));
  view.set("divisions", std::to_string(count.divisions));
  view.set("square_roots", std::to_string(count.square_roots));
  return view;
}

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

std::vector<std::string> elimination_steps(const Elimination& elimination) {
  std::vector<std::string> steps;
  for (const RecordedStep& step : elimination.record) {
    if (!step.eliminated.empty()) {
      steps.push_back(step.title);
    }
  }
  const std::string first = elimination.first->name;
  const std::string degree = std::to_string(elimination.degree);
  steps.push_back(elimination.first->is_angle()
                      ? "trigonometric polynomial of degree " + degree + " in " + first
                      : "polynomial of degree " + degree + " in " + first);
  steps.push_back("at most " + std::to_string(elimination.max_configurations) +
                  (elimination.max_configurations == 1 ? " configuration" : " configurations"));
  return steps;
}

void show_solution(const StructuredJacobian& structured, const ClosureEquations& equations,
                   const Elimination& elimination, mustache::data& view) {
  view.set("pivots", pivot_list(structured));
  view.set("pivot_count", std::to_string(structured.pivots().size()));
  view.set("core_pivot_count", std::to_string(structured.core_pivot_count()));
  view.set("determinant_sign", std::to_string(structured.sign()));
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
}

}  // namespace assur::generator
