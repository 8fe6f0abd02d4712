// Law: a result that cannot be computed has a status that says so, and the version is the
// project's.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <assur/assur.hpp>
#include <assur/dyad/model_01.hpp>
#include <assur/tetrad/model_01.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace assur::test::status_test {
namespace {

using Model = tetrad::Model01;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// RRR-RRR in general position, and a motion of E that it can follow for a while.
struct Group {
  Model::Dimensions<double> d{1.5, 1.2, 0.8, 1.4, 1.1, -0.7, 1.3, 1.6};
  Model::Inputs<double> u{0.1, 0.2, 1.4, -0.3};
  Model::Configuration<double> q;
  Vector<double, 4> rate{0, 0, 0.3, -0.1};

  Group() {
    const auto found = assemblies<Model>(d, u);
    EXPECT_EQ(found.status, AssemblyStatus::ok);
    EXPECT_GT(found.count, 0);
    q = found.configurations[0];
  }
  [[nodiscard]] InputMotion<Model> operator()(double time) const {
    InputMotion<Model> moving{u, rate, Vector<double, 4>::Zero()};
    advance(moving.u, Vector<double, 4>(time * rate));
    return moving;
  }
};

TEST(BranchPoint, HasTheMotionAndThePivots) {
  const Group group;
  const auto point = branch_point<Model>(group.d, group(0), group.q);
  EXPECT_EQ(point.status, Status::ok);
  Motion<Model, double> expected;
  ASSERT_EQ((motion<Model, double>(group.d, group.u, group.q, group.rate, Vector<double, 4>::Zero(),
                                   expected)),
            Status::ok);
  EXPECT_EQ(point.motion.velocity, expected.velocity);
  EXPECT_EQ(point.motion.acceleration, expected.acceleration);
  Matrix<double, 4, 4> J;
  Model::jacobian(group.d, group.u, group.q, J);
  const double product = Model::determinant_sign * point.pivots.prod();
  EXPECT_NEAR(product, J.determinant(), 1e-12 * std::abs(product));
}

TEST(Assemblies, OfLengthsBelowTheSmallestWithAllDigitsAreThoseOfLongerOnes) {
  const Group group;
  const auto whole = assemblies<Model>(group.d, group.u);
  // Both groups have the lengths that few digits leave.
  const auto shortened = [](auto variables, double scale) {
    for_each_member(variables, [scale](double& length, std::size_t) { length *= scale; });
    return variables;
  };
  const auto d = shortened(group.d, 0x1p-1040);
  const auto u = shortened(group.u, 0x1p-1040);
  const auto longer = assemblies<Model>(shortened(d, 0x1p1000), shortened(u, 0x1p1000));
  const auto found = assemblies<Model>(d, u);
  EXPECT_EQ(found.status, AssemblyStatus::ok);
  ASSERT_EQ(found.count, longer.count);
  ASSERT_EQ(found.count, whole.count);
  for (int index = 0; index < found.count; ++index) {
    const auto place = static_cast<std::size_t>(index);
    for_each_pair(found.configurations[place], longer.configurations[place],
                  [](const auto& one, const auto& other) {
                    EXPECT_NEAR(one.cos, other.cos, 1e-9);
                    EXPECT_NEAR(one.sin, other.sin, 1e-9);
                  });
  }
}

TEST(BranchPoint, IsRefusedWhereTheJacobianHasNoInverse) {
  Group group;
  group.d.CD = 0;  // a bar of no length turns freely
  const auto point = branch_point<Model>(group.d, group(0), group.q);
  EXPECT_EQ(point.status, Status::singular);
  EXPECT_TRUE(point.pivots.isZero());
  const auto way = track<Model>(group.d, group, 0, 0.1, point);
  EXPECT_EQ(way.status, Status::singular);
  EXPECT_EQ(way.reached, 0);
}

TEST(BranchPoint, IsRefusedWhereSomethingIsNoNumber) {
  for (const double spoilt : {nan, infinity}) {
    for (int place = 0; place < 5; ++place) {
      Group group;
      InputMotion<Model> inputs = group(0);
      (place == 0   ? group.d.CD
       : place == 1 ? inputs.u.x_B
       : place == 2 ? inputs.rate(1)
       : place == 3 ? inputs.second_rate(2)
                    : group.q.theta_CD.sin) = spoilt;
      const auto point = branch_point<Model>(group.d, inputs, group.q);
      EXPECT_EQ(point.status, Status::not_finite) << place;
      const auto way = track<Model>(group.d, group, 0, 0.1, point);
      EXPECT_EQ(way.status, Status::not_finite) << place;
    }
  }
}

TEST(Track, OfNoWayIsItsStart) {
  const Group group;
  const auto start = branch_point<Model>(group.d, group(0), group.q);
  const auto way = track<Model>(group.d, group, 0, 0, start);
  EXPECT_EQ(way.status, Status::ok);
  EXPECT_EQ(way.reached, 0);
  EXPECT_EQ(way.point.q.theta_BCG.cos, group.q.theta_BCG.cos);
}

TEST(Track, LeavesItsStartAndEndsAtTheBranchesPoint) {
  const Group group;
  const auto start = branch_point<Model>(group.d, group(0), group.q);
  const auto way = track<Model>(group.d, group, 0, 0.1, start);
  ASSERT_EQ(way.status, Status::ok);
  EXPECT_EQ(way.reached, 0.1);
  EXPECT_EQ(way.point.status, Status::ok);
  EXPECT_TRUE((way.point.pivots.array() * start.pivots.array() > 0).all());
  auto expected = way.point.q;
  ASSERT_EQ((refine<Model, double>(group.d, group(0.1).u, expected)), Status::ok);
  for_each_pair(way.point.q, expected, [](const auto& one, const auto& other) {
    EXPECT_NEAR(one.cos, other.cos, 1e-13);
    EXPECT_NEAR(one.sin, other.sin, 1e-13);
  });
  EXPECT_EQ(start.q.theta_BCG.cos, group.q.theta_BCG.cos);
}

/// E is pulled away until the links are stretched: up to there the branch is followed.
TEST(Track, EndsAtAFold) {
  Group group;
  group.rate = {0, 0, 10, 0};
  const auto start = branch_point<Model>(group.d, group(0), group.q);
  const auto way = track<Model>(group.d, group, 0, 1, start);
  EXPECT_EQ(way.status, Status::no_convergence);
  EXPECT_GT(way.reached, 0);
  EXPECT_LT(way.reached, 1);
  EXPECT_TRUE(is_solvable(way.point.status));
  Vector<double, 4> f;
  Model::residual(group.d, group(way.reached).u, way.point.q, f);
  EXPECT_LT(f.cwiseAbs().maxCoeff(), 1e-12);
  // A little further on the branch is gone: fewer configurations are left.
  const auto before = assemblies<Model>(group.d, group(way.reached).u);
  const auto after = assemblies<Model>(group.d, group(way.reached + 0.004).u);
  EXPECT_LT(after.count, before.count);
}

TEST(Track, SaysWhatIsNoNumber) {
  const Group group;
  const auto start = branch_point<Model>(group.d, group(0), group.q);
  EXPECT_EQ((track<Model>(group.d, group, nan, 0.1, start).status), Status::not_finite);
  EXPECT_EQ((track<Model>(group.d, group, 0, infinity, start).status), Status::not_finite);
  Model::Dimensions<double> spoilt = group.d;
  spoilt.BC = nan;
  EXPECT_EQ((track<Model>(spoilt, group, 0, 0.1, start).status), Status::not_finite);
  const auto lost = [&group](double time) {
    InputMotion<Model> inputs = group(time);
    inputs.u.x_B = time > 0.25 ? nan : inputs.u.x_B;
    return inputs;
  };
  const auto way = track<Model>(group.d, lost, 0, 0.5, start);
  EXPECT_EQ(way.status, Status::not_finite);
  EXPECT_LE(way.reached, 0.25);
  EXPECT_TRUE(is_finite(way.point.q));
}

TEST(Singularity, HasAStatus) {
  Group group;
  const Vector<double, Model::dimension_count> held = Vector<double, 8>::Zero();
  const auto along = [&] {
    return singularity_along<Model, double>(group.d, group.u, group.q, held, group.rate);
  };
  EXPECT_EQ(along().status, Status::ok);
  group.rate(0) = nan;
  EXPECT_EQ(along().status, Status::not_finite);
  group.rate(0) = 0;
  group.d = {};  // no link has a length, and J vanishes
  EXPECT_EQ(along().status, Status::singular);
}

TEST(InverseJacobian, SolvesNothingWhereThereIsNone) {
  Group group;
  group.d.CD = 0;
  const InverseJacobian<Model, double> inverse(group.d, group.u, group.q);
  EXPECT_EQ(inverse.status(), Status::singular);
  EXPECT_FALSE(inverse.solve(Vector<double, 4>(1, 0, 0, 0)).allFinite());
}

TEST(NormalForm, RefusesWhatIsNoLink) {
  NormalForm<double> form;
  std::array<LinkFeature<double>, 3> features{{{false, 0, 0, {}}, {false, 2, 0, {}}, {}}};
  EXPECT_EQ(normal_form(features, 1, form), Status::singular);
  EXPECT_EQ(normal_form(features, 4, form), Status::singular);
  EXPECT_EQ(normal_form(features, 2, form), Status::ok);
  EXPECT_EQ(form.dimension_count, 1);
  features[1].y = nan;
  EXPECT_EQ(normal_form(features, 2, form), Status::not_finite);
  features[0] = {true, 0, 0, {1, 0}};
  features[1] = {true, 0, 1, {-1, 0}};
  EXPECT_EQ(normal_form(features, 2, form), Status::singular);
}

TEST(NormalForm, RefusesAFeatureOfWhichANumberIsMissing) {
  NormalForm<double> form;
  const auto expect_refusal = [&form](const LinkFeature<double>& spoilt) {
    EXPECT_EQ(normal_form({{{false, 0, 0, {}}, spoilt, {}}}, 2, form), Status::not_finite);
    EXPECT_EQ(normal_form({{spoilt, {false, 0, 0, {}}, {}}}, 2, form), Status::not_finite);
  };
  for (const double spoilt : {nan, std::numeric_limits<double>::infinity()}) {
    expect_refusal({false, spoilt, 1, {1, 0}});
    expect_refusal({false, 1, spoilt, {1, 0}});
    expect_refusal({true, 1, 1, {spoilt, 0}});
    expect_refusal({true, 1, 1, {0, spoilt}});
  }
}

TEST(NormalForm, RefusesPointsWhoseDistanceHasNoSquare) {
  NormalForm<double> form;
  for (const double far : {1e200, 1e-200}) {
    const std::array<LinkFeature<double>, 3> features{
        {{false, 0, 0, {}}, {false, 0, -far, {}}, {}}};
    EXPECT_EQ(normal_form(features, 2, form), Status::not_finite) << far;
  }
}

TEST(NormalForm, OfCoincidingPointsHasAnyAxis) {
  NormalForm<double> form;
  const std::array<LinkFeature<double>, 3> features{{{false, 1, 2, {}}, {false, 1, 2, {}}, {}}};
  ASSERT_EQ(normal_form(features, 2, form), Status::ok);
  ASSERT_EQ(form.dimension_count, 1);
  EXPECT_EQ(form.dimensions[0].length, 0);
}

TEST(NormalForm, FillsDimensionsOnlyFromTheModelsLinks) {
  std::array<NormalForm<double>, 4> forms;
  const std::array<LinkFeature<double>, 3> ternary{
      {{false, 0, 0, {}}, {false, 2, 0, {}}, {false, 1, 1, {}}}};
  Model::Dimensions<double> d;
  EXPECT_EQ((fill_dimensions<Model, double>(forms, d)), Status::singular);
  for (int link = 0; link < 4; ++link) {
    EXPECT_EQ(normal_form(ternary, link < 2 ? 3 : 2, forms[static_cast<std::size_t>(link)]),
              Status::ok);
  }
  EXPECT_EQ((fill_dimensions<Model, double>(forms, d)), Status::ok);
  EXPECT_EQ(d.BC, 2);
  EXPECT_EQ(d.y_G_BCG, 1);
  EXPECT_EQ(d.GF, 2);
  EXPECT_EQ(normal_form(ternary, 3, forms[3]), Status::ok);
  EXPECT_EQ((fill_dimensions<Model, double>(forms, d)), Status::singular);
}

TEST(AssemblyStatus, HasANameOfItsOwn) {
  std::set<std::string> names;
  for (int status = 0; status <= static_cast<int>(AssemblyStatus::unresolved); ++status) {
    names.insert(to_string(static_cast<AssemblyStatus>(status)));
  }
  EXPECT_EQ(names.size(), 5U);
  EXPECT_EQ(names.count("unknown"), 0U);
}

TEST(Version, IsThatOfTheProject) {
  EXPECT_STREQ(version, ASSUR_PROJECT_VERSION);
  EXPECT_EQ(std::to_string(ASSUR_VERSION_MAJOR) + "." + std::to_string(ASSUR_VERSION_MINOR) + "." +
                std::to_string(ASSUR_VERSION_PATCH),
            version);
}

/// A branch ends, too, where a step that is short enough does not change so long a parameter. The
/// path returns NaN after many calls, so that tracking cannot go on for ever.
TEST(Track, EndsAtAFoldAmongParametersThatAreLong) {
  using Dyad = dyad::Model01;
  const Dyad::Dimensions<double> d{1, 1};
  const double from = 0x1p50;  // the next double is a quarter away
  int asked = 0;
  const auto away = [&](double time) {
    const double x = 1 + (time - from) / 64;  // beyond reach from 64 on
    const double lost = ++asked < 10000 ? 0 : nan;
    return InputMotion<Dyad>{{0, lost, x, 0}, {0, 0, 1.0 / 64, 0}, {0, 0, 0, 0}};
  };
  const Dyad::Configuration<double> q{{0.5, std::sqrt(0.75)}, {0.5, -std::sqrt(0.75)}};
  const auto start = branch_point<Dyad>(d, away(from), q);
  ASSERT_EQ(start.status, Status::ok);
  const auto way = track<Dyad>(d, away, from, from + 100, start);
  EXPECT_EQ(way.status, Status::no_convergence);
  EXPECT_GT(way.reached, from + 60);
  EXPECT_LE(way.reached, from + 64);
}

}  // namespace
}  // namespace assur::test::status_test
