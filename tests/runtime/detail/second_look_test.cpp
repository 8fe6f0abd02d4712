// Law: the second look at a configuration in float includes every effect that may move its
// derivatives.
#include <gtest/gtest.h>

#include <assur/detail/second_look.hpp>
#include <assur/dyad/model_01.hpp>
#include <cmath>
#include <limits>

namespace assur::test::second_look_test {
namespace {

using Model = dyad::Model01;
constexpr float epsilon = std::numeric_limits<float>::epsilon();

/// Two bars that are nearly stretched, the first half as long as the other.
struct Bars {
  Model::Dimensions<float> d{1, 2};
  Model::Configuration<float> q{direction_of(0.3F), direction_of(0.5F)};
  Model::Inputs<float> u{};

  Bars() {
    Vector<float, 2> f;
    Model::residual(d, u, q, f);
    u.x_D = f(0);
    u.y_D = f(1);
  }
  [[nodiscard]] Regularity<float> seen(float displaced, float kept, float other) const {
    Regularity<float> result;
    result.margin = 1;
    detail::look_again<Model, float>(d, u, q, displaced, {kept, 1, other}, result);
    return result;
  }
};

TEST(SecondLook, CountsWhatTheInputsAreOff) {
  const Bars bars;
  const float closures = detail::polished_rounding(1.0F);
  const float still = bars.seen(0, 1, 1).error();
  const float once = bars.seen(closures, 1, 1).error();
  const float twice = bars.seen(2 * closures, 1, 1).error();
  EXPECT_GT(still, 0);
  EXPECT_GT(once, 1.1F * still);
  EXPECT_NEAR(twice - once, once - still, 1e-3F * once);  // in proportion
}

TEST(SecondLook, CountsWhatTheEliminationLoses) {
  const Bars bars;
  const float firm = bars.seen(0, 1, 1).error();
  const auto lost = [&](float kept, float other) {
    return (bars.seen(0, kept, other).error() - firm) / epsilon;
  };
  EXPECT_NEAR(lost(0x1p-10F, 1), 4 * 1023, 1);
  EXPECT_NEAR(lost(1, 0x1p-10F), 4 * 1023, 1);
  EXPECT_NEAR(lost(0x1p-5F, 0x1p-5F), 4 * 1023, 1);
}

/// 1/firmness is how far an angle turns, to first order, if closures open by the longest length.
TEST(SecondLook, TellsHowFirmlyTheClosuresHoldAngles) {
  const Bars bars;
  Matrix<float, 2, 2> inverse;
  Model::inverse_jacobian(bars.d, bars.u, bars.q, inverse);
  const float longest = support::own_size<Model, float>(bars.d, bars.u);
  const float loose = longest * inverse.cwiseAbs().rowwise().sum().maxCoeff();
  ASSERT_GT(loose, 2);
  EXPECT_NEAR(bars.seen(0, 1, 1).firmness * loose, 1, 1e-5);
}

}  // namespace
}  // namespace assur::test::second_look_test
