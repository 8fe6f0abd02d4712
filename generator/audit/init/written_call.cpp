#include "audit/init/written_call.hpp"

#include <algorithm>
#include <assur/text/names.hpp>

namespace assur::generator::audit::init {

namespace {

class CallWriter {
 public:
  CallWriter(const ProgramFunction& function, const ProgramOutline& outline, Language language,
             const std::function<std::string(const std::string&)>& name_of,
             std::set<std::string>& taken)
      : function_(function),
        outline_(outline),
        language_(language),
        name_of_(name_of),
        taken_(taken) {}

  WrittenCall write() {
    if (outline_.of_symbols) {
      write_substitution();
      return std::move(call_);
    }
    if (!function_.space.empty()) {
      call_.before.push_back("using namespace " + function_.space);
    }
    std::vector<std::string> outputs;
    for (const Argument& argument : function_.arguments) {
      arguments_.push_back(argument.kind == Argument::Kind::output ? output(argument, outputs)
                                                                   : text_of(argument));
    }
    const std::string call = function_.name + "(" + text::joined(arguments_, ", ") + ")";
    if (!outputs.empty()) {
      call_.before.push_back(call);
      call_.results = outputs;
    } else if (language_ == Language::matlab) {
      write_outputs(call);
    } else if (function_.given.size() > 1) {
      for (std::size_t at = 0; at < function_.given.size(); ++at) {
        call_.results.push_back(call + "[" + std::to_string(at) + "]");
      }
    } else {
      call_.results = {call};
    }
    return std::move(call_);
  }

 private:
  /// A name for a variable of the rows.
  std::string variable(const std::string& name) {
    std::string free = name;
    if (taken_.contains(free)) {
      free = function_.name + "_" + name;
    }
    while (!taken_.insert(free).second) {
      free += "_";
    }
    return free;
  }

  [[nodiscard]] std::vector<std::string> names_of(const Argument& argument) const {
    std::vector<std::string> names;
    std::transform(argument.parts.begin(), argument.parts.end(), std::back_inserter(names),
                   name_of_);
    return names;
  }

  [[nodiscard]] std::string list(const std::vector<std::string>& names) const {
    const std::string content = text::joined(names, language_ == Language::matlab ? "; " : ", ");
    return outline_.has_numpy && language_ == Language::python ? "np.array([" + content + "])"
                                                               : "[" + content + "]";
  }

  std::string text_of(const Argument& argument) {
    const std::vector<std::string> names = names_of(argument);
    if (names.empty()) {
      return "0";  // unused
    }
    if (argument.kind == Argument::Kind::number) {
      return names[0];
    }
    const std::string content = text::joined(names, ", ");
    const bool is_c = language_ == Language::c || language_ == Language::cpp;
    if (argument.kind == Argument::Kind::list) {
      if (!is_c) {
        return list(names);
      }
      const std::string name = variable(argument.name);
      if (argument.is_array) {
        call_.before.push_back("const " + argument.type + " " + name + "[" +
                               std::to_string(names.size()) + "] = {" + content + "}");
        return name;
      }
      if (argument.type.find("Matrix") != std::string::npos ||
          argument.type.find("Vector") != std::string::npos) {
        const std::string size = std::to_string(names.size());
        call_.before.push_back(argument.type + " " + name +
                               (argument.type.ends_with("X"
                                                        "d")
                                    ? "(" + size + ")"
                                    : ""));
        call_.before.push_back(name + " << " + content);
        return name;
      }
      return argument.type + "{" + content + "}";
    }
    return object(argument, names);
  }

  std::string object(const Argument& argument, const std::vector<std::string>& names) {
    std::vector<std::string> members;
    for (std::size_t at = 0; at < names.size(); ++at) {
      const std::string& member = argument.members[at];
      members.push_back(language_ == Language::python       ? member + "=" + names[at]
                        : language_ == Language::javascript ? member + ": " + names[at]
                        : language_ == Language::matlab     ? "\"" + member + "\", " + names[at]
                                                            : names[at]);
    }
    const std::string content = text::joined(members, ", ");
    switch (language_) {
      case Language::python:
        return "__import__(\"types\").SimpleNamespace(" + content + ")";
      case Language::javascript:
        return "{" + content + "}";
      case Language::matlab:
        return "struct(" + content + ")";
      default: {
        const std::string name = variable(argument.name);
        call_.before.push_back("const " + argument.type + " " + name + " = {" + content + "}");
        return argument.is_array ? "&" + name : name;
      }
    }
  }

  std::string output(const Argument& argument, std::vector<std::string>& outputs) {
    const auto given = std::find_if(function_.given.begin(), function_.given.end(),
                                    [&](const Given& each) { return each.name == argument.name; });
    const std::size_t rows = given == function_.given.end() ? 1 : given->rows;
    const std::size_t columns = given == function_.given.end() ? 1 : given->columns;
    const std::string name = variable(argument.name);
    const std::string row = std::to_string(rows);
    const std::string column = std::to_string(columns);
    if (given != function_.given.end()) {
      outputs.push_back(name);
    }
    switch (language_) {
      case Language::python:
        call_.before.push_back(name + " = " +
                               (outline_.has_numpy && columns > 1
                                    ? "np.zeros((" + row + ", " + column + "))"
                                : columns > 1 ? "[[0.0]*" + column + " for _ in range(" + row + ")]"
                                              : "[0.0]*" + row));
        break;
      case Language::javascript:
        call_.before.push_back(
            "const " + name + " = " +
            (columns > 1 ? "Array.from({length: " + row + "}, () => Array(" + column + ").fill(0))"
                         : "Array(" + row + ").fill(0)"));
        break;
      default: {
        const std::string size = columns > 1 ? "[" + row + "][" + column + "]" : "[" + row + "]";
        const bool is_vector = argument.type.find("vector<") != std::string::npos;
        const bool is_dynamic = argument.type.ends_with("Xd");
        call_.before.push_back(argument.type + " " + name +
                               (argument.is_array ? size
                                : is_vector && columns > 1
                                    ? "(" + row + ", std::vector<double>(" + column + "))"
                                : is_vector || (is_dynamic && columns == 1) ? "(" + row + ")"
                                : is_dynamic ? "(" + row + ", " + column + ")"
                                             : ""));
      }
    }
    return name;
  }

  /// Octave has an expression only for the first result.
  void write_outputs(const std::string& call) {
    std::vector<std::string> names;
    for (const Given& each : function_.given) {
      if (each.columns == 1 && !each.names.empty() && each.name.empty()) {
        for (const std::string& name : each.names) {
          names.push_back(variable(name + "_"));
        }
      } else if (function_.given.size() > 1) {
        names.push_back(variable(each.name));
      }
    }
    if (names.empty()) {
      call_.results = {call};
      return;
    }
    call_.before.push_back("[" + text::joined(names, ", ") + "] = " + call);
    call_.results = function_.given.size() == 1
                        ? std::vector<std::string>{"[" + text::joined(names, "; ") + "]"}
                        : names;
  }

  /// The symbols of a SymPy module take their values by name, whatever their assumptions.
  void write_substitution() {
    std::vector<std::string> pairs;
    for (const Argument& argument : function_.arguments) {
      pairs.push_back("\"" + argument.name + "\": " + name_of_(argument.name));
    }
    const std::string values = "{" + text::joined(pairs, ", ") + "}";
    for (const Given& each : function_.given) {
      call_.results.push_back(each.name + ".subs({s: " + values + "[s.name] for s in " + each.name +
                              ".free_symbols})");
    }
  }

  const ProgramFunction& function_;
  const ProgramOutline& outline_;
  Language language_;
  const std::function<std::string(const std::string&)>& name_of_;
  std::set<std::string>& taken_;
  std::vector<std::string> arguments_;
  WrittenCall call_;
};

}  // namespace

WrittenCall written_call(const ProgramFunction& function, const ProgramOutline& outline,
                         Language language,
                         const std::function<std::string(const std::string&)>& name_of,
                         std::set<std::string>& taken) {
  return CallWriter(function, outline, language, name_of, taken).write();
}

}  // namespace assur::generator::audit::init
