// Fits the lengths of a four-bar to measured points of its coupler curve.
#include <Eigen/QR>
#include <array>
#include <assur/scenes/measured_four_bar.hpp>
#include <cmath>
#include <cstdio>

using FourBar = assur::scenes::MeasuredFourBar;
constexpr int lengths = FourBar::parameter_count;

/// A crank angle in degrees, and the measured position of the coupler point P in millimetres.
struct Measurement {
  double angle, x, y;
};

/// From a four-bar of 80.35, 40.12, 99.71, 100.42 and 200.90 mm, with an error of 0.05 mm.
constexpr std::array<Measurement, 16> measured{{
    {5.0, 94.22, 196.94},
    {27.5, 152.70, 181.67},
    {50.0, 172.81, 167.74},
    {72.5, 169.97, 162.45},
    {95.0, 156.36, 161.57},
    {117.5, 137.88, 161.61},
    {140.0, 117.30, 161.46},
    {162.5, 96.40, 161.07},
    {185.0, 75.41, 160.97},
    {207.5, 54.28, 161.14},
    {230.0, 33.09, 161.32},
    {252.5, 12.89, 161.03},
    {275.0, -4.39, 160.85},
    {297.5, -14.90, 162.55},
    {320.0, -10.86, 170.77},
    {342.5, 23.29, 188.25},
}};
constexpr auto rows = static_cast<int>(2 * measured.size());

/// The residuals at the lengths, point by point, and their derivatives with respect to them.
struct Misfit {
  Eigen::Matrix<double, rows, 1> left;
  Eigen::Matrix<double, rows, lengths> slope;
};

/// False where the four-bar does not reach the crank angle of some point.
bool evaluate(const FourBar::Parameters<double>& parameters, Misfit& misfit) {
  int row = 0;
  for (const Measurement& point : measured) {
    FourBar::Drivers<double> drivers;
    drivers.A.position = point.angle * std::acos(-1.0) / 180;
    std::array<FourBar::State<double>, FourBar::max_configurations> states;
    const FourBar::Solution found = FourBar::solve(drivers, parameters, states);
    if (found.count == 0) {
      return false;
    }
    // The configuration that drew the point is the one closer to it.
    const Eigen::Vector2d place(point.x, point.y);
    const auto distance = [&](const FourBar::State<double>& state) {
      return (state.outputs.P.position - place).norm();
    };
    const auto& nearest =
        found.count > 1 && distance(states[1]) < distance(states[0]) ? states[1] : states[0];
    misfit.left.segment<2>(row) = nearest.outputs.P.position - place;
    misfit.slope.middleRows<2>(row) = nearest.outputs.P.sensitivity;
    row += 2;
  }
  return true;
}

int main() {
  FourBar::Parameters<double> parameters;  // as the scene has them
  std::printf("step  rms error");
  for (const char* name : FourBar::parameters) {
    std::printf("  %8s", name);
  }
  std::printf("\n");
  for (int step = 0; step < 10; ++step) {
    Misfit misfit;
    if (!evaluate(parameters, misfit)) {
      std::printf("the four-bar does not reach its crank angles\n");
      return 1;
    }
    std::printf("%4d  %9.4f", step, std::sqrt(misfit.left.squaredNorm() / rows));
    for (const double* length : parameters.values()) {
      std::printf("  %8.3f", *length);
    }
    std::printf("\n");
    // Gauss-Newton: the lengths that are optimal if points depend linearly on them.
    const Eigen::Matrix<double, lengths, 1> change =
        misfit.slope.colPivHouseholderQr().solve(-misfit.left);
    int place = 0;
    for (double* length : parameters.values()) {
      *length += change(place++);
    }
    if (change.norm() < 1e-6) {
      std::printf("settled\n");
      return 0;
    }
  }
  return 1;
}
