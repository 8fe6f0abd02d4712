#include "audit/running/program_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "audit/running/drivers.hpp"
#include "audit/running/limited_process.hpp"
#include "audit/running/work_directory.hpp"

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

/// The first line that says what is wrong, without the name of the driver's own directory.
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
      "it cannot be told how an entry of the result is read; say, for instance, 'entry result[i*" +
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
  if (program.language == Language::python) {
    arguments.emplace_back("-B");
  } else {
    for (const char* quiet : {"--norc", "--silent", "--no-window-system", "--no-history"}) {
      arguments.emplace_back(quiet);
    }
  }
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

/// Throws unless the program ended without an error. `done` points have their values.
void expect_quiet(const ProcessEnd& end, const std::string& complaint, const MatrixSize& size,
                  std::size_t done, std::size_t all, const RunLimits& limits) {
  if (!complaint.empty() && complaint[0] == '!') {
    throw ProgramError("it ended with " + complaint.substr(1), done);
  }
  if (complaint == entry_is_unclear) {
    fail_on_entry(size);
  }
  if (!complaint.empty()) {
    throw ProgramError("the result is " + complaint + ", not " + std::to_string(size.rows) +
                           " by " + std::to_string(size.columns),
                       done);
  }
  const std::size_t point = done < all ? done : ProgramError::none;
  if (end.kind == ProcessEnd::Kind::too_long) {
    throw ProgramError("it did not end within " + seconds_text(limits.seconds), point);
  }
  if (end.kind == ProcessEnd::Kind::killed) {
    throw ProgramError(signal_text(end.code), point);
  }
  if (end.code != 0 || done < all) {
    throw ProgramError("it ended with status " + std::to_string(end.code) + " after " +
                           std::to_string(done) + " of " + std::to_string(all) + " points",
                       point);
  }
}

}  // namespace

std::vector<std::vector<double>> program_values(const UserProgram& program, const MatrixSize& size,
                                                const PointTable& table, const RunLimits& limits) {
  const WorkDirectory work;
  const Driver driver = driver_of(program, size, table.names);
  work.write(driver.file_name, driver.text);
  std::string points;
  std::array<char, 40> number{};
  for (const std::vector<double>& point : table.points) {
    for (const double value : point) {
      std::snprintf(number.data(), number.size(), "%.17g ", value);
      points += number.data();
    }
    points += ";\n";
  }
  work.write("points", points);
  const ProcessEnd end = run(program, size, work, driver, limits);

  const std::size_t count = size.rows * size.columns;
  std::vector<std::vector<double>> values;
  std::istringstream lines(work.read("values"));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::vector<double> entries;
    for (std::string word; words >> word;) {
      char* last = nullptr;
      entries.push_back(std::strtod(word.c_str(), &last));
      if (last == word.c_str() || last != word.c_str() + word.size()) {
        throw ProgramError("it gave '" + word.substr(0, 40) + "', which is not a number",
                           values.size());
      }
    }
    if (entries.size() != count || values.size() == table.points.size()) {
      break;
    }
    const auto strange = std::find_if_not(entries.begin(), entries.end(),
                                          [](double value) { return std::isfinite(value); });
    if (strange != entries.end()) {
      const auto at = static_cast<std::size_t>(strange - entries.begin());
      throw ProgramError("entry (" + std::to_string(at / size.columns + 1) + "," +
                             std::to_string(at % size.columns + 1) + ") is " +
                             (std::isnan(*strange) ? "not a number" : "infinite"),
                         values.size());
    }
    values.push_back(std::move(entries));
  }
  expect_quiet(end, work.read("complaint"), size, values.size(), table.points.size(), limits);
  return values;
}

}  // namespace assur::generator::audit::running
