// Law: for every kind the generated model, reached by relabelling, agrees with rigid
// bodies that know nothing of it: closure, poses, motion, sensitivities.
#include <assur/kinematics.hpp>
#include <iostream>
#include <set>
#include <span>

#include "kind_in_space.hpp"
#include "largest.hpp"
#include "runtime/model_types.hpp"
#include "whole_campaign.hpp"

namespace assur::test::kinds_test {
namespace {

/// The number of groups of each kind of a model; `ctest -L long` draws all of them. Half of the
/// groups cannot be compared, so a model of few kinds needs more of each.
template <typename Model>
unsigned samples() {
  return is_whole_campaign() ? 25 : 4 + 12 / static_cast<unsigned>(Model::kinds.size());
}
// Second differences need the longer step: their rounding error grows with its inverse square.
constexpr Real motion_step = 1e-3L;
constexpr Real dimension_step = 1e-5L;

// What follows works on matrices of no fixed size, so that it is compiled once for all models.

/// d/dt at 0 of a function known at -3h .. 3h by central differences, extrapolated by Richardson
/// twice: error O(h^6).
using Stencil = std::array<RealVector, 7>;
RealVector first_derivative(const Stencil& at, Real h) {
  return (45 * (at[4] - at[2]) - 9 * (at[5] - at[1]) + (at[6] - at[0])) / (60 * h);
}
RealVector second_derivative(const Stencil& at, Real h) {
  return (270 * (at[4] + at[2]) - 27 * (at[5] + at[1]) + 2 * (at[6] + at[0]) - 490 * at[3]) /
         (180 * h * h);
}
/// Samples a function of a number of steps.
template <typename Sample>
Stencil sampled(const Sample& at) {
  Stencil stencil;
  for (std::size_t place = 0; place < stencil.size(); ++place) {
    stencil[place] = at(static_cast<int>(place) - 3);
  }
  return stencil;
}

/// The numbers of a model's vector or matrix, column by column.
template <int Rows, int Columns>
RealVector numbers(const Matrix<Real, Rows, Columns>& matrix) {
  RealVector list(Rows * Columns);
  std::copy_n(matrix.data(), Rows * Columns, list.data());
  return list;
}

Real largest_entry(const RealVector& list) { return list.cwiseAbs().maxCoeff(); }

/// The largest error of `found` against `expected`, relative to one plus the expected size.
Real worst_of(Real so_far, const RealVector& found, const RealVector& expected) {
  for (Eigen::Index index = 0; index < found.size(); ++index) {
    so_far =
        largest(so_far, std::abs(found(index) - expected(index)) / (1 + std::abs(expected(index))));
  }
  return so_far;
}

/// The angle between -pi and pi that differs by full turns.
Real wrapped(Real angle) { return std::remainder(angle, 2 * std::acos(Real(-1))); }

void expect_pose(const Pose<Real>& pose, const BodyPose& expected) {
  // Lines that are nearly parallel put a frame's origin far away.
  const Real size = 1 + std::abs(expected.x) + std::abs(expected.y);
  EXPECT_NEAR(static_cast<double>((pose.x - expected.x) / size), 0.0, 1e-15);
  EXPECT_NEAR(static_cast<double>((pose.y - expected.y) / size), 0.0, 1e-15);
  EXPECT_NEAR(static_cast<double>(wrapped(angle_of(pose.direction) - expected.theta)), 0.0, 1e-15);
}

/// Expects that angles tied by prismatic joints agree: their differences are (1, 0).
void expect_compatible(const RealVector& cosines_then_sines) {
  const Eigen::Index count = cosines_then_sines.size() / 2;
  for (Eigen::Index row = 0; row < count; ++row) {
    EXPECT_NEAR(static_cast<double>(cosines_then_sines(row)), 1.0, 1e-15);
    EXPECT_NEAR(static_cast<double>(cosines_then_sines(count + row)), 0.0, 1e-15);
  }
}

/// How the links of a model have moved, x, y and theta link by link, when every coordinate of the
/// base has travelled with its rate and its second rate for a time.
RealVector links_after(const KindBodies& space, std::span<const NormalForm<Real>> forms,
                       const RealVector& rate, const RealVector& second, Real t) {
  KindBodies moved = space;
  int index = 0;
  for (std::size_t joint = 0; joint < space.model_joints.size(); ++joint) {
    if (space.model_joints[joint].first != base_link) {
      continue;
    }
    BodyJoint& at = moved.bodies.joints[space.player(static_cast<int>(joint))];
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
  RealVector poses(3 * static_cast<Eigen::Index>(forms.size()));
  for (std::size_t link = 0; link < forms.size(); ++link) {
    const BodyPose pose = moved.frame(static_cast<int>(link), forms[link]);
    const Real before = space.frame(static_cast<int>(link), forms[link]).theta;
    poses.segment<3>(3 * static_cast<Eigen::Index>(link)) << pose.x, pose.y,
        wrapped(pose.theta - before);
  }
  return poses;
}

/// The same numbers, row by row where they stood column by column.
RealVector by_rows(const RealVector& by_columns, Eigen::Index rows) {
  const RealMatrix transposed = by_columns.reshaped(rows, by_columns.size() / rows).transpose();
  return transposed.reshaped();
}

Real difference(Real to, Real from) { return to - from; }
Real difference(const Direction<Real>& to, const Direction<Real>& from) {
  return angle_of(turned(to, reversed(from)));
}
/// The change of variables, angles as angles.
template <typename Variables>
RealVector change(const Variables& to, const Variables& from, int count) {
  RealVector list(count);
  Eigen::Index row = 0;
  for_each_pair(to, from,
                [&](const auto& one, const auto& other) { list(row++) = difference(one, other); });
  return list;
}

/// Moves one of the variables by steps, the others by nothing.
template <int Count, typename Variables>
void move_one(Variables& variables, int moved, int steps) {
  Vector<Real, Count> way;
  std::fill_n(way.data(), Count, Real(0));
  way(moved) = steps * dimension_step;
  advance(variables, way);
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
      for (unsigned sample = 0; sample < samples<Model>(); ++sample) {
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

TYPED_TEST_SUITE(Kinds, AllModels, ModelNames);

TYPED_TEST(Kinds, AssembledBodiesCloseTheLoopsAndPosesAgree) {
  using Model = TypeParam;
  this->for_each_group(
      [](const auto& space, const auto& forms, const auto& d, const auto& u, const auto& q) {
        Vector<Real, Model::equation_count> f;
        Model::residual(d, u, q, f);
        EXPECT_LT(largest_entry(numbers(f)), 1e-15L);
        Poses<Real, Model::link_count> poses;
        Model::link_poses(d, u, q, poses);
        for (std::size_t link = 0; link < poses.size(); ++link) {
          expect_pose(poses[link], space.frame(static_cast<int>(link), forms[link]));
        }
        if constexpr (!Model::rigid) {
          Matrix<Real, Model::compatibility_count, 2> c;
          Model::compatibility(d, u, c);
          expect_compatible(numbers(c));
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
        return;  // finite differences need room; near-singular groups are tested in stability/
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
      const Real h = motion_step / (1 + largest_entry(numbers(q_motion.velocity)) +
                                    std::sqrt(largest_entry(numbers(q_motion.acceleration))));
      const Stencil stands = sampled([&](int steps) {
        return links_after(space, forms, numbers(rate), numbers(second), steps * h);
      });
      Matrix<Real, Model::link_count, 3> v;
      Matrix<Real, Model::link_count, 3> a;
      Model::link_velocities(d, u, q, q_motion.velocity, rate, v);
      Model::link_accelerations(d, u, q, q_motion.velocity, q_motion.acceleration, rate, second, a);
      worst_velocity = worst_of(worst_velocity, by_rows(numbers(v), Model::link_count),
                                first_derivative(stands, h));
      worst_acceleration = worst_of(worst_acceleration, by_rows(numbers(a), Model::link_count),
                                    second_derivative(stands, h));
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
      const auto reassembled = [&q](const auto& moved_d, const auto& moved_u) {
        auto moved = q;
        EXPECT_EQ((refine<Model, Real>(moved_d, moved_u, moved)), Status::ok);
        return change(moved, q, Model::unknown_count);
      };
      const auto compare = [&worst](const RealVector& entries, int column, const Stencil& at) {
        worst =
            worst_of(worst, entries.segment(column * Model::unknown_count, Model::unknown_count),
                     first_derivative(at, dimension_step));
      };
      for (int index = 0; index < Model::dimension_count; ++index) {
        compare(numbers(result.to_dimensions), index, sampled([&](int steps) {
                  auto moved = d;
                  move_one<Model::dimension_count>(moved, index, steps);
                  return reassembled(moved, u);
                }));
      }
      for (int index = 0; index < Model::input_count; ++index) {
        compare(numbers(result.to_inputs), index, sampled([&](int steps) {
                  auto moved = u;
                  move_one<Model::input_count>(moved, index, steps);
                  return reassembled(d, moved);
                }));
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
}  // namespace assur::test::kinds_test
