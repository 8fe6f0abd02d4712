// Law: the singular point of constraints and their residual there agree with formulas, for fixed
// and dynamic sizes, with given and numerical derivatives; a fold is not one.
#include <gtest/gtest.h>

#include <assur/local/singular_point.hpp>
#include <random>

namespace assur::test::singular_point_test {
namespace {

using local::singular_point;

/// x^2 - (a + b) s x + a b s^2 + mu = 0 and y = x + s^2, turned by a constant matrix, so that no
/// equation is one of these alone: for mu = 0 the lines x = a s and x = b s cross at zero.
template <int Size>
struct Lines {
  using Scalar = double;
  static constexpr int rows = Size;
  static constexpr int unknowns = Size;
  static constexpr int most_corank = 1;
  struct Point {
    double x = 0, y = 0, s = 0;
  };
  double a, b, mu;

  [[nodiscard]] static constexpr int row_count() { return 2; }
  [[nodiscard]] static constexpr int unknown_count() { return 2; }
  [[nodiscard]] Vector<double, Size> misses(const Point& at) const {
    const double first = at.x * at.x - (a + b) * at.s * at.x + a * b * at.s * at.s + mu;
    const double second = at.y - at.x - at.s * at.s;
    Vector<double, Size> f(2);
    f << 0.6 * first - 0.8 * second, 0.8 * first + 0.6 * second;
    return f;
  }
  template <typename Step>
  void move(const Step& step, Point& at) const {
    at = {at.x + step(0), at.y + step(1), at.s + step(2)};
  }
};

/// The same with derivatives.
struct GivenLines : Lines<Eigen::Dynamic> {
  using Wide = Eigen::MatrixXd;
  [[nodiscard]] static Wide mixed(const Wide& plain) {
    const Eigen::Matrix2d mix{{0.6, -0.8}, {0.8, 0.6}};
    return mix * plain;
  }
  [[nodiscard]] Wide jacobian(const Point& at) const {
    Wide J(2, 3);
    J << 2 * at.x - (a + b) * at.s, 0, -(a + b) * at.x + 2 * a * b * at.s, -1, 1, -2 * at.s;
    return mixed(J);
  }
  [[nodiscard]] Wide bends(const Point& /*at*/, const Eigen::VectorXd& v) const {
    Wide bent(2, 3);
    bent << 2 * v(0) - (a + b) * v(2), 0, -(a + b) * v(0) + 2 * a * b * v(2), 0, 0, -2 * v(2);
    return mixed(bent);
  }
};

template <typename System>
void expect_crossing(const System& system, std::mt19937_64& random) {
  // On one of the lines, as a branch is, but for a little.
  std::uniform_real_distribution<double> near(-0.1, 0.1);
  const double s = near(random);
  const double x = system.a * s + 0.01 * near(random);
  const typename System::Point from{x, x + s * s, s};
  const auto found = singular_point(system, from, 1);
  ASSERT_TRUE(found.is_found) << system.a << " " << system.b << " " << system.mu;
  // W is the direction that was lost where the search began, which is off by as much as that place.
  const double mu = std::abs(system.mu);
  EXPECT_LT(std::abs(found.at.x) + std::abs(found.at.y) + std::abs(found.at.s), 1e-9 + mu);
  EXPECT_NEAR(found.opening, mu, 4e-16 + 0.2 * mu);
}

TEST(SingularPoint, IsWhereLinesCrossAndOpenByWhatTheyAre) {
  constexpr unsigned seed = 7;
  std::printf("seed %u\n", seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> slope(-3, 3);
  for (int index = 0; index < 200; ++index) {
    const double a = slope(random);
    const double b = a + (index % 2 == 0 ? 1 : -0.5) * (0.5 + std::abs(slope(random)));
    for (const double mu : {0.0, 1e-14, -1e-12, 1e-6}) {
      expect_crossing(Lines<2>{a, b, mu}, random);
      expect_crossing(Lines<Eigen::Dynamic>{a, b, mu}, random);
      expect_crossing(GivenLines{{a, b, mu}}, random);
    }
  }
}

/// (x - s) (x - 2 s) = 0 and (y - s) (y + s - x) = 0: both lose a rank at zero.
struct TwoCrossings {
  using Scalar = double;
  static constexpr int rows = 2;
  static constexpr int unknowns = 2;
  static constexpr int most_corank = 2;
  [[nodiscard]] static constexpr int row_count() { return 2; }
  [[nodiscard]] static constexpr int unknown_count() { return 2; }
  struct Point {
    double x = 0, y = 0, s = 0;
  };
  [[nodiscard]] static Vector<double, 2> misses(const Point& at) {
    return {(at.x - at.s) * (at.x - 2 * at.s), (at.y - at.s) * (at.y + at.s - at.x)};
  }
  static void move(const Vector<double, 3>& step, Point& at) {
    at = {at.x + step(0), at.y + step(1), at.s + step(2)};
  }
};

TEST(SingularPoint, IsFoundWhereTwoConstraintsLoseARankTogether) {
  const auto found = singular_point(TwoCrossings(), {0.02, 0.03, -0.01}, 2);
  ASSERT_TRUE(found.is_found);
  EXPECT_LT(std::abs(found.at.x) + std::abs(found.at.y) + std::abs(found.at.s), 1e-9);
  EXPECT_LT(found.opening, 1e-16);
}

/// A circle x^2 + s^2 = 1: at its extreme dF/dx vanishes, but F' does not.
struct Fold {
  using Scalar = double;
  static constexpr int rows = 1;
  static constexpr int unknowns = 1;
  static constexpr int most_corank = 1;
  [[nodiscard]] static constexpr int row_count() { return 1; }
  [[nodiscard]] static constexpr int unknown_count() { return 1; }
  struct Point {
    double x = 0, s = 0;
  };
  [[nodiscard]] static Vector<double, 1> misses(const Point& at) {
    return Vector<double, 1>(at.x * at.x + at.s * at.s - 1);
  }
  static void move(const Vector<double, 2>& step, Point& at) {
    at = {at.x + step(0), at.s + step(1)};
  }
};

TEST(SingularPoint, IsNoFold) {
  const auto found = singular_point(Fold(), {0.1, 0.995}, 1);
  EXPECT_FALSE(found.is_found && found.opening < 1e-3);
}

}  // namespace
}  // namespace assur::test::singular_point_test
