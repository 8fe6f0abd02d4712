// Turns the angle of a four-bar's crank into its torque and the forces in its pins as one writes
// them by hand.
#pragma once

#include "everyday/by_hand.hpp"

namespace assur::speed::by_hand {

/// The four-bar of four_bar_forces.json, at any scalar: kg, mm, s.
template <typename Scalar>
struct LoadedFourBar {
  struct Body {
    Scalar mass, x, y, inertia;  ///< of a mass at (x, y) in the link's frame
  };
  FourBar<Scalar> lengths;
  Body crank, coupler, rocker;
  Scalar gravity, work, velocity, acceleration;

  /// The forces on a link, and their moment about the place from which its mass is measured.
  struct Wrench {
    Scalar x, y, moment;
  };
  /// Weight and inertia of a link: its direction, its angular velocity and acceleration, and the
  /// acceleration of its frame's origin.
  [[nodiscard]] Wrench inertia(const Body& body, const Scalar& cos, const Scalar& sin,
                               const Scalar& w, const Scalar& a, const Scalar& ax,
                               const Scalar& ay) const {
    const Scalar x = cos * body.x - sin * body.y;
    const Scalar y = sin * body.x + cos * body.y;
    const Scalar w_square = w * w;
    const Scalar force_x = -body.mass * (ax - a * y - w_square * x);
    const Scalar force_y = body.mass * (gravity - (ay + a * x - w_square * y));
    return {force_x, force_y, x * force_y - y * force_x - body.inertia * a};
  }

  /// The torque at A and the moment on the ground, each beside the work on the rocker; the forces
  /// at A on the crank, at B on the coupler, at C and at D on the rocker, and on the ground.
  [[nodiscard]] Listed<Scalar, 14> operator()(const Scalar& angle) const {
    using std::cos;
    using std::sin;
    const Scalar c = cos(angle);
    const Scalar s = sin(angle);
    const Scalar x_B = lengths.crank * c;
    const Scalar y_B = lengths.crank * s;
    const Scalar vx_B = -velocity * y_B;
    const Scalar vy_B = velocity * x_B;
    const Scalar ax_B = -acceleration * y_B - velocity * vy_B;
    const Scalar ay_B = acceleration * x_B + velocity * vx_B;
    const Scalar x = lengths.ground - x_B;
    const Scalar y = -y_B;
    const auto [reached, along, across] = corners<Scalar>(x, y, lengths.coupler, lengths.rocker);
    if (!reached) {
      return {};
    }
    const Scalar zero(0);
    const Wrench on_crank = inertia(crank, c, s, velocity, acceleration, zero, zero);
    const Scalar one_by_coupler = Scalar(1) / lengths.coupler;
    const Scalar one_by_rocker = Scalar(1) / lengths.rocker;
    const auto configuration = [&, along = along](const Scalar& left) -> std::array<Scalar, 14> {
      const Scalar BC_x = along * x - left * y;
      const Scalar BC_y = along * y + left * x;
      const Scalar DC_x = BC_x - x;
      const Scalar DC_y = BC_y - y;
      const Scalar one_by_area = Scalar(1) / (BC_x * DC_y - BC_y * DC_x);
      const Scalar w_BC = -(vx_B * DC_x + vy_B * DC_y) * one_by_area;
      const Scalar w_DC = -(vx_B * BC_x + vy_B * BC_y) * one_by_area;
      const Scalar BC_DC = BC_x * DC_x + BC_y * DC_y;
      const Scalar a_BC = -(ax_B * DC_x + ay_B * DC_y - w_BC * w_BC * BC_DC +
                            w_DC * w_DC * lengths.rocker * lengths.rocker) *
                          one_by_area;
      const Scalar a_DC = -(ax_B * BC_x + ay_B * BC_y -
                            w_BC * w_BC * lengths.coupler * lengths.coupler + w_DC * w_DC * BC_DC) *
                          one_by_area;
      const Wrench on_coupler =
          inertia(coupler, BC_x * one_by_coupler, BC_y * one_by_coupler, w_BC, a_BC, ax_B, ay_B);
      Wrench on_rocker =
          inertia(rocker, DC_x * one_by_rocker, DC_y * one_by_rocker, w_DC, a_DC, zero, zero);
      on_rocker.moment += work;
      // BC x f = moment about B, DC x f = -moment about D, f on the rocker at C.
      const Scalar f_x = (on_coupler.moment * DC_x + on_rocker.moment * BC_x) * one_by_area;
      const Scalar f_y = (on_coupler.moment * DC_y + on_rocker.moment * BC_y) * one_by_area;
      const Scalar B_x = f_x - on_coupler.x;
      const Scalar B_y = f_y - on_coupler.y;
      const Scalar moment = on_crank.moment + on_coupler.moment + x_B * on_coupler.y -
                            y_B * on_coupler.x + on_rocker.moment + lengths.ground * on_rocker.y;
      return {x_B * B_y - y_B * B_x - on_crank.moment,
              work,
              moment,
              work,
              B_x - on_crank.x,
              B_y - on_crank.y,
              B_x,
              B_y,
              f_x,
              f_y,
              -f_x - on_rocker.x,
              -f_y - on_rocker.y,
              on_crank.x + on_coupler.x + on_rocker.x,
              on_crank.y + on_coupler.y + on_rocker.y};
    };
    return {2, {configuration(across), configuration(-across)}};
  }
};

}  // namespace assur::speed::by_hand
