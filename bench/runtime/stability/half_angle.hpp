// Derivatives by the half-angle form: the unknowns are the tangents of half the angles.
#pragma once

#include <Eigen/LU>
#include <cmath>

#include "problem.hpp"

namespace assur::stability {

/// Let t = tan(theta/2). Then cos theta = (1 - t^2)/(1 + t^2), sin theta = 2 t/(1 + t^2), and
///     theta'  = m t',         m = 2/(1 + t^2),
///     theta'' = m t'' + m' t',  m' = -4 t t'/(1 + t^2)^2.
/// t is taken from the angle itself, tan(atan2(sin, cos)/2), which loses nothing near pi. A
/// displacement is an unknown as it stands: m = 1.
template <typename Model>
class HalfAngleForm {
  using Unknowns = Vector<double, Model::unknown_count>;
  using Rates = Vector<double, Model::equation_count>;
  using Square = Matrix<double, Model::equation_count, Model::unknown_count>;

 public:
  [[nodiscard]] static Answer<Model> answer(const Geometry<Model, double>& given) {
    Geometry<Model, double> g = given;
    const Unknowns t = tangents(g.q);
    Unknowns m;
    for (int index = 0; index < Model::unknown_count; ++index) {
      m(index) = is_angle(index) ? 2 / (1 + t(index) * t(index)) : 1;
    }
    Square by_angles;
    Model::jacobian(g.d, g.u, g.q, by_angles);
    const Square by_tangents = by_angles * m.asDiagonal();
    const Eigen::PartialPivLU<Square> factors(by_tangents);

    Answer<Model> result;
    Matrix<double, Model::equation_count, Model::dimension_count> by_dimensions;
    Matrix<double, Model::equation_count, Model::input_count> by_inputs;
    Model::dimension_jacobian(g.d, g.u, g.q, by_dimensions);
    Model::input_jacobian(g.d, g.u, g.q, by_inputs);
    result.sensitivities.to_dimensions = m.asDiagonal() * factors.solve(-by_dimensions);
    result.sensitivities.to_inputs = m.asDiagonal() * factors.solve(-by_inputs);

    Rates rhs;
    Model::velocity_rhs(g.d, g.u, g.q, g.u_rate, rhs);
    const Unknowns t_rate = factors.solve(rhs);
    result.motion.velocity = m.cwiseProduct(t_rate);
    Unknowns turn_of_m;  // m' t'
    for (int index = 0; index < Model::unknown_count; ++index) {
      turn_of_m(index) =
          is_angle(index) ? -m(index) * m(index) * t(index) * t_rate(index) * t_rate(index) : 0;
    }
    Model::acceleration_rhs(g.d, g.u, g.q, result.motion.velocity, g.u_rate, g.u_second_rate, rhs);
    const Rates rhs_of_tangents = rhs - by_angles * turn_of_m;
    const Unknowns t_second_rate = factors.solve(rhs_of_tangents);
    result.motion.acceleration = m.cwiseProduct(t_second_rate) + turn_of_m;
    return result;
  }

 private:
  static bool is_angle(int index) {
    return Model::unknowns[static_cast<std::size_t>(index)].is_angle;
  }

  /// The tangents; replaces each direction by the one that its tangent gives.
  static Unknowns tangents(typename Model::template Configuration<double>& q) {
    Unknowns t;
    int index = 0;
    const auto replace = [&](auto& member) {
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Direction<double>>) {
        const double tangent = std::tan(angle_of(member) / 2);
        const double square = tangent * tangent;
        member = {(1 - square) / (1 + square), 2 * tangent / (1 + square)};
        t(index) = tangent;
      } else {
        t(index) = member;
      }
      ++index;
    };
    std::apply([&](auto&... member) { (replace(member), ...); }, q.members());
    return t;
  }
};
template <typename Model>
[[nodiscard]] Answer<Model> half_angle(const Geometry<Model, double>& g) {
  return HalfAngleForm<Model>::answer(g);
}

}  // namespace assur::stability
