// Automatic differentiation by Ceres Solver's Jet, with LU, as entries of the derivative tasks.
#include <ceres/jet.h>

#include <array>

#include "derivatives/derivative_methods.hpp"
#include "derivatives/solve_closure.hpp"

namespace assur::speed {

namespace {

using Sample = TetradSample<double>;

/// The Jet of a direction whose angle is slot `first`; no trigonometric function is evaluated.
template <typename Jet>
Direction<Jet> turning(const Direction<double>& direction, int slot) {
  Direction<Jet> result{Jet(direction.cos), Jet(direction.sin)};
  result.cos.v(slot) = -direction.sin;
  result.sin.v(slot) = direction.cos;
  return result;
}

template <typename Jet, typename To, typename From, typename Fill>
To filled(const From& from, Fill fill) {
  To result;
  int index = 0;
  std::apply(
      [&](const auto&... source) {
        std::apply([&](auto&... target) { ((target = fill(source, index++)), ...); },
                   result.members());
      },
      from.members());
  return result;
}

/// A direction from its angle, as a user of Ceres writes it.
template <typename Jet>
Direction<Jet> from_angle(double theta, int slot) {
  const Jet angle(theta, slot);
  return {cos(angle), sin(angle)};
}

template <typename Jet, bool from_angles>
Model01::Configuration<Jet> directions(const Sample& sample) {
  return filled<Jet, Model01::Configuration<Jet>>(
      sample.g.q, [&](const Direction<double>& value, int index) {
        if constexpr (from_angles) {
          return from_angle<Jet>(sample.theta(index), index);
        } else {
          return turning<Jet>(value, index);
        }
      });
}

/// f and its derivatives to the first `Slots` of unknowns, dimensions and inputs.
template <int Slots, bool from_angles = false>
Vector<ceres::Jet<double, Slots>, 4> closure(const Sample& sample) {
  using Jet = ceres::Jet<double, Slots>;
  const auto length = [](int first) {
    return [first](double value, int index) {
      return Slots > first ? Jet(value, first + index) : Jet(value);
    };
  };
  Vector<Jet, 4> f;
  Model01::residual(filled<Jet, Model01::Dimensions<Jet>>(sample.g.d, length(4)),
                    filled<Jet, Model01::Inputs<Jet>>(sample.g.u, length(12)),
                    directions<Jet, from_angles>(sample), f);
  return f;
}

template <bool from_angles = false>
ClosureAnswer<double> closure_jacobians(const Sample& sample) {
  const auto f = closure<16, from_angles>(sample);
  ClosureAnswer<double> answer;
  for (int row = 0; row < 4; ++row) {
    answer.by_unknowns.row(row) = f(row).v.template head<4>().transpose();
    answer.by_dimensions.row(row) = f(row).v.template segment<8>(4).transpose();
    answer.by_inputs.row(row) = f(row).v.template tail<4>().transpose();
  }
  return answer;
}

/// d2f/dt2 with the second rates of the unknowns left out: Jets of Jets in time. The closures are
/// linear in the links' vectors, so each vector is differentiated by itself.
Eigen::Vector4d second_derivative(const Sample& sample, const Eigen::Vector4d& velocity) {
  using Inner = ceres::Jet<double, 1>;
  using Jet = ceres::Jet<Inner, 1>;
  struct Turning {
    Jet cos, sin;
  };
  const auto moving = [](double value, double rate, double second_rate) {
    Jet result;
    result.a = Inner(value);
    result.a.v(0) = rate;
    result.v(0) = Inner(rate);
    result.v(0).v(0) = second_rate;
    return result;
  };
  const auto turning_link = [&](const Direction<double>& at, double w) {
    return Turning{moving(at.cos, -at.sin * w, -at.cos * w * w),
                   moving(at.sin, at.cos * w, -at.sin * w * w)};
  };
  const auto& d = sample.g.d;
  const auto& q = sample.g.q;
  const auto& v = sample.g.u_rate;
  const auto& a = sample.g.u_second_rate;
  const Turning BCG = turning_link(q.theta_BCG, velocity(0));
  const Turning EDF = turning_link(q.theta_EDF, velocity(1));
  const Turning CD = turning_link(q.theta_CD, velocity(2));
  const Turning GF = turning_link(q.theta_GF, velocity(3));
  const auto length = [](double value) { return Inner(value); };
  const Jet x = moving(sample.g.u.x_B - sample.g.u.x_E, v(0) - v(2), a(0) - a(2));
  const Jet y = moving(sample.g.u.y_B - sample.g.u.y_E, v(1) - v(3), a(1) - a(3));
  const std::array<Jet, 4> f = {
      x + BCG.cos * length(d.BC) + CD.cos * length(d.CD) - EDF.cos * length(d.ED),
      y + BCG.sin * length(d.BC) + CD.sin * length(d.CD) - EDF.sin * length(d.ED),
      x + BCG.cos * length(d.x_G_BCG) - BCG.sin * length(d.y_G_BCG) + GF.cos * length(d.GF) -
          EDF.cos * length(d.x_F_EDF) + EDF.sin * length(d.y_F_EDF),
      y + BCG.sin * length(d.x_G_BCG) + BCG.cos * length(d.y_G_BCG) + GF.sin * length(d.GF) -
          EDF.sin * length(d.x_F_EDF) - EDF.cos * length(d.y_F_EDF)};
  return {f[0].v(0).v(0), f[1].v(0).v(0), f[2].v(0).v(0), f[3].v(0).v(0)};
}

template <bool from_angles = false>
JacobianAnswer<double> jacobian(const Sample& sample) {
  const auto f = closure<4, from_angles>(sample);
  JacobianAnswer<double> answer;
  for (int row = 0; row < 4; ++row) {
    answer.by_unknowns.row(row) = f(row).v.transpose();
  }
  return answer;
}

/// Slots 0 to 3 are the unknowns', slot 4 is time's.
template <bool from_angles = false>
MotionAnswer<double> motion(const Sample& sample) {
  using Jet = ceres::Jet<double, 5>;
  const auto& g = sample.g;
  Vector<Jet, 4> f;
  Model01::residual(
      filled<Jet, Model01::Dimensions<Jet>>(g.d, [](double value, int) { return Jet(value); }),
      filled<Jet, Model01::Inputs<Jet>>(g.u,
                                        [&](double value, int index) {
                                          Jet jet(value);
                                          jet.v(4) = g.u_rate(index);
                                          return jet;
                                        }),
      directions<Jet, from_angles>(sample), f);
  Eigen::Matrix4d J;
  Eigen::Vector4d first;
  for (int row = 0; row < 4; ++row) {
    J.row(row) = f(row).v.template head<4>().transpose();
    first(row) = f(row).v(4);
  }
  return solved_motion<double>(
      J, first, [&](const Eigen::Vector4d& w) { return second_derivative(sample, w); });
}

template <bool from_angles = false>
DerivativesAnswer<double> derivatives(const Sample& sample) {
  return solved<double>(closure_jacobians<from_angles>(sample), sample.g.u_rate,
                        [&](const Eigen::Vector4d& w) { return second_derivative(sample, w); });
}

}  // namespace

void add_ceres_jet(DerivativeTask& task, Wanted wanted) {
  const char* given = "Ceres Jet";
  const char* angles = "Ceres Jet from angles";
  const char* given_and_lu = "Ceres Jet + LU";
  const char* angles_and_lu = "Ceres Jet from angles + LU";
  // Functions as lambdas, so that each is inlined into its own loop.
  switch (wanted) {
    case Wanted::jacobian:
      task.add<double>(given, "double", [](const Sample& sample) { return jacobian(sample); });
      task.add<double>(angles, "double",
                       [](const Sample& sample) { return jacobian<true>(sample); });
      return;
    case Wanted::closure:
      task.add<double>(given, "double",
                       [](const Sample& sample) { return closure_jacobians(sample); });
      task.add<double>(angles, "double",
                       [](const Sample& sample) { return closure_jacobians<true>(sample); });
      return;
    case Wanted::motion:
      task.add<double>(given_and_lu, "double", [](const Sample& sample) { return motion(sample); });
      task.add<double>(angles_and_lu, "double",
                       [](const Sample& sample) { return motion<true>(sample); });
      return;
    case Wanted::derivatives:
      task.add<double>(given_and_lu, "double",
                       [](const Sample& sample) { return derivatives(sample); });
      task.add<double>(angles_and_lu, "double",
                       [](const Sample& sample) { return derivatives<true>(sample); });
      return;
  }
}

}  // namespace assur::speed
