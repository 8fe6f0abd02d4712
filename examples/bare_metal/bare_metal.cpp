// The coupler point of a four-bar on a microcontroller: every configuration once, then one branch
// around a whole turn of the crank.
#include <array>
#include <assur/scenes/four_bar_coupler_curve.hpp>
#include <cmath>

#include "semihosting.hpp"

namespace {

/// Writes lines of text, with numbers in thousandths, without an operating system.
class Console {
 public:
  Console& operator<<(const char* text) {
    std::size_t size = 0;
    while (text[size] != '\0') {
      ++size;
    }
    semihosting::write(file_, text, size);
    return *this;
  }
  Console& operator<<(double number) {
    std::array<char, 24> text{};  // the last character stays zero
    char* at = &text.back();
    auto left = static_cast<long>(std::lround(std::abs(number) * 1000));
    for (int digit = 0; digit < 4 || left > 0; ++digit, left /= 10) {
      if (digit == 3) {
        *--at = '.';
      }
      *--at = static_cast<char>('0' + left % 10);
    }
    return *this << (number < 0 ? "-" : "") << at;
  }

 private:
  std::uintptr_t file_ = semihosting::console(true);
};

}  // namespace

int main() {
  using Solver = assur::scenes::FourBarCouplerCurve;
  Console console;
  Solver::Drivers<double> drivers;
  std::array<Solver::State<double>, Solver::max_configurations> states;
  const auto solution = Solver::solve(drivers, states);
  for (int index = 0; index < solution.count; ++index) {
    const auto& P = states[static_cast<std::size_t>(index)].outputs.P.position;
    console << "configuration: P at " << P(0) << ", " << P(1) << "\n";
  }
  auto branch = Solver::branch(drivers, 0);
  Solver::State<double> state;
  for (int step = 0; step < 12; ++step) {
    drivers.A.position += 0.5235987755982988;
    if (!assur::is_solvable(Solver::track(drivers, branch, state).status)) {
      return 1;
    }
    console << "followed: P at " << state.outputs.P.position(0) << ", "
            << state.outputs.P.position(1) << "\n";
  }
  // After a whole turn the branch is where it began.
  const auto& P = states[0].outputs.P.position;
  return solution.count == 2 && std::abs(state.outputs.P.position(0) - P(0)) < 1e-9 ? 0 : 1;
}
