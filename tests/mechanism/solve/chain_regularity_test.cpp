// Law: regular configurations of a scene of several groups have six digits of sensitivities.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <iostream>
#include <random>

#include "mechanism/scene_solutions.hpp"

namespace assur::test::chain_regularity_test {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_100;
using Lengths = std::map<std::string, double>;

struct ExactPoint {
  Exact x, y;
};

/// Where two bars that turn about p and q meet, on one side of the line from p to q.
bool meet(const ExactPoint& p, const Exact& from_p, const ExactPoint& q, const Exact& from_q,
          int side, ExactPoint& result) {
  const Exact x = q.x - p.x;
  const Exact y = q.y - p.y;
  const Exact square = x * x + y * y;
  const Exact along = (square + from_p * from_p - from_q * from_q) / (2 * square);
  const Exact across_square = from_p * from_p / square - along * along;
  if (across_square < 0) {
    return false;
  }
  const Exact across = side * sqrt(across_square);
  result = {p.x + along * x - across * y, p.y + along * y + across * x};
  return true;
}

/// Two dyads: rod BC and rocker DCP, then rod PQ and rocker EQ; B, D and E are on the ground.
struct TwoDyads {
  double away = 0;  ///< of the whole from the origin
  double x_B = 0, y_B = 0;
  Lengths lengths;  ///< BC, DC, x_D, x_P, y_P, PQ, EQ, x_E, y_E

  [[nodiscard]] Json scene() const {
    Json json;
    for (const auto& [name, value] : lengths) {
      json["parameters"][name] = value;
    }
    const std::string shift = std::to_string(std::llround(away));
    json["links"] = {{"ground",
                      {{"B", {x_B + away, y_B}},
                       {"D", {"x_D + " + shift, 0}},
                       {"E", {"x_E + " + shift, "y_E"}}}},
                     {"rod", {{"B", {0, 0}}, {"C", {"BC", 0}}}},
                     {"rocker", {{"D", {0, 0}}, {"C", {"DC", 0}}, {"P", {"x_P", "y_P"}}}},
                     {"second_rod", {{"P", {0, 0}}, {"Q", {"PQ", 0}}}},
                     {"second_rocker", {{"E", {0, 0}}, {"Q", {"EQ", 0}}}}};
    const auto pin = [&json](const std::string& name, const std::string& one,
                             const std::string& other) {
      json["joints"][name] = {{"type", "revolute"},
                              {"between", {one + "." + name, other + "." + name}}};
    };
    pin("B", "ground", "rod");
    pin("C", "rod", "rocker");
    pin("D", "ground", "rocker");
    pin("P", "rocker", "second_rod");
    pin("Q", "second_rod", "second_rocker");
    pin("E", "ground", "second_rocker");
    json["outputs"]["Q"] = "second_rod.Q";
    return json;
  }

  /// Q with one length changed and the two dyads on the given sides.
  [[nodiscard]] bool exact(const std::string& moved, const Exact& by, int first, int second,
                           ExactPoint& Q) const {
    std::map<std::string, Exact> a;
    for (const auto& [name, value] : lengths) {
      a[name] = value;
    }
    a[moved] += by;
    // The scene holds x_B + away as one number, which is rounded.
    const ExactPoint B{Exact(x_B + away) - away, y_B};
    const ExactPoint D{a["x_D"], 0};
    ExactPoint C;
    if (!meet(B, a["BC"], D, a["DC"], first, C)) {
      return false;
    }
    const Exact cos = (C.x - D.x) / a["DC"];
    const Exact sin = (C.y - D.y) / a["DC"];
    const ExactPoint P{D.x + cos * a["x_P"] - sin * a["y_P"],
                       D.y + sin * a["x_P"] + cos * a["y_P"]};
    return meet(P, a["PQ"], {a["x_E"], a["y_E"]}, a["EQ"], second, Q);
  }
};

/// The longer side of a triangle with the sides `base` and `other` and the given sine of the angle
/// opposite to `base`, which is obtuse.
double stretched(double base, double other, double sine) {
  const double along = -other * std::sqrt(1 - sine * sine);
  return along + std::sqrt(along * along + base * base - other * other);
}

class Chains {
 public:
  explicit Chains(unsigned seed) : engine_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  /// A chain whose middle pins both have a sine between 10^low and 10^high.
  TwoDyads draw(double low, double high, double away) {
    TwoDyads chain;
    chain.away = away;
    const double crank = between(0.5, 1.5);
    chain.x_B = 0.6 * crank;
    chain.y_B = 0.8 * crank;
    Lengths& a = chain.lengths;
    a["x_D"] = between(2, 4);
    const double BD = std::hypot(a["x_D"] - chain.x_B, chain.y_B);
    a["DC"] = between(0.4, 0.6) * BD;
    a["BC"] = stretched(BD, a["DC"], std::pow(10, between(low, high)));
    a["x_P"] = between(0.5, 1.5);
    a["y_P"] = between(-1, 1);
    a["x_E"] = between(4, 6);
    a["y_E"] = between(-1, 1);
    const ExactPoint B{chain.x_B, chain.y_B};
    ExactPoint C;
    (void)meet(B, a["BC"], {a["x_D"], 0}, a["DC"], 1, C);
    const auto cos = static_cast<double>((C.x - a["x_D"]) / a["DC"]);
    const auto sin = static_cast<double>(C.y / a["DC"]);
    const double PE = std::hypot(a["x_E"] - a["x_D"] - cos * a["x_P"] + sin * a["y_P"],
                                 a["y_E"] - sin * a["x_P"] - cos * a["y_P"]);
    a["EQ"] = between(0.4, 0.6) * PE;
    a["PQ"] = stretched(PE, a["EQ"], std::pow(10, between(low, high)));
    return chain;
  }

 private:
  std::mt19937 engine_;
};

struct Tally {
  int regular = 0;
  int near_singular = 0;
  double worst = 0;  ///< relative error of the regular ones' sensitivities
};

/// The error of Q's gradient against differences in 100 digits, on the sides where Q is nearest.
double gradient_error(const TwoDyads& chain, const Configuration& found) {
  const mechanism::Point& point = found.output("Q");
  const double x = point.position.x();
  const double y = point.position.y();
  double nearest = std::numeric_limits<double>::infinity();
  std::array<int, 2> sides{};
  for (const int first : {1, -1}) {
    for (const int second : {1, -1}) {
      ExactPoint Q;
      if (!chain.exact("BC", 0, first, second, Q)) {
        continue;
      }
      const double distance =
          std::hypot(static_cast<double>(Q.x + chain.away - x), static_cast<double>(Q.y - y));
      if (distance < nearest) {
        nearest = distance;
        sides = {first, second};
      }
    }
  }
  double largest = 0;
  double off = 0;
  Eigen::Index column = 0;
  for (const auto& [name, value] : chain.lengths) {
    const Exact step("1e-30");
    ExactPoint more;
    ExactPoint less;
    if (!chain.exact(name, step, sides[0], sides[1], more) ||
        !chain.exact(name, -step, sides[0], sides[1], less)) {
      return std::numeric_limits<double>::infinity();
    }
    const auto x_slope = static_cast<double>((more.x - less.x) / (2 * step));
    const auto y_slope = static_cast<double>((more.y - less.y) / (2 * step));
    largest = std::max({largest, std::abs(x_slope), std::abs(y_slope)});
    off = std::max({off, std::abs(x_slope - point.follows.first(0, column)),
                    std::abs(y_slope - point.follows.first(1, column))});
    ++column;
  }
  return off / largest;
}

void add(const TwoDyads& chain, Tally& tally) {
  const Solved all = solved(chain.scene());
  for (const Configuration& found : all.configurations()) {
    if (found.regularity != Status::ok) {
      ++tally.near_singular;
      continue;
    }
    ++tally.regular;
    tally.worst = std::max(tally.worst, gradient_error(chain, found));
  }
}

constexpr unsigned seed = 60221;

/// Chains whose middle pins have sines between 10^low and 10^high, up to 10^farthest away.
Tally tally_of(const char* family, int draws, double low, double high, double farthest) {
  Chains chains(seed);
  Tally tally;
  for (int draw = 0; draw < draws; ++draw) {
    const double away = farthest > 0 ? std::round(std::pow(10, chains.between(3, farthest))) : 0;
    add(chains.draw(low, high, away), tally);
  }
  std::cout << family << ", seed " << seed << ": " << tally.regular << " regular, "
            << tally.near_singular << " near-singular, largest error of the regular " << tally.worst
            << '\n';
  return tally;
}

TEST(ChainRegularity, CountsWhatAGroupBeforeHasLost) {
  const Tally tally = tally_of("close to the limit", 400, -3.7, -2, 0);
  EXPECT_LT(tally.worst, 1e-6);
  EXPECT_GT(tally.regular, 100);
  EXPECT_GT(tally.near_singular, 100);
}

TEST(ChainRegularity, CountsTheRoundingOfFarCoordinates) {
  const Tally tally = tally_of("far away", 200, -1, 0, 14);
  EXPECT_LT(tally.worst, 1e-6);
  EXPECT_GT(tally.regular, 50);
  EXPECT_GT(tally.near_singular, 50);
}

TEST(ChainRegularity, LeavesOrdinaryMechanismsAlone) {
  const Tally tally = tally_of("ordinary", 200, -1, 0, 0);
  EXPECT_LT(tally.worst, 1e-10);
  EXPECT_EQ(tally.near_singular, 0);
}

}  // namespace
}  // namespace assur::test::chain_regularity_test
