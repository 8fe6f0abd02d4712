// Law: the runtime's second derivatives are those of re-assembled groups, and where there are none
// the status says so.
#include <gtest/gtest.h>

#include <assur/second_order.hpp>
#include <assur/tetrad/model_01.hpp>
#include <assur/tetrad/model_02.hpp>
#include <assur/tetrad/model_17.hpp>
#include <iostream>

#include "kind_in_space.hpp"
#include "largest.hpp"
#include "richardson.hpp"

namespace assur::test::second_order_test {
namespace {

/// A random assembled group of a model, a curve of dimensions and inputs through it, and what
/// follows along the curve.
template <typename Model>
class Curve {
 public:
  using DimensionRates = Vector<Real, Model::dimension_count>;
  using InputRates = Vector<Real, Model::input_count>;
  using Unknowns = Vector<Real, Model::unknown_count>;
  using Frames = Vector<Real, 3 * Model::link_count>;
  using Order = SecondOrder<Model, Real>;
  using First = FirstDerivative<Model, Real>;
  using Second = SecondDerivative<Model, Real>;

  explicit Curve(unsigned seed) {
    const KindInSpace<Model> space(Model::kinds[0], seed);
    std::array<NormalForm<Real>, static_cast<std::size_t>(Model::link_count)> forms;
    EXPECT_EQ(space.normal_forms(forms), Status::ok);
    EXPECT_EQ((fill_dimensions<Model, Real>(forms, d)), Status::ok);
    u = space.inputs();
    q = space.configuration(forms);
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> rate(-1, 1);
    for (DimensionRates* drawn : {&d_x, &d_y, &d_xy}) {
      *drawn = DimensionRates::NullaryExpr([&] { return Real(rate(engine)); });
    }
    for (InputRates* drawn : {&u_x, &u_y, &u_xy}) {
      *drawn = InputRates::NullaryExpr([&] { return Real(rate(engine)); });
    }
    // Directions of unequal length, as parameters of unequal units make them.
    d_y *= Real(1e-3);
    u_y *= Real(1e-3);
  }

  /// The first derivative along x at a distance t along y, where the direction x has turned by
  /// t (d_xy, u_xy); and the configuration there.
  First moved(Real t, typename Model::template Configuration<Real>& at) const {
    typename Model::template Dimensions<Real> d_t = d;
    typename Model::template Inputs<Real> u_t = u;
    advance(d_t, DimensionRates(t * d_y));
    advance(u_t, InputRates(t * u_y));
    at = q;
    EXPECT_EQ((refine<Model, Real>(d_t, u_t, at)), Status::ok);
    First first;
    EXPECT_EQ(Order(d_t, u_t, at).first(d_x + t * d_xy, u_x + t * u_xy, first), Status::ok);
    return first;
  }

  typename Model::template Dimensions<Real> d;
  typename Model::template Inputs<Real> u;
  typename Model::template Configuration<Real> q;
  DimensionRates d_x, d_y, d_xy;
  InputRates u_x, u_y, u_xy;
};

template <typename Model>
class RuntimeSecondOrder : public testing::Test {};
using SomeModels = testing::Types<tetrad::Model01, tetrad::Model02, tetrad::Model17>;
TYPED_TEST_SUITE(RuntimeSecondOrder, SomeModels);

TYPED_TEST(RuntimeSecondOrder, IsTheDifferenceOfFirstDerivatives) {
  using Model = TypeParam;
  using Configuration = typename Model::template Configuration<Real>;
  using Stacked = Vector<Real, Model::unknown_count + 5 * Model::link_count>;
  const Vector<Real, 2> local(Real(0.7), Real(-0.4));
  Real worst = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Curve<Model> curve(seed);
    const SecondOrder<Model, Real> order(curve.d, curve.u, curve.q);
    FirstDerivative<Model, Real> x;
    FirstDerivative<Model, Real> y;
    SecondDerivative<Model, Real> xy;
    ASSERT_EQ(order.first(curve.d_x, curve.u_x, x), Status::ok);
    ASSERT_EQ(order.first(curve.d_y, curve.u_y, y), Status::ok);
    ASSERT_EQ(order.second(x, y, curve.d_xy, curve.u_xy, xy), Status::ok);
    Poses<Real, Model::link_count> poses;
    Model::link_poses(curve.d, curve.u, curve.q, poses);
    Stacked derived;
    derived << xy.q, xy.p, Vector<Real, 2 * Model::link_count>::Zero();
    for (int link = 0; link < Model::link_count; ++link) {
      derived.template segment<2>(Model::unknown_count + 3 * Model::link_count + 2 * link) =
          point_second_derivative(link, poses[static_cast<std::size_t>(link)].direction, local, x,
                                  y, xy);
    }
    // Unknowns, frames, and the velocity of one point of each link.
    const auto first_at = [&](double t) {
      Configuration at;
      const auto first = curve.moved(t, at);
      auto d_t = curve.d;
      auto u_t = curve.u;
      advance(d_t, typename Curve<Model>::DimensionRates(t * curve.d_y));
      advance(u_t, typename Curve<Model>::InputRates(t * curve.u_y));
      Poses<Real, Model::link_count> moved;
      Model::link_poses(d_t, u_t, at, moved);
      Stacked values;
      values << first.q, first.p, Vector<Real, 2 * Model::link_count>::Zero();
      for (int link = 0; link < Model::link_count; ++link) {
        const Direction<Real>& direction = moved[static_cast<std::size_t>(link)].direction;
        const Real turning = first.p(3 * link + 2);
        const int row = Model::unknown_count + 3 * Model::link_count + 2 * link;
        values(row) =
            first.p(3 * link) - turning * (direction.sin * local(0) + direction.cos * local(1));
        values(row + 1) =
            first.p(3 * link + 1) + turning * (direction.cos * local(0) - direction.sin * local(1));
      }
      return values;
    };
    const auto difference = best_richardson<Stacked>(first_at, 1.0, 6);
    const Real scale = derived.cwiseAbs().maxCoeff();
    worst = largest(worst, (difference.derivative - derived).cwiseAbs().maxCoeff() / scale);
  }
  std::cout << "seeds 1 to 10, largest relative difference " << worst << '\n';
  EXPECT_LT(worst, 1e-11L);
}

/// Parameters have units of their own: a direction may be far shorter than another.
TYPED_TEST(RuntimeSecondOrder, IsBilinearToTheLastDigits) {
  using Model = TypeParam;
  const Curve<Model> curve(11);
  const SecondOrder<Model, Real> order(curve.d, curve.u, curve.q);
  const Real shrunk = std::ldexp(Real(1), -40);
  FirstDerivative<Model, Real> x;
  FirstDerivative<Model, Real> y;
  FirstDerivative<Model, Real> short_y;
  SecondDerivative<Model, Real> xy;
  SecondDerivative<Model, Real> short_xy;
  ASSERT_EQ(order.first(curve.d_x, curve.u_x, x), Status::ok);
  ASSERT_EQ(order.first(curve.d_y, curve.u_y, y), Status::ok);
  ASSERT_EQ(order.first(shrunk * curve.d_y, shrunk * curve.u_y, short_y), Status::ok);
  ASSERT_EQ(order.second(x, y, xy), Status::ok);
  ASSERT_EQ(order.second(x, short_y, short_xy), Status::ok);
  const Real apart = (short_xy.q / shrunk - xy.q).cwiseAbs().maxCoeff();
  EXPECT_LE(apart, 1e-17L * xy.q.cwiseAbs().maxCoeff());
  FirstDerivative<Model, Real> rest;
  ASSERT_EQ(order.first(Real(0) * curve.d_y, Real(0) * curve.u_y, rest), Status::ok);
  ASSERT_EQ(order.second(x, rest, xy), Status::ok);
  EXPECT_EQ(xy.q.cwiseAbs().maxCoeff(), 0);
  EXPECT_EQ(xy.p.cwiseAbs().maxCoeff(), 0);
}

TEST(RuntimeSecondOrderStatus, SaysWhereNothingWasComputed) {
  using Model = tetrad::Model01;
  Curve<Model> curve(1);
  FirstDerivative<Model, Real> x;
  SecondDerivative<Model, Real> xy;
  Model::Dimensions<Real> none = curve.d;
  none.CD = 0;
  const SecondOrder<Model, Real> singular(none, curve.u, curve.q);
  EXPECT_EQ(singular.status(), Status::singular);
  EXPECT_EQ(singular.first(curve.d_x, curve.u_x, x), Status::singular);
  EXPECT_EQ(singular.second(x, x, xy), Status::singular);
  const SecondOrder<Model, Real> regular(curve.d, curve.u, curve.q);
  Curve<Model>::DimensionRates no_number = curve.d_x;
  no_number(0) = std::numeric_limits<Real>::quiet_NaN();
  EXPECT_EQ(regular.first(no_number, curve.u_x, x), Status::not_finite);
  ASSERT_EQ(regular.first(curve.d_x, curve.u_x, x), Status::ok);
  EXPECT_EQ(regular.second(x, x, no_number, curve.u_xy, xy), Status::not_finite);
  const auto expect_refusal = [&](auto FirstDerivative<Model, Real>::*part) {
    FirstDerivative<Model, Real> spoilt = x;
    (spoilt.*part)(0) = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_EQ(regular.second(spoilt, x, xy), Status::not_finite);
    EXPECT_EQ(regular.second(x, spoilt, xy), Status::not_finite);
  };
  expect_refusal(&FirstDerivative<Model, Real>::d);
  expect_refusal(&FirstDerivative<Model, Real>::u);
  expect_refusal(&FirstDerivative<Model, Real>::q);
  expect_refusal(&FirstDerivative<Model, Real>::p);
  curve.u.x_B = std::numeric_limits<Real>::quiet_NaN();
  const SecondOrder<Model, Real> unknown(curve.d, curve.u, curve.q);
  EXPECT_EQ(unknown.first(curve.d_x, curve.u_x, x), Status::not_finite);
  EXPECT_EQ(unknown.second(x, x, xy), Status::not_finite);
}

}  // namespace
}  // namespace assur::test::second_order_test
