// Automatic differentiation by ADOL-C, the closures taped once, as entries of the derivative tasks.
#include <adolc/adolc.h>

#include <array>

#include "derivative_methods.hpp"
#include "solve_closure.hpp"

namespace assur::speed {

namespace {

using Sample = TetradSample<double>;

constexpr int variables = 16;  ///< unknowns (angles), inputs, dimensions, in this order

/// A tape that differentiates by the first so many variables; the others are ADOL-C's parameters,
/// which cost no derivatives. It is recorded once, as are the rows of pointers that the drivers
/// want.
template <int Independents>
class Tape {
  static constexpr short tag = Independents;
  static constexpr int directions = 5;

 public:
  using Jacobian = Eigen::Matrix<double, 4, Independents, Eigen::RowMajor>;

  Tape() {
    record();
    for (int row = 0; row < 4; ++row) {
      jacobian_rows_[row] = jacobian_.data() + row * Independents;
      y_rows_[row] = y_series_.data() + row * directions;
    }
    for (int row = 0; row < Independents; ++row) {
      x_rows_[row] = x_series_.data() + row * directions;
    }
  }

  [[nodiscard]] const Jacobian& jacobian(const Sample& sample) {
    set(sample);
    ::jacobian(tag, 4, Independents, x_.data(), jacobian_rows_);
    return jacobian_;
  }

  /// J and df/dt with the unknowns held: five directions at once.
  [[nodiscard]] Eigen::Matrix<double, 4, 5, Eigen::RowMajor> along_unknowns_and_time(
      const Sample& sample) {
    set(sample);
    x_series_.setZero();
    x_series_.template topLeftCorner<4, 4>().setIdentity();
    x_series_.template block<4, 1>(4, 4) = sample.g.u_rate;
    Eigen::Vector4d y;
    fov_forward(tag, 4, Independents, directions, x_.data(), x_rows_, y.data(), y_rows_);
    return y_series_;
  }

  /// d2f/dt2 with the second rates of the unknowns left out: a Taylor series of degree two at the
  /// point of the last call.
  [[nodiscard]] Eigen::Vector4d second_derivative(const Sample& sample,
                                                  const Eigen::Vector4d& velocity) {
    x_series_.setZero();
    x_series_.template block<4, 1>(0, 0) = velocity;
    x_series_.template block<4, 1>(4, 0) = sample.g.u_rate;
    x_series_.template block<4, 1>(4, 1) = sample.g.u_second_rate / 2;
    Eigen::Vector4d y;
    hos_forward(tag, 4, Independents, 2, 0, x_.data(), x_rows_, y.data(), y_rows_);
    return 2 * y_series_.col(1);
  }

 private:
  static void record() {
    std::array<adouble, variables> x;
    Vector<adouble, 4> f;
    trace_on(tag);
    for (std::size_t index = 0; index < variables; ++index) {
      if (index < Independents) {
        x[index] <<= 0.7;
      } else {
        x[index] = mkparam(0.7);
      }
    }
    const auto direction = [](const adouble& angle) {
      return Direction<adouble>{cos(angle), sin(angle)};
    };
    Model01::residual<adouble>(
        {x[8], x[9], x[10], x[11], x[12], x[13], x[14], x[15]}, {x[4], x[5], x[6], x[7]},
        {direction(x[0]), direction(x[1]), direction(x[2]), direction(x[3])}, f);
    for (int row = 0; row < 4; ++row) {
      double value = 0;
      f(row) >>= value;
    }
    trace_off();
  }

  void set(const Sample& sample) {
    std::size_t index = 0;
    const auto append = [&](double value) { x_[index++] = value; };
    for (const double angle : sample.theta) {
      append(angle);
    }
    std::apply([&](const auto&... member) { (append(member), ...); }, sample.g.u.members());
    std::apply([&](const auto&... member) { (append(member), ...); }, sample.g.d.members());
    if constexpr (Independents < variables) {
      set_param_vec(tag, variables - Independents, x_.data() + Independents);
    }
  }

  std::array<double, variables> x_{};
  Jacobian jacobian_;
  Eigen::Matrix<double, Independents, directions, Eigen::RowMajor> x_series_;
  Eigen::Matrix<double, 4, directions, Eigen::RowMajor> y_series_;
  double* jacobian_rows_[4];
  double* x_rows_[Independents];
  double* y_rows_[4];
};

template <int Independents>
Tape<Independents>& tape() {
  static Tape<Independents> recorded;
  return recorded;
}

ClosureAnswer<double> closure(const Sample& sample) {
  const auto& all = tape<variables>().jacobian(sample);
  return {all.leftCols<4>(), all.rightCols<8>(), all.middleCols<4>(4)};
}

}  // namespace

void add_adol_c(DerivativeTask& task, Wanted wanted) {
  switch (wanted) {
    case Wanted::jacobian:
      task.add<double>("ADOL-C", "double", [](const Sample& sample) {
        return JacobianAnswer<double>{tape<4>().jacobian(sample)};
      });
      return;
    case Wanted::closure:
      task.add<double>("ADOL-C", "double", closure);
      return;
    case Wanted::motion:
      task.add<double>("ADOL-C + LU", "double", [](const Sample& sample) {
        auto& moving = tape<8>();
        const auto f = moving.along_unknowns_and_time(sample);
        return solved_motion<double>(f.leftCols<4>(), f.col(4), [&](const Eigen::Vector4d& w) {
          return moving.second_derivative(sample, w);
        });
      });
      return;
    case Wanted::derivatives:
      task.add<double>("ADOL-C + LU", "double", [](const Sample& sample) {
        return solved<double>(closure(sample), sample.g.u_rate, [&](const Eigen::Vector4d& w) {
          return tape<variables>().second_derivative(sample, w);
        });
      });
      return;
  }
}

}  // namespace assur::speed
