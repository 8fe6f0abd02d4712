// Uses the solver of a four-bar that CMake had generated: of its two configurations one is a
// parallelogram, in which C moves as B does.
#include <assur/scenes/four_bar.hpp>
#include <cmath>
#include <cstdio>

int main() {
  using Solver = assur::scenes::FourBar;
  Solver::Drivers<double> drivers;
  drivers.A.position = 0.7;
  drivers.A.velocity = 1;
  std::array<Solver::State<double>, Solver::max_configurations> states;
  const Solver::Solution solution = Solver::solve(drivers, states);
  bool found = false;
  for (int index = 0; index < solution.count; ++index) {
    const auto& C = states[static_cast<std::size_t>(index)].outputs.C.position;
    std::printf("C at %.12f, %.12f\n", C(0), C(1));
    const auto& velocity = states[static_cast<std::size_t>(index)].outputs.C.velocity;
    found = found ||
            (std::hypot(C(0) - 5 - 2 * std::cos(0.7), C(1) - 2 * std::sin(0.7)) < 1e-12 &&
             std::hypot(velocity(0) + 2 * std::sin(0.7), velocity(1) - 2 * std::cos(0.7)) < 1e-12);
  }
  return solution.count == 2 && found ? 0 : 1;
}
