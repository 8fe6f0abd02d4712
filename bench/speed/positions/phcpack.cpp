#include "positions/phcpack.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <complex>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>

namespace assur::speed {

namespace {

using Complex = std::complex<double>;
using tetrad::Model01;

/// |b + g z1 - f z2|^2 - bar^2 as a Laurent polynomial in z1 and z2, in PHCpack's notation.
std::string squared_closure(const Complex& b, const Complex& g, const Complex& f, double bar) {
  const auto term = [](const Complex& coefficient, const char* monomial) {
    std::array<char, 128> text{};
    std::snprintf(text.data(), text.size(), "+(%.17g%+.17g*I)*%s", coefficient.real(),
                  coefficient.imag(), monomial);
    return std::string(text.data());
  };
  const Complex mixed = -g * std::conj(f);
  std::array<char, 32> constant{};
  std::snprintf(constant.data(), constant.size(), "%.17g",
                std::norm(b) + std::norm(g) + std::norm(f) - bar * bar);
  return constant.data() + term(std::conj(b) * g, "z1") + term(b * std::conj(g), "z1^-1") +
         term(-std::conj(b) * f, "z2") + term(-b * std::conj(f), "z2^-1") +
         term(mixed, "z1*z2^-1") + term(std::conj(mixed), "z1^-1*z2") + ";\n";
}

/// The files of one call, removed with it.
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

/// Pairs (z1, z2) of the last list of solutions, and the time of solving.
struct Output {
  std::vector<std::array<Complex, 2>> solutions;
  double solving_ns = 0;
};

Output read_output(const std::filesystem::path& path) {
  Output result;
  std::ifstream file(path);
  std::string line;
  const std::regex value(R"( z([12]) : *(\S+) +(\S+))");
  const std::regex time(R"(The elapsed time in seconds was +(\S+) =.*)");
  bool total = false;
  std::array<Complex, 2> z;
  std::smatch match;
  while (std::getline(file, line)) {
    if (line.find("THE SOLUTIONS") != std::string::npos) {
      result.solutions.clear();
    } else if (line.find("TIMING INFORMATION for Solving") != std::string::npos) {
      total = true;
    } else if (std::regex_match(line, match, value)) {
      const std::size_t place = match[1] == "1" ? 0 : 1;
      z[place] = {std::stod(match[2]), std::stod(match[3])};
      if (place == 1) {
        result.solutions.push_back(z);
      }
    } else if (total && std::regex_match(line, match, time)) {
      result.solving_ns = 1e9 * std::stod(match[1]);
      total = false;
    }
  }
  return result;
}

}  // namespace

std::optional<PhcAnswer> solve_by_phc(const PositionSample<Model01>& sample) {
  const auto& d = sample.d;
  const Complex b(sample.u.x_B - sample.u.x_E, sample.u.y_B - sample.u.y_E);
  const Complex G(d.x_G_BCG, d.y_G_BCG);
  const Complex F(d.x_F_EDF, d.y_F_EDF);
  const CallFiles files;
  std::ofstream(files.input) << "2\n"
                             << squared_closure(b, d.BC, d.ED, d.CD)
                             << squared_closure(b, G, F, d.GF);
  const std::string command = std::string(ASSUR_PHC) + " -b " + files.input.string() + ' ' +
                              files.output.string() + " > /dev/null 2>&1";
  const double before = children_ns();
  if (std::system(command.c_str()) != 0) {
    return std::nullopt;
  }
  PhcAnswer answer;
  answer.call_ns = children_ns() - before;
  const Output output = read_output(files.output);
  answer.solving_ns = output.solving_ns;
  for (const auto& [z1, z2] : output.solutions) {
    constexpr double tolerance = 1e-8;
    if (std::abs(std::abs(z1) - 1) > tolerance || std::abs(std::abs(z2) - 1) > tolerance) {
      continue;
    }
    const auto direction = [](const Complex& z) {
      return Direction<double>{z.real() / std::abs(z), z.imag() / std::abs(z)};
    };
    Model01::Configuration<double> q = {direction(z1), direction(z2),
                                        direction(-(b + d.BC * z1 - d.ED * z2) / d.CD),
                                        direction(-(b + G * z1 - F * z2) / d.GF)};
    (void)refine<Model01, double>(d, sample.u, q, 3);
    answer.found.add(q);
  }
  return answer;
}

}  // namespace assur::speed
