// Calls an emitted solver, ASSUR_SOLVER, with numbers unknown to the compiler, so that the linked
// program holds all of it.
#include ASSUR_HEADER
#include <array>
#include <cstddef>

namespace {
volatile double given;
volatile unsigned char result;
volatile int word;

template <typename State>
void use(const State& state) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(&state);
  for (std::size_t place = 0; place < sizeof(State); ++place) {
    result = bytes[place];
  }
}
}  // namespace

int main() {
  using Solver = assur::scenes::ASSUR_SOLVER;
  Solver::Drivers<double> drivers;
  for (double* position : drivers.positions()) {
    *position = given;
  }
  std::array<Solver::State<double>, Solver::max_configurations> states;
  word = Solver::solve(drivers, states).count;
  use(states);
  auto branch = Solver::branch(drivers, 0);
  for (double* position : drivers.positions()) {
    *position = given;
  }
  word = static_cast<int>(Solver::track(drivers, branch, states[0]).status);
  use(states[0]);
}
