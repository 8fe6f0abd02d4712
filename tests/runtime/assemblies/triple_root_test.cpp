// Law: near geometries at which three configurations meet, none is lost and none invented.
#include <gtest/gtest.h>

#include <assur/assemblies.hpp>
#include <assur/tetrad/model_01.hpp>
#include <assur/tetrad/model_02.hpp>
#include <assur/tetrad/model_05.hpp>
#include <iostream>

#include "least_change.hpp"
#include "runtime/compiled_models.hpp"
#include "runtime/exact.hpp"
#include "whole_campaign.hpp"

namespace assur::test::triple_root_test {
namespace {

constexpr unsigned seed = 1618;

/// T, T' and T'' at x, relative to the size of the coefficients.
template <std::size_t Degree>
Vector<double, 3> contact(const TrigonometricPolynomial<double, Degree>& T, double x) {
  Vector<double, 3> f(T.cosine[0], 0, 0);
  double scale = std::abs(T.cosine[0]);
  for (std::size_t k = 1; k <= Degree; ++k) {
    const auto order = static_cast<double>(k);
    const double c = std::cos(order * x);
    const double s = std::sin(order * x);
    f(0) += T.cosine[k] * c + T.sine[k] * s;
    f(1) += order * (T.sine[k] * c - T.cosine[k] * s);
    f(2) -= order * order * (T.cosine[k] * c + T.sine[k] * s);
    scale += std::abs(T.cosine[k]) + std::abs(T.sine[k]);
  }
  return f / scale;
}

/// Dimensions changed by Newton's least steps until T has a triple root at a random angle.
template <typename Model>
bool meet_three(RandomInputs& random, typename Model::template Dimensions<double>& d,
                const typename Model::template Inputs<double>& u) {
  constexpr int size = Model::dimension_count;
  using Step = Vector<double, size>;
  const double x = random.angle();
  const auto at = [&](const Step& change) {
    auto moved = d;
    advance(moved, change);
    TrigonometricPolynomial<double, Model::polynomial_degree> T;
    Model::position_polynomial(moved, u, T);
    return contact(T, x);
  };
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Vector<double, 3> f = at(Step::Zero());
    if (f.cwiseAbs().maxCoeff() < 1e-15) {
      return true;
    }
    Matrix<double, 3, size> jacobian;
    constexpr double h = 1e-6;
    for (int index = 0; index < size; ++index) {
      const Step step = h * Step::Unit(index);
      jacobian.col(index) = (at(step) - at(-step)) / (2 * h);
    }
    const Step change = least_change(jacobian, -f);
    const double longest = change.cwiseAbs().maxCoeff();
    if (!(longest < 1e3)) {
      return false;
    }
    advance(d, Step(longest > 0.3 ? Step(change * (0.3 / longest)) : change));
  }
  return at(Step::Zero()).cwiseAbs().maxCoeff() < 1e-14;
}

template <typename Model>
class TripleRoot : public testing::Test {};
using Models = testing::Types<tetrad::Model01, tetrad::Model02, tetrad::Model05>;
TYPED_TEST_SUITE(TripleRoot, Models);

TYPED_TEST(TripleRoot, LosesNoneAndInventsNone) {
  using Model = TypeParam;
  RandomInputs random(seed + static_cast<unsigned>(Model::number));
  int groups = 0;
  int undecided = 0;
  const int wanted = is_whole_campaign() ? 20 : 8;
  for (int attempt = 0; attempt < 400 && groups < wanted; ++attempt) {
    auto d = random.variables<typename Model::template Dimensions<double>>();
    const auto u = random.variables<typename Model::template Inputs<double>>();
    if (!meet_three<Model>(random, d, u)) {
      continue;
    }
    ++groups;
    for (int exponent = 1; exponent <= 14; ++exponent) {
      auto near = d;
      advance(near, Vector<double, Model::dimension_count>(
                        std::pow(10.0, -exponent) *
                        random.vector<Vector<double, Model::dimension_count>>()));
      const Assemblies<Model> found = compiled::assemblies<Model>(near, u);
      const int expected = compiled::exact_assembly_count<Model>(near, u);
      bool declared = found.status == AssemblyStatus::degenerate;
      for (int index = 0; index < found.count; ++index) {
        declared = declared || found.regularity[static_cast<std::size_t>(index)] != Status::ok;
      }
      if (found.count != expected && declared) {
        ++undecided;
        continue;
      }
      EXPECT_EQ(found.count, expected) << "distance 1e-" << exponent;
    }
  }
  std::cout << "model " << Model::number << ": " << groups
            << " geometries with a triple root, each at 14 distances, " << undecided
            << " answers near-singular\n";
  EXPECT_GT(groups, 0);
}

}  // namespace
}  // namespace assur::test::triple_root_test
