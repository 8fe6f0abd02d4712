// Law: the generated Jacobians agree with the residual's numerical derivatives, by the complex step
// and by central differences with Richardson extrapolation.
#include <complex>
#include <iostream>

#include "largest.hpp"
#include "runtime/exact.hpp"
#include "runtime/model_types.hpp"

namespace assur::test::numeric_derivatives_test {
namespace {

constexpr int samples = 50;
constexpr unsigned seed = 31415;

using Complex = std::complex<double>;

/// A variable displaced by i*h: to first order a length grows and an angle turns.
double imaginary_step() { return 1e-40; }
Complex stepped(double length, bool chosen) { return {length, chosen ? imaginary_step() : 0.0}; }
Direction<Complex> stepped(const Direction<double>& angle, bool chosen) {
  const double h = chosen ? imaginary_step() : 0.0;
  return {{angle.cos, -h * angle.sin}, {angle.sin, h * angle.cos}};
}

template <typename To, typename From>
To stepped_variables(const From& from, int chosen) {
  To result;
  int index = 0;
  for_each_pair(result, from, [&](auto& target, const auto& source) {
    target = stepped(source, index++ == chosen);
  });
  return result;
}

template <typename Model>
struct Point {
  typename Model::template Dimensions<double> d;
  typename Model::template Inputs<double> u;
  typename Model::template Configuration<double> q;
};

/// The lists of variables of a point, each of which has a Jacobian.
enum class List : unsigned char { unknowns, dimensions, inputs };

template <typename Model>
using Residual = Vector<double, Model::equation_count>;

template <typename Model>
Residual<Model> complex_step(const Point<Model>& at, List list, int index) {
  const auto pick = [&](List which) { return which == list ? index : -1; };
  Vector<Complex, Model::equation_count> f;
  Model::residual(
      stepped_variables<typename Model::template Dimensions<Complex>>(at.d, pick(List::dimensions)),
      stepped_variables<typename Model::template Inputs<Complex>>(at.u, pick(List::inputs)),
      stepped_variables<typename Model::template Configuration<Complex>>(at.q,
                                                                         pick(List::unknowns)),
      f);
  return f.imag() / imaginary_step();
}

template <typename Model>
Residual<Model> moved_residual(Point<Model> at, List list, int index, double step) {
  const auto move = [&](auto& variables, auto zero) {
    zero(index) = step;
    advance(variables, zero);
  };
  switch (list) {
    case List::unknowns:
      move(at.q, Vector<double, Model::unknown_count>::Zero().eval());
      break;
    case List::dimensions:
      move(at.d, Vector<double, Model::dimension_count>::Zero().eval());
      break;
    case List::inputs:
      move(at.u, Vector<double, Model::input_count>::Zero().eval());
      break;
  }
  Residual<Model> f;
  Model::residual(at.d, at.u, at.q, f);
  return f;
}

/// Central differences at h and h/2, extrapolated: error O(h^4).
template <typename Model>
Residual<Model> richardson(const Point<Model>& at, List list, int index) {
  const auto central = [&](double h) -> Residual<Model> {
    return (moved_residual(at, list, index, h) - moved_residual(at, list, index, -h)) / (2 * h);
  };
  constexpr double h = 4e-3;
  return (4 * central(h / 2) - central(h)) / 3;
}

template <typename Model>
class NumericDerivatives : public testing::Test {
 protected:
  template <typename Jacobian>
  void compare(const Point<Model>& at, List list, const Jacobian& jacobian) {
    for (int column = 0; column < jacobian.cols(); ++column) {
      const Residual<Model> exact = jacobian.col(column);
      const double size = 1 + exact.cwiseAbs().maxCoeff();
      const auto error = [&](const Residual<Model>& numeric) {
        return (numeric - exact).cwiseAbs().maxCoeff() / size;
      };
      worst_complex_ = largest(worst_complex_, error(complex_step(at, list, column)));
      worst_central_ = largest(worst_central_, error(richardson(at, list, column)));
    }
  }

  double worst_complex_ = 0;
  double worst_central_ = 0;
};

TYPED_TEST_SUITE(NumericDerivatives, AllModels, ModelNames);

TYPED_TEST(NumericDerivatives, ResidualAndJacobiansAgree) {
  using Model = TypeParam;
  RandomInputs random(seed + static_cast<unsigned>(Model::number));
  for (int sample = 0; sample < samples; ++sample) {
    const Point<Model> at{random.variables<typename Model::template Dimensions<double>>(),
                          random.variables<typename Model::template Inputs<double>>(),
                          random.variables<typename Model::template Configuration<double>>()};
    Matrix<double, Model::equation_count, Model::unknown_count> f_q;
    Matrix<double, Model::equation_count, Model::dimension_count> f_d;
    Matrix<double, Model::equation_count, Model::input_count> f_u;
    Model::jacobian(at.d, at.u, at.q, f_q);
    Model::dimension_jacobian(at.d, at.u, at.q, f_d);
    Model::input_jacobian(at.d, at.u, at.q, f_u);
    this->compare(at, List::unknowns, f_q);
    this->compare(at, List::dimensions, f_d);
    this->compare(at, List::inputs, f_u);
  }
  std::cout << model_name<Model>() << ", seed " << seed << ": largest relative error, complex step "
            << this->worst_complex_ << ", central differences " << this->worst_central_ << '\n';
  EXPECT_LT(this->worst_complex_, 4e-15);
  EXPECT_LT(this->worst_central_, 1e-10);
}

}  // namespace
}  // namespace assur::test::numeric_derivatives_test
