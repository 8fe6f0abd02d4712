// Law: if the first unknown is a displacement, its values are the roots of the final polynomial in
// double-double, and the result says whether they are certain.
#include <gtest/gtest.h>

#include <assur/detail/first_values.hpp>

namespace assur::test::first_values_test {
namespace {

using numeric::Bounded;
using numeric::DoubleDouble;
using Certified = Bounded<DoubleDouble>;
using Parabola = Vector<Certified, 3>;

/// Coefficients that are known to `within`.
Parabola parabola(double c0, double c1, double c2, double within = 0) {
  return {Certified(DoubleDouble(c0), within), Certified(DoubleDouble(c1), within),
          Certified(DoubleDouble(c2), within)};
}

TEST(FirstValues, OfAParabolaAreItsRoots) {
  for (const double leading : {1.0, 4.0, -0.5}) {  // leading (x - 1)(x - 3)
    const auto found = detail::first_values(parabola(3 * leading, -4 * leading, leading));
    EXPECT_TRUE(found.certain());
    ASSERT_EQ(found.count, 2U);
    EXPECT_EQ(found.list[0].cos + found.list[1].cos, DoubleDouble(4)) << leading;
    EXPECT_EQ(found.list[0].cos * found.list[1].cos, DoubleDouble(3)) << leading;
  }
  const auto none = detail::first_values(parabola(1, 0, 4));
  EXPECT_TRUE(none.certain());
  EXPECT_EQ(none.count, 0U);
}

TEST(FirstValues, OfAParabolaThatTouchesZeroIsItsVertex) {
  const auto found = detail::first_values(parabola(4.5, -6, 2, 1e-20));  // 2 (x - 1.5)^2
  EXPECT_FALSE(found.certain());
  ASSERT_EQ(found.count, 1U);
  EXPECT_EQ(found.list[0].cos, DoubleDouble(1.5));
}

TEST(FirstValues, AreNotCertainWhereOneMayHaveRunToInfinity) {
  const auto one = detail::first_values(parabola(-6, 2, 0, 1e-20));
  EXPECT_FALSE(one.certain());
  EXPECT_FALSE(one.vanishing);
  ASSERT_EQ(one.count, 1U);
  EXPECT_EQ(one.list[0].cos, DoubleDouble(3));
  EXPECT_TRUE(detail::first_values(parabola(1, 0, 0, 1e-20)).vanishing);
}

}  // namespace
}  // namespace assur::test::first_values_test
