// Follows one branch of the four-bar through a turn of its crank, and prints where P is.
#include <array>
#include <assur/scenes/four_bar.hpp>
#include <cstdio>

int main() {
  using FourBar = assur::scenes::FourBar;
  FourBar::Drivers<double> drivers;  // the crank at 60 degrees, as in the scene
  std::array<FourBar::State<double>, FourBar::max_configurations> states;
  const FourBar::Solution solution = FourBar::solve(drivers, states);
  if (solution.status != assur::AssemblyStatus::ok || solution.count < 2) {
    return 1;
  }
  FourBar::Branch branch = FourBar::branch(drivers, 1);  // configuration 2 of `assur solve`
  FourBar::State<double>& state = states[1];
  for (int step = 0; step < 4; ++step) {
    drivers.A.position += 1.5707963267948966;
    if (FourBar::track(drivers, branch, state).status != assur::Status::ok) {
      return 1;
    }
    const auto& P = state.outputs.P;
    std::printf("P at %8.3f %8.3f, speed %8.1f %8.1f\n", P.position(0), P.position(1),
                P.velocity(0), P.velocity(1));
  }
}
