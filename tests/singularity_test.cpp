// Law: at a singular Jacobian a motion that leaves the closures' range is a fold, one that stays in
// it a crossing; and no singular configuration is called regular.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <assur/singularity.hpp>
#include <assur/tetrad/model_01.hpp>
#include <iostream>
#include <random>

namespace assur::test {
namespace {

using Model = tetrad::Model01;
constexpr unsigned seed = 5;
constexpr int samples = 200;

struct SingularGroup {
  Model::Dimensions<double> d;
  Model::Inputs<double> u;
  Model::Configuration<double> q;
};

/// A random group whose core's determinant vanishes: the determinant is linear in y_F_EDF.
SingularGroup singular_group(std::mt19937& engine) {
  std::uniform_real_distribution<double> length(0.5, 2);
  std::uniform_real_distribution<double> angle(-3.1, 3.1);
  SingularGroup group;
  const auto fill = [&](auto& member) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
      member = length(engine);
    } else {
      member = direction_of(angle(engine));
    }
  };
  std::apply([&](auto&... member) { (fill(member), ...); }, group.d.members());
  std::apply([&](auto&... member) { (fill(member), ...); }, group.q.members());
  const auto determinant = [&](double y_F) {
    group.d.y_F_EDF = y_F;
    Vector<double, Model::pivot_count> pivots;
    Vector<double, Model::pivot_count> sizes;
    double terms = 0;
    Model::degeneracies(group.d, group.u, group.q, pivots, sizes, terms);
    return pivots(0);
  };
  const double at_zero = determinant(0);
  const double slope = determinant(1) - at_zero;
  group.d.y_F_EDF = -at_zero / slope;
  return group;
}

TEST(Singularity, TypeFollowsTheMotion) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> rate(-1, 1);
  double smallest_at_fold = 1;
  double largest_at_crossing = 0;
  int compared = 0;
  for (int sample = 0; sample < samples; ++sample) {
    const SingularGroup group = singular_group(engine);
    if (!(std::abs(group.d.y_F_EDF) < 10)) {
      continue;  // the determinant hardly depends on y_F_EDF
    }
    ++compared;
    EXPECT_NE((regularity<Model, double>(group.d, group.u, group.q).status), Status::ok);
    Vector<double, Model::dimension_count> d_rate;
    for (int index = 0; index < Model::dimension_count; ++index) {
      d_rate(index) = rate(engine);
    }
    Vector<double, Model::input_count> u_rate = Vector<double, Model::input_count>::Zero();
    const auto fold = singularity_along<Model, double>(group.d, group.u, group.q, d_rate, u_rate);
    // Any dq/dt makes a motion that stays in the range: J dq/dt = -F_u du/dt - F_d dd/dt, here by
    // moving the lengths CD, BC and GF, x_G with the unknowns.
    Matrix<double, Model::equation_count, Model::unknown_count> jacobian;
    Matrix<double, Model::equation_count, Model::dimension_count> f_d;
    Model::jacobian(group.d, group.u, group.q, jacobian);
    Model::dimension_jacobian(group.d, group.u, group.q, f_d);
    Vector<double, Model::unknown_count> q_rate;
    for (int index = 0; index < Model::unknown_count; ++index) {
      q_rate(index) = rate(engine);
    }
    const Vector<double, Model::dimension_count> within =
        f_d.fullPivLu().solve(Vector<double, Model::equation_count>(-(jacobian * q_rate)));
    const auto crossing =
        singularity_along<Model, double>(group.d, group.u, group.q, within, u_rate);
    if (fold.transversality > 1e-4) {  // a random motion may come close to the range
      EXPECT_EQ(fold.type, SingularityType::fold) << fold.transversality << " " << fold.distance;
    }
    EXPECT_EQ(crossing.type, SingularityType::crossing)
        << crossing.transversality << " " << crossing.distance;
    smallest_at_fold = std::min(smallest_at_fold, fold.transversality);
    largest_at_crossing = std::max(largest_at_crossing, crossing.transversality);
  }
  std::cout << "seed " << seed << ", " << compared << " singular groups: transversality at least "
            << smallest_at_fold << " at folds, at most " << largest_at_crossing
            << " at crossings\n";
  EXPECT_GT(compared, samples / 2);
}

}  // namespace
}  // namespace assur::test
