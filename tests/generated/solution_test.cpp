// Law: over rational numbers the structured elimination of every rigid model solves its linear
// equations exactly, and its pivots multiply to the determinant and stay within their bounds.
#include "runtime/exact.hpp"
#include "runtime/model_types.hpp"

namespace assur::test::solution_test {
namespace {

constexpr int samples = 10;

template <int Rows, int Columns>
using RationalMatrix = Matrix<Rational, Rows, Columns>;

template <int Rows, int Inner, int Columns>
RationalMatrix<Rows, Columns> product(const RationalMatrix<Rows, Inner>& a,
                                      const RationalMatrix<Inner, Columns>& b) {
  RationalMatrix<Rows, Columns> result;
  for (int row = 0; row < Rows; ++row) {
    for (int column = 0; column < Columns; ++column) {
      Rational sum = 0;
      for (int inner = 0; inner < Inner; ++inner) {
        sum = sum + a(row, inner) * b(inner, column);
      }
      result(row, column) = sum;
    }
  }
  return result;
}

/// The determinant of the rows from `row` on and of `columns`, by expansion along `row`.
template <int Size>
Rational determinant(const RationalMatrix<Size, Size>& matrix, std::vector<int> columns, int row) {
  if (columns.empty()) {
    return 1;
  }
  Rational sum = 0;
  for (std::size_t place = 0; place < columns.size(); ++place) {
    std::vector<int> rest = columns;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(place));
    const Rational part = matrix(row, columns[place]) * determinant<Size>(matrix, rest, row + 1);
    sum = place % 2 == 0 ? sum + part : sum - part;
  }
  return sum;
}

template <typename Model>
class Solution : public testing::Test {
 protected:
  static constexpr int size = Model::unknown_count;
  using Square = RationalMatrix<size, size>;

  /// Draws a group that is not singular; at a singularity rational numbers would divide by zero.
  void draw() {
    Vector<Rational, Model::pivot_count> pivots;
    bool singular = true;
    while (singular) {
      draw_once();
      Vector<Rational, Model::pivot_count> sizes;
      Rational terms;
      Model::degeneracies(d_, u_, q_, pivots, sizes, terms);
      singular = false;
      for (int index = 0; index < Model::pivot_count; ++index) {
        singular = singular || pivots(index).is_zero();
      }
    }
    Model::jacobian(d_, u_, q_, jacobian_);
  }

  void draw_once() {
    d_ = random_.template variables<typename Model::template Dimensions<Rational>>();
    u_ = random_.template variables<typename Model::template Inputs<Rational>>();
    q_ = random_.template variables<typename Model::template Configuration<Rational>>();
  }

  template <int Columns>
  static void expect_equal(const RationalMatrix<size, Columns>& one,
                           const RationalMatrix<size, Columns>& other, const char* what) {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < Columns; ++column) {
        EXPECT_EQ(one(row, column), other(row, column))
            << what << " (" << row << ", " << column << ")";
      }
    }
  }

  RandomInputs random_{4711U + static_cast<unsigned>(Model::number)};
  typename Model::template Dimensions<Rational> d_;
  typename Model::template Inputs<Rational> u_;
  typename Model::template Configuration<Rational> q_;
  Square jacobian_;
};

TYPED_TEST_SUITE(Solution, AllModels, ModelNames);

TYPED_TEST(Solution, InverseTimesJacobianIsOne) {
  using Model = TypeParam;
  if constexpr (Model::rigid) {
    for (int sample = 0; sample < samples; ++sample) {
      this->draw();
      typename TestFixture::Square inverse;
      Model::inverse_jacobian(this->d_, this->u_, this->q_, inverse);
      typename TestFixture::Square one;
      for (int row = 0; row < TestFixture::size; ++row) {
        for (int column = 0; column < TestFixture::size; ++column) {
          one(row, column) = row == column ? 1 : 0;
        }
      }
      this->expect_equal(product(inverse, this->jacobian_), one, "J_inverse J");
    }
  }
}

TYPED_TEST(Solution, PivotsMultiplyToTheDeterminantWithinTheirBounds) {
  using Model = TypeParam;
  if constexpr (Model::rigid) {
    for (int sample = 0; sample < samples; ++sample) {
      this->draw();
      Vector<Rational, Model::pivot_count> pivots;
      Vector<Rational, Model::pivot_count> sizes;
      Rational terms;
      Model::degeneracies(this->d_, this->u_, this->q_, pivots, sizes, terms);
      Rational expected = Model::determinant_sign;
      for (int index = 0; index < Model::pivot_count; ++index) {
        expected = expected * pivots(index);
        EXPECT_LE(abs(pivots(index)), sizes(index)) << Model::pivots[std::size_t(index)];
      }
      EXPECT_LE(abs(pivots(0)), terms);
      std::vector<int> columns;
      for (int column = 0; column < TestFixture::size; ++column) {
        columns.push_back(column);
      }
      EXPECT_EQ(determinant<TestFixture::size>(this->jacobian_, columns, 0), expected);
    }
  }
}

TYPED_TEST(Solution, SensitivitiesAndRatesSolveTheirEquations) {
  using Model = TypeParam;
  if constexpr (Model::rigid) {
    constexpr int unknowns = Model::unknown_count;
    constexpr int inputs = Model::input_count;
    for (int sample = 0; sample < samples; ++sample) {
      this->draw();
      const auto& d = this->d_;
      const auto& u = this->u_;
      const auto& q = this->q_;
      const auto u1 = this->random_.template vector<Vector<Rational, inputs>>();
      const auto u2 = this->random_.template vector<Vector<Rational, inputs>>();

      RationalMatrix<unknowns, Model::dimension_count> s_d;
      RationalMatrix<unknowns, inputs> s_u;
      Vector<Rational, unknowns> velocity;
      Vector<Rational, unknowns> q1;
      Vector<Rational, unknowns> q2;
      Model::sensitivities(d, u, q, s_d, s_u);
      Model::velocity(d, u, q, u1, velocity);
      Model::motion(d, u, q, u1, u2, q1, q2);

      RationalMatrix<unknowns, Model::dimension_count> f_d;
      RationalMatrix<unknowns, inputs> f_u;
      Vector<Rational, unknowns> velocity_rhs;
      Vector<Rational, unknowns> acceleration_rhs;
      Model::dimension_jacobian(d, u, q, f_d);
      Model::input_jacobian(d, u, q, f_u);
      Model::velocity_rhs(d, u, q, u1, velocity_rhs);
      Model::acceleration_rhs(d, u, q, q1, u1, u2, acceleration_rhs);
      this->expect_equal(product(this->jacobian_, s_d),
                         RationalMatrix<unknowns, Model::dimension_count>(-f_d), "J S_d");
      this->expect_equal(product(this->jacobian_, s_u), RationalMatrix<unknowns, inputs>(-f_u),
                         "J S_u");
      this->expect_equal(product(this->jacobian_, q1), velocity_rhs, "J dq/dt");
      this->expect_equal(product(this->jacobian_, q2), acceleration_rhs, "J d2q/dt2");
      this->expect_equal(velocity, q1, "velocity");

      RationalMatrix<unknowns, Model::dimension_count> all_s_d;
      RationalMatrix<unknowns, inputs> all_s_u;
      Vector<Rational, unknowns> all_q1;
      Vector<Rational, unknowns> all_q2;
      Model::sensitivities_and_motion(d, u, q, u1, u2, all_s_d, all_s_u, all_q1, all_q2);
      this->expect_equal(all_s_d, s_d, "all at once, S_d");
      this->expect_equal(all_s_u, s_u, "all at once, S_u");
      this->expect_equal(all_q1, q1, "all at once, dq/dt");
      this->expect_equal(all_q2, q2, "all at once, d2q/dt2");
    }
  }
}

}  // namespace
}  // namespace assur::test::solution_test
