#include "phcpack.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <string>

namespace assur::speed {

namespace {

using Complex = std::complex<double>;

/// A closure as a Laurent polynomial, in PHCpack's notation.
std::string polynomial_of(const SquaredClosure& closure) {
  const auto& [first, second, b, g, f, bar] = closure;
  const std::string one = "z" + std::to_string(first);
  const std::string other = "z" + std::to_string(second);
  const auto term = [](const Complex& coefficient, const std::string& monomial) {
    std::array<char, 128> text{};
    std::snprintf(text.data(), text.size(), "+(%.17g%+.17g*I)*", coefficient.real(),
                  coefficient.imag());
    return text.data() + monomial;
  };
  const Complex mixed = -g * std::conj(f);
  std::array<char, 32> constant{};
  std::snprintf(constant.data(), constant.size(), "%.17g",
                std::norm(b) + std::norm(g) + std::norm(f) - bar * bar);
  return constant.data() + term(std::conj(b) * g, one) + term(b * std::conj(g), one + "^-1") +
         term(-std::conj(b) * f, other) + term(-b * std::conj(f), other + "^-1") +
         term(mixed, one + "*" + other + "^-1") + term(std::conj(mixed), one + "^-1*" + other) +
         ";\n";
}

/// The files of one call, removed by the destructor.
struct CallFiles {
  std::filesystem::path input, output;
  CallFiles() {
    const auto stem =
        std::filesystem::temp_directory_path() / ("assur_phc_" + std::to_string(::getpid()));
    input = stem.string() + ".in";
    output = stem.string() + ".out";
    std::filesystem::remove(output);
  }
  ~CallFiles() {
    std::error_code ignored;
    std::filesystem::remove(input, ignored);
    std::filesystem::remove(output, ignored);
  }
  CallFiles(const CallFiles&) = delete;
  CallFiles& operator=(const CallFiles&) = delete;
};

double children_ns() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto ns = [](const timeval& time) {
    return 1e9 * static_cast<double>(time.tv_sec) + 1e3 * static_cast<double>(time.tv_usec);
  };
  return ns(usage.ru_utime) + ns(usage.ru_stime);
}

struct Answer {
  std::vector<LinkDirections> found;  ///< on unit circles
  double solving_ns = 0;              ///< as PHCpack states it, without program start and files
  double call_ns = 0;                 ///< processor time of the process
};

/// The last list of solutions, and the time of solving.
Answer read_output(const std::filesystem::path& path, std::size_t links) {
  Answer result;
  std::ifstream file(path);
  std::string line;
  const std::regex value(R"( z(\d+) : *(\S+) +(\S+))");
  const std::regex time(R"(The elapsed time in seconds was +(\S+) =.*)");
  constexpr double tolerance = 1e-8;
  bool total = false;
  LinkDirections z(links);
  std::smatch match;
  while (std::getline(file, line)) {
    if (line.find("THE SOLUTIONS") != std::string::npos) {
      result.found.clear();
    } else if (line.find("TIMING INFORMATION for Solving") != std::string::npos) {
      total = true;
    } else if (std::regex_match(line, match, value)) {
      const auto number = static_cast<std::size_t>(std::stoi(match[1]));
      z[number - 1] = {std::stod(match[2]), std::stod(match[3])};
      const bool is_real = std::all_of(z.begin(), z.end(), [](const Complex& one) {
        return std::abs(std::abs(one) - 1) <= tolerance;
      });
      if (number == links && is_real) {
        result.found.push_back(z);
      }
    } else if (total && std::regex_match(line, match, time)) {
      result.solving_ns = 1e9 * std::stod(match[1]);
      total = false;
    }
  }
  return result;
}

/// Empty if PHCpack fails.
std::optional<Answer> solved(const std::vector<SquaredClosure>& closures) {
  const CallFiles files;
  std::ofstream input(files.input);
  input << closures.size() << "\n";
  for (const SquaredClosure& closure : closures) {
    input << polynomial_of(closure);
  }
  input.close();
  const std::string command = std::string(ASSUR_PHC) + " -b " + files.input.string() + ' ' +
                              files.output.string() + " > /dev/null 2>&1";
  const double before = children_ns();
  if (std::system(command.c_str()) != 0) {
    return std::nullopt;
  }
  const double call_ns = children_ns() - before;
  Answer answer = read_output(files.output, closures.size());
  answer.call_ns = call_ns;
  return answer;
}

}  // namespace

void add_phc_rows(Task& task, std::size_t inputs, const PhcQuestions& questions) {
  ErrorTally tally;
  std::vector<double> solving;
  std::vector<double> call;
  for (std::size_t input = 0; input < inputs; ++input) {
    const auto answer = solved(questions.closures(input));
    if (!answer) {
      tally.add_failure();
      continue;
    }
    tally.add(questions.error(input, answer->found));
    solving.push_back(answer->solving_ns);
    call.push_back(answer->call_ns);
  }
  Entry entry;
  entry.row.task = task.name;
  tally.write_to(entry.row);
  const auto append = [&](const char* method, std::vector<double>& times) {
    entry.row.method = method;
    std::sort(times.begin(), times.end());
    entry.row.ns = times.empty() ? 0 : times[times.size() / 2];
    task.entries.push_back(entry);
  };
  append("PHCpack, solving alone", solving);
  append("PHCpack, the whole process", call);
}

}  // namespace assur::speed
