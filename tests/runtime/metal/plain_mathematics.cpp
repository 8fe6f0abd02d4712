// Mathematical functions that the runtime calls and that libraries round differently, by products,
// sums, quotients and square roots alone. They give the same bits on every machine, so that any
// difference between machines is in the rest of the code.

extern "C" {

double sqrt(double);
double ldexp(double, int);
int ilogb(double);

namespace {

constexpr double half_pi = 1.5707963267948966, half_pi_rest = 6.123233995736766e-17;

double absolute(double x) { return x < 0 ? -x : x; }

/// Sine (first = 1) or cosine (first = 0) by its series, for angles up to 45 degrees.
double series(double x, int first) {
  double term = first == 1 ? x : 1;
  double sum = 0;
  for (int order = first; order < first + 22; order += 2) {
    sum += term;
    term *= -x * x / ((order + 1) * (order + 2));
  }
  return sum;
}

/// The cosine of the angle x and `quarters` quarter turns.
double turned_cosine(double x, int quarters) {
  const double whole = x / half_pi;
  const auto nearest = static_cast<long long>(whole < 0 ? whole - 0.5 : whole + 0.5);
  const auto times = static_cast<double>(nearest);
  const double rest = (x - times * half_pi) - times * half_pi_rest;
  const auto quarter = static_cast<unsigned>((nearest + quarters) & 3);
  const double value = series(rest, static_cast<int>(quarter & 1U));
  return quarter == 1 || quarter == 2 ? -value : value;
}

}  // namespace

double cos(double x) { return turned_cosine(x, 0); }
double sin(double x) { return turned_cosine(x, 3); }
void sincos(double x, double* sine, double* cosine) {
  *sine = sin(x);
  *cosine = cos(x);
}

double atan(double x) {
  if (absolute(x) > 1) {
    return (x < 0 ? -half_pi : half_pi) - atan(1 / x);
  }
  double part = x;
  for (int halving = 0; halving < 3; ++halving) {
    part /= 1 + sqrt(1 + part * part);
  }
  double power = part;
  double sum = 0;
  for (int order = 1; order < 20; order += 2) {
    sum += power / order;
    power *= -part * part;
  }
  return 8 * sum;
}

double atan2(double y, double x) {
  if (x == 0 && y == 0) {
    return 0;
  }
  if (absolute(y) > absolute(x)) {
    return (y < 0 ? -half_pi : half_pi) - atan(x / y);
  }
  return atan(y / x) + (x > 0 ? 0 : y < 0 ? -2 * half_pi : 2 * half_pi);
}

double acos(double x) { return 2 * atan2(sqrt(1 - x), sqrt(1 + x)); }

double hypot(double x, double y) {
  const double larger = absolute(x) > absolute(y) ? absolute(x) : absolute(y);
  const double ratio = larger == 0 ? 0 : (absolute(x) > absolute(y) ? y : x) / larger;
  return larger * sqrt(1 + ratio * ratio);
}

/// The power of a number that is not negative.
double pow(double x, double y) {
  if (x == 0 || x - x != 0) {
    return y == 0 ? 1 : x;
  }
  const int exponent = ilogb(x);
  const double mantissa = ldexp(x, -exponent);
  const double ratio = (mantissa - 1) / (mantissa + 1);
  double power = 2 * ratio;
  double logarithm = 0;
  for (int order = 1; order < 40; order += 2) {
    logarithm += power / order;
    power *= ratio * ratio;
  }
  constexpr double log_2 = 0.6931471805599453;
  const double wanted = y * (exponent * log_2 + logarithm);
  const auto doublings = static_cast<int>(wanted / log_2);
  const double rest = wanted - doublings * log_2;
  double term = 1;
  double sum = 0;
  for (int order = 1; order < 24; ++order) {
    sum += term;
    term *= rest / order;
  }
  return ldexp(sum, doublings);
}

// The functions of float are those of double, rounded.
float cosf(float x) { return static_cast<float>(cos(static_cast<double>(x))); }
float sinf(float x) { return static_cast<float>(sin(static_cast<double>(x))); }
void sincosf(float x, float* sine, float* cosine) {
  *sine = sinf(x);
  *cosine = cosf(x);
}
float atanf(float x) { return static_cast<float>(atan(static_cast<double>(x))); }
float atan2f(float y, float x) {
  return static_cast<float>(atan2(static_cast<double>(y), static_cast<double>(x)));
}
float acosf(float x) { return static_cast<float>(acos(static_cast<double>(x))); }
float hypotf(float x, float y) {
  return static_cast<float>(hypot(static_cast<double>(x), static_cast<double>(y)));
}
float powf(float x, float y) {
  return static_cast<float>(pow(static_cast<double>(x), static_cast<double>(y)));
}
}
