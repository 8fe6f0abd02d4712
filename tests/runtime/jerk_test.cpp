// Law: the jerk of a configuration is the rate of its acceleration as the inputs move, for every
// rigid model; and rates that are not finite give none.
#include <assur/kinematics.hpp>
#include <iostream>
#include <limits>

#include "kind_in_space.hpp"
#include "largest.hpp"
#include "richardson.hpp"
#include "runtime/model_types.hpp"
#include "whole_campaign.hpp"

namespace assur::test::jerk_test {
namespace {

constexpr unsigned seed = 271;
const unsigned samples = is_whole_campaign() ? 100 : 25;

/// A random assembled group whose inputs move by a cubic of time.
template <typename Model>
struct CubicMotion {
  using Inputs = Vector<Real, Model::input_count>;

  explicit CubicMotion(unsigned number) {
    const KindInSpace<Model> space(Model::kinds[0], number);
    std::array<NormalForm<Real>, static_cast<std::size_t>(Model::link_count)> forms;
    EXPECT_EQ(space.normal_forms(forms), Status::ok);
    EXPECT_EQ((fill_dimensions<Model, Real>(forms, d)), Status::ok);
    u = space.inputs();
    q = space.configuration(forms);
    std::mt19937 engine(number);
    std::uniform_real_distribution<double> rate(-1, 1);
    for (Inputs* drawn : {&u1, &u2, &u3}) {
      *drawn = Inputs::NullaryExpr([&] { return Real(rate(engine)); });
    }
  }

  /// The inputs and the configuration on the branch; no_convergence beyond its end.
  [[nodiscard]] Status follow(Real t, typename Model::template Inputs<Real>& inputs,
                              typename Model::template Configuration<Real>& configuration) const {
    inputs = u;
    configuration = q;
    advance(inputs, Inputs(t * u1 + t * t / 2 * u2 + t * t * t / 6 * u3));
    return refine<Model, Real>(d, inputs, configuration);
  }

  /// Whether the branch goes on for some time before and after.
  [[nodiscard]] bool lasts(Real time) const {
    auto inputs = u;
    auto configuration = q;
    return follow(time, inputs, configuration) == Status::ok &&
           follow(-time, inputs, configuration) == Status::ok;
  }

  [[nodiscard]] Motion<Model, Real> at(Real t) const {
    auto inputs = u;
    auto configuration = q;
    EXPECT_EQ(follow(t, inputs, configuration), Status::ok);
    Motion<Model, Real> moving;
    EXPECT_EQ((motion<Model, Real>(d, inputs, configuration, u1 + t * u2 + t * t / 2 * u3,
                                   u2 + t * u3, moving)),
              Status::ok);
    return moving;
  }

  typename Model::template Dimensions<Real> d;
  typename Model::template Inputs<Real> u;
  typename Model::template Configuration<Real> q;
  Inputs u1, u2, u3;
};

template <typename Model>
class Jerk : public testing::Test {};
TYPED_TEST_SUITE(Jerk, AllModels, ModelNames);

TYPED_TEST(Jerk, IsTheDifferenceOfAccelerations) {
  using Model = TypeParam;
  if constexpr (Model::rigid) {
    using Unknowns = Vector<Real, Model::unknown_count>;
    double worst = 0;
    int compared = 0;
    for (unsigned number = seed; number < seed + samples; ++number) {
      const CubicMotion<Model> moves(number);
      constexpr double step = 1e-3;
      if (regularity<Model, Real>(moves.d, moves.u, moves.q).margin < Real(1e-3) ||
          !moves.lasts(step)) {
        continue;  // differences lose too many digits, or reach beyond a fold
      }
      ++compared;
      Unknowns found;
      ASSERT_EQ((jerk<Model, Real>(moves.d, moves.u, moves.q, moves.u1, moves.u2, moves.u3,
                                   moves.at(0), found)),
                Status::ok);
      const auto acceleration = [&](double t) { return moves.at(t).acceleration; };
      const auto difference = best_richardson<Unknowns>(acceleration, step, 4);
      const Real error = (found - difference.derivative).cwiseAbs().maxCoeff();
      worst = largest(worst, static_cast<double>(error / (1 + found.cwiseAbs().maxCoeff())));
    }
    std::cout << model_name<Model>() << ", seed " << seed << ", " << compared
              << " groups: largest relative error " << worst << '\n';
    EXPECT_GT(compared, 0);
    EXPECT_LT(worst, 1e-9);
  }
}

TYPED_TEST(Jerk, OfRatesThatAreNoNumbersIsNone) {
  using Model = TypeParam;
  if constexpr (Model::rigid && Model::input_count > 0) {
    const CubicMotion<Model> moves(seed);
    const Motion<Model, Real> moving = moves.at(0);
    for (const int spoilt : {0, 1, 2, 3}) {
      CubicMotion<Model> other = moves;
      Motion<Model, Real> lower = moving;
      const Real nothing = std::numeric_limits<Real>::quiet_NaN();
      (spoilt == 0   ? other.u1(0)
       : spoilt == 1 ? other.u2(0)
       : spoilt == 2 ? other.u3(0)
                     : lower.acceleration(0)) = nothing;
      Vector<Real, Model::unknown_count> found;
      EXPECT_EQ((jerk<Model, Real>(other.d, other.u, other.q, other.u1, other.u2, other.u3, lower,
                                   found)),
                Status::not_finite)
          << spoilt;
    }
  }
}

}  // namespace
}  // namespace assur::test::jerk_test
