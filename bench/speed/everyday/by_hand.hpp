// Positions and rates of dyads and a four-bar as one writes them by hand: the code reports that a
// linkage does not close, and checks nothing else.
#pragma once

#include <array>
#include <assur/dyad/model_01.hpp>
#include <assur/dyad/model_02.hpp>
#include <assur/dyad/model_03.hpp>
#include <cmath>

namespace assur::speed {

/// The configurations that a method lists, both or none.
template <typename Configuration>
struct Pair {
  int count = 0;
  std::array<Configuration, 2> list;
};

/// The requested quantities of a configuration, one after the other.
template <typename Scalar, std::size_t Numbers>
using Listed = Pair<std::array<Scalar, Numbers>>;

namespace by_hand {

/// The two third corners of the triangles on the side (x, y) between two centres, at the distances
/// r and R from the centres.
template <typename Scalar>
struct Corners {
  bool reached;
  Scalar along, across;  ///< components along the side and across it, to the corner on its left
};

template <typename Scalar>
[[nodiscard]] inline Corners<Scalar> corners(const Scalar& x, const Scalar& y, const Scalar& r,
                                             const Scalar& R) {
  using std::sqrt;
  const Scalar one_by_square = Scalar(1) / (x * x + y * y);
  const Scalar r_square = r * r * one_by_square;
  const Scalar along = (Scalar(1) + r_square - R * R * one_by_square) / Scalar(2);
  const Scalar across_square = r_square - along * along;
  if (!(across_square >= 0)) {
    return {false, {}, {}};
  }
  return {true, along, sqrt(across_square)};
}

/// RRR: two bars between two pivots.
struct TwoBars {
  using Model = dyad::Model01;
  [[nodiscard]] Pair<Model::Configuration<double>> operator()(
      const Model::Dimensions<double>& d, const Model::Inputs<double>& u) const {
    const double x = u.x_D - u.x_B;
    const double y = u.y_D - u.y_B;
    const auto [reached, along, across] = corners(x, y, d.BC, d.CD);
    if (!reached) {
      return {};
    }
    const double one_by_BC = 1 / d.BC;
    const double one_by_CD = 1 / d.CD;
    const auto configuration = [&, along = along](double left) {
      const double BC_x = along * x - left * y;
      const double BC_y = along * y + left * x;
      return Model::Configuration<double>{{BC_x * one_by_BC, BC_y * one_by_BC},
                                          {(x - BC_x) * one_by_CD, (y - BC_y) * one_by_CD}};
    };
    return {2, {configuration(across), configuration(-across)}};
  }
};

/// PRR: a bar from a pivot to a block on a guide.
struct BarAndBlock {
  using Model = dyad::Model02;
  [[nodiscard]] Pair<Model::Configuration<double>> operator()(
      const Model::Dimensions<double>& d, const Model::Inputs<double>& u) const {
    const double x = u.x_D - u.x_B;
    const double y = u.y_D - u.y_B;
    // clang++ 14 does not let lambdas capture structured bindings.
    const double cos = u.phi_B.cos;
    const double sin = u.phi_B.sin;
    const double across = cos * y - sin * x + d.h_B_BC;
    const double square = d.CD * d.CD - across * across;
    if (!(square >= 0)) {
      return {};
    }
    const double foot = cos * x + sin * y;
    const double one_by_CD = 1 / d.CD;
    const auto configuration = [&](double along) {
      return Model::Configuration<double>{
          {(cos * along - sin * across) * one_by_CD, (sin * along + cos * across) * one_by_CD},
          foot - along};
    };
    const double root = std::sqrt(square);
    return {2, {configuration(root), configuration(-root)}};
  }
};

/// RPR: a cylinder between two pivots, which may be offset from its axis.
struct Cylinder {
  using Model = dyad::Model03;
  [[nodiscard]] Pair<Model::Configuration<double>> operator()(
      const Model::Dimensions<double>& d, const Model::Inputs<double>& u) const {
    const double x = u.x_D - u.x_B;
    const double y = u.y_D - u.y_B;
    const double across = d.h_C_BC - d.h_C_CD;
    const double square = x * x + y * y;
    const double stroke_square = square - across * across;
    if (!(stroke_square >= 0)) {
      return {};
    }
    const double one_by_square = 1 / square;
    const auto configuration = [&](double stroke) {
      return Model::Configuration<double>{
          {(stroke * x + across * y) * one_by_square, (stroke * y - across * x) * one_by_square},
          stroke};
    };
    const double root = std::sqrt(stroke_square);
    return {2, {configuration(root), configuration(-root)}};
  }
};

template <typename Scalar>
struct SliderCrank {
  Scalar crank, rod, offset;

  /// The position of the slider on its guide.
  [[nodiscard]] Listed<Scalar, 1> operator()(const Scalar& angle) const {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const Scalar height = offset - crank * sin(angle);
    const Scalar square = rod * rod - height * height;
    if (!(square >= 0)) {
      return {};
    }
    const Scalar x = crank * cos(angle);
    const Scalar foot = sqrt(square);
    return {2, {{{x + foot}, {x - foot}}}};
  }
};

template <typename Scalar>
struct FourBar {
  Scalar ground, crank, coupler, rocker, reach;

  /// The position of the coupler point.
  [[nodiscard]] Listed<Scalar, 2> position(const Scalar& angle) const {
    using std::cos;
    using std::sin;
    const Scalar x_B = crank * cos(angle);
    const Scalar y_B = crank * sin(angle);
    const Scalar x = ground - x_B;
    const Scalar y = -y_B;
    const auto [reached, along, across] = corners<Scalar>(x, y, coupler, rocker);
    if (!reached) {
      return {};
    }
    const Scalar part = reach / coupler;
    const Scalar near = part * along;
    const Scalar far = part * across;
    const Scalar x_middle = x_B + near * x;
    const Scalar y_middle = y_B + near * y;
    return {2,
            {{{x_middle - far * y, y_middle + far * x}, {x_middle + far * y, y_middle - far * x}}}};
  }

  /// The end of the crank with its velocity and acceleration.
  struct CrankEnd {
    Scalar x, y, vx, vy, ax, ay;
  };
  [[nodiscard]] CrankEnd crank_end(const Scalar& cos, const Scalar& sin, const Scalar& velocity,
                                   const Scalar& acceleration) const {
    const Scalar x = crank * cos;
    const Scalar y = crank * sin;
    const Scalar vx = -velocity * y;
    const Scalar vy = velocity * x;
    return {x, y, vx, vy, -acceleration * y - velocity * vy, acceleration * x + velocity * vx};
  }

  /// The coupler vector from B to C, the rocker vector from D to C, and their rates.
  struct Bars {
    Scalar BC_x, BC_y, DC_x, DC_y, one_by_area;
    Scalar w_BC, w_DC, a_BC, a_DC;
  };
  /// Both bars from the side (x, y), B to D, and its components to C.
  [[nodiscard]] Bars bars(const CrankEnd& B, const Scalar& x, const Scalar& y, const Scalar& along,
                          const Scalar& left) const {
    Bars of;
    of.BC_x = along * x - left * y;
    of.BC_y = along * y + left * x;
    of.DC_x = of.BC_x - x;
    of.DC_y = of.BC_y - y;
    of.one_by_area = Scalar(1) / (of.BC_x * of.DC_y - of.BC_y * of.DC_x);
    of.w_BC = -(B.vx * of.DC_x + B.vy * of.DC_y) * of.one_by_area;
    of.w_DC = -(B.vx * of.BC_x + B.vy * of.BC_y) * of.one_by_area;
    const Scalar BC_DC = of.BC_x * of.DC_x + of.BC_y * of.DC_y;
    of.a_BC = -(B.ax * of.DC_x + B.ay * of.DC_y - of.w_BC * of.w_BC * BC_DC +
                of.w_DC * of.w_DC * rocker * rocker) *
              of.one_by_area;
    of.a_DC = -(B.ax * of.BC_x + B.ay * of.BC_y - of.w_BC * of.w_BC * coupler * coupler +
                of.w_DC * of.w_DC * BC_DC) *
              of.one_by_area;
    return of;
  }

  /// Position, velocity and acceleration of the coupler point.
  [[nodiscard]] Listed<Scalar, 6> motion(const Scalar& angle, const Scalar& velocity,
                                         const Scalar& acceleration) const {
    using std::cos;
    using std::sin;
    const CrankEnd B = crank_end(cos(angle), sin(angle), velocity, acceleration);
    const Scalar x = ground - B.x;
    const Scalar y = -B.y;
    const auto [reached, along, across] = corners<Scalar>(x, y, coupler, rocker);
    if (!reached) {
      return {};
    }
    const Scalar part = reach / coupler;
    const auto configuration = [&, along = along](const Scalar& left) -> std::array<Scalar, 6> {
      const Bars of = bars(B, x, y, along, left);
      const Scalar w_square = of.w_BC * of.w_BC;
      return {B.x + part * of.BC_x,
              B.y + part * of.BC_y,
              B.vx - part * of.w_BC * of.BC_y,
              B.vy + part * of.w_BC * of.BC_x,
              B.ax - part * (of.a_BC * of.BC_y + w_square * of.BC_x),
              B.ay + part * (of.a_BC * of.BC_x - w_square * of.BC_y)};
    };
    return {2, {configuration(across), configuration(-across)}};
  }
};

}  // namespace by_hand

}  // namespace assur::speed
