// Prints the torque at the crank of the loaded four-bar, and the force in its pin C, as the crank
// turns.
#include <array>
#include <assur/scenes/four_bar_forces.hpp>
#include <cstdio>

int main() {
  using Solver = assur::scenes::FourBarForces;
  Solver::Drivers<double> drivers;  // the crank as it is drawn, at 10 radians per second
  std::array<Solver::State<double>, Solver::max_configurations> states;
  const Solver::Solution found = Solver::solve(drivers, states);
  const int drawn = Solver::nearest(found, states).configuration;
  Solver::Branch branch = Solver::branch(drivers, drawn);
  Solver::State<double> state = states[static_cast<std::size_t>(drawn)];
  for (int step = 0; step < 4; ++step) {
    std::printf("torque %8.4f, C %8.4f %8.4f\n", state.efforts.A, state.forces.C(0),
                state.forces.C(1));
    drivers.A.position += 0.2;
    if (Solver::track(drivers, branch, state).status != assur::Status::ok) {
      return 1;
    }
  }
}
