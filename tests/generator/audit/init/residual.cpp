// A slider-crank: its closures, and their Jacobian by the rod's angle and the place of the slider.
#include <cmath>
struct Lengths {
  double r, l;
};
void residual(const Lengths& p, double crank, const double q[2], double f[2]) {
  f[0] = p.r * std::cos(crank) + p.l * std::cos(q[0]) - q[1];
  f[1] = p.r * std::sin(crank) + p.l * std::sin(q[0]);
}
void jacobian(const Lengths& p, double /*crank*/, const double q[2], double J[2][2]) {
  const double s = std::sin(q[0]), c = std::cos(q[0]);
  J[0][0] = -p.l * s;
  J[0][1] = -1;
  J[1][0] = p.l * c;
  J[1][1] = 0;
}
