// Second derivatives of a configuration and of its links' frames along directions in dimensions and
// inputs.
#pragma once

#include <assur/kinematics.hpp>
#include <assur/support/rigid_motion.hpp>

namespace assur {

/// First derivatives along one direction x: those of the dimensions d and the inputs u, which the
/// caller sets, and the resulting ones of the unknowns q and the link frames p.
template <typename Model, typename Scalar>
struct FirstDerivative {
  Vector<Scalar, Model::dimension_count> d;
  Vector<Scalar, Model::input_count> u;
  Vector<Scalar, Model::unknown_count> q;
  Vector<Scalar, 3 * Model::link_count> p;  ///< (x, y, theta) link by link
};

/// Second derivatives along two directions x and y, of the unknowns and of the link frames.
template <typename Model, typename Scalar>
struct SecondDerivative {
  Vector<Scalar, Model::unknown_count> q;
  Vector<Scalar, 3 * Model::link_count> p;  ///< (x, y, theta) link by link
};

/// Second derivatives of an assembled configuration, on demand: J is factored once, for any number
/// of directions. Every result is set if its status is ok or near_singular.
///
///     const SecondOrder<Model, double> order(d, u, q);
///     FirstDerivative<Model, double> x, y;        // first: d and u along each direction
///     SecondDerivative<Model, double> xy;
///     status = order.first(d_x, u_x, x);
///     status = order.first(d_y, u_y, y);
///     status = order.second(x, y, xy);
template <typename Model, typename Scalar>
class SecondOrder {
 public:
  using Dimensions = typename Model::template Dimensions<Scalar>;
  using Inputs = typename Model::template Inputs<Scalar>;
  using Configuration = typename Model::template Configuration<Scalar>;
  using First = FirstDerivative<Model, Scalar>;
  using Second = SecondDerivative<Model, Scalar>;
  using DimensionRates = Vector<Scalar, Model::dimension_count>;
  using InputRates = Vector<Scalar, Model::input_count>;

  SecondOrder(const Dimensions& d, const Inputs& u, const Configuration& q)
      : d_(d), u_(u), q_(q), jacobian_(d, u, q) {
    if (jacobian_.solvable()) {
      Model::dimension_jacobian(d, u, q, f_d_);
      Model::input_jacobian(d, u, q, f_u_);
      Model::pose_jacobians(d, u, q, p_q_, p_d_, p_u_);
    }
  }

  /// The status of the first derivatives.
  [[nodiscard]] Status status() const { return jacobian_.status(); }

  /// q_x and p_x along a direction (d_x, u_x):
  ///     J q_x = -F_d d_x - F_u u_x,  p_x = P_q q_x + P_d d_x + P_u u_x.
  [[nodiscard]] Status first(const DimensionRates& d_x, const InputRates& u_x,
                             First& result) const {
    if (jacobian_.solvable()) {
      if (!assur::is_finite(d_x) || !assur::is_finite(u_x)) {
        return Status::not_finite;
      }
      result.d = d_x;
      result.u = u_x;
      result.q = jacobian_.solve(Equations(-(f_d_ * d_x) - f_u_ * u_x));
      result.p = p_q_ * result.q + p_d_ * d_x + p_u_ * u_x;
    }
    return status();
  }

  /// q_xy and p_xy along two directions, of which d and u may have second derivatives d_xy, u_xy:
  ///     J q_xy = -f''(x, y) - F_d d_xy - F_u u_xy,
  ///     p_xy = p''(x, y) + P_q q_xy + P_d d_xy + P_u u_xy,
  /// where f'' and p'' are bilinear in x = (q_x, d_x, u_x) and y, all variables independent.
  [[nodiscard]] Status second(const First& x, const First& y, const DimensionRates& d_xy,
                              const InputRates& u_xy, Second& result) const {
    if (!jacobian_.solvable()) {
      return status();
    }
    if (!is_finite(x) || !is_finite(y) || !assur::is_finite(d_xy) || !assur::is_finite(u_xy)) {
      return Status::not_finite;
    }
    // A quadratic form Q has the bilinear form (Q(x + y) - Q(x - y))/4. The difference loses digits
    // if one of x and y is longer than the other, so both are scaled to one length.
    const Scalar length_x = length(x);
    const Scalar length_y = length(y);
    Equations rhs = -(f_d_ * d_xy) - f_u_ * u_xy;
    PoseRates bent = p_d_ * d_xy + p_u_ * u_xy;
    if (length_x > Scalar(0) && length_y > Scalar(0)) {
      const Curvature sum = curvature(x, Scalar(1) / length_x, y, Scalar(1) / length_y);
      const Curvature difference = curvature(x, Scalar(1) / length_x, y, -Scalar(1) / length_y);
      const Scalar weight = length_x * length_y / Scalar(4);
      rhs += weight * (sum.rhs - difference.rhs);
      bent += weight * (sum.p - difference.p);
    }
    result.q = jacobian_.solve(rhs);
    result.p = p_q_ * result.q + bent;
    return status();
  }

  /// The same with d_xy = 0 and u_xy = 0.
  [[nodiscard]] Status second(const First& x, const First& y, Second& result) const {
    return second(x, y, DimensionRates::Zero(), InputRates::Zero(), result);
  }

 private:
  using Equations = Vector<Scalar, Model::equation_count>;
  using PoseRates = Vector<Scalar, 3 * Model::link_count>;

  /// -d2f and d2p along the line that a direction spans.
  struct Curvature {
    Equations rhs;
    PoseRates p;
  };

  [[nodiscard]] static bool is_finite(const First& x) {
    return assur::is_finite(x.d) && assur::is_finite(x.u) && assur::is_finite(x.q) &&
           assur::is_finite(x.p);
  }

  [[nodiscard]] static Scalar length(const First& x) {
    using std::max;
    return max EIGEN_NOT_A_MACRO(
        x.q.cwiseAbs().maxCoeff(),
        max EIGEN_NOT_A_MACRO(x.d.cwiseAbs().maxCoeff(), x.u.cwiseAbs().maxCoeff()));
  }

  /// The curvature along a x + b y.
  [[nodiscard]] Curvature curvature(const First& x, const Scalar& a, const First& y,
                                    const Scalar& b) const {
    const Vector<Scalar, Model::unknown_count> q_rate = a * x.q + b * y.q;
    const DimensionRates d_rate = a * x.d + b * y.d;
    const InputRates u_rate = a * x.u + b * y.u;
    Curvature result;
    Matrix<Scalar, Model::link_count, 3> p;
    Model::curvature_rhs(d_, u_, q_, q_rate, d_rate, u_rate, result.rhs);
    Model::pose_curvatures(d_, u_, q_, q_rate, d_rate, u_rate, p);
    for (int link = 0; link < Model::link_count; ++link) {
      result.p.template segment<3>(3 * link) = p.row(link).transpose();
    }
    return result;
  }

  Dimensions d_;
  Inputs u_;
  Configuration q_;
  InverseJacobian<Model, Scalar> jacobian_;
  Matrix<Scalar, Model::equation_count, Model::dimension_count> f_d_;
  Matrix<Scalar, Model::equation_count, Model::input_count> f_u_;
  Matrix<Scalar, 3 * Model::link_count, Model::unknown_count> p_q_;
  Matrix<Scalar, 3 * Model::link_count, Model::dimension_count> p_d_;
  Matrix<Scalar, 3 * Model::link_count, Model::input_count> p_u_;
};

/// Second derivative along two directions of the point of a link with constant local coordinates
/// (a, b): with r = R(direction) (a, b) and r' its quarter turn,
///     (x, y)_xy + theta_xy r' - theta_x theta_y r.
/// `link` counts as Model::links, `direction` is that of its pose.
template <typename Model, typename Scalar>
[[nodiscard]] Vector<Scalar, 2> point_second_derivative(int link,
                                                        const Direction<Scalar>& direction,
                                                        const Vector<Scalar, 2>& local,
                                                        const FirstDerivative<Model, Scalar>& x,
                                                        const FirstDerivative<Model, Scalar>& y,
                                                        const SecondDerivative<Model, Scalar>& xy) {
  const int row = 3 * link;
  const Vector<Scalar, 2> at_rest = Vector<Scalar, 2>::Zero();
  return support::carried_twice<Scalar>(xy.p.template segment<3>(row), x.p(row + 2), y.p(row + 2),
                                        support::rotated(direction, local), at_rest, at_rest,
                                        at_rest);
}

}  // namespace assur
