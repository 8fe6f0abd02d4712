// Law: in double precision every generated function is within a few units in the last place of its
// exact value, which CLN's rational numbers give for the same inputs.
#include <iostream>
#include <vector>

#include "largest.hpp"
#include "runtime/exact.hpp"
#include "runtime/model_types.hpp"

namespace assur::test::rounding_test {
namespace {

constexpr int samples = 100;
constexpr unsigned seed = 27182;

/// All results of a model's functions, one list for each function.
template <typename Model, typename Scalar>
struct AllResults {
  std::vector<std::vector<Scalar>> lists;

  template <typename Matrix>
  void add(const Matrix& matrix) {
    lists.emplace_back();
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
      for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
        lists.back().push_back(matrix(row, column));
      }
    }
  }

  AllResults(const typename Model::template Dimensions<Scalar>& d,
             const typename Model::template Inputs<Scalar>& u,
             const typename Model::template Configuration<Scalar>& q,
             const Vector<Scalar, Model::unknown_count>& q1,
             const Vector<Scalar, Model::unknown_count>& q2,
             const Vector<Scalar, Model::input_count>& u1,
             const Vector<Scalar, Model::input_count>& u2) {
    Vector<Scalar, Model::equation_count> f;
    Model::residual(d, u, q, f);
    add(f);
    Matrix<Scalar, Model::equation_count, Model::unknown_count> f_q;
    Model::jacobian(d, u, q, f_q);
    add(f_q);
    Matrix<Scalar, Model::equation_count, Model::dimension_count> f_d;
    Model::dimension_jacobian(d, u, q, f_d);
    add(f_d);
    Matrix<Scalar, Model::equation_count, Model::input_count> f_u;
    Model::input_jacobian(d, u, q, f_u);
    add(f_u);
    Model::velocity_rhs(d, u, q, u1, f);
    add(f);
    Model::acceleration_rhs(d, u, q, q1, u1, u2, f);
    add(f);
    Poses<Scalar, Model::link_count> poses;
    Model::link_poses(d, u, q, poses);
    Matrix<Scalar, Model::link_count, 4> flat;
    for (int link = 0; link < Model::link_count; ++link) {
      const auto& pose = poses[static_cast<std::size_t>(link)];
      flat(link, 0) = pose.x;
      flat(link, 1) = pose.y;
      flat(link, 2) = pose.direction.cos;
      flat(link, 3) = pose.direction.sin;
    }
    add(flat);
    Matrix<Scalar, 3 * Model::link_count, Model::unknown_count> p_q;
    Matrix<Scalar, 3 * Model::link_count, Model::dimension_count> p_d;
    Matrix<Scalar, 3 * Model::link_count, Model::input_count> p_u;
    Model::pose_jacobians(d, u, q, p_q, p_d, p_u);
    add(p_q);
    add(p_d);
    add(p_u);
    Matrix<Scalar, Model::link_count, 3> rates;
    Model::link_velocities(d, u, q, q1, u1, rates);
    add(rates);
    Model::link_accelerations(d, u, q, q1, q2, u1, u2, rates);
    add(rates);
  }
};

template <typename Model>
class Rounding : public testing::Test {};
TYPED_TEST_SUITE(Rounding, AllModels, ModelNames);

TYPED_TEST(Rounding, StaysWithinUlps) {
  using Model = TypeParam;
  RandomInputs random(seed + static_cast<unsigned>(Model::number));
  const auto convert = [](const auto& value) { return exact(value); };
  const auto convert_vector = [](const auto& from, auto to) {
    for (Eigen::Index index = 0; index < from.size(); ++index) {
      to(index) = exact(from(index));
    }
    return to;
  };
  double worst = 0;
  for (int sample = 0; sample < samples; ++sample) {
    const auto d = random.variables<typename Model::template Dimensions<double>>();
    const auto u = random.variables<typename Model::template Inputs<double>>();
    const auto q = random.variables<typename Model::template Configuration<double>>();
    using UnknownRates = Vector<double, Model::unknown_count>;
    using InputRates = Vector<double, Model::input_count>;
    const auto q1 = random.vector<UnknownRates>();
    const auto q2 = random.vector<UnknownRates>();
    const auto u1 = random.vector<InputRates>();
    const auto u2 = random.vector<InputRates>();
    const AllResults<Model, double> rounded(d, u, q, q1, q2, u1, u2);
    const Vector<Rational, Model::unknown_count> no_q;
    const Vector<Rational, Model::input_count> no_u;
    const AllResults<Model, Rational> truth(
        converted<typename Model::template Dimensions<Rational>>(d, convert),
        converted<typename Model::template Inputs<Rational>>(u, convert),
        converted<typename Model::template Configuration<Rational>>(q, convert),
        convert_vector(q1, no_q), convert_vector(q2, no_q), convert_vector(u1, no_u),
        convert_vector(u2, no_u));
    for (std::size_t list = 0; list < truth.lists.size(); ++list) {
      // The unit is that of the largest entry of the function's result: an entry whose terms cancel
      // may have no correct digit of its own.
      double scale = 0;
      for (const double value : rounded.lists[list]) {
        scale = largest(scale, std::abs(value));
      }
      if (scale == 0) {
        continue;
      }
      const double ulp = scale * std::numeric_limits<double>::epsilon();
      for (std::size_t entry = 0; entry < truth.lists[list].size(); ++entry) {
        const Rational error = exact(rounded.lists[list][entry]) - truth.lists[list][entry];
        worst = largest(worst, std::abs(error.rounded()) / ulp);
      }
    }
  }
  std::cout << model_name<Model>() << ", seed " << seed << ": largest error " << worst << " ulp\n";
  EXPECT_LT(worst, 16.0);
}

}  // namespace
}  // namespace assur::test::rounding_test
