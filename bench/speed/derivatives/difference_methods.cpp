// Central differences of the closures and of whole assemblies as entries of the derivative tasks.
#include <array>
#include <cstdio>

#include "derivatives/derivative_methods.hpp"
#include "derivatives/eigen_by_hand.hpp"
#include "derivatives/solve_closure.hpp"
#include "stability/step_methods.hpp"

namespace assur::speed {

namespace {

using Sample = TetradSample<double>;

/// The unknowns, dimensions and inputs of the closures as a differencing routine takes them.
using Point = Eigen::Matrix<double, 16, 1>;

Point point_of(const Sample& sample) {
  const auto& d = sample.g.d;
  const auto& u = sample.g.u;
  Point x;
  x << sample.theta, d.BC, d.x_G_BCG, d.y_G_BCG, d.ED, d.x_F_EDF, d.y_F_EDF, d.CD, d.GF, u.x_B,
      u.y_B, u.x_E, u.y_E;
  return x;
}

Eigen::Vector4d closure(const Point& x) {
  const Model01::Dimensions<double> d = {x(4), x(5), x(6), x(7), x(8), x(9), x(10), x(11)};
  const Eigen::Vector4d c(std::cos(x(0)), std::cos(x(1)), std::cos(x(2)), std::cos(x(3)));
  const Eigen::Vector4d s(std::sin(x(0)), std::sin(x(1)), std::sin(x(2)), std::sin(x(3)));
  return HandVectors(d, c, s).closure({x(12), x(13), x(14), x(15)});
}

template <int Columns>
Eigen::Matrix<double, 4, Columns> differences(Point x, double step) {
  Eigen::Matrix<double, 4, Columns> result;
  for (int column = 0; column < Columns; ++column) {
    const double value = x(column);
    const double high = value + step;
    const double low = value - step;
    x(column) = high;
    const Eigen::Vector4d after = closure(x);
    x(column) = low;
    result.col(column) = (after - closure(x)) / (high - low);
    x(column) = value;
  }
  return result;
}

/// d2f/dt2 along q + w t, u + u' t + u'' t^2/2.
Eigen::Vector4d second_difference(const Sample& sample, const Eigen::Vector4d& velocity,
                                  double step) {
  const Point x = point_of(sample);
  const auto at = [&](double time) {
    Point moved = x;
    moved.head<4>() += time * velocity;
    moved.tail<4>() += time * sample.g.u_rate + time * time / 2 * sample.g.u_second_rate;
    return closure(moved);
  };
  return (at(step) - 2 * closure(x) + at(-step)) / (step * step);
}

ClosureAnswer<double> closure_differences(const Sample& sample, double step) {
  const Eigen::Matrix<double, 4, 16> all = differences<16>(point_of(sample), step);
  return {all.leftCols<4>(), all.middleCols<8>(4), all.rightCols<4>()};
}

void add_central(DerivativeTask& task, Wanted wanted, double step) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.0e", step);
  const std::string method = std::string("central differences, step ") + text.data();
  // Second differences are best at eps^(1/4), first ones at eps^(1/3).
  const double longer = std::pow(step, 0.75);
  switch (wanted) {
    case Wanted::jacobian:
      task.add<double>(method, "double", [step](const Sample& sample) {
        return JacobianAnswer<double>{differences<4>(point_of(sample), step)};
      });
      return;
    case Wanted::closure:
      task.add<double>(method, "double",
                       [step](const Sample& sample) { return closure_differences(sample, step); });
      return;
    case Wanted::motion:
      task.add<double>(method, "double", [step, longer](const Sample& sample) {
        const Point x = point_of(sample);
        Point after = x;
        Point before = x;
        after.tail<4>() += step * sample.g.u_rate;
        before.tail<4>() -= step * sample.g.u_rate;
        const Eigen::Vector4d first = (closure(after) - closure(before)) / (2 * step);
        return solved_motion<double>(differences<4>(x, step), first, [&](const Eigen::Vector4d& w) {
          return second_difference(sample, w, longer);
        });
      });
      return;
    case Wanted::derivatives:
      task.add<double>(method, "double", [step, longer](const Sample& sample) {
        return solved<double>(
            closure_differences(sample, step), sample.g.u_rate,
            [&](const Eigen::Vector4d& w) { return second_difference(sample, w, longer); });
      });
      return;
  }
}

}  // namespace

void add_differences(DerivativeTask& task, Wanted wanted) {
  for (const double step : {1e-3, 6e-6, 1e-8}) {
    add_central(task, wanted, step);
  }
  if (wanted == Wanted::derivatives) {
    task.add<double>("central differences of assemblies", "double",
                     by_assemblies<stability::central_differences<Model01>>);
  }
}

}  // namespace assur::speed
