// Law: seeded numbers are the same with every compiler and library, so that verdicts at them are.
#include "equations/seeded_numbers.hpp"

#include <gtest/gtest.h>

namespace assur::test::seeded_numbers_test {
namespace {

using GiNaC::numeric;

TEST(SeededNumbers, AreThoseOfTheirSeed) {
  generator::equations::SeededNumbers random(1);
  EXPECT_EQ(random.integer(0, 1000), 539);
  EXPECT_EQ(random.number(), numeric(-22, 15));
  EXPECT_EQ(random.number(), numeric(-19, 3));
  const generator::equations::Vector2 direction = random.direction();
  EXPECT_TRUE(direction.x.is_equal(numeric(13, 85))) << direction.x;
  EXPECT_TRUE(direction.y.is_equal(numeric(84, 85))) << direction.y;
}

}  // namespace
}  // namespace assur::test::seeded_numbers_test
