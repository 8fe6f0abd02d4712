/* Two links, each with the angle that it has to the frame. */
#include <math.h>
void fk(double a, double b, double q1, double q2, double *p) {
  p[0] = a*cos(q1) + b*cos(q2);
  p[1] = a*sin(q1) + b*sin(q2);
}
void jac(double a, double b, double q1, double q2, double J[2][2]) {
  J[0][0] = -a*sin(q1); J[0][1] = -b*sin(q2);
  J[1][0] = a*cos(q1);  J[1][1] = b*cos(q2);
}
void acc(double a, double b, double q1, double q2, double w1, double w2, double e1, double e2, double out[2]) {
  out[0] = -a*sin(q1)*e1 - a*cos(q1)*w1*w1 - b*sin(q2)*e2 - b*cos(q2)*w2*w2;
  out[1] = a*cos(q1)*e1 - a*sin(q1)*w1*w1 + b*cos(q2)*e2 - b*sin(q2)*w2*w2;
}
