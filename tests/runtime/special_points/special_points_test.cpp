// Laws over all models: the special point method is defined where geometry says so, its equations
// hold exactly, and it gives the motion that the Jacobian gives.
#include <assur/special_points.hpp>
#include <iostream>
#include <numeric>
#include <vector>

#include "largest.hpp"
#include "runtime/exact_assembly.hpp"
#include "runtime/model_types.hpp"
#include "runtime/motion_error.hpp"

namespace assur::test::special_points_test {
namespace {

constexpr unsigned seed = 20110;
constexpr int exact_samples = 5;
constexpr int samples = 400;

/// Which links prismatic joints hold to one angle; the base is the last.
template <typename Model>
std::vector<int> links_turning_together() {
  std::vector<int> set(static_cast<std::size_t>(Model::link_count) + 1);
  std::iota(set.begin(), set.end(), 0);
  for (const ModelJoint& joint : Model::joints) {
    if (joint.prismatic) {
      const int first = joint.first == base_link ? Model::link_count : joint.first;
      const int kept = set[static_cast<std::size_t>(first)];
      const int merged = set[static_cast<std::size_t>(joint.second)];
      for (int& member : set) {
        member = member == merged ? kept : member;
      }
    }
  }
  return set;
}

/// Geometry's verdict. A side has its line unless the closure link is only shifted, because the
/// base holds its angle, or turns in one piece with a neighbour that a pin holds to the base.
template <typename Model>
bool special_points_exist() {
  const std::vector<int> set = links_turning_together<Model>();
  const auto angle = [&](int link) { return set[static_cast<std::size_t>(link)]; };
  for (const ModelJoint& inner : Model::joints) {
    if (inner.first == base_link) {
      continue;
    }
    for (const ModelJoint& outer : Model::joints) {
      if (outer.first != base_link || outer.second != inner.first) {
        continue;
      }
      const bool only_shifted = angle(inner.second) == angle(Model::link_count);
      const bool one_piece =
          !outer.prismatic && !inner.prismatic && angle(inner.first) == angle(inner.second);
      if (only_shifted || one_piece) {
        return false;
      }
    }
  }
  return true;
}

template <typename Model>
class SpecialPoints : public testing::Test {
 protected:
  Assembly<Model, Rational> assembly() {
    Assembly<Model, Rational> at;
    do {
      at = {random_.variables<typename Model::template Dimensions<Rational>>(),
            random_.variables<typename Model::template Inputs<Rational>>(),
            random_.variables<typename Model::template Configuration<Rational>>()};
    } while (!close_loops(at));
    return at;
  }

  /// Whether a special point of an assembly has parallel lines, as small rational numbers may give.
  static bool has_parallel_lines(const Assembly<Model, Rational>& at) {
    Matrix<Rational, 2 * Model::closure_link_count, 3> lines;
    Model::special_point_lines(at.d, at.u, at.q, lines);
    bool parallel = false;
    for (int i = 0; i < 2 * Model::closure_link_count; i += 2) {
      parallel = parallel || lines(i, 0) * lines(i + 1, 1) == lines(i, 1) * lines(i + 1, 0);
    }
    return parallel;
  }

  RandomInputs random_{seed + static_cast<unsigned>(Model::number)};
};

/// The method is the tetrad's: the other groups have no closure link, or one in two loops.
TYPED_TEST_SUITE(SpecialPoints, TypesOf<tetrad::Models>::Type, ModelNames);

TYPED_TEST(SpecialPoints, AreDefinedWhereGeometrySaysSo) {
  using Model = TypeParam;
  EXPECT_EQ(Model::closure_link_count, 2);
  EXPECT_EQ(Model::has_special_points, Model::rigid && special_points_exist<Model>());
}

TYPED_TEST(SpecialPoints, EquationsHoldExactly) {
  using Model = TypeParam;
  if constexpr (Model::has_special_points) {
    constexpr int points = Model::closure_link_count;
    constexpr int sides = 2 * points;
    for (int sample = 0; sample < exact_samples; ++sample) {
      const Assembly<Model, Rational> at = this->assembly();
      if (this->has_parallel_lines(at)) {
        continue;
      }
      Matrix<Rational, sides, 3> lines;
      Model::special_point_lines(at.d, at.u, at.q, lines);
      // Rational numbers have no root for unit normals; with n / (n . n) it is L n that moves S.
      Matrix<Rational, sides, 2> scaled;
      for (int side = 0; side < sides; ++side) {
        const Rational square = lines(side, 0) * lines(side, 0) + lines(side, 1) * lines(side, 1);
        scaled(side, 0) = lines(side, 0) / square;
        scaled(side, 1) = lines(side, 1) / square;
      }
      Matrix<Rational, points, 2> S;
      for (int point = 0; point < points; ++point) {
        const int i = 2 * point;
        const Rational cross = lines(i, 0) * lines(i + 1, 1) - lines(i, 1) * lines(i + 1, 0);
        S(point, 0) = (lines(i, 2) * lines(i + 1, 1) - lines(i + 1, 2) * lines(i, 1)) / cross;
        S(point, 1) = (lines(i, 0) * lines(i + 1, 2) - lines(i + 1, 0) * lines(i, 2)) / cross;
      }
      const auto q1 = this->random_.template vector<Vector<Rational, Model::unknown_count>>();
      const auto q2 = this->random_.template vector<Vector<Rational, Model::unknown_count>>();
      const auto u1 = this->random_.template vector<Vector<Rational, Model::input_count>>();
      const auto u2 = this->random_.template vector<Vector<Rational, Model::input_count>>();
      Matrix<Rational, sides, Model::unknown_count> L;
      Matrix<Rational, sides, 2> v;
      Matrix<Rational, sides, 2> a;
      Model::special_point_lengths(at.d, at.u, at.q, S, scaled, L);
      Model::special_point_velocities(at.d, at.u, at.q, S, u1, v);
      Model::special_point_accelerations(at.d, at.u, at.q, S, q1, u1, u2, a);

      Matrix<Rational, Model::equation_count, Model::unknown_count> J;
      Vector<Rational, Model::equation_count> velocity_rhs;
      Vector<Rational, Model::equation_count> acceleration_rhs;
      Model::jacobian(at.d, at.u, at.q, J);
      Model::velocity_rhs(at.d, at.u, at.q, u1, velocity_rhs);
      Model::acceleration_rhs(at.d, at.u, at.q, q1, u1, u2, acceleration_rhs);
      Matrix<Rational, Model::link_count, 3> link_v;
      Matrix<Rational, Model::link_count, 3> link_a;
      Model::link_velocities(at.d, at.u, at.q, q1, u1, link_v);
      Model::link_accelerations(at.d, at.u, at.q, q1, q2, u1, u2, link_a);
      for (int point = 0; point < points; ++point) {
        const int i = 2 * point;
        const int link = Model::closure_links[static_cast<std::size_t>(point)];
        const Vector<Rational, 2> arm(S(point, 0), S(point, 1));
        const Vector<Rational, 2> across(-arm(1), arm(0));
        const Rational omega = link_v(link, 2);
        for (int axis = 0; axis < 2; ++axis) {
          const int row = i + axis;  // loop by loop, and each loop has one closure link
          Rational velocity = v(i, axis);
          Rational acceleration = a(i, axis);
          for (int k = 0; k < Model::unknown_count; ++k) {
            const Rational first = lines(i, axis) * L(i, k);
            EXPECT_TRUE(J(row, k) == first - lines(i + 1, axis) * L(i + 1, k));
            velocity = velocity + first * q1(k);
            acceleration = acceleration + first * q2(k);
          }
          EXPECT_TRUE(velocity_rhs(row) == v(i + 1, axis) - v(i, axis));
          EXPECT_TRUE(acceleration_rhs(row) == a(i + 1, axis) - a(i, axis));
          // S moves as a point of the link.
          EXPECT_TRUE(velocity == link_v(link, axis) + omega * across(axis));
          EXPECT_TRUE(acceleration == link_a(link, axis) + link_a(link, 2) * across(axis) -
                                          omega * omega * arm(axis));
        }
      }
    }
  }
}

TYPED_TEST(SpecialPoints, MotionIsThatOfTheJacobian) {
  using Model = TypeParam;
  if constexpr (Model::has_special_points) {
    using Rates = Vector<double, Model::input_count>;
    double worst = 0;
    double worst_of_jacobian = 0;
    double worst_ratio = 0;  // of an error to epsilon condition(L)
    int near = 0;
    int parallel = 0;
    int compared = 0;
    for (int sample = 0; sample < samples; ++sample) {
      const Assembly<Model, Rational> exact_at = this->assembly();
      const auto at = rounded<double>(exact_at);
      const auto longer = rounded<long double>(exact_at);
      const auto u1 = this->random_.template vector<Rates>();
      const auto u2 = this->random_.template vector<Rates>();
      Motion<Model, double> by_jacobian;
      if (motion<Model, double>(at.d, at.u, at.q, u1, u2, by_jacobian) != Status::ok) {
        continue;
      }
      Motion<Model, long double> truth;
      ASSERT_EQ(
          (motion<Model, long double>(longer.d, longer.u, longer.q, u1.template cast<long double>(),
                                      u2.template cast<long double>(), truth)),
          Status::ok);
      const SpecialPointSystem<Model, double> system(at.d, at.u, at.q);
      Motion<Model, double> found;
      const Status status = special_point_motion<Model, double>(at.d, at.u, at.q, u1, u2, found);
      EXPECT_EQ(status == Status::point_at_infinity, this->has_parallel_lines(exact_at));
      if (status == Status::point_at_infinity || status == Status::near_singular) {
        ++(status == Status::near_singular ? near : parallel);
        continue;
      }
      ASSERT_EQ(status, Status::ok) << to_string(status);
      const double relative = relative_error(at, u1, u2, found, truth);
      worst = largest(worst, relative);
      worst_ratio = largest(worst_ratio, relative * system.reciprocal_condition() /
                                             std::numeric_limits<double>::epsilon());
      worst_of_jacobian =
          largest(worst_of_jacobian, relative_error(at, u1, u2, by_jacobian, truth));
      ++compared;
    }
    std::cout << model_name<Model>() << ", seed " << seed << ": " << compared
              << " configurations, largest relative error " << worst << " by special points ("
              << worst_ratio << " epsilon condition), " << worst_of_jacobian << " by the Jacobian; "
              << near << " near-singular, " << parallel << " with parallel lines\n";
    EXPECT_GT(compared, samples / 2);
    EXPECT_LT(worst, 1e-9);
    EXPECT_LT(worst_ratio, 64);
  }
}

TEST(SpecialPointTable, ServesTwentyKinds) {
  std::string kinds;
  int count = 0;
  std::apply(
      [&](auto... model) {
        (
            [&] {
              using Model = decltype(model);
              if (Model::has_special_points) {
                for (const auto& roles : Model::kinds) {
                  kinds += std::string(" ") + roles.kind;
                  ++count;
                }
              }
            }(),
            ...);
      },
      tetrad::Models());
  std::cout << count << " kinds have special points:" << kinds << '\n';
  EXPECT_EQ(count, 20);
}

}  // namespace
}  // namespace assur::test::special_points_test
