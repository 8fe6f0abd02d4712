// Velocity and acceleration of a slider, in a namespace and by value.
#include <array>
#include <cmath>
namespace press {
using Pair = std::array<double, 2>;
double slider(double r, double l, double th) {
  const double h = r * std::sin(th);
  return r * std::cos(th) + std::sqrt(l * l - h * h);
}
double slider_velocity(double r, double l, double th, double w) {
  const double h = r * std::sin(th);
  return -w * h - w * h * r * std::cos(th) / std::sqrt(l * l - h * h);
}
std::array<double, 2> pin(double r, double th) { return {r * std::cos(th), r * std::sin(th)}; }
std::array<double, 2> pin_acceleration(double r, double th, double w, double al) {
  return {-r * std::sin(th) * al - r * std::cos(th) * w * w,
          r * std::cos(th) * al - r * std::sin(th) * w * w};
}
}  // namespace press
