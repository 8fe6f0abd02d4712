// The complex step through the closures and through whole assemblies, as entries of the derivative
// tasks.
#include <complex>

#include "derivatives/derivative_methods.hpp"
#include "derivatives/solve_closure.hpp"
#include "stability/step_methods.hpp"

namespace assur::speed {

namespace {

using Sample = TetradSample<double>;
using Complex = std::complex<double>;
using Point = stability::Geometry<Model01, Complex>;

/// Its square vanishes beside one, so there is neither truncation nor cancellation.
constexpr double h = 1e-100;

Direction<Complex> turning(const Direction<Complex>& at, double rate) {
  return {Complex(at.cos.real(), -h * rate * at.sin.real()),
          Complex(at.sin.real(), h * rate * at.cos.real())};
}

void displace(Complex& length) { length += Complex(0, h); }
void displace(Direction<Complex>& direction) { direction = turning(direction, 1); }

// Inlined so that the compiler sees which one variable is complex: half the time.
[[gnu::always_inline]] inline Eigen::Vector4d derivative(const Point& displaced) {
  Vector<Complex, 4> f;
  Model01::residual(displaced.d, displaced.u, displaced.q, f);
  return f.imag() / h;
}

/// df/dx, one column for each of the given variables, which are part of the point.
template <typename Variables, typename Columns>
[[gnu::always_inline]] inline void differentiate(Point& at, Variables& variables,
                                                 Columns& columns) {
  int column = 0;
  const auto by = [&](auto& variable) {
    const auto held = variable;
    displace(variable);
    columns.col(column++) = derivative(at);
    variable = held;
  };
  std::apply([&](auto&... member) { (by(member), ...); }, variables.members());
}

JacobianAnswer<double> jacobian(const Sample& sample) {
  Point at = stability::converted<Complex>(sample.g);
  JacobianAnswer<double> answer;
  differentiate(at, at.q, answer.by_unknowns);
  return answer;
}

ClosureAnswer<double> closure(const Sample& sample) {
  Point at = stability::converted<Complex>(sample.g);
  ClosureAnswer<double> answer;
  differentiate(at, at.q, answer.by_unknowns);
  differentiate(at, at.d, answer.by_dimensions);
  differentiate(at, at.u, answer.by_inputs);
  return answer;
}

/// The point a moment later, with its inputs and its unknowns moved.
Point later(const Sample& sample, const Eigen::Vector4d& velocity) {
  Point at = stability::converted<Complex>(sample.g);
  at.u_rate += Complex(0, h) * at.u_second_rate;
  advance(at.u, Vector<Complex, 4>(Complex(0, h) * sample.g.u_rate));
  int index = 0;
  const auto turn = [&](Direction<Complex>& direction) {
    direction = turning(direction, velocity(index++));
  };
  std::apply([&](auto&... member) { (turn(member), ...); }, at.q.members());
  return at;
}

/// d2f/dt2 with the second rates of the unknowns left out. A complex step differentiates once, so
/// it is that of df/dt = J w + f_u u', which is written out.
Eigen::Vector4d second_derivative(const Sample& sample, const Eigen::Vector4d& velocity) {
  const Point at = later(sample, velocity);
  Matrix<Complex, 4, 4> J;
  Vector<Complex, 4> rhs;
  Model01::jacobian(at.d, at.u, at.q, J);
  Model01::velocity_rhs(at.d, at.u, at.q, at.u_rate, rhs);
  return (J.imag() * velocity - rhs.imag()) / h;
}

MotionAnswer<double> motion(const Sample& sample) {
  const Eigen::Vector4d first = derivative(later(sample, Eigen::Vector4d::Zero()));
  return solved_motion<double>(jacobian(sample).by_unknowns, first, [&](const Eigen::Vector4d& w) {
    return second_derivative(sample, w);
  });
}

}  // namespace

void add_complex_step(DerivativeTask& task, Wanted wanted) {
  // Functions as lambdas, so that each is inlined into its own loop.
  switch (wanted) {
    case Wanted::jacobian:
      task.add<double>("complex step", "double",
                       [](const Sample& sample) { return jacobian(sample); });
      return;
    case Wanted::closure:
      task.add<double>("complex step", "double",
                       [](const Sample& sample) { return closure(sample); });
      return;
    case Wanted::motion:
      task.add<double>("complex step + LU", "double",
                       [](const Sample& sample) { return motion(sample); });
      return;
    case Wanted::derivatives:
      task.add<double>("complex step + LU", "double", [](const Sample& sample) {
        return solved<double>(closure(sample), sample.g.u_rate, [&](const Eigen::Vector4d& w) {
          return second_derivative(sample, w);
        });
      });
      task.add<double>("complex step of assemblies", "double",
                       by_assemblies<stability::complex_step<Model01>>);
      return;
  }
}

}  // namespace assur::speed
