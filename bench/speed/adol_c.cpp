// Automatic differentiation by ADOL-C, the closures taped once, as entries of the derivative tasks.
#include <adolc/adolc.h>

#include <array>

#include "derivative_methods.hpp"
#include "solve_closure.hpp"

namespace assur::speed {

namespace {

using Sample = TetradSample<double>;

constexpr int unknowns = 4;
constexpr int variables = 16;  ///< unknowns (angles), dimensions, inputs

void record(short tape) {
  std::array<adouble, variables> x;
  Vector<adouble, 4> f;
  trace_on(tape);
  for (adouble& variable : x) {
    variable <<= 0.7;
  }
  const auto direction = [](const adouble& angle) {
    return Direction<adouble>{cos(angle), sin(angle)};
  };
  Model01::residual<adouble>(
      {x[4], x[5], x[6], x[7], x[8], x[9], x[10], x[11]}, {x[12], x[13], x[14], x[15]},
      {direction(x[0]), direction(x[1]), direction(x[2]), direction(x[3])}, f);
  for (int row = 0; row < 4; ++row) {
    double value = 0;
    f(row) >>= value;
  }
  trace_off();
}

/// The drivers want rows of pointers; they are made once, as the tape is.
class Tape {
 public:
  Tape() {
    record(tag);
    for (std::size_t row = 0; row < 4; ++row) {
      jacobian_rows_[row] = &jacobian_[row * variables];
      y_rows_[row] = &y_series_[row * 2];
    }
    for (std::size_t row = 0; row < variables; ++row) {
      x_rows_[row] = &x_series_[row * 2];
    }
  }

  [[nodiscard]] ClosureAnswer<double> closure(const Sample& sample) {
    set(sample);
    ::jacobian(tag, 4, variables, x_.data(), jacobian_rows_.data());
    const Eigen::Map<const Eigen::Matrix<double, 4, variables, Eigen::RowMajor>> all(
        jacobian_.data());
    return {all.leftCols<unknowns>(), all.middleCols<8>(unknowns), all.rightCols<4>()};
  }

  /// d2f/dt2 with the second rates of the unknowns left out: a Taylor series of degree two.
  [[nodiscard]] Eigen::Vector4d second_derivative(const Sample& sample,
                                                  const Eigen::Vector4d& velocity) {
    set(sample);
    x_series_.fill(0);
    for (std::size_t index = 0; index < 4; ++index) {
      const auto place = static_cast<Eigen::Index>(index);
      x_series_[2 * index] = velocity(place);
      x_series_[2 * (12 + index)] = sample.g.u_rate(place);
      x_series_[2 * (12 + index) + 1] = sample.g.u_second_rate(place) / 2;
    }
    std::array<double, 4> y;
    hos_forward(tag, 4, variables, 2, 0, x_.data(), x_rows_.data(), y.data(), y_rows_.data());
    return 2 * Eigen::Vector4d(y_series_[1], y_series_[3], y_series_[5], y_series_[7]);
  }

 private:
  static constexpr short tag = 1;

  void set(const Sample& sample) {
    std::size_t index = 0;
    for (const double angle : sample.theta) {
      x_[index++] = angle;
    }
    const auto append = [&](double value) { x_[index++] = value; };
    std::apply([&](const auto&... member) { (append(member), ...); }, sample.g.d.members());
    std::apply([&](const auto&... member) { (append(member), ...); }, sample.g.u.members());
  }

  std::array<double, variables> x_{};
  std::array<double, 4 * variables> jacobian_{};
  std::array<double*, 4> jacobian_rows_{};
  std::array<double, variables * 2> x_series_{};
  std::array<double*, variables> x_rows_{};
  std::array<double, 8> y_series_{};
  std::array<double*, 4> y_rows_{};
};

Tape& tape() {
  static Tape recorded;
  return recorded;
}

}  // namespace

void add_adol_c(DerivativeTask& task, Wanted wanted) {
  switch (wanted) {
    case Wanted::jacobian:
      return;  // its tape gives the columns of the parameters as well
    case Wanted::closure:
      task.add<double>("ADOL-C", "double",
                       [](const Sample& sample) { return tape().closure(sample); });
      return;
    case Wanted::motion:
      return;
    case Wanted::derivatives:
      task.add<double>("ADOL-C + LU", "double", [](const Sample& sample) {
        return solved<double>(
            tape().closure(sample), sample.g.u_rate,
            [&](const Eigen::Vector4d& w) { return tape().second_derivative(sample, w); });
      });
      return;
  }
}

}  // namespace assur::speed
