#include "audit/running/program_values.hpp"

#include <algorithm>
#include <array>
#include <assur/text/input_file.hpp>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <sstream>

#include "audit/running/drivers.hpp"
#include "audit/running/limited_process.hpp"

namespace assur::generator::audit::running {

namespace {

std::vector<std::string> usual_tools(Language language) {
  switch (language) {
    case Language::cpp:
      return {"c++", "g++", "clang++"};
    case Language::c:
      return {"cc", "gcc", "clang"};
    case Language::python:
      return {"python3", "python"};
    case Language::javascript:
      return {"node", "nodejs"};
    case Language::octave:
      break;
  }
  return {"octave-cli", "octave"};
}

std::string seconds_text(double seconds) {
  std::ostringstream text;
  text << seconds << " s";
  return text.str();
}

/// The first line that states an error, without the name of the driver's directory.
std::string first_error(const std::string& output, const std::string& directory) {
  std::istringstream in(output);
  std::string line;
  std::string first;
  while (std::getline(in, line)) {
    if (line.find("error") != std::string::npos || line.find("undefined") != std::string::npos) {
      first = line;
      break;
    }
    first = first.empty() ? line : first;
  }
  for (std::size_t at = first.find(directory); at != std::string::npos;
       at = first.find(directory)) {
    first.erase(at, directory.size() + 1);
  }
  return first.substr(0, 300);
}

/// Runs the command with the first of the tools that exists.
ProcessEnd run_tool(const UserProgram& program, const std::vector<std::string>& arguments,
                    const std::filesystem::path& directory, const std::filesystem::path& home,
                    const ProcessLimits& limits) {
  const std::vector<std::string> tools =
      program.tool.empty() ? usual_tools(program.language) : std::vector{program.tool};
  for (const std::string& tool : tools) {
    std::vector<std::string> command = {tool};
    command.insert(command.end(), arguments.begin(), arguments.end());
    ProcessEnd end = run_process(command, directory, home, limits);
    if (end.kind != ProcessEnd::Kind::not_found) {
      return end;
    }
  }
  throw ProgramError("'" + tools.front() +
                     "' cannot be started here, so nothing was run; install it");
}

[[noreturn]] void fail_on_entry(const MatrixSize& size) {
  throw ProgramError(
      "how to read an entry of the result is not known; say, for instance, 'entry result[i*" +
      std::to_string(size.columns) + " + j]'");
}

void compile(const UserProgram& program, const MatrixSize& size, const WorkDirectory& work,
             const Driver& driver, const RunLimits& limits) {
  if (program.file.string().find_first_of("\"\\\n") != std::string::npos) {
    throw ProgramError(
        "no #include can name a path with a quotation mark or a backslash; move the file");
  }
  const bool cpp = program.language == Language::cpp;
  std::vector<std::string> arguments = {cpp ? "-std=c++20" : "-std=gnu11"};
  arguments.insert(arguments.end(), program.flags.begin(), program.flags.end());
  for (const std::string& more :
       {std::string("-w"), (work.path() / driver.file_name).string(), std::string("-o"),
        (work.path() / "program").string(), std::string("-lm")}) {
    arguments.push_back(more);
  }
  const double seconds = 6 * limits.seconds;
  const ProcessEnd end = run_tool(program, arguments, program.directory, work.path(),
                                  {seconds, limits.most_megabytes << 20U});
  if (end.kind == ProcessEnd::Kind::too_long) {
    throw ProgramError("compiling it did not end within " + seconds_text(seconds));
  }
  if (end.output.find(entry_is_unclear) != std::string::npos) {
    fail_on_entry(size);
  }
  if (end.kind != ProcessEnd::Kind::ended || end.code != 0) {
    throw ProgramError("it does not compile: " + first_error(end.output, work.path().string()));
  }
}

ProcessEnd run(const UserProgram& program, const MatrixSize& size, const WorkDirectory& work,
               const Driver& driver, const RunLimits& limits) {
  const bool compiled = program.language == Language::cpp || program.language == Language::c;
  if (compiled) {
    compile(program, size, work, driver, limits);
    return run_process({(work.path() / "program").string()}, work.path(), work.path(),
                       {limits.seconds, limits.megabytes << 20U});
  }
  std::vector<std::string> arguments = program.flags;
  const std::map<Language, std::vector<std::string>> quiet = {
      {Language::python, {"-B"}},
      {Language::octave, {"--norc", "--silent", "--no-window-system", "--no-history"}},
      {Language::javascript, {"--no-warnings", "--experimental-vm-modules"}}};
  const std::vector<std::string>& more = quiet.at(program.language);
  arguments.insert(arguments.end(), more.begin(), more.end());
  arguments.push_back((work.path() / driver.file_name).string());
  return run_tool(program, arguments, work.path(), work.path(),
                  {limits.seconds, limits.most_megabytes << 20U});
}

std::string signal_text(int signal) {
  const char* const name = sigabbrev_np(signal);
  const std::string what = strsignal(signal);
  return "it was ended by a signal: " + what +
         (name == nullptr ? "" : std::string(" (SIG") + name + ")");
}

/// Throws the driver's complaint if it can compute no values at all; a result of another size at a
/// later point is a fault of that point, which is returned. `done` points have their values.
std::string fault_of(const std::string& complaint, const MatrixSize& size, std::size_t done) {
  if (complaint == entry_is_unclear) {
    fail_on_entry(size);
  }
  const std::string rest = complaint.substr(1);
  if (complaint[0] == '!' || complaint[0] == '?') {
    throw ProgramError(complaint[0] == '!' ? "it ended with " + rest : rest);
  }
  std::string text = "the result is " + complaint + ", not " + std::to_string(size.rows) + " by " +
                     std::to_string(size.columns);
  if (done == 0) {
    throw ProgramError(text + ", at point 1");
  }
  return text;
}

/// The reason why the program ended.
std::string end_text(const ProcessEnd& end, const RunLimits& limits) {
  switch (end.kind) {
    case ProcessEnd::Kind::too_long:
      return "it did not end within " + seconds_text(limits.seconds);
    case ProcessEnd::Kind::killed:
      return signal_text(end.code);
    case ProcessEnd::Kind::ended:
    case ProcessEnd::Kind::not_found:
      break;
  }
  return "it ended with status " + std::to_string(end.code);
}

PointValues failed(const std::string& why, std::size_t count) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {std::vector<double>(count, none), std::vector<double>(count, none),
          std::vector<std::string>(count, why)};
}

/// The entry that a word spells, and the reason if it has no value.
std::pair<double, std::string> read_entry(const std::string& word) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const std::string complex = "complex:";
  if (word.starts_with(complex)) {
    return {none, "it is a complex number, " + word.substr(complex.size())};
  }
  char* last = nullptr;
  const double value = std::strtod(word.c_str(), &last);
  if (last == word.c_str() || last != word.c_str() + word.size()) {
    return {none, "it is '" + word.substr(0, 40) + "', which is not a number"};
  }
  return {value, std::isnan(value)   ? "it is not a number (NaN)"
                 : std::isinf(value) ? "it is infinite"
                                     : ""};
}

/// The driver's line for a point; empty if the line is incomplete.
std::optional<PointValues> read_point(const std::string& line, std::size_t count, bool complex) {
  if (line.starts_with('!')) {
    return failed("it ended with " + line.substr(1), count);
  }
  std::istringstream words(line.substr(std::min<std::size_t>(line.size(), 1)));
  PointValues values;
  for (std::string word; words >> word;) {
    auto [value, fault] = read_entry(word);
    values.entries.push_back(value);
    values.faults.push_back(std::move(fault));
    if (complex && words >> word) {
      values.imaginary.push_back(read_entry(word).first);
    }
  }
  return values.entries.size() == count ? std::optional(values) : std::nullopt;
}

std::string point_lines(const PointTable& table) {
  std::string text;
  std::array<char, 40> number{};
  const auto add = [&](double value) {
    std::snprintf(number.data(), number.size(), "%.17g ", value);
    text += number.data();
  };
  for (std::size_t point = 0; point < table.points.size(); ++point) {
    for (std::size_t at = 0; at < table.points[point].size(); ++at) {
      add(table.points[point][at]);
      if (!table.imaginary.empty()) {
        add(table.imaginary[point][at]);
      }
    }
    text += ";\n";
  }
  return text;
}

bool declares_single_parameters(const UserProgram& program) {
  if (program.language != Language::cpp && program.language != Language::c) {
    return false;
  }
  std::string rows = program.result;
  for (const std::string& statement : program.before) {
    rows += " " + statement;
  }
  return has_single_parameters(text::read_input_file(program.file.string()), rows);
}

}  // namespace

bool takes_complex_numbers(Language language) {
  return language == Language::python || language == Language::octave;
}

ProgramValues program_values(const UserProgram& program, const MatrixSize& size,
                             const PointTable& table, const RunLimits& limits) {
  const WorkDirectory work;
  const Driver driver = driver_of(program, size, table);
  work.write(driver.file_name, driver.text);
  work.write("points", point_lines(table));
  const ProcessEnd end = run(program, size, work, driver, limits);

  const std::size_t count = size.rows * size.columns;
  ProgramValues values;
  values.single_precision = declares_single_parameters(program);
  std::istringstream lines(work.read("values"));
  for (std::string line; std::getline(lines, line);) {
    std::optional<PointValues> point = read_point(line, count, !table.imaginary.empty());
    if (!point || values.points.size() == table.points.size()) {
      break;
    }
    values.single_precision = values.single_precision || line.starts_with('s');
    values.points.push_back(std::move(*point));
  }
  const std::size_t done = values.points.size();
  const std::string complaint = work.read("complaint");
  if (complaint.empty() && !std::filesystem::exists(work.path() / "values")) {
    throw ProgramError(end_text(end, limits));
  }
  if (!complaint.empty() || done < table.points.size()) {
    const std::string why =
        complaint.empty() ? end_text(end, limits) : fault_of(complaint, size, done);
    values.points.push_back(failed(why, count));
  }
  return values;
}

}  // namespace assur::generator::audit::running
