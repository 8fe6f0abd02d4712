// Law: steps are measured and limited by the rotations of links; equal configurations, and lanes of
// a pack with a number that is not finite, are found.
#include <gtest/gtest.h>

#include <assur/assemblies.hpp>
#include <assur/detail/batch/pack_verdicts.hpp>
#include <assur/detail/branch_step.hpp>
#include <assur/detail/general_search.hpp>
#include <assur/detail/limit_turns.hpp>
#include <assur/directions.hpp>
#include <assur/dyad/model_02.hpp>
#include <assur/numeric/pack.hpp>
#include <assur/tetrad/model_01.hpp>
#include <cmath>
#include <limits>

namespace assur::test::small_judgements_test {
namespace {

using Model = tetrad::Model01;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Changes of angles count as they are, changes of lengths relative to the group's size.
TEST(Steps, AreMeasuredByTheTurnsOfLinks) {
  using Dyad = dyad::Model02;
  static_assert(Dyad::unknowns[0].is_angle && !Dyad::unknowns[1].is_angle);
  using Step = Vector<double, 2>;
  EXPECT_EQ((detail::turn_of<Dyad, double>(Step(-0.25, 0), 0.5)), 0.25);
  EXPECT_EQ((detail::turn_of<Dyad, double>(Step(0.25, -2), 0.5)), 1);
  EXPECT_TRUE(std::isnan(detail::turn_of<Dyad, double>(Step(0.25, nan), 0.5)));
}

/// A step that turns a link by more than half a radian is shortened as a whole and keeps its
/// direction; but the turn of a short bar is cut alone, and does not hold back the others.
TEST(Steps, AreShortenedWhereTheyTurnTooFar) {
  using Jacobian = Matrix<double, Model::equation_count, Model::unknown_count>;
  using Step = Vector<double, Model::unknown_count>;
  const auto limited = [](const Jacobian& jacobian, Step step) {
    detail::limit_turns<Model, double>(jacobian, step);
    return step;
  };
  const Jacobian levers = Jacobian::Identity();
  EXPECT_EQ(limited(levers, Step(0.5, -0.25, 0, 0.125)), Step(0.5, -0.25, 0, 0.125));
  EXPECT_EQ(limited(levers, Step(2, -1, 0, 0.5)), Step(0.5, -0.25, 0, 0.125));
  Jacobian short_bar = levers;
  short_bar(3, 3) = 0x1p-10;
  EXPECT_EQ(limited(short_bar, Step(0.25, -0.25, 0, 8)), Step(0.25, -0.25, 0, 0.5));
}

/// Where two roots lead to one configuration, another one may be missing.
TEST(Twins, AreToldFromConfigurationsThatDiffer) {
  Assemblies<Model> found;
  found.count = 3;
  for (std::size_t index = 0; index < 3; ++index) {
    found.configurations[index].theta_BCG = direction_of(0.1 * static_cast<double>(index));
  }
  EXPECT_FALSE((detail::has_twins<Model, double>(found)));
  found.configurations[2].theta_BCG = direction_of(1e-9);
  EXPECT_TRUE((detail::has_twins<Model, double>(found)));
  found.count = 2;
  EXPECT_FALSE((detail::has_twins<Model, double>(found)));
}

/// Lanes with finite numbers are not computed again alone.
TEST(FiniteNumbers, AreToldLaneByLane) {
  using Pack = numeric::PackOf<double, 4>;
  for (const double spoilt :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (std::size_t place = 0; place < 9; ++place) {
      detail::batch::FiniteNumbers<Pack> numbers;
      for (std::size_t other = 0; other < 9; ++other) {
        Pack number(other % 2 == 0 ? 1e300 : -1e-300);
        if (other == place) {
          number.put(2, spoilt);
        }
        numbers.look_at(number, other);
      }
      EXPECT_EQ(numbers.all().bits(), 0b1011U) << place;
    }
  }
}

}  // namespace
}  // namespace assur::test::small_judgements_test
