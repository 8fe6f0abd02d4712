// Follows the drawn branch of the four-bar as its crank turns, and prints where P is.
#include <array>
#include <assur/scenes/four_bar.hpp>
#include <cstdio>

int main() {
  using FourBar = assur::scenes::FourBar;
  FourBar::Drivers<double> drivers;  // the crank as drawn, at 90 degrees
  std::array<FourBar::State<double>, FourBar::max_configurations> states;
  const FourBar::Solution solution = FourBar::solve(drivers, states);
  if (solution.status != assur::AssemblyStatus::ok || solution.count == 0) {
    return 1;
  }
  const int drawn = FourBar::nearest(solution, states).configuration;
  FourBar::Branch branch = FourBar::branch(drivers, drawn);
  FourBar::State<double>& state = states[static_cast<std::size_t>(drawn)];
  for (int step = 0; step < 4; ++step) {
    drivers.A.position += 1.2566370614359172;
    if (FourBar::track(drivers, branch, state).status != assur::Status::ok) {
      return 1;
    }
    const auto& P = state.outputs.P;
    std::printf("P at %8.3f %8.3f, speed %8.1f %8.1f\n", P.position(0), P.position(1),
                P.velocity(0), P.velocity(1));
  }
}
