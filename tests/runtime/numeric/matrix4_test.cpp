// Law: operations on four by four matrices agree with Eigen's, with the same pivots.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <assur/numeric/matrix4.hpp>
#include <iostream>
#include <random>

namespace assur::test::matrix4_test {
namespace {

constexpr unsigned seed = 60514;
using numeric::Elimination;
using numeric::Matrix4;
using numeric::Vector4;

Eigen::Vector4d in_eigen(const Vector4& x) { return {x(0), x(1), x(2), x(3)}; }

Eigen::Matrix4d in_eigen(const Matrix4& A) {
  Eigen::Matrix4d result;
  for (int column = 0; column < 4; ++column) {
    result.col(column) = in_eigen(A.column(column));
  }
  return result;
}

/// A matrix of small integers, so that many pivots are equally large, of at most the given rank.
Matrix4 random_matrix(int rank, std::mt19937& random) {
  std::uniform_int_distribution<int> number(-2, 2);
  Matrix4 result;
  for (int term = 0; term < rank; ++term) {
    Vector4 left;
    for (double& entry : left.entries) {
      entry = number(random);
    }
    for (Vector4& column : result.columns) {
      column = column + number(random) * left;
    }
  }
  return result;
}

TEST(Matrix4, ProductsAreThoseOfEigen) {
  std::mt19937 random(seed);
  for (int trial = 0; trial < 1000; ++trial) {
    const Matrix4 A = random_matrix(4, random);
    const Vector4 x = random_matrix(1, random).column(0);
    const Eigen::Matrix4d expected = in_eigen(A);
    EXPECT_EQ(in_eigen(transposed_product(A, x)), expected.transpose() * in_eigen(x));
    EXPECT_EQ(in_eigen(transposed(A)), expected.transpose());
    EXPECT_EQ(dot(A.column(0), x), expected.col(0).dot(in_eigen(x)));
    EXPECT_NEAR(norm(x), in_eigen(x).norm(), 1e-15 * norm(x));
    EXPECT_NEAR((in_eigen(normalised(x)) - in_eigen(x).normalized()).norm(), 0, 1e-15);
  }
}

TEST(Matrix4, EliminationChoosesThePivotsOfEigen) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  double largest = 0;
  for (const double threshold : {1e-14, 1e-4}) {
    // The noise that is added to entries is above the threshold, or below it.
    for (const double noise : {0.0, 1e-7}) {
      for (int rank = 0; rank <= 4; ++rank) {
        for (int trial = 0; trial < 2000; ++trial) {
          Matrix4 A = random_matrix(rank, random);
          Vector4 b;
          for (int row = 0; row < 4; ++row) {
            b(row) = normal(random);
            for (int column = 0; column < 4; ++column) {
              A(row, column) += noise * normal(random);
            }
          }
          const Elimination found(A, threshold);
          Eigen::FullPivLU<Eigen::Matrix4d> expected(in_eigen(A));
          expected.setThreshold(threshold);
          ASSERT_EQ(found.rank(), expected.rank()) << in_eigen(A);
          const Eigen::Vector4d x = expected.solve(in_eigen(b));
          double difference = (in_eigen(found.solve(b)) - x).norm() / (1 + x.norm());
          if (found.rank() < 4) {
            const Eigen::Matrix<double, 4, Eigen::Dynamic> kernel = expected.kernel();
            for (int index = 0; index < 4 - found.rank(); ++index) {
              const Eigen::Vector4d apart = in_eigen(found.null_vector(index)) - kernel.col(index);
              difference = std::max(difference, apart.norm());
            }
          }
          EXPECT_LT(difference, 1e-14) << in_eigen(A);
          largest = std::max(largest, difference);
        }
      }
    }
  }
  std::cout << "seed " << seed << ", largest difference " << largest << "\n";
}

TEST(Matrix4, SolutionsAndNullVectorsSatisfyTheirEquations) {
  std::mt19937 random(seed);
  for (int rank = 1; rank <= 4; ++rank) {
    for (int trial = 0; trial < 2000; ++trial) {
      const Matrix4 A = random_matrix(rank, random);
      const Eigen::Matrix4d matrix = in_eigen(A);
      const Elimination elimination(A, 1e-14);
      const Vector4 b = A.column(0) - A.column(3);
      EXPECT_LT((matrix * in_eigen(elimination.solve(b)) - in_eigen(b)).norm(), 1e-12);
      for (int index = 0; index < 4 - elimination.rank(); ++index) {
        const Eigen::Vector4d x = in_eigen(elimination.null_vector(index));
        EXPECT_LT((matrix * x).norm(), 1e-12);
        EXPECT_GE(x.norm(), 1);
      }
    }
  }
}

}  // namespace
}  // namespace assur::test::matrix4_test
