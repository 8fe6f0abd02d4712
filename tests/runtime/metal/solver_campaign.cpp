// Largest number of instructions and deepest stack of `solve` and `track` of an emitted solver,
// ASSUR_SOLVER, over random positions of the drivers and multiples of 15 degrees, at which links
// are collinear.
#include ASSUR_HEADER
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "board.hpp"

namespace {

using Solver = assur::scenes::ASSUR_SOLVER;
using Drivers = Solver::Drivers<double>;
constexpr int random_places = 500, places_in_line = 24;

/// The same numbers on every machine, from 0 to 1.
class Random {
 public:
  double next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state_ >> 40U) * 0x1p-24;
  }

 private:
  std::uint64_t state_ = 57721;
};

/// What one function took at most.
struct Cost {
  double instructions = 0, stack = 0;

  template <typename Function>
  void measure(const Function& function) {
    board::paint_stack();
    board::start_counting();
    function();
    const auto taken = static_cast<double>(board::instructions());
    instructions = (std::max)(instructions, taken);
    stack = (std::max)(stack, static_cast<double>(board::painted_over()));
  }
};

void place(int number, Random& random, Drivers& drivers) {
  drivers = {};
  std::size_t index = 0;
  for (double* position : drivers.positions()) {
    const double part = random.next();
    if (index++ >= assur::support::Access<Solver, double>::turning_drivers) {
      *position *= 0.9 + 0.2 * part;
    } else if (number < random_places) {
      *position = 6.283185307179586 * part;
    } else {
      *position = (number - random_places) * (6.283185307179586 / places_in_line);
    }
  }
}

}  // namespace

int main() {
  std::array<Solver::State<double>, Solver::max_configurations> states;
  Solver::State<double> state;
  Solver::Branch branch;
  Drivers drivers;
  Random random;
  Cost solving;
  Cost tracking;
  double configurations = 0;
  double followed = 0;
  for (int number = 0; number < random_places + places_in_line; ++number) {
    place(number, random, drivers);
    int count = 0;
    solving.measure([&] { count = Solver::solve(drivers, states).count; });
    configurations += count;
    branch = Solver::branch(drivers, 0);
    for (double* position : drivers.positions()) {
      *position *= 1.001;
    }
    bool reached = false;
    tracking.measure(
        [&] { reached = assur::is_solvable(Solver::track(drivers, branch, state).status); });
    followed += reached ? 1 : 0;
  }
  const std::array<double, 7> answer = {
      random_places + places_in_line, configurations, followed, solving.instructions, solving.stack,
      tracking.instructions,          tracking.stack};
  board::write(answer.data(), sizeof(answer));
  return 0;
}
