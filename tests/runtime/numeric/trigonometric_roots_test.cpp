// Law: whenever the root finder certifies, its count is Sturm's; and near multiple roots
// double-double decides what double leaves open.
#include <gtest/gtest.h>

#include <array>
#include <assur/directions.hpp>
#include <assur/numeric/double_double.hpp>
#include <assur/numeric/trigonometric_roots.hpp>
#include <iostream>

#include "runtime/cluster_value.hpp"
#include "runtime/sturm.hpp"
#include "whole_campaign.hpp"

namespace assur::test::trigonometric_roots_test {
namespace {

constexpr unsigned seed = 66260;
using numeric::DoubleDouble;
using numeric::RootStatus;
using numeric::trigonometric_roots;
using Polynomial = TrigonometricPolynomial<double, 3>;

int exact_count(const Polynomial& T) {
  TrigonometricPolynomial<Rational, 3> exact_T;
  for (std::size_t k = 0; k <= 3; ++k) {
    exact_T.cosine[k] = exact(T.cosine[k]);
    exact_T.sine[k] = exact(T.sine[k]);
  }
  const RationalPolynomial p = half_angle_polynomial(exact_T);
  return real_root_count(p) + (p.back().is_zero() ? 1 : 0);
}

/// Factors 1 - cos(x - a) + c: a double root at a for c = 0, none for c > 0, two for c < 0.
struct Factor {
  double angle;
  double lift;
};

/// The product of up to three factors, lifted by a constant.
Polynomial product_of(const std::vector<Factor>& factors, double lift) {
  // Laurent coefficients in exp(i x), centred.
  std::vector<std::complex<double>> laurent = {1};
  for (const Factor& factor : factors) {
    const std::complex<double> half = -0.5 * std::polar(1.0, -factor.angle);
    std::vector<std::complex<double>> next(laurent.size() + 2);
    for (std::size_t k = 0; k < laurent.size(); ++k) {
      next[k] += std::conj(half) * laurent[k];
      next[k + 1] += (1 + factor.lift) * laurent[k];
      next[k + 2] += half * laurent[k];
    }
    laurent = next;
  }
  Polynomial T;
  const std::size_t middle = laurent.size() / 2;
  T.cosine[0] = laurent[middle].real() + lift;
  for (std::size_t k = 1; k <= middle; ++k) {
    T.cosine[k] = 2 * laurent[middle + k].real();
    T.sine[k] = -2 * laurent[middle + k].imag();
  }
  return T;
}

struct Outcome {
  double largest_open = 0;  // |T| where double-double did not decide, over its error
  int certified = 0;
  int by_double_double = 0;
  int undecided = 0;
};

void judge(const Polynomial& T, Outcome& outcome) {
  const auto plain = trigonometric_roots<double, 3>(T, 0.0);
  if (plain.status == RootStatus::certified) {
    EXPECT_EQ(static_cast<int>(plain.root_count), exact_count(T));
    ++outcome.certified;
    return;
  }
  TrigonometricPolynomial<DoubleDouble, 3> finer;
  for (std::size_t k = 0; k <= 3; ++k) {
    finer.cosine[k] = T.cosine[k];
    finer.sine[k] = T.sine[k];
  }
  const auto fine = trigonometric_roots<DoubleDouble, 3>(finer, DoubleDouble(0));
  if (fine.status == RootStatus::certified) {
    EXPECT_EQ(static_cast<int>(fine.root_count), exact_count(T));
    ++outcome.by_double_double;
  } else {
    ++outcome.undecided;
    outcome.largest_open = std::max(outcome.largest_open,
                                    largest_cluster_value<DoubleDouble, 3>(finer, DoubleDouble(0)));
  }
}

void report(const char* family, const Outcome& outcome) {
  std::cout << family << ", seed " << seed << ": " << outcome.certified << " certified in double, "
            << outcome.by_double_double << " in double-double, " << outcome.undecided
            << " undecided, where T is at most " << outcome.largest_open << " of its error\n";
  EXPECT_LT(outcome.largest_open, 10);
}

TEST(TrigonometricRoots, RandomPolynomials) {
  RandomInputs random(seed);
  Outcome outcome;
  for (int sample = 0; sample < 2000; ++sample) {
    Polynomial T;
    for (std::size_t k = 0; k <= 3; ++k) {
      T.cosine[k] = random.length();
      T.sine[k] = k == 0 ? 0 : random.length();
    }
    judge(T, outcome);
  }
  report("random", outcome);
  EXPECT_EQ(outcome.undecided, 0);
}

TEST(TrigonometricRoots, VanishingLeadingHarmonics) {
  RandomInputs random(seed + 1);
  Outcome outcome;
  for (int exponent = 1; exponent <= 20; ++exponent) {
    for (int sample = 0; sample < 50; ++sample) {
      Polynomial T;
      for (std::size_t k = 0; k <= 3; ++k) {
        const double scale = k == 3 ? std::pow(10.0, -exponent) : 1;
        T.cosine[k] = scale * random.length();
        T.sine[k] = k == 0 ? 0 : scale * random.length();
      }
      judge(T, outcome);
    }
  }
  report("leading harmonic 1e-1 to 1e-20", outcome);
  EXPECT_EQ(outcome.undecided, 0);
}

TEST(TrigonometricRoots, NearlyDoubleRoots) {
  RandomInputs random(seed + 2);
  Outcome outcome;
  for (int exponent = 1; exponent <= 14; ++exponent) {
    for (int sample = 0; sample < 40; ++sample) {
      const double lift = (sample % 2 == 0 ? 1 : -1) * std::pow(10.0, -exponent);
      judge(product_of({{random.angle(), lift}, {random.angle(), 0.5}, {random.angle(), -0.5}}, 0),
            outcome);
    }
  }
  report("nearly double", outcome);
  EXPECT_EQ(outcome.undecided, 0);
}

TEST(TrigonometricRoots, NearlyTripleAndQuadrupleRoots) {
  RandomInputs random(seed + 3);
  Outcome outcome;
  for (int exponent = 1; exponent <= 14; ++exponent) {
    for (int sample = 0; sample < 20; ++sample) {
      // A double root and one of a pair meet at `a`: a triple root, but for the distance.
      const double a = random.angle();
      const double distance = std::pow(10.0, -exponent);
      const double width = 0.7;
      judge(product_of({{a, 0}, {a + width + distance, std::cos(width) - 1}}, 0), outcome);
      judge(product_of({{a, 0}, {a + width, std::cos(width) - 1}}, distance), outcome);
      judge(product_of({{a, 0}, {a + distance, 0}, {random.angle(), 0.4}}, 0), outcome);
    }
  }
  report("nearly triple and quadruple", outcome);
}

TEST(TrigonometricRoots, FourAndSixRootsOrFewerNearOnePoint) {
  RandomInputs random(seed + 5);
  Outcome outcome;
  const int samples = is_whole_campaign() ? 2000 : 500;
  for (int exponent = 1; exponent <= 8; ++exponent) {
    for (int sample = 0; sample < samples; ++sample) {
      // Pairs of roots, real or not, within some distances of a point; half the points are close to
      // where the charts meet.
      const double distance = std::pow(10.0, -exponent);
      const auto by_distance = [&] { return distance * random.length(); };
      const auto lift = [&] { return distance * by_distance() * (1 + sample % 3); };
      const double a = sample % 2 == 0
                           ? random.angle()
                           : 0.25 * std::acos(-1.0) * random.integer(-4, 4) + by_distance();
      const Factor third =
          sample % 4 < 2 ? Factor{random.angle(), 0.4} : Factor{a + by_distance(), lift()};
      const Polynomial T = product_of({{a, lift()}, {a + by_distance(), lift()}, third}, 0);
      judge(T, outcome);
    }
  }
  report("four or six near one point", outcome);
}

TEST(TrigonometricRoots, RootAtPi) {
  RandomInputs random(seed + 4);
  Outcome outcome;
  for (int sample = 0; sample < 200; ++sample) {
    Polynomial T;
    for (std::size_t k = 1; k <= 3; ++k) {
      // Multiples of 1/64, so that the sum at pi is exactly zero.
      T.cosine[k] = random.integer(-64, 64) / 64.0;
      T.sine[k] = random.integer(-64, 64) / 64.0;
    }
    T.cosine[0] = T.cosine[1] - T.cosine[2] + T.cosine[3];
    judge(T, outcome);
    const auto roots = trigonometric_roots<double, 3>(T, 0.0);
    double nearest = 1;
    for (std::size_t root = 0; root < roots.root_count; ++root) {
      nearest = std::min(nearest, std::abs(roots.roots[root].angle - std::acos(-1.0)));
    }
    if (roots.status == RootStatus::certified) {
      EXPECT_LT(nearest, 1e-12);
    }
  }
  report("a root at pi exactly", outcome);
}

TEST(TrigonometricRoots, VerdictsOnWhatIsNoPolynomial) {
  Polynomial T;
  EXPECT_EQ((trigonometric_roots<double, 3>(T, 0.0).status), RootStatus::vanishing);
  T.sine[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ((trigonometric_roots<double, 3>(T, 0.0).status), RootStatus::invalid);
  T.sine[2] = 1e-300;
  EXPECT_EQ((trigonometric_roots<double, 3>(T, 0.0).root_count), 4U);
  T.sine[2] = 1e300;
  EXPECT_EQ((trigonometric_roots<double, 3>(T, 0.0).root_count), 4U);
}

/// T and dT/dx in double-double at a direction of no more digits.
std::array<DoubleDouble, 2> value_and_slope(const Polynomial& T, const Direction<DoubleDouble>& x) {
  Direction<DoubleDouble> multiple = x;
  std::array<DoubleDouble, 2> result = {DoubleDouble(T.cosine[0]), DoubleDouble(0)};
  for (std::size_t k = 1; k <= 3; ++k) {
    const DoubleDouble cosine(T.cosine[k]);
    const DoubleDouble sine(T.sine[k]);
    result[0] += cosine * multiple.cos + sine * multiple.sin;
    result[1] += DoubleDouble(static_cast<int>(k)) * (sine * multiple.cos - cosine * multiple.sin);
    multiple = turned(multiple, x);
  }
  return result;
}

/// The largest |T| at the roots that are found, in epsilons of the sum of coefficients.
template <typename Scalar>
double largest_left(const Polynomial& T) {
  TrigonometricPolynomial<Scalar, 3> given;
  double sum = 0;
  for (std::size_t k = 0; k <= 3; ++k) {
    given.cosine[k] = T.cosine[k];
    given.sine[k] = T.sine[k];
    sum += std::abs(T.cosine[k]) + std::abs(T.sine[k]);
  }
  const auto found = trigonometric_roots<Scalar, 3>(given, Scalar(0));
  double left = 0;
  double before = -1;
  for (std::size_t root = 0; root < found.root_count; ++root) {
    const auto& at = found.roots[root];
    const auto [value, slope] =
        value_and_slope(T, {DoubleDouble(at.cosine), DoubleDouble(at.sine)});
    left = std::max(left, std::abs(static_cast<double>(value)));
    EXPECT_NEAR(static_cast<double>(at.slope), static_cast<double>(slope), 1e-12 * sum);
    EXPECT_LT(before, at.angle);  // by ascending angle
    before = at.angle;
  }
  return left / (sum * static_cast<double>(std::numeric_limits<Scalar>::epsilon()));
}

TEST(TrigonometricRoots, AreKnownToAFewRoundings) {
  RandomInputs random(seed + 6);
  double in_double = 0;
  double in_double_double = 0;
  for (int sample = 0; sample < 2000; ++sample) {
    Polynomial T;
    for (std::size_t k = 0; k <= 3; ++k) {
      T.cosine[k] = random.length();
      T.sine[k] = k == 0 ? 0 : random.length();
    }
    in_double = std::max(in_double, largest_left<double>(T));
    in_double_double = std::max(in_double_double, largest_left<DoubleDouble>(T));
  }
  std::cout << "random, seed " << seed + 6 << ": left of T " << in_double << " eps in double, "
            << in_double_double << " in double-double\n";
  EXPECT_LT(in_double, 8);
  EXPECT_LT(in_double_double, 8);
}

/// A cluster locates its multiple root much better than the range in which |T| is below its error.
TEST(TrigonometricRoots, ClustersAreWhereTIsFlattest) {
  RandomInputs random(seed + 7);
  double farthest = 0;
  int clusters = 0;
  for (int sample = 0; sample < 200; ++sample) {
    const double a = random.angle();
    const Polynomial T = product_of({{a, 0}, {random.angle(), 0.5}, {random.angle(), 0.5}}, 0);
    const auto found = trigonometric_roots<double, 3>(T, 0.0);
    for (std::size_t cluster = 0; cluster < found.cluster_count; ++cluster) {
      const double apart = found.clusters[cluster].angle - a;
      farthest = std::max(farthest, std::abs(std::remainder(apart, 2 * std::acos(-1.0))));
      ++clusters;
    }
  }
  std::cout << "double roots, seed " << seed + 7 << ": " << clusters << " clusters, at most "
            << farthest << " from them\n";
  EXPECT_GT(clusters, 100);
  EXPECT_LT(farthest, 1e-13);
}

}  // namespace
}  // namespace assur::test::trigonometric_roots_test
