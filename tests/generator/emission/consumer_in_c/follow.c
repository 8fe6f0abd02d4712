// Follows the parallelogram branch of a four-bar over its change points, point by point and as a
// batch. On it C moves as B does; the other configuration is crossed.
#include <assur/scenes/four_bar.h>
#include <math.h>
#include <stdio.h>

enum { places = 200, bad = 50 };

static int is_parallelogram(const four_bar_state* state, double angle) {
  const double rounding = sizeof(REAL) == sizeof(double) ? 1e-9 : 1e-4;
  const REAL* C = state->outputs.C.position;
  return fabs(C[0] - 5 - 2 * cos(angle)) < rounding && fabs(C[1] - 2 * sin(angle)) < rounding;
}

int main(void) {
  four_bar_drivers drivers;
  four_bar_defaults(&drivers);
  drivers.A.position = (REAL)0.7;
  four_bar_solution found;
  if (four_bar_solve(&drivers, &found) != four_bar_status_ok || found.count != 2) {
    return 1;
  }
  // The order of states is that of one angle, so the state itself says which it is.
  const int number = is_parallelogram(&found.states[1], drivers.A.position);
  if (!is_parallelogram(&found.states[number], drivers.A.position)) {
    return 2;
  }
  four_bar_branch branch;
  if (four_bar_begin(&drivers, number, &branch) != four_bar_status_ok) {
    return 3;
  }
  static four_bar_drivers all[places];
  static four_bar_state states[places];
  static four_bar_status statuses[places];
  four_bar_branch begun = branch;
  for (int place = 0; place < places; ++place) {
    drivers.A.position = (REAL)(0.7 + 0.05 * (place + 1));
    all[place] = drivers;
    four_bar_state state;
    four_bar_way way;
    const four_bar_status status = four_bar_track(&drivers, &branch, &state, &way);
    if (status > four_bar_status_near_singular || way.reached < 1 ||
        !is_parallelogram(&state, drivers.A.position)) {
      printf("place %d: status %d\n", place, (int)status);
      return 4;
    }
  }
  // A place that is no number is a gap, and the branch goes on behind it.
  all[bad].A.position = (REAL)NAN;
  if (four_bar_track_batch(places, all, &begun, states, statuses) != places - 1 ||
      statuses[bad] != four_bar_status_not_finite || !isnan(states[bad].outputs.C.position[0])) {
    return 5;
  }
  for (int place = 0; place < places; ++place) {
    if (place != bad && !is_parallelogram(&states[place], all[place].A.position)) {
      return 6;
    }
  }
  four_bar_branch none;
  return four_bar_begin(&all[0], 2, &none) == four_bar_status_no_convergence ? 0 : 7;
}
