// Prints one line for each of many answers of the runtime, for comparison between compilers'
// arithmetics. A second argument changes the processor's rounding mode or flushing of subnormals.
#include <array>
#include <assur/assembly.hpp>
#include <assur/dyad/model_01.hpp>
#include <cfenv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#ifdef ASSUR_WHOLE_ANSWERS
#include <assur/closures/four_bar.hpp>
#include <assur/kinematics.hpp>
#include <assur/scenes/four_bar.hpp>
#include <assur/tetrad/model_01.hpp>
#endif
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#ifdef ASSUR_FMA_ROUNDS_TWICE
extern "C" double fma(double x, double y, double z) noexcept { return x * y + z; }
#endif

namespace {

using Dyad = assur::dyad::Model01;

// Read from memory, so that compilers that assume no NaN still get one.
const volatile double spoilt = std::numeric_limits<double>::quiet_NaN();

const char* word(assur::AssemblyStatus status) {
  constexpr std::array words = {"ok", "degenerate", "not finite", "unsound"};
  return words[static_cast<std::size_t>(status)];
}

/// In thousandths: whole numbers are printed alike however the processor rounds.
long printed(double value) { return std::lround(value * 1000 + 0.1); }

/// Prints what rounding does not change: statuses, counts, and first angles in thousandths.
template <typename Model>
void print(const char* name, int number, const assur::Assemblies<Model>& found) {
  if (found.status == assur::AssemblyStatus::unsound_arithmetic) {
    std::printf("%s %d: unsound\n", name, number);
    return;
  }
  std::printf("%s %d: %s, %d, mobility %d", name, number, word(found.status), found.count,
              found.mobility);
  for (int index = 0; index < found.count; ++index) {
    const auto place = static_cast<std::size_t>(index);
    const auto& q = found.configurations[place];
    const auto& angle = std::get<0>(q.members());
    std::printf(", %s %ld %ld", assur::to_string(found.regularity[place]), printed(angle.cos),
                printed(angle.sin));
  }
  std::printf("\n");
}

void print_dyad(const char* name, int number, double first, double second, double apart) {
  Dyad::Dimensions<double> d;
  Dyad::Inputs<double> u{};
  std::get<0>(d.members()) = first;
  std::get<1>(d.members()) = second;
  std::get<2>(u.members()) = apart;
  print<Dyad>(name, number, assur::assemblies<Dyad>(d, u));
}

/// Dyads in general position, flat, of no base, out of reach, nearly flat, tiny and with NaN.
void print_dyads() {
  for (int number = 1; number <= 9; ++number) {
    const double first = 0.7 + 0.13 * number;
    print_dyad("dyad", number, first, 2.5, 3);
    print_dyad("flat dyad", number, first, 3 - first, 3);
    print_dyad("dyad of no base", number, first, first, 0);
    print_dyad("dyad out of reach", number, first, 2, 5);
    print_dyad("nearly flat dyad", number, first, 2.5, (first + 2.5) * (1 - 1e-13 * number));
    print_dyad("short dyad", number, first * 0x1p-1010, 2.5 * 0x1p-1010, 3 * 0x1p-1010);
  }
  print_dyad("spoilt dyad", 0, spoilt, 2, 3);
  print_dyad("spoilt base of a dyad", 0, 1, 2, spoilt);
}

#ifdef ASSUR_WHOLE_ANSWERS
using Tetrad = assur::tetrad::Model01;

/// Numbers from a fixed seed, in [-2, 2].
double next_number(unsigned& seed) {
  seed = seed * 1664525U + 1013904223U;
  return 4.0 * (seed >> 8U) / 0x1p24 - 2;
}

void print_tetrads() {
  unsigned seed = 17;
  for (int number = 0; number < 100; ++number) {
    Tetrad::Dimensions<double> d;
    Tetrad::Inputs<double> u{};
    std::apply([&](auto&... member) { ((member = next_number(seed)), ...); }, d.members());
    std::apply([&](auto&... member) { ((member = next_number(seed)), ...); }, u.members());
    print<Tetrad>("tetrad", number, assur::assemblies<Tetrad>(d, u));
    // With two joints of a link in one place.
    std::get<0>(d.members()) = 0;
    print<Tetrad>("folded tetrad", number, assur::assemblies<Tetrad>(d, u));
  }
}

/// A parallelogram, through its flat positions.
void print_solver() {
  using Solver = assur::scenes::FourBar;
  Solver::Drivers<double> drivers;
  std::array<Solver::State<double>, Solver::max_configurations> states;
  const auto print_at = [&](int number, double angle) {
    drivers.A.position = angle;
    const auto found = Solver::solve(drivers, states);
    std::printf("four-bar %d: %s, %d", number, word(found.status), found.count);
    for (int index = 0; index < found.count; ++index) {
      const auto& state = states[static_cast<std::size_t>(index)];
      std::printf(", %s %ld %ld", assur::to_string(state.regularity),
                  printed(state.outputs.C.position(0)), printed(state.outputs.C.position(1)));
    }
    std::printf("\n");
    auto branch = Solver::branch(drivers, 0);
    drivers.A.position = angle + 0.1;
    Solver::State<double> state{};
    const auto way = Solver::track(drivers, branch, state);
    if (way.status == assur::Status::unsound_arithmetic) {
      std::printf("branch %d: unsound\n", number);
    } else if (way.status == assur::Status::singular ||
               way.status == assur::Status::no_convergence) {
      // At a change point the last digit decides which of the two it is.
      std::printf("branch %d: not followed, %ld\n", number, printed(way.reached));
    } else {
      std::printf("branch %d: %s, %ld\n", number, assur::to_string(way.status),
                  printed(way.reached));
    }
  };
  for (int number = 0; number < 24; ++number) {
    print_at(number, 0.2617993877991494 * number);
  }
  print_at(24, spoilt);
}

/// Closures that a user has typed: the same four-bar.
void print_closures() {
  using Closures = assur::closures::FourBar;
  Closures::Dimensions<double> d;
  Closures::Inputs<double> u;
  Closures::Configuration<double> q;
  d.l1 = d.l3 = 2;
  d.l2 = d.x = 5;
  q.phi2 = {1, 0};
  assur::Vector<double, 1> rate(1.0);
  assur::Vector<double, 1> second_rate(0.0);
  for (int number = 0; number < 24; ++number) {
    const double angle = number < 23 ? 0.2617993877991494 * number + 0.1 : double(spoilt);
    u.phi1 = q.phi3 = {std::cos(angle), std::sin(angle)};
    assur::Motion<Closures, double> moving;
    const auto status = assur::motion<Closures, double>(d, u, q, rate, second_rate, moving);
    if (status == assur::Status::unsound_arithmetic) {
      std::printf("closures %d: unsound\n", number);
    } else {
      std::printf("closures %d: %s", number, assur::to_string(status));
      if (assur::is_solvable(status)) {
        std::printf(", %ld %ld", printed(moving.velocity(0)), printed(moving.velocity(1)));
      }
      std::printf("\n");
    }
  }
}
#endif

}  // namespace

int main(int count, char** arguments) {
  const char* setting = count > 1 ? arguments[1] : "";
#ifdef __SSE2__
  constexpr unsigned flush_to_zero = 0x8000;
  constexpr unsigned denormals_are_zero = 0x0040;
  if (std::strcmp(setting, "flush") == 0) {
    _mm_setcsr(_mm_getcsr() | flush_to_zero | denormals_are_zero);
  }
#endif
  if (std::strcmp(setting, "upward") == 0) {
    std::fesetround(FE_UPWARD);
  } else if (std::strcmp(setting, "downward") == 0) {
    std::fesetround(FE_DOWNWARD);
  } else if (std::strcmp(setting, "towardzero") == 0) {
    std::fesetround(FE_TOWARDZERO);
  }
  print_dyads();
#ifdef ASSUR_WHOLE_ANSWERS
  print_tetrads();
  print_solver();
  print_closures();
#endif
  return 0;
}
