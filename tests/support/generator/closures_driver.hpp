// Tests emitted functions of closures against their residual, and the residual against a typed one:
// Jacobians by complex steps, right-hand sides by differences in long double.
#pragma once

#include <array>
#include <assur/kinematics.hpp>
#include <cmath>
#include <complex>
#include <cstdio>
#include <random>
#include <vector>

namespace closures_driver {

using Values = std::vector<double>;

template <typename Scalar>
void set(Scalar& length, const Scalar& value) {
  length = value;
}
template <typename Scalar>
void set(assur::Direction<Scalar>& direction, const Scalar& value) {
  using std::cos;
  using std::sin;
  direction = {cos(value), sin(value)};
}

/// A model's variables from lengths and from angles in radians.
template <typename Variables, typename List>
Variables variables_of(const List& values) {
  Variables variables;
  std::size_t index = 0;
  std::apply([&](auto&... member) { (set(member, values[index++]), ...); }, variables.members());
  return variables;
}

/// A point of evaluation: values, and three orders of rates.
struct Sample {
  Values d, u, q;
  Values d_rate, u_rate, q_rate, u_second, q_second, u_third;
};

template <typename Scalar>
using Vector = std::vector<Scalar>;

template <typename Model, typename Scalar>
assur::Vector<Scalar, Model::equation_count> residual_at(const Vector<Scalar>& d,
                                                         const Vector<Scalar>& u,
                                                         const Vector<Scalar>& q) {
  assur::Vector<Scalar, Model::equation_count> f;
  Model::residual(variables_of<typename Model::template Dimensions<Scalar>>(d),
                  variables_of<typename Model::template Inputs<Scalar>>(u),
                  variables_of<typename Model::template Configuration<Scalar>>(q), f);
  return f;
}

/// The largest difference of two arrays, relative to the larger of one and what is expected.
template <typename Found, typename Expected>
double difference(const Found& found, const Expected& expected) {
  double largest = 0;
  for (Eigen::Index row = 0; row < expected.rows(); ++row) {
    for (Eigen::Index column = 0; column < expected.cols(); ++column) {
      const double size = std::max(1.0, std::abs(double(expected(row, column))));
      const double error =
          std::abs(double(found(row, column)) - double(expected(row, column))) / size;
      largest = error <= largest ? largest : error;  // NaN stays
    }
  }
  return largest;
}

/// df/dx for the variables of one list, which `residual` takes.
template <typename Model, int Columns, typename Residual>
assur::Matrix<double, Model::equation_count, Columns> complex_step(const Values& values,
                                                                   Residual residual) {
  constexpr double step = 1e-150;
  assur::Matrix<double, Model::equation_count, Columns> slopes;
  for (int column = 0; column < Columns; ++column) {
    Vector<std::complex<double>> moved(values.begin(), values.end());
    moved[static_cast<std::size_t>(column)] += std::complex<double>(0, step);
    slopes.col(column) = residual(moved).imag() / step;
  }
  return slopes;
}

/// The derivative of an order from 1 to 3 of f(t) at 0, by nine points.
template <typename Function>
auto derivative(Function f, int order) {
  constexpr long double h = 4e-3L;
  static const std::array<std::array<long double, 9>, 3> weights = {
      {{1 / 280.0L, -4 / 105.0L, 0.2L, -0.8L, 0, 0.8L, -0.2L, 4 / 105.0L, -1 / 280.0L},
       {-1 / 560.0L, 8 / 315.0L, -0.2L, 1.6L, -205 / 72.0L, 1.6L, -0.2L, 8 / 315.0L, -1 / 560.0L},
       {-7 / 240.0L, 0.3L, -169 / 120.0L, 61 / 30.0L, 0, -61 / 30.0L, 169 / 120.0L, -0.3L,
        7 / 240.0L}}};
  auto sum = (f(0.0L) * 0).eval();
  for (int point = -4; point <= 4; ++point) {
    const auto& row = weights[static_cast<std::size_t>(order - 1)];
    sum += f(point * h) * row[static_cast<std::size_t>(point + 4)];
  }
  return (sum / std::pow(h, order)).eval();
}

inline Vector<long double> moved(const Values& value, const Values& rate, const Values& second,
                                 const Values& third, long double t) {
  Vector<long double> result;
  for (std::size_t index = 0; index < value.size(); ++index) {
    const auto at = [&](const Values& list) { return list.empty() ? 0.0L : list[index]; };
    result.push_back(value[index] + t * (at(rate) + t * (at(second) / 2 + t * at(third) / 6)));
  }
  return result;
}

template <int Size>
assur::Vector<double, Size> eigen(const Values& values) {
  assur::Vector<double, Size> vector;
  for (int index = 0; index < Size; ++index) {
    vector(index) = values[static_cast<std::size_t>(index)];
  }
  return vector;
}

/// The largest errors over some samples, by function.
struct Errors {
  double residual = 0, jacobian = 0, dimension_jacobian = 0, input_jacobian = 0;
  double velocity_rhs = 0, acceleration_rhs = 0, jerk_rhs = 0, curvature_rhs = 0;
};

template <typename Model, typename Typed>
void measure(const Sample& at, Typed typed, Errors& errors) {
  constexpr int n = Model::equation_count;
  const auto note = [](double& largest, double error) {
    largest = error <= largest ? largest : error;
  };
  using Complex = std::complex<double>;
  const auto d = variables_of<typename Model::template Dimensions<double>>(at.d);
  const auto u = variables_of<typename Model::template Inputs<double>>(at.u);
  const auto q = variables_of<typename Model::template Configuration<double>>(at.q);
  const Vector<Complex> cd(at.d.begin(), at.d.end());
  const Vector<Complex> cu(at.u.begin(), at.u.end());
  const Vector<Complex> cq(at.q.begin(), at.q.end());
  const auto u_rate = eigen<Model::input_count>(at.u_rate);
  const auto q_rate = eigen<Model::unknown_count>(at.q_rate);

  assur::Vector<double, n> f;
  Model::residual(d, u, q, f);
  note(errors.residual, difference(f, typed(at.d, at.u, at.q)));

  assur::Matrix<double, n, Model::unknown_count> J;
  Model::jacobian(d, u, q, J);
  note(errors.jacobian,
       difference(J, complex_step<Model, Model::unknown_count>(at.q, [&](const Vector<Complex>& x) {
                    return residual_at<Model, Complex>(cd, cu, x);
                  })));
  assur::Matrix<double, n, Model::dimension_count> F_d;
  Model::dimension_jacobian(d, u, q, F_d);
  note(errors.dimension_jacobian,
       difference(F_d,
                  complex_step<Model, Model::dimension_count>(at.d, [&](const Vector<Complex>& x) {
                    return residual_at<Model, Complex>(x, cu, cq);
                  })));
  assur::Matrix<double, n, Model::input_count> F_u;
  Model::input_jacobian(d, u, q, F_u);
  note(errors.input_jacobian,
       difference(F_u, complex_step<Model, Model::input_count>(at.u, [&](const Vector<Complex>& x) {
                    return residual_at<Model, Complex>(cd, x, cq);
                  })));

  // The highest rates of the unknowns are left out, so the right-hand side is minus the rate of f.
  const auto along = [&](const Values& d1, const Values& q1, const Values& q2, const Values& u2,
                         const Values& u3) {
    return [&](long double t) {
      return residual_at<Model, long double>(moved(at.d, d1, {}, {}, t),
                                             moved(at.u, at.u_rate, u2, u3, t),
                                             moved(at.q, q1, q2, {}, t));
    };
  };
  assur::Vector<double, n> rhs;
  Model::velocity_rhs(d, u, q, u_rate, rhs);
  note(errors.velocity_rhs, difference(-rhs, derivative(along({}, {}, {}, {}, {}), 1)));
  Model::acceleration_rhs(d, u, q, q_rate, u_rate, eigen<Model::input_count>(at.u_second), rhs);
  note(errors.acceleration_rhs,
       difference(-rhs, derivative(along({}, at.q_rate, {}, at.u_second, {}), 2)));
  Model::jerk_rhs(d, u, q, q_rate, eigen<Model::unknown_count>(at.q_second), u_rate,
                  eigen<Model::input_count>(at.u_second), eigen<Model::input_count>(at.u_third),
                  rhs);
  note(errors.jerk_rhs,
       difference(-rhs, derivative(along({}, at.q_rate, at.q_second, at.u_second, at.u_third), 3)));
  Model::curvature_rhs(d, u, q, q_rate, eigen<Model::dimension_count>(at.d_rate), u_rate, rhs);
  note(errors.curvature_rhs,
       difference(-rhs, derivative(along(at.d_rate, at.q_rate, {}, {}, {}), 2)));
}

/// Draws lengths within a tenth of those given, and angles within a turn of them.
template <typename Model, typename Typed>
void report(const char* name, const Values& d, const Values& u, const Values& q, double turn,
            Typed typed) {
  constexpr unsigned seed = 20;
  constexpr int samples = 25;
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto draw = [&](const Values& about, const auto& table) {
    Values values;
    for (std::size_t index = 0; index < about.size(); ++index) {
      values.push_back(table[index].is_angle ? about[index] + turn * uniform(engine)
                                             : about[index] * (1 + uniform(engine) / 10));
    }
    return values;
  };
  const auto rates = [&](const Values& like) {
    Values values;
    for (std::size_t index = 0; index < like.size(); ++index) {
      values.push_back(uniform(engine) / 2);
    }
    return values;
  };
  Errors errors;
  for (int sample = 0; sample < samples; ++sample) {
    const Sample at{draw(d, Model::dimensions),
                    draw(u, Model::inputs),
                    draw(q, Model::unknowns),
                    rates(d),
                    rates(u),
                    rates(q),
                    rates(u),
                    rates(q),
                    rates(u)};
    measure<Model>(at, typed, errors);
  }
  std::printf("%s %.3g %.3g %.3g %.3g %.3g %.3g %.3g %.3g\n", name, errors.residual,
              errors.jacobian, errors.dimension_jacobian, errors.input_jacobian,
              errors.velocity_rhs, errors.acceleration_rhs, errors.jerk_rhs, errors.curvature_rhs);
}

}  // namespace closures_driver
