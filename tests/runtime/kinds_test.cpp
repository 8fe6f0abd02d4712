// Law: for each of the 64 kinds the generated model, reached by relabelling, agrees with rigid
// bodies that know nothing of it: closure, poses, motion, sensitivities.
#include <assur/kinematics.hpp>
#include <iostream>
#include <set>

#include "kind_in_space.hpp"
#include "largest.hpp"
#include "model_types.hpp"

namespace assur::test {
namespace {

constexpr unsigned samples = 25;
// Second differences need the longer step: their rounding error grows with its inverse square.
constexpr Real motion_step = 1e-3L;
constexpr Real dimension_step = 1e-5L;

/// d/dt at 0 of a function known at -3h .. 3h by central differences, extrapolated by Richardson
/// twice: error O(h^6).
template <typename Sample>
auto first_derivative(const Sample& at, Real h) {
  using Value = std::decay_t<decltype(at(0))>;  // not an expression of values that are gone
  return Value((45 * (at(1) - at(-1)) - 9 * (at(2) - at(-2)) + (at(3) - at(-3))) / (60 * h));
}
template <typename Sample>
auto second_derivative(const Sample& at, Real h) {
  using Value = std::decay_t<decltype(at(0))>;
  return Value(
      (270 * (at(1) + at(-1)) - 27 * (at(2) + at(-2)) + 2 * (at(3) + at(-3)) - 490 * at(0)) /
      (180 * h * h));
}

template <typename Model>
class Kinds : public testing::Test {
 protected:
  using Space = KindInSpace<Model>;
  using Forms = std::array<NormalForm<Real>, Space::link_count>;

  /// Runs a law on random groups of every kind of the model.
  template <typename Law>
  void for_each_group(Law law) {
    for (const auto& roles : Model::kinds) {
      for (unsigned sample = 0; sample < samples; ++sample) {
        const unsigned seed = 1000 * static_cast<unsigned>(Model::number) + sample;
        SCOPED_TRACE(std::string(roles.kind) + ", seed " + std::to_string(seed));
        Space space(roles, seed);
        Forms forms;
        ASSERT_EQ(space.normal_forms(forms), Status::ok);
        typename Model::template Dimensions<Real> d;
        ASSERT_EQ((fill_dimensions<Model, Real>(forms, d)), Status::ok);
        law(space, forms, d, space.inputs(), space.configuration(forms));
      }
    }
  }
};

/// The angle between -pi and pi that differs by full turns.
Real wrapped(Real angle) { return std::remainder(angle, 2 * std::acos(Real(-1))); }

TYPED_TEST_SUITE(Kinds, AllModels, ModelNames);

TYPED_TEST(Kinds, AssembledBodiesCloseTheLoopsAndPosesAgree) {
  using Model = TypeParam;
  this->for_each_group([](const auto& space, const auto& forms, const auto& d, const auto& u,
                          const auto& q) {
    Vector<Real, Model::equation_count> f;
    Model::residual(d, u, q, f);
    EXPECT_LT(f.cwiseAbs().maxCoeff(), 1e-15L);
    Poses<Real, Model::link_count> poses;
    Model::link_poses(d, u, q, poses);
    for (int link = 0; link < Model::link_count; ++link) {
      const auto slot = static_cast<std::size_t>(link);
      const BodyPose expected = space.frame(link, forms[slot]);
      // Lines that are nearly parallel put a frame's origin far away.
      const Real size = 1 + std::abs(expected.x) + std::abs(expected.y);
      EXPECT_NEAR(static_cast<double>((poses[slot].x - expected.x) / size), 0.0, 1e-15);
      EXPECT_NEAR(static_cast<double>((poses[slot].y - expected.y) / size), 0.0, 1e-15);
      EXPECT_NEAR(static_cast<double>(wrapped(angle_of(poses[slot].direction) - expected.theta)),
                  0.0, 1e-15);
    }
    if constexpr (!Model::rigid) {
      Matrix<Real, Model::compatibility_count, 2> c;
      Model::compatibility(d, u, c);
      for (int row = 0; row < Model::compatibility_count; ++row) {
        EXPECT_NEAR(static_cast<double>(c(row, 0)), 1.0, 1e-15);
        EXPECT_NEAR(static_cast<double>(c(row, 1)), 0.0, 1e-15);
      }
    }
  });
}

TYPED_TEST(Kinds, MotionFollowsTheBodies) {
  using Model = TypeParam;
  if constexpr (Model::rigid) {
    Real worst_velocity = 0;
    Real worst_acceleration = 0;
    int compared = 0;
    this->for_each_group([&](const auto& space, const auto& forms, const auto& d, const auto& u,
                             const auto& q) {
      if (regularity<Model, Real>(d, u, q).margin < 1e-3L) {
        return;  // finite differences need room; near-singular groups are the laboratory's
      }
      // Every coordinate of the base moves with a rate and a second rate of its own.
      std::mt19937 engine(7);
      std::uniform_real_distribution<double> number(-1.0, 1.0);
      Vector<Real, Model::input_count> rate;
      Vector<Real, Model::input_count> second;
      for (int index = 0; index < Model::input_count; ++index) {
        rate(index) = number(engine);
        second(index) = number(engine);
      }
      Motion<Model, Real> q_motion;
      ASSERT_EQ((motion<Model, Real>(d, u, q, rate, second, q_motion)), Status::ok);
      // The faster the motion, the shorter the time in which differences can follow it.
      const Real h = motion_step / (1 + q_motion.velocity.cwiseAbs().maxCoeff() +
                                    std::sqrt(q_motion.acceleration.cwiseAbs().maxCoeff()));
      const auto stands = [&](int steps) {
        auto moved = space;
        const Real t = steps * h;
        int index = 0;
        for (int joint = 0; joint < Model::joint_count; ++joint) {
          if (Model::joints[static_cast<std::size_t>(joint)].first != base_link) {
            continue;
          }
          BodyJoint& at = moved.bodies.joints[space.player(joint)];
          const auto travel = [&] {
            const Real value = rate(index) * t + second(index) * t * t / 2;
            ++index;
            return value;
          };
          at.on_first.x += travel();
          at.on_first.y += travel();
          if (at.prismatic) {
            at.on_first.angle += travel();
          }
        }
        EXPECT_TRUE(moved.bodies.assemble());
        RealVector poses(3 * Model::link_count);
        for (int link = 0; link < Model::link_count; ++link) {
          const BodyPose pose = moved.frame(link, forms[static_cast<std::size_t>(link)]);
          poses.template segment<3>(3 * link) << pose.x, pose.y,
              wrapped(pose.theta - space.frame(link, forms[static_cast<std::size_t>(link)]).theta);
        }
        return poses;
      };
      std::array<RealVector, 7> stand;
      for (int index = 0; index < 7; ++index) {
        stand[static_cast<std::size_t>(index)] = stands(index - 3);
      }
      const auto at = [&](int index) { return stand[static_cast<std::size_t>(index + 3)]; };
      const RealVector v_expected = first_derivative(at, h);
      const RealVector a_expected = second_derivative(at, h);

      Matrix<Real, Model::link_count, 3> v;
      Matrix<Real, Model::link_count, 3> a;
      Model::link_velocities(d, u, q, q_motion.velocity, rate, v);
      Model::link_accelerations(d, u, q, q_motion.velocity, q_motion.acceleration, rate, second, a);
      for (int link = 0; link < Model::link_count; ++link) {
        for (int part = 0; part < 3; ++part) {
          const Real v_true = v_expected(3 * link + part);
          const Real a_true = a_expected(3 * link + part);
          worst_velocity =
              largest(worst_velocity, std::abs(v(link, part) - v_true) / (1 + std::abs(v_true)));
          worst_acceleration = largest(worst_acceleration,
                                       std::abs(a(link, part) - a_true) / (1 + std::abs(a_true)));
        }
      }
      ++compared;
    });
    std::cout << model_name<Model>() << ": " << compared << " groups, largest relative error of "
              << "velocity " << worst_velocity << ", acceleration " << worst_acceleration << '\n';
    EXPECT_GT(compared, 0);
    EXPECT_LT(worst_velocity, 1e-11L);
    EXPECT_LT(worst_acceleration, 1e-7L);
  }
}

TYPED_TEST(Kinds, SensitivitiesFollowReassembly) {
  using Model = TypeParam;
  if constexpr (Model::rigid) {
    Real worst = 0;
    int compared = 0;
    this->for_each_group([&](const auto&, const auto&, const auto& d, const auto& u,
                             const auto& q) {
      if (regularity<Model, Real>(d, u, q).margin < 1e-3L) {
        return;
      }
      Sensitivities<Model, Real> result;
      ASSERT_EQ((sensitivities<Model, Real>(d, u, q, result)), Status::ok);
      const auto change = [&](auto variables, int index, int steps, auto reassembled) {
        auto move =
            decltype(Vector<Real, std::tuple_size_v<decltype(variables.members())>>())::Zero()
                .eval();
        move(index) = steps * dimension_step;
        advance(variables, move);
        auto moved = q;
        EXPECT_EQ(reassembled(variables, moved), Status::ok);
        // The change of the unknowns, angles as angles.
        Vector<Real, Model::unknown_count> difference;
        Eigen::Index row = 0;
        const auto part = [](const auto& to, const auto& from) -> Real {
          if constexpr (std::is_same_v<std::decay_t<decltype(to)>, Real>) {
            return to - from;
          } else {
            return angle_of(turned(to, reversed(from)));
          }
        };
        for_each_pair(moved, q, [&](const auto& to, const auto& from) {
          difference(row++) = part(to, from);
        });
        return difference;
      };
      const auto compare = [&](const auto& column, const auto& expected) {
        for (int row = 0; row < Model::unknown_count; ++row) {
          worst =
              largest(worst, std::abs(column(row) - expected(row)) / (1 + std::abs(expected(row))));
        }
      };
      for (int index = 0; index < Model::dimension_count; ++index) {
        const auto at = [&](int steps) {
          return change(d, index, steps, [&](const auto& moved_d, auto& moved_q) {
            return refine<Model, Real>(moved_d, u, moved_q);
          });
        };
        compare(result.to_dimensions.col(index), first_derivative(at, dimension_step).eval());
      }
      for (int index = 0; index < Model::input_count; ++index) {
        const auto at = [&](int steps) {
          return change(u, index, steps, [&](const auto& moved_u, auto& moved_q) {
            return refine<Model, Real>(d, moved_u, moved_q);
          });
        };
        compare(result.to_inputs.col(index), first_derivative(at, dimension_step).eval());
      }
      ++compared;
    });
    std::cout << model_name<Model>() << ": " << compared
              << " groups, largest relative error of sensitivities " << worst << '\n';
    EXPECT_GT(compared, 0);
    EXPECT_LT(worst, 1e-11L);
  }
}

TEST(KindTable, CoversEveryKindOnce) {
  std::multiset<std::string> kinds;
  std::apply(
      [&](auto... model) {
        (
            [&] {
              for (const auto& roles : decltype(model)::kinds) {
                kinds.insert(roles.kind);
              }
            }(),
            ...);
      },
      tetrad::Models());
  EXPECT_EQ(kinds.size(), 64U);
  EXPECT_EQ(std::set<std::string>(kinds.begin(), kinds.end()).size(), 64U);
}

}  // namespace
}  // namespace assur::test
