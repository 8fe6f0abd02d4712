// Uses the solver of a four-bar in C: of its two configurations one is a parallelogram, in which C
// moves as B does, and a branch of it stays one.
#include <assur/scenes/four_bar.h>
#include <math.h>
#include <stdio.h>

static int is_parallelogram(const four_bar_state* state, double angle) {
  const double* C = state->outputs.C.position;
  printf("C at %.12f, %.12f\n", C[0], C[1]);
  return fabs(C[0] - 5 - 2 * cos(angle)) < 1e-12 && fabs(C[1] - 2 * sin(angle)) < 1e-12;
}

int main(void) {
  four_bar_drivers drivers;
  four_bar_defaults(&drivers);
  drivers.A.position = 0.7;
  four_bar_solution found;
  if (four_bar_solve(&drivers, &found) != four_bar_status_ok || found.count != 2) {
    return 1;
  }
  const int number = is_parallelogram(&found.states[1], 0.7);
  if (!is_parallelogram(&found.states[number], 0.7)) {
    return 2;
  }
  four_bar_branch branch;
  four_bar_state state;
  four_bar_way way;
  if (four_bar_begin(&drivers, number, &branch) != four_bar_status_ok) {
    return 3;
  }
  drivers.A.position = 0.9;
  if (four_bar_track(&drivers, &branch, &state, &way) != four_bar_status_ok || way.reached < 1 ||
      !is_parallelogram(&state, 0.9)) {
    return 4;
  }
  four_bar_branch none;
  return four_bar_begin(&drivers, 2, &none) == four_bar_status_no_convergence ? 0 : 5;
}
