// Includes an emitted solver after macros of common names and inside a namespace; exits with 0 if
// its answers are right.
#include <complex.h>

#include <assur/support/scene_track.hpp>
#include <functional>
#include <limits>
#undef I
#define I (0.0)
#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#define near
#define far
namespace outside {
#include <assur/scenes/scotch_yoke.hpp>
}

int main() {
  using Solver = outside::assur::scenes::ScotchYoke;
  std::array<Solver::State<double>, Solver::max_configurations> states;
  const auto solved = [&states](double position, double velocity) {
    Solver::Drivers<double> drivers;
    drivers.A.position = position;
    drivers.A.velocity = velocity;
    return Solver::solve(drivers, states);
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto found = solved(0, 3);
  // The crank of length 2 moves the pin across the yoke, which stands still for a moment.
  bool right = found.status == assur::AssemblyStatus::ok && found.count == 1 &&
               std::abs(states[0].outputs.P.position(0) - 3) < 1e-12 &&
               std::abs(states[0].outputs.P.velocity(0)) < 1e-12;
  for (const double spoilt : {infinity, nan}) {
    right = right && solved(spoilt, 3).status == assur::AssemblyStatus::not_finite &&
            solved(0, spoilt).status == assur::AssemblyStatus::not_finite;
  }
  return right ? 0 : 1;
}
