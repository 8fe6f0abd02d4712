#include "emission/model/model_view.hpp"

#include <algorithm>
#include <assur/text/names.hpp>
#include <set>

#include "emission/cpp/cpp_text.hpp"

namespace assur::generator::emission::model {

namespace {

cpp::View::List pivot_list(const pivoting::StructuredJacobian& jacobian) {
  cpp::View::List list;
  for (const pivoting::Pivot& pivot : jacobian.pivots()) {
    list.emplace_back("meaning", pivot.degeneracy);
  }
  return list;
}

cpp::View::List variable_list(const std::deque<equations::Variable>& variables,
                              const std::vector<equations::Owner>& owners) {
  cpp::View::List list;
  for (std::size_t index = 0; index < variables.size(); ++index) {
    const equations::Variable& variable = variables[index];
    cpp::View entry;
    if (!owners.empty()) {
      entry.set("owner", std::visit([](auto owner) { return std::to_string(owner.place()); },
                                    owners[index]));
    }
    entry.set("type", variable.is_angle() ? "Direction<Scalar>" : "Scalar");
    entry.set("name", variable.name);
    entry.set("meaning", cpp::comment_text(variable.meaning));
    entry.set("is_angle", cpp::boolean(variable.is_angle()));
    list.push_back(entry);
  }
  return list;
}

std::string names_of(const std::deque<equations::Variable>& variables) {
  return text::joined(variables, ", ",
                      [](const equations::Variable& variable) { return variable.name; });
}

}  // namespace

void ModelSpelling::add(const std::deque<equations::Variable>& variables,
                        const std::string& argument) {
  for (std::size_t index = 0; index < variables.size(); ++index) {
    const equations::Variable& variable = variables[index];
    const std::string member = "." + variable.name;
    members_[variable.value.get_name()] = {{argument, member}};
    members_[variable.size.get_name()] = {{argument, member}, true};
    members_[variable.cosine.get_name()] = {{argument, member + ".cos"}};
    members_[variable.sine.get_name()] = {{argument, member + ".sin"}};
    rates_[variable.rate.get_name()] = program::entry(argument + "_rate", index);
    rates_[variable.second_rate.get_name()] = program::entry(argument + "_second_rate", index);
    rates_[variable.third_rate.get_name()] = program::entry(argument + "_third_rate", index);
  }
}

std::string ModelSpelling::spell(const std::string& symbol) const {
  const std::optional<Source> found = source(symbol);
  const std::string place = found ? cpp::spelled(found->place) : symbol;
  return found && found->is_size ? "abs(" + place + ")" : place;
}

void show_variables(const std::deque<equations::Variable>& variables, const std::string& kind,
                    cpp::View& view, const std::vector<equations::Owner>& owners) {
  view.set(kind + "s", variable_list(variables, owners));
  view.set(kind + "_names", names_of(variables));
  view.set(kind + "_count", std::to_string(variables.size()));
}

cpp::View::List link_list(const equations::ClosureEquations& equations) {
  const structure::Group& group = *equations.model->group;
  cpp::View::List list;
  for (const structure::LinkIndex link : group.links().keys()) {
    std::vector<std::string> joints;
    for (const structure::JointIndex joint : group.joints_of(link)) {
      joints.push_back(std::to_string(joint.place()));
    }
    joints.resize(3, "-1");
    cpp::View entry;
    entry.set("link", group.links()[link]);
    entry.set("text",
              equations.frames[link].description + ", angle " + equations.poses[link].angle.text());
    entry.set("joint_list", text::joined(joints, ", "));
    list.push_back(entry);
  }
  return list;
}

cpp::View function_view(const ModelFunction& function, const program::Program& program,
                        const ModelSpelling& spelling, ZeroResults zeros,
                        const FirstStatements& first) {
  const auto spell = [&](const std::string& symbol) { return spelling.spell(symbol); };
  cpp::FilledLines body;
  std::vector<std::pair<std::string, program::Place>> taken_out;
  std::set<std::string> used;
  bool sizes = false;
  for (const std::string& symbol : program.reads()) {
    if (const auto entry = spelling.taken_out(symbol)) {
      used.insert(entry->argument);
      taken_out.emplace_back(symbol, *entry);
    } else if (const auto source = spelling.source(symbol)) {
      used.insert(source->place.argument);
      sizes = sizes || source->is_size;
    }
  }
  const program::OperationCount count = program.count();
  for (const std::string& line : first.lines) {
    body.add(line);
  }
  if (count.square_roots > 0) {
    body.add("using std::sqrt;");
  }
  if (sizes) {
    body.add("using std::abs;");
  }
  for (const auto& [symbol, entry] : taken_out) {
    body.declare(symbol, cpp::spelled(entry));
  }
  body.begin_line();
  for (const Parameter& output : function.outputs) {
    if (is_cleared(function, output)) {
      body.add(output.name + ".setZero();");
    }
  }
  if (zeros == ZeroResults::assigned) {
    for (const program::Result& result : function.results) {
      if (result.value.is_zero() && !result.target.is_entry()) {
        body.assign(result.target, "Scalar(0)");
      }
    }
  }
  cpp::add_program(program, spell, body);

  const auto input_text = [&](const Parameter& parameter) {
    const bool is_used = used.contains(parameter.name) || first.reads.contains(parameter.name);
    return parameter.type + (is_used ? " " + parameter.name : "");
  };
  const auto output_text = [&](const Parameter& parameter) {
    const bool assigned = zeros == ZeroResults::left_out ||
                          std::any_of(function.results.begin(), function.results.end(),
                                      [&](const program::Result& result) {
                                        return result.target.argument == parameter.name;
                                      });
    return parameter.type + (assigned ? " " + parameter.name : "");
  };
  cpp::View view;
  view.set("name", function.name);
  view.set("doc", cpp::line_list(function.doc, ""));
  view.set("parameters", text::joined(function.inputs, ", ", input_text) + ", " +
                             text::joined(function.outputs, ", ", output_text));
  view.set("body", cpp::line_list(body.lines(), "    "));
  show_operations(function.name, count, view);
  return view;
}

bool is_cleared(const ModelFunction& function, const Parameter& output) {
  return std::any_of(function.results.begin(), function.results.end(),
                     [&](const program::Result& result) {
                       return result.target.argument == output.name && result.target.is_entry() &&
                              result.value.is_zero();
                     });
}

void show_operations(const std::string& name, const program::OperationCount& count,
                     cpp::View& view) {
  view.set("padded_name", name + ":" + std::string(28 - name.size(), ' '));
  view.set("multiplications", std::to_string(count.multiplications));
  view.set("additions", std::to_string(count.additions));
  view.set("divisions", std::to_string(count.divisions));
  view.set("square_roots", std::to_string(count.square_roots));
}

std::vector<std::string> closure_lines(const equations::ClosureEquations& equations) {
  std::vector<std::string> lines;
  for (const equations::LoopClosure& loop : equations.loops) {
    lines.push_back(loop.name + ":  " + loop.equation);
  }
  for (const equations::AngleSum& sum : equations.compatibility) {
    lines.push_back("angles that prismatic joints alone close:  " + sum.text() + " = 0");
  }
  return lines;
}

std::vector<std::string> elimination_steps(const elimination::Elimination& elimination) {
  std::vector<std::string> steps;
  for (const elimination::RecordedStep& step : elimination.record) {
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

void show_solution(const pivoting::StructuredJacobian& structured,
                   const equations::ClosureEquations& equations,
                   const elimination::Elimination& elimination, cpp::View& view) {
  view.set("pivots", pivot_list(structured));
  view.set("pivot_count", std::to_string(structured.pivots().size()));
  view.set("core_pivot_count", std::to_string(structured.core_pivot_count()));
  view.set("determinant_sign", std::to_string(structured.sign()));
  const auto index_of = [&](const equations::Variable* unknown) {
    int index = 0;
    for (const equations::Variable& candidate : equations.unknowns) {
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

}  // namespace assur::generator::emission::model
