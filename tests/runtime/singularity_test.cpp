// Law: at a singular Jacobian a motion that leaves the closures' range is a fold, one that stays in
// it a crossing; and no singular configuration is called regular.
#include <Eigen/LU>
#include <array>
#include <assur/kinematics.hpp>
#include <assur/singularity.hpp>
#include <iostream>
#include <random>

#include "runtime/model_types.hpp"

namespace assur::test::singularity_test {
namespace {

constexpr unsigned seed = 5;
constexpr int samples = 200;

// Matrices below have no fixed size, so that what computes with them is compiled once for all
// models.

/// Any x with A x = -b.
Eigen::VectorXd solution_of(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  return A.fullPivLu().solve(-b);
}

/// The product, summed from the first column to the last.
Eigen::VectorXd product(const Eigen::MatrixXd& A, const Eigen::VectorXd& x) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(A.rows());
  for (Eigen::Index column = 0; column < A.cols(); ++column) {
    sum += A.col(column) * x(column);
  }
  return sum;
}

/// Copies the columns of a matrix into a larger one, from a column on.
template <int Rows, int Columns>
void put(const Matrix<double, Rows, Columns>& from, Eigen::MatrixXd& to,
         Eigen::Index first_column) {
  std::copy_n(from.data(), Rows * Columns, to.data() + first_column * Rows);
}

/// Draws variables and rates.
class Draws {
 public:
  using Range = std::uniform_real_distribution<double>;

  void fill(double& member, Range& range) { member = range(engine_); }
  void fill(Direction<double>& member, Range& /*range*/) {
    member = direction_of(angles_(engine_));
  }
  Eigen::VectorXd rates(int count) {
    Eigen::VectorXd drawn(count);
    for (int index = 0; index < count; ++index) {
      drawn(index) = rates_(engine_);
    }
    return drawn;
  }

  Range lengths{0.5, 2};
  Range coordinates{-2, 2};

 private:
  std::mt19937 engine_{seed};
  Range angles_{-3.1, 3.1};
  Range rates_{-1, 1};
};

template <typename Model>
struct SingularGroup {
  typename Model::template Dimensions<double> d;
  typename Model::template Inputs<double> u;
  typename Model::template Configuration<double> q;
};

template <typename Model>
class Singular : public testing::Test {
 protected:
  using Group = SingularGroup<Model>;
  static constexpr int parameter_count = Model::dimension_count + Model::input_count;

  /// Draws a group between two random ones at which the determinant of the core vanishes. Returns
  /// false if its sign is the same at both.
  bool draw(Group& group) {
    std::array<Group, 2> ends = {random_group(), random_group()};
    if (core(ends[0]) * core(ends[1]) >= 0) {
      return false;
    }
    if (core(ends[0]) > 0) {
      std::swap(ends[0], ends[1]);
    }
    double low = 0;
    double high = 1;
    for (int halving = 0; halving < 100; ++halving) {
      const double middle = low + (high - low) / 2;
      group = between(ends[0], ends[1], middle);
      (core(group) < 0 ? low : high) = middle;
    }
    return std::abs(core(group)) < 1e-14;
  }

  /// [F_d F_u].
  static Eigen::MatrixXd parameters(const Group& group) {
    Matrix<double, Model::equation_count, Model::dimension_count> f_d;
    Matrix<double, Model::equation_count, Model::input_count> f_u;
    Model::dimension_jacobian(group.d, group.u, group.q, f_d);
    Model::input_jacobian(group.d, group.u, group.q, f_u);
    Eigen::MatrixXd both(Model::equation_count, parameter_count);
    put(f_d, both, 0);
    put(f_u, both, Model::dimension_count);
    return both;
  }

  static Singularity<double> along(const Group& group, const Eigen::VectorXd& rate) {
    Vector<double, Model::dimension_count> d_rate;
    Vector<double, Model::input_count> u_rate;
    std::copy_n(rate.data(), Model::dimension_count, d_rate.data());
    std::copy_n(rate.data() + Model::dimension_count, Model::input_count, u_rate.data());
    return singularity_along<Model, double>(group.d, group.u, group.q, d_rate, u_rate);
  }

  Draws draws;

 private:
  Group random_group() {
    Group group;
    for_each_member(group.d,
                    [this](auto& member, std::size_t) { draws.fill(member, draws.lengths); });
    for_each_member(group.u,
                    [this](auto& member, std::size_t) { draws.fill(member, draws.coordinates); });
    for_each_member(group.q,
                    [this](auto& member, std::size_t) { draws.fill(member, draws.coordinates); });
    return group;
  }

  static Group between(const Group& one, const Group& other, double part) {
    Group group = one;
    const auto mix = [part](auto& member, const auto& target) {
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
        member += part * (target - member);
      } else {
        member = direction_of(angle_of(member) + part * (angle_of(target) - angle_of(member)));
      }
    };
    for_each_pair(group.d, other.d, mix);
    for_each_pair(group.u, other.u, mix);
    for_each_pair(group.q, other.q, mix);
    return group;
  }

  /// det J, up to its sign and the pivots outside the core.
  static double core(const Group& group) {
    Vector<double, Model::pivot_count> pivots;
    Vector<double, Model::pivot_count> sizes;
    double terms = 0;
    Model::degeneracies(group.d, group.u, group.q, pivots, sizes, terms);
    double product = 1;
    for (int index = 0; index < Model::core_pivot_count; ++index) {
      product *= pivots(index);
    }
    return product;
  }
};

TYPED_TEST_SUITE(Singular, AllModels, ModelNames);

TYPED_TEST(Singular, TypeFollowsTheMotion) {
  using Model = TypeParam;
  if constexpr (Model::rigid) {
    double smallest_at_fold = 1;
    double largest_at_crossing = 0;
    int compared = 0;
    for (int sample = 0; sample < samples; ++sample) {
      SingularGroup<Model> group;
      if (!this->draw(group)) {
        continue;
      }
      ++compared;
      EXPECT_NE((regularity<Model, double>(group.d, group.u, group.q).status), Status::ok);
      const auto fold = this->along(group, this->draws.rates(TestFixture::parameter_count));
      Matrix<double, Model::equation_count, Model::unknown_count> jacobian;
      Model::jacobian(group.d, group.u, group.q, jacobian);
      Eigen::MatrixXd of_unknowns(Model::equation_count, Model::unknown_count);
      put(jacobian, of_unknowns, 0);
      // Any dq/dt makes a motion that stays in the range.
      const Eigen::VectorXd within = product(of_unknowns, this->draws.rates(Model::unknown_count));
      const auto crossing = this->along(group, solution_of(TestFixture::parameters(group), within));
      if (fold.transversality > 1e-4) {  // a random motion may come close to the range
        EXPECT_EQ(fold.type, SingularityType::fold) << fold.transversality << " " << fold.distance;
      }
      EXPECT_EQ(crossing.type, SingularityType::crossing)
          << crossing.transversality << " " << crossing.distance;
      smallest_at_fold = std::min(smallest_at_fold, fold.transversality);
      largest_at_crossing = std::max(largest_at_crossing, crossing.transversality);
    }
    std::cout << model_name<Model>() << ", seed " << seed << ", " << compared
              << " singular groups: transversality at least " << smallest_at_fold
              << " at folds, at most " << largest_at_crossing << " at crossings\n";
    EXPECT_GT(compared, samples / 5);
  }
}

}  // namespace
}  // namespace assur::test::singularity_test
