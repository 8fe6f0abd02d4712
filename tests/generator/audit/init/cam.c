#include <math.h>
static double square(double x) { return x * x; }
double lift(double e, double r, double d, double th) {
  return e * cos(th) + sqrt(square(r) - square(e * sin(th))) - d;
}
double dlift(double e, double r, double d, double th) {
  (void)d;
  return -e * sin(th) - e * e * sin(th) * cos(th) / sqrt(square(r) - square(e * sin(th)));
}
