// Automatic differentiation by ADOL-C as entries of the derivative tasks, in its traceless forward
// mode, which is six times faster here than its tapes.
#include <adolc/adtl.h>

#include <array>

#include "derivatives/derivative_methods.hpp"
#include "derivatives/solve_closure.hpp"

namespace assur::speed {

namespace {

using Sample = TetradSample<double>;

using Variable = adtl::adouble;

constexpr int variables = 16;  ///< unknowns (angles), inputs, dimensions, in this order

/// The group with variables that have a derivative along each direction.
struct Point {
  std::array<Variable, variables> x;

  explicit Point(const Sample& sample) {
    std::size_t index = 0;
    const auto append = [&](double value) { x[index++] = value; };
    for (const double angle : sample.theta) {
      append(angle);
    }
    std::apply([&](const auto&... member) { (append(member), ...); }, sample.g.u.members());
    std::apply([&](const auto&... member) { (append(member), ...); }, sample.g.d.members());
  }
  [[nodiscard]] Model01::Dimensions<Variable> d() const {
    return {x[8], x[9], x[10], x[11], x[12], x[13], x[14], x[15]};
  }
  [[nodiscard]] Model01::Inputs<Variable> u() const { return {x[4], x[5], x[6], x[7]}; }
  [[nodiscard]] Model01::Configuration<Variable> q() const {
    const auto direction = [](const Variable& angle) {
      return Direction<Variable>{cos(angle), sin(angle)};
    };
    return {direction(x[0]), direction(x[1]), direction(x[2]), direction(x[3])};
  }
};

/// The derivatives of f along the first directions.
template <int Columns>
Eigen::Matrix<double, 4, Columns> derivatives(const Point& at) {
  Vector<Variable, 4> f;
  Model01::residual(at.d(), at.u(), at.q(), f);
  Eigen::Matrix<double, 4, Columns> result;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < Columns; ++column) {
      result(row, column) = f(row).getADValue(static_cast<unsigned>(column));
    }
  }
  return result;
}

/// The Jacobian with respect to the first `Columns` variables.
template <int Columns>
Eigen::Matrix<double, 4, Columns> jacobian(const Sample& sample) {
  Point at(sample);
  for (unsigned index = 0; index < Columns; ++index) {
    at.x[index].setADValue(index, 1);
  }
  return derivatives<Columns>(at);
}

ClosureAnswer<double> closure(const Sample& sample) {
  const auto all = jacobian<variables>(sample);
  return {all.leftCols<4>(), all.rightCols<8>(), all.middleCols<4>(4)};
}

/// d2f/dt2 with the second rates of the unknowns left out. The traceless mode differentiates once,
/// so it is the derivative of df/dt = J w + f_u u', which is written out.
Eigen::Vector4d second_derivative(const Sample& sample, const Eigen::Vector4d& velocity) {
  Point at(sample);
  Vector<Variable, 4> u_rate;
  for (unsigned index = 0; index < 4; ++index) {
    at.x[index].setADValue(0, velocity(index));
    at.x[4 + index].setADValue(0, sample.g.u_rate(index));
    u_rate(index) = sample.g.u_rate(index);
    u_rate(index).setADValue(0, sample.g.u_second_rate(index));
  }
  const auto d = at.d();
  const auto u = at.u();
  const auto q = at.q();
  Matrix<Variable, 4, 4> J;
  Vector<Variable, 4> rhs;
  Model01::jacobian(d, u, q, J);
  Model01::velocity_rhs(d, u, q, u_rate, rhs);
  Eigen::Vector4d result;
  for (int row = 0; row < 4; ++row) {
    result(row) = -rhs(row).getADValue(0);
    for (int column = 0; column < 4; ++column) {
      result(row) += J(row, column).getADValue(0) * velocity(column);
    }
  }
  return result;
}

/// J and df/dt with the unknowns held: five directions.
MotionAnswer<double> motion(const Sample& sample) {
  Point at(sample);
  for (unsigned index = 0; index < 4; ++index) {
    at.x[index].setADValue(index, 1);
    at.x[4 + index].setADValue(4, sample.g.u_rate(index));
  }
  const auto f = derivatives<5>(at);
  return solved_motion<double>(f.leftCols<4>(), f.col(4), [&](const Eigen::Vector4d& w) {
    return second_derivative(sample, w);
  });
}

}  // namespace

void add_adol_c(DerivativeTask& task, Wanted wanted) {
  // The number of directions holds for the whole program and is set before its first variable.
  static const bool set = (adtl::setNumDir(variables), true);
  (void)set;
  switch (wanted) {
    case Wanted::jacobian:
      task.add<double>("ADOL-C", "double", [](const Sample& sample) {
        return JacobianAnswer<double>{jacobian<4>(sample)};
      });
      return;
    case Wanted::closure:
      task.add<double>("ADOL-C", "double", [](const Sample& sample) { return closure(sample); });
      return;
    case Wanted::motion:
      task.add<double>("ADOL-C + LU", "double",
                       [](const Sample& sample) { return motion(sample); });
      return;
    case Wanted::derivatives:
      task.add<double>("ADOL-C + LU", "double", [](const Sample& sample) {
        return solved<double>(closure(sample), sample.g.u_rate, [&](const Eigen::Vector4d& w) {
          return second_derivative(sample, w);
        });
      });
      return;
  }
}

}  // namespace assur::speed
