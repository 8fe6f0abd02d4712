#include "audit/running/drivers.hpp"

#include <stdexcept>

#include "audit/running/templates.hpp"

namespace assur::generator::audit::running {

namespace {

/// The text with every `{{NAME}}` replaced.
std::string filled(std::string text,
                   const std::vector<std::pair<std::string, std::string>>& values) {
  for (const auto& [name, value] : values) {
    const std::string mark = "{{" + name + "}}";
    for (std::size_t at = text.find(mark); at != std::string::npos;
         at = text.find(mark, at + value.size())) {
      text.replace(at, mark.size(), value);
    }
  }
  return text;
}

std::string template_named(std::string_view name) {
  for (const auto& [file, text] : templates::all) {
    if (file == name) {
      return text;
    }
  }
  throw std::logic_error("no such template");
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) {
    result += letter == '"' || letter == '\\' ? "\\" : "";
    result += letter == '\n' ? "\\n" : std::string(1, letter);
  }
  return result + "\"";
}

/// The statements one per line, each with the end that its language requires.
std::string lines(const std::vector<std::string>& statements, const std::string& indent,
                  const std::string& end) {
  std::string text;
  for (const std::string& statement : statements) {
    text += indent + statement + end + "\n";
  }
  return text;
}

std::string cpp_driver(const UserProgram& program, const MatrixSize& size,
                       const std::vector<std::string>& names) {
  const bool cpp = program.language == Language::cpp;
  std::string quantities = "  (void)assur_quantities;\n";
  for (std::size_t at = 0; at < names.size(); ++at) {
    quantities += "  double " + names[at] + " = assur_quantities[" + std::to_string(at) +
                  "];\n  (void)" + names[at] + ";\n";
  }
  const std::size_t count = size.rows * size.columns;
  const bool flat = size.rows == 1 || size.columns == 1;
  std::string entry = program.entry;
  std::string check;
  if (entry.empty()) {
    entry = cpp    ? "assur_audit::entry(result, i, j, assur_audit::Rank<3>())"
            : flat ? entry_is_unclear + std::string("(result, i, j)")
                   : "result[i][j]";
    check = cpp                 ? "  assur_audit::check(result, assur_audit::Rank<3>());\n"
            : flat && count > 1 ? "  _Static_assert(!assur_is_number(result), \"{{unclear}}\");\n"
                                : "";
  }
  return filled(template_named(cpp ? "driver.cpp" : "driver.c"),
                {{"file", quoted(program.file.string())},
                 {"quantities", quantities},
                 {"before", lines(program.before, "  ", ";")},
                 {"result", program.result},
                 {"check", check},
                 {"entry", entry}});
}

std::string quoted_list(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) {
    list += quoted(name) + ", ";
  }
  return list;
}

std::string script_driver(const UserProgram& program, const std::string& form,
                          const std::vector<std::string>& names) {
  const std::string end = program.language == Language::javascript ? ";" : "";
  return filled(template_named(form), {{"file", quoted(program.file.string())},
                                       {"names", quoted_list(names)},
                                       {"before", quoted(lines(program.before, "", end))},
                                       {"result", quoted(program.result)},
                                       {"entry", quoted(program.entry)}});
}

std::string octave_driver(const UserProgram& program, const std::vector<std::string>& names) {
  std::string quantities;
  for (std::size_t at = 0; at < names.size(); ++at) {
    quantities += "  " + names[at] + " = assur_quantities(" + std::to_string(at + 1) + ");\n";
  }
  const std::string check =
      "  if ! isequal(size(result), [{{rows}} {{columns}}])\n"
      "    complain(strjoin(cellfun(@num2str, num2cell(size(result)), \"UniformOutput\", false), "
      "\" by \"));\n  end\n";
  return filled(template_named("driver.m"),
                {{"file", quoted(program.file.string())},
                 {"names", quoted_list(names)},
                 {"row_text", quoted(lines(program.before, "", " ") + program.result)},
                 {"quantities", quantities},
                 {"before", lines(program.before, "  ", ";")},
                 {"result", program.result},
                 {"check", program.entry.empty() ? check : ""},
                 {"entry", program.entry.empty() ? "result(i, j)" : program.entry}});
}

}  // namespace

Driver driver_of(const UserProgram& program, const MatrixSize& size, const PointTable& table) {
  const std::vector<std::string>& names = table.names;
  Driver driver;
  switch (program.language) {
    case Language::cpp:
      driver = {"assur_driver.cpp", cpp_driver(program, size, names)};
      break;
    case Language::c:
      driver = {"assur_driver.c", cpp_driver(program, size, names)};
      break;
    case Language::python:
      driver = {"assur_driver.py", script_driver(program, "driver.py", names)};
      break;
    case Language::octave:
      driver = {"assur_driver.m", octave_driver(program, names)};
      break;
    case Language::javascript:
      driver = {"assur_driver.cjs", script_driver(program, "driver.cjs", names)};
      break;
  }
  const bool python = program.language == Language::python;
  const bool complex = !table.imaginary.empty();
  driver.text =
      filled(driver.text,
             {{"rows", std::to_string(size.rows)},
              {"columns", std::to_string(size.columns)},
              {"count", std::to_string(names.size())},
              {"complex", complex ? (python ? "True" : "true") : (python ? "False" : "false")},
              {"unclear", entry_is_unclear}});
  return driver;
}

}  // namespace assur::generator::audit::running
