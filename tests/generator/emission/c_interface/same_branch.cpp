// Follows a branch by a solver's C functions and by its C++ ones; after every step all numbers must
// be the same.
#include ASSUR_C_HEADER
#include ASSUR_CPP_HEADER

#include <assur/support/flat_branch.hpp>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

#define ASSUR_JOIN_NOW(prefix, name) prefix##name
#define ASSUR_JOIN(prefix, name) ASSUR_JOIN_NOW(prefix, name)
#define ASSUR_C(name) ASSUR_JOIN(ASSUR_PREFIX, name)

namespace {

using Solver = assur::scenes::ASSUR_SOLVER;
using Flat = assur::support::FlatBranch<Solver, double>;

/// Both kinds of arguments, which hold the same numbers.
struct Given {
  ASSUR_C(drivers) drivers;
  Solver::Drivers<double> cpp_drivers;
#if ASSUR_HAS_PARAMETERS
  ASSUR_C(parameters) parameters;
  Solver::Parameters<double> cpp_parameters;
#endif

  Given() {
#if ASSUR_HAS_PARAMETERS
    ASSUR_C(defaults)(&drivers, &parameters);
#else
    ASSUR_C(defaults)(&drivers);
#endif
  }
  void move(double by) {
    for (double* position : cpp_drivers.positions()) {
      *position += by;
    }
    std::memcpy(static_cast<void*>(&drivers), &cpp_drivers, sizeof(drivers));
  }
};
static_assert(sizeof(Given::drivers) == sizeof(Given::cpp_drivers), "drivers are plain numbers");

#if ASSUR_HAS_PARAMETERS
#define ASSUR_C_GIVEN(given) &(given).drivers, &(given).parameters
#define ASSUR_CPP_GIVEN(given) (given).cpp_drivers, (given).cpp_parameters
#else
#define ASSUR_C_GIVEN(given) &(given).drivers
#define ASSUR_CPP_GIVEN(given) (given).cpp_drivers
#endif

int differences = 0;
void expect(bool holds, const char* what) {
  if (!holds) {
    std::printf("differs: %s\n", what);
    ++differences;
  }
}

}  // namespace

int main() {
  Given given;
  ASSUR_C(branch) branch;
  ASSUR_C(state) state;
  ASSUR_C(way) way;
  expect(ASSUR_C(begin)(ASSUR_C_GIVEN(given), -1, &branch) == ASSUR_C(status_no_convergence),
         "a branch of number -1");
  int steps = 0;
  for (int configuration = 0; configuration < Solver::max_configurations; ++configuration) {
    given.cpp_drivers = {};
    given.move(0);
    auto cpp_branch = Solver::branch(ASSUR_CPP_GIVEN(given), configuration);
    const bool begins = assur::is_solvable(cpp_branch.status);
    expect((ASSUR_C(begin)(ASSUR_C_GIVEN(given), configuration, &branch) <=
            ASSUR_C(status_near_singular)) == begins,
           "whether there is a branch");
    while (begins && steps++ % 20 != 19) {
      given.move(0.03);
      Solver::State<double> cpp_state;
      const auto cpp_way = Solver::track(ASSUR_CPP_GIVEN(given), cpp_branch, cpp_state);
      const auto status = ASSUR_C(track)(ASSUR_C_GIVEN(given), &branch, &state, &way);
      std::array<double, Flat::size> numbers{};
      Flat::flatten(cpp_branch, numbers.data());
      expect(std::memcmp(numbers.data(), branch.numbers, sizeof(branch.numbers)) == 0, "numbers");
      expect((status <= ASSUR_C(status_near_singular)) == assur::is_solvable(cpp_way.status),
             "status");
      expect(way.reached == cpp_way.reached, "reached");
      if (!assur::is_solvable(cpp_way.status)) {
        break;
      }
    }
  }
  given.cpp_drivers.positions()[0][0] = std::numeric_limits<double>::quiet_NaN();
  given.move(0);
  static ASSUR_C(solution) solution;
  expect(ASSUR_C(solve)(ASSUR_C_GIVEN(given), &solution) == ASSUR_C(status_not_finite), "NaN");
  expect(ASSUR_C(begin)(ASSUR_C_GIVEN(given), 0, &branch) == ASSUR_C(status_not_finite),
         "a branch from NaN");
  std::printf("%d steps of branches, %d differences\n", steps, differences);
  return differences == 0 && steps > 0 ? 0 : 1;
}
