// Derivatives from neighbouring assembled configurations: central differences, complex step,
// Newton.
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <limits>

#include "linear_methods.hpp"

namespace assur::stability {

/// to - from: the difference of angles lies in (-pi, pi].
template <typename Model>
[[nodiscard]] Vector<double, Model::unknown_count> difference(
    const typename Model::template Configuration<double>& to,
    const typename Model::template Configuration<double>& from) {
  Vector<double, Model::unknown_count> result;
  Eigen::Index index = 0;
  const auto append = [&](const auto& end, const auto& start) {
    if constexpr (std::is_same_v<std::decay_t<decltype(end)>, double>) {
      result(index++) = end - start;
    } else {
      result(index++) = angle_of(turned(end, reversed(start)));
    }
  };
  std::apply(
      [&](const auto&... end) {
        std::apply([&](const auto&... start) { (append(end, start), ...); }, from.members());
      },
      to.members());
  return result;
}

/// Central differences of configurations that Newton's iteration assembles from the given one. The
/// step is eps^(1/3) of the size of the group, or of a radian; the divisor is the step that the
/// rounded sum represents. The step in time, in which the inputs move by about that size, is
/// eps^(1/3) for velocities and eps^(1/4) for accelerations.
template <typename Model>
class CentralDifferences {
  using Configuration = typename Model::template Configuration<double>;
  using Unknowns = Vector<double, Model::unknown_count>;
  using Ends = Vector<double, Model::input_count>;

 public:
  explicit CentralDifferences(const Geometry<Model, double>& g) : g_(g) {
    const double epsilon = std::numeric_limits<double>::epsilon();
    const double step = std::cbrt(epsilon);
    by_each(&Geometry<Model, double>::d, Model::dimensions, step,
            answer_.sensitivities.to_dimensions);
    by_each(&Geometry<Model, double>::u, Model::inputs, step, answer_.sensitivities.to_inputs);
    const Configuration before = at_time(-step);
    const Configuration after = at_time(step);
    answer_.motion.velocity = difference<Model>(after, before) / (2 * step);
    const double longer = std::pow(epsilon, 0.25);
    const Configuration now = at_time(0);
    const Unknowns ahead = difference<Model>(at_time(longer), now);
    const Unknowns behind = difference<Model>(now, at_time(-longer));
    answer_.motion.acceleration = (ahead - behind) / (longer * longer);
  }

  [[nodiscard]] const Answer<Model>& answer() const { return answer_; }

 private:
  Configuration assembled(const Geometry<Model, double>& moved) {
    Configuration q = moved.q;
    const Status status = refine<Model, double>(moved.d, moved.u, q);
    if (answer_.status == Status::ok || !is_solvable(status)) {
      answer_.status = status;
    }
    return q;
  }

  Configuration at_time(double time) {
    Geometry<Model, double> moved = g_;
    const Ends way = time * g_.u_rate + time * time / 2 * g_.u_second_rate;
    advance(moved.u, way);
    return assembled(moved);
  }

  template <typename Variables, typename Table, typename Columns>
  void by_each(Variables variables, const Table& table, double relative_step, Columns& columns) {
    for (int column = 0; column < columns.cols(); ++column) {
      using Steps = Vector<double, Columns::ColsAtCompileTime>;
      const bool is_angle = table[static_cast<std::size_t>(column)].is_angle;
      const Steps way = relative_step * (is_angle ? 1 : g_.size) * Steps::Unit(column);
      Geometry<Model, double> after = g_;
      Geometry<Model, double> before = g_;
      advance(after.*variables, way);
      advance(before.*variables, Steps(-way));
      const double width = is_angle
                               ? 2 * way(column)
                               : value(after.*variables, column) - value(before.*variables, column);
      columns.col(column) = difference<Model>(assembled(after), assembled(before)) / width;
    }
  }

  /// The length at an index.
  template <typename Variables>
  static double value(const Variables& variables, int wanted) {
    double result = 0;
    int index = 0;
    const auto pick = [&](const auto& member) {
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
        result = index == wanted ? member : result;
      }
      ++index;
    };
    std::apply([&](const auto&... member) { (pick(member), ...); }, variables.members());
    return result;
  }

  const Geometry<Model, double>& g_;
  Answer<Model> answer_;
};
template <typename Model>
[[nodiscard]] Answer<Model> central_differences(const Geometry<Model, double>& g) {
  return CentralDifferences<Model>(g).answer();
}

/// Complex step: two Newton steps in complex numbers from the configuration, one variable displaced
/// by 1e-100 i. Accelerations by the complex step of the velocity.
template <typename Model>
class ComplexStep {
  using Complex = std::complex<double>;
  using Point = Geometry<Model, Complex>;
  using Unknowns = Vector<double, Model::unknown_count>;
  using Square = Matrix<Complex, Model::equation_count, Model::unknown_count>;
  using Residual = Vector<Complex, Model::equation_count>;
  static constexpr double h = 1e-100;

 public:
  [[nodiscard]] static Answer<Model> answer(const Geometry<Model, double>& g) {
    Answer<Model> result;
    const Point at = converted<Complex>(g);
    const Complex step(0, h);
    for (int column = 0; column < Model::dimension_count; ++column) {
      using Steps = Vector<Complex, Model::dimension_count>;
      Point moved = at;
      advance(moved.d, Steps(step * Steps::Unit(column)));
      result.sensitivities.to_dimensions.col(column) = rates(assembled(moved));
    }
    using Steps = Vector<Complex, Model::input_count>;
    for (int column = 0; column < Model::input_count; ++column) {
      Point moved = at;
      advance(moved.u, Steps(step * Steps::Unit(column)));
      result.sensitivities.to_inputs.col(column) = rates(assembled(moved));
    }
    Point moved = at;
    advance(moved.u, Steps(step * at.u_rate));
    moved.u_rate += step * at.u_second_rate;
    moved = assembled(moved);
    result.motion.velocity = rates(moved);
    Square jacobian;
    Residual rhs;
    Model::jacobian(moved.d, moved.u, moved.q, jacobian);
    Model::velocity_rhs(moved.d, moved.u, moved.q, moved.u_rate, rhs);
    const Vector<Complex, Model::unknown_count> velocity =
        Eigen::PartialPivLU<Square>(jacobian).solve(rhs);
    result.motion.acceleration = velocity.imag() / h;
    return result;
  }

 private:
  static Point assembled(Point moved) {
    for (int iteration = 0; iteration < 2; ++iteration) {
      Square jacobian;
      Residual residual;
      Model::jacobian(moved.d, moved.u, moved.q, jacobian);
      Model::residual(moved.d, moved.u, moved.q, residual);
      const Vector<Complex, Model::unknown_count> newton =
          Eigen::PartialPivLU<Square>(jacobian).solve(-residual);
      advance(moved.q, newton);
    }
    return moved;
  }

  static Unknowns rates(const Point& moved) {
    Unknowns result;
    Eigen::Index index = 0;
    const auto append = [&](const auto& member) {
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Complex>) {
        result(index++) = member.imag() / h;
      } else {
        result(index++) =
            (member.cos.real() * member.sin.imag() - member.sin.real() * member.cos.imag()) / h;
      }
    };
    std::apply([&](const auto&... member) { (append(member), ...); }, moved.q.members());
    return result;
  }
};
template <typename Model>
[[nodiscard]] Answer<Model> complex_step(const Geometry<Model, double>& g) {
  return ComplexStep<Model>::answer(g);
}

/// The start of Newton's iteration: each unknown is off by this many radians or typical lengths,
/// with alternating signs.
inline constexpr double newton_neighbour = 0.1;

/// Newton's iteration from a neighbour, then the generated derivatives where it converges.
template <typename Model>
[[nodiscard]] Answer<Model> newton(const Geometry<Model, double>& given) {
  Geometry<Model, double> g = given;
  Vector<double, Model::unknown_count> away;
  for (int index = 0; index < Model::unknown_count; ++index) {
    const bool is_angle = Model::unknowns[static_cast<std::size_t>(index)].is_angle;
    away(index) = (index % 2 == 0 ? 1 : -1) * newton_neighbour * (is_angle ? 1 : g.size);
  }
  advance(g.q, away);
  Answer<Model> answer;
  answer.status = refine<Model, double>(g.d, g.u, g.q);
  return is_solvable(answer.status) ? generated<Model>(g) : answer;
}

}  // namespace assur::stability
