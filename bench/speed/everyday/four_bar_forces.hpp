// The crank torque and the pin forces of a four-bar as one writes them by hand.
#pragma once

#include "everyday/by_hand.hpp"

namespace assur::speed::by_hand {

/// The four-bar of four_bar_forces.json, in any scalar: kg, mm, s.
template <typename Scalar>
struct LoadedFourBar {
  struct Body {
    Scalar mass, x, y, inertia;  ///< of a mass with its centre at (x, y) in the link's frame
  };
  FourBar<Scalar> lengths;
  Body crank, coupler, rocker;
  Scalar gravity, work, velocity, acceleration;

  /// The force on a link, and its moment about the point from which its centre of mass is measured.
  struct Wrench {
    Scalar x, y, moment;
  };
  /// Weight and inertia force of a link from its direction, its angular velocity and acceleration,
  /// and the acceleration of its frame's origin.
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

  /// The torque at A and the moment on the ground, each followed by the work on the rocker; the
  /// forces at A on the crank, at B on the coupler, at C and at D on the rocker, and on the ground.
  [[nodiscard]] Listed<Scalar, 14> operator()(const Scalar& angle) const {
    using std::cos;
    using std::sin;
    const Scalar c = cos(angle);
    const Scalar s = sin(angle);
    const typename FourBar<Scalar>::CrankEnd B = lengths.crank_end(c, s, velocity, acceleration);
    const Scalar x = lengths.ground - B.x;
    const Scalar y = -B.y;
    const auto [reached, along, across] = corners<Scalar>(x, y, lengths.coupler, lengths.rocker);
    if (!reached) {
      return {};
    }
    const Scalar zero(0);
    const Wrench on_crank = inertia(crank, c, s, velocity, acceleration, zero, zero);
    const Scalar one_by_coupler = Scalar(1) / lengths.coupler;
    const Scalar one_by_rocker = Scalar(1) / lengths.rocker;
    const auto configuration = [&, along = along](const Scalar& left) -> std::array<Scalar, 14> {
      const typename FourBar<Scalar>::Bars of = lengths.bars(B, x, y, along, left);
      const Wrench on_coupler = inertia(coupler, of.BC_x * one_by_coupler, of.BC_y * one_by_coupler,
                                        of.w_BC, of.a_BC, B.ax, B.ay);
      Wrench on_rocker = inertia(rocker, of.DC_x * one_by_rocker, of.DC_y * one_by_rocker, of.w_DC,
                                 of.a_DC, zero, zero);
      on_rocker.moment += work;
      // BC x f = moment about B, DC x f = -moment about D, f on the rocker at C.
      const Scalar f_x =
          (on_coupler.moment * of.DC_x + on_rocker.moment * of.BC_x) * of.one_by_area;
      const Scalar f_y =
          (on_coupler.moment * of.DC_y + on_rocker.moment * of.BC_y) * of.one_by_area;
      const Scalar at_B_x = f_x - on_coupler.x;
      const Scalar at_B_y = f_y - on_coupler.y;
      const Scalar moment = on_crank.moment + on_coupler.moment + B.x * on_coupler.y -
                            B.y * on_coupler.x + on_rocker.moment + lengths.ground * on_rocker.y;
      return {B.x * at_B_y - B.y * at_B_x - on_crank.moment,
              work,
              moment,
              work,
              at_B_x - on_crank.x,
              at_B_y - on_crank.y,
              at_B_x,
              at_B_y,
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
