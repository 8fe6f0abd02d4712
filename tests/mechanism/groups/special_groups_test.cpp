// Law: larger groups in special position lose no configuration, and slightly perturbed groups have
// the same; known results for named groups are reproduced.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <array>
#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <assur/mechanism/sweep.hpp>
#include <iostream>
#include <limits>
#include <map>
#include <set>

#include "mechanism/pinned_bodies.hpp"
#include "whole_campaign.hpp"

namespace assur::test::special_groups_test {
namespace {

using Json = nlohmann::ordered_json;
using Complex = std::complex<double>;

mechanism::Solution solved(const Json& json, bool prove = false) {
  mechanism::Scene scene = mechanism::parse_scene(json.dump(), "a group");
  scene.request.prove = prove;
  const mechanism::Plan plan(scene);
  return plan.solve(plan.values());
}

/// Joints on the points of a small lattice, no two on one.
Places lattice_places(const Chain& chain, std::mt19937& engine) {
  std::uniform_int_distribution<int> place(-2, 2);
  Places result;
  while (result.size() < chain.size()) {
    const double x = place(engine);
    const Complex one(x, place(engine));
    if (std::ranges::find(result, one) == result.end()) {
      result.push_back(one);
    }
  }
  return result;
}

/// The same, each joint moved by no more than a length.
Places beside(const Places& places, double most, std::mt19937& engine) {
  std::uniform_real_distribution<double> by(-most, most);
  Places result = places;
  for (Complex& one : result) {
    const double x = by(engine);
    one += Complex(x, by(engine));
  }
  return result;
}

double distance_to(const std::vector<Eigen::VectorXd>& listed, const Eigen::VectorXd& q) {
  double result = std::numeric_limits<double>::infinity();
  for (const Eigen::VectorXd& one : listed) {
    result = std::min(result, distance_of(one, q));
  }
  return result;
}

/// Whether the first two joints of every link, which tell its direction, are in two places.
bool have_directions(const Chain& chain, const Places& places, int links) {
  std::vector<std::vector<std::complex<double>>> of_links(static_cast<std::size_t>(links));
  for (std::size_t joint = 0; joint < chain.size(); ++joint) {
    for (const int link : {chain[joint].first, chain[joint].second}) {
      of_links[static_cast<std::size_t>(link)].push_back(places[joint]);
    }
  }
  return std::ranges::all_of(of_links, [](const auto& at) { return at[0] != at[1]; });
}

/// Whether links that are drawn in a singular position close beside it, too: where they are moved
/// by a tenth of a radian, the Levenberg-Marquardt method leads back there if they do not.
bool moves(const PinnedBodies& bodies, unsigned seed) {
  std::mt19937 engine(seed);
  constexpr int starts = 20;
  constexpr int steps = 60;
  constexpr double away = 0.02;
  std::uniform_real_distribution<double> by(-0.1, 0.1);
  for (int start = 0; start < starts; ++start) {
    Eigen::VectorXd q =
        Eigen::VectorXd::NullaryExpr(bodies.size(), [&](Eigen::Index) { return by(engine); });
    Eigen::MatrixXd jacobian(bodies.size(), bodies.size());
    for (int step = 0; step < steps; ++step) {
      const Eigen::VectorXd gaps = bodies.gaps(q, &jacobian);
      Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
      normal.diagonal().array() += gaps.squaredNorm();
      q -= normal.ldlt().solve(jacobian.transpose() * gaps);
    }
    if (bodies.gap(q) < 1e-10 && q.cwiseAbs().maxCoeff() > away && q.cwiseAbs().maxCoeff() < 1) {
      return true;
    }
  }
  return false;
}

int count_near(const std::vector<Eigen::VectorXd>& listed, const Eigen::VectorXd& q, double near) {
  return static_cast<int>(std::ranges::count_if(
      listed, [&](const Eigen::VectorXd& one) { return distance_of(one, q) < near; }));
}

/// How many configurations bodies have nearer to coordinates than a length. Along the direction in
/// which the Jacobian is smallest the gap is a parabola, and all other directions follow: one root
/// is near where a configuration is single, two or none where two meet.
int roots_near(const PinnedBodies& bodies, const Eigen::VectorXd& q, double near) {
  constexpr double step = 1e-4;  // the difference below is off by its square, and 1e-16 / step^2
  Eigen::MatrixXd jacobian(q.size(), q.size());
  const Eigen::VectorXd open = bodies.gaps(q, &jacobian);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::VectorXd along = svd.matrixV().rightCols<1>();
  const Eigen::VectorXd across = svd.matrixU().rightCols<1>();
  const double gap = across.dot(open);
  const double slope = svd.singularValues()(q.size() - 1);
  const Eigen::VectorXd around =
      bodies.gaps(q + step * along, nullptr) + bodies.gaps(q - step * along, nullptr);
  const double bend = across.dot(around - 2 * open) / (step * step);
  const double discriminant = slope * slope - 2 * bend * gap;
  if (discriminant < 0) {
    return 0;
  }
  const double sum = slope + std::sqrt(discriminant);
  return (2 * std::abs(gap) < near * sum ? 1 : 0) + (sum < near * std::abs(bend) ? 1 : 0);
}

// With all joints in one line the Jacobian loses a rank for each loop.
TEST(SpecialGroups, InOneLineAreFoundAndNotCalledRegular) {
  constexpr unsigned seed = 7;
  constexpr double near = 1e-3;
  std::mt19937 engine(seed);
  std::uniform_int_distribution<int> place(-3, 3);
  int isolated = 0;
  int moving = 0;
  int told = 0;
  int missed = 0;
  for (int trial = 0; isolated + moving < 40; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const Chain& chain = seven_link_chains()[static_cast<std::size_t>(trial) % 3];
    const int ground = trial % 7;
    Places places(chain.size());
    for (std::complex<double>& one : places) {
      one = place(engine);
    }
    if (!have_directions(chain, places, 7)) {
      continue;
    }
    const PinnedBodies bodies(chain, places, 7, ground);
    const mechanism::Solution solution = solved(drawn_chain(chain, places, 7, ground));
    EXPECT_NE(solution.incomplete, "");
    if (moves(bodies, seed)) {
      ++moving;
      told += !solution.families.empty() || solution.mobility > 0 ? 1 : 0;
      continue;
    }
    ++isolated;
    int drawn = 0;
    for (const mechanism::Configuration& one : solution.configurations) {
      if (bodies.coordinates(one).cwiseAbs().maxCoeff() < near) {
        ++drawn;
        EXPECT_NE(one.regularity, Status::ok);
      }
    }
    EXPECT_LE(drawn, 1);
    missed += drawn == 0 ? 1 : 0;
  }
  std::cout << "seed " << seed << ": " << isolated << " isolated, " << moving << " move, of which "
            << told << " are told to; not listed: " << missed << "\n";
  EXPECT_LE(missed, 1);  // four pins in one point make families of complex configurations
  EXPECT_GT(isolated, 10);
  EXPECT_GT(told, moving / 2);
}

// Joints that move by 1e-12 part a double configuration by the root of it, or leave a complex pair
// in its place: how many twins it has its gaps tell. A complex pair may be listed as one real
// configuration, since its gaps may be no more than rounding.
TEST(SpecialGroups, OnALatticeLoseNothingAndAreLikeTheirTwins) {
  constexpr unsigned seed = 42;
  constexpr double twin = 1e-12;
  constexpr double near = 1e-3;
  std::mt19937 engine(seed);
  const int groups = is_whole_campaign() ? 500 : 40;
  const int starts = is_whole_campaign() ? 200 : 50;
  int complete = 0;
  int rests = 0;
  int listed_ones = 0;
  std::array<int, 3> with_roots{};
  double farthest = 0;
  for (int trial = 0; trial < groups; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const Chain& chain = seven_link_chains()[static_cast<std::size_t>(trial) % 3];
    const int ground = trial % 7;
    const Places places = lattice_places(chain, engine);
    const Places moved = beside(places, twin, engine);
    std::vector<std::vector<Eigen::VectorXd>> listed;
    for (const Places& drawn : {places, moved}) {
      const PinnedBodies bodies(chain, drawn, 7, ground);
      const mechanism::Solution solution = solved(drawn_chain(chain, drawn, 7, ground));
      complete += solution.incomplete.empty() ? 1 : 0;
      EXPECT_TRUE(solution.families.empty());
      listed.emplace_back();
      for (const mechanism::Configuration& one : solution.configurations) {
        listed.back().push_back(bodies.coordinates(one));
        EXPECT_LT(bodies.gap(listed.back().back()), 1e-11) << "a configuration is invented";
      }
      listed_ones += static_cast<int>(listed.back().size());
      std::uniform_real_distribution<double> place(-6, 6);
      std::uniform_real_distribution<double> angle(-3.2, 3.2);
      for (int start = 0; start < starts; ++start) {
        Eigen::VectorXd q(bodies.size());
        for (Eigen::Index coordinate = 0; coordinate < q.size(); ++coordinate) {
          q(coordinate) = coordinate % 3 == 2 ? angle(engine) : place(engine);
        }
        if (bodies.assemble(q)) {
          ++rests;
          EXPECT_LT(distance_to(listed.back(), q), near) << "a configuration is lost";
        }
      }
    }
    const PinnedBodies beside_them(chain, moved, 7, ground);
    for (const Eigen::VectorXd& q : listed[0]) {
      const int roots = roots_near(beside_them, q, near);
      const int twins = count_near(listed[1], q, near);
      EXPECT_GE(twins, std::min(roots, 1)) << "it has no twin";
      EXPECT_LE(twins, std::max(roots, 1)) << "it has a twin too many";
      EXPECT_EQ(count_near(listed[0], q, near), 1) << "it is listed twice";
      ++with_roots[static_cast<std::size_t>(roots)];
    }
    for (const Eigen::VectorXd& q : listed[1]) {
      const double to_other = distance_to(listed[0], q);
      EXPECT_LT(to_other, near) << "it is the twin of none";
      farthest = std::max(farthest, to_other);
    }
  }
  std::cout << "seed " << seed << ": " << complete << " of " << 2 * groups << " proven complete, "
            << listed_ones << " configurations; of those on a lattice " << with_roots[1]
            << " are single, " << with_roots[2] << " part, " << with_roots[0]
            << " become complex; Newton's method came to rest " << rests << " times, twins within "
            << farthest << "\n";
}

/// Slides along the axes and diagonals of a lattice.
Lines lattice_lines(const std::vector<bool>& slides, std::mt19937& engine) {
  std::uniform_int_distribution<int> eighth(0, 7);
  Lines result;
  for (const bool is_slide : slides) {
    result.push_back(is_slide ? std::polar(1.0, eighth(engine) * std::acos(-1) / 4) : 0.0);
  }
  return result;
}

// Parallel slides make families here; where there is none, nothing that Newton's method finds is
// lost.
TEST(SpecialGroups, WithSlidesInThreeDirectionsOnALatticeLoseNothing) {
  constexpr unsigned seed = 43;
  constexpr double near = 1e-3;
  std::mt19937 engine(seed);
  const int starts = is_whole_campaign() ? 200 : 50;
  int groups = 0;
  int complete = 0;
  int moving = 0;
  int rests = 0;
  for (const auto& [chain, slides] : share_of(chains_with_slides_in_three_directions(), 13)) {
    SCOPED_TRACE("group " + std::to_string(groups));
    const int ground = groups++ % 7;
    const Places places = lattice_places(chain, engine);
    const Lines lines = lattice_lines(slides, engine);
    const PinnedBodies bodies(chain, places, lines, 7, ground);
    const mechanism::Solution solution = solved(drawn_chain(chain, places, lines, 7, ground));
    complete += solution.incomplete.empty() ? 1 : 0;
    std::vector<Eigen::VectorXd> listed;
    for (const mechanism::Configuration& one : solution.configurations) {
      listed.push_back(bodies.coordinates(one));
      EXPECT_LT(bodies.gap(listed.back()), 1e-11) << "a configuration is invented";
      EXPECT_EQ(count_near(listed, listed.back(), near), 1) << "it is listed twice";
    }
    if (!solution.families.empty() || solution.mobility > 0) {
      ++moving;
      continue;
    }
    EXPECT_EQ(count_near(listed, Eigen::VectorXd::Zero(bodies.size()), near), 1)
        << "the drawn configuration is lost";
    std::uniform_real_distribution<double> place(-6, 6);
    std::uniform_real_distribution<double> angle(-3.2, 3.2);
    for (int start = 0; start < starts; ++start) {
      Eigen::VectorXd q(bodies.size());
      for (Eigen::Index coordinate = 0; coordinate < q.size(); ++coordinate) {
        q(coordinate) = coordinate % 3 == 2 ? angle(engine) : place(engine);
      }
      if (bodies.assemble(q)) {
        ++rests;
        EXPECT_LT(distance_to(listed, q), near) << "a configuration is lost";
      }
    }
  }
  std::cout << "seed " << seed << ": " << groups << " groups, " << complete << " proven complete, "
            << moving << " move; Newton's method came to rest " << rests << " times\n";
}

/// Links that are given by points in frames of their own, pinned where points have one name.
Json pinned(const Json& links) {
  Json scene{{"links", links}};
  std::map<std::string, std::vector<std::string>> features;
  for (const auto& [link, points] : links.items()) {
    for (const auto& [point, place] : points.items()) {
      features[point].push_back(link + "." + point);
    }
  }
  for (const auto& [point, between] : features) {
    scene["joints"][point] = {{"type", "revolute"}, {"between", between}};
  }
  return scene;
}

// The closed normal Assur chain of class 4 in S. Lösch, Parallel redundant manipulators based on
// open and closed normal Assur chains, Computational Kinematics '95, pages 251-260: a ring of four
// ternary links on four legs. Its dimensions, read off the published equations, are whole numbers;
// the 56 solutions that PHCpack lists have ten real ones among them.
TEST(SpecialGroups, OfLoeschHas56ConfigurationsTenOfThemReal) {
  const Json scene =
      pinned({{"ground", {{"A", {0, 0}}, {"Q", {-6, 0}}, {"R", {7, 7.5}}, {"S", {-4, 9}}}},
              {"a", {{"A", {0, 0}}, {"B", {2, 0}}}},
              {"b", {{"B", {0, 0}}, {"C", {-4, 3}}, {"D", {2, 3}}}},
              {"c", {{"C", {0, 0}}, {"F", {2, 2}}, {"E", {5, 0}}}},
              {"d", {{"D", {0, 0}}, {"G", {-2, 4}}, {"H", {-7, 0}}}},
              {"e", {{"E", {0, 0}}, {"H", {3.5, 0}}, {"K", {2.5, 5}}}},
              {"q", {{"Q", {0, 0}}, {"F", {5, 0}}}},
              {"r", {{"R", {0, 0}}, {"G", {5.5, 0}}}},
              {"s", {{"S", {0, 0}}, {"K", {3, 0}}}}});
  const mechanism::Solution solution = solved(scene, true);
  EXPECT_EQ(solution.incomplete, "");
  EXPECT_EQ(solution.configurations.size(), 10U);
  for (const mechanism::Configuration& configuration : solution.configurations) {
    for (const mechanism::GroupProof& proof : configuration.proofs) {
      EXPECT_EQ(proof.boxes, 56);
      EXPECT_EQ(proof.of, 56);
    }
  }
}

/// A scene that is drawn with these points, and pins where links have one in common.
Json drawn(const std::map<std::string, Complex>& points,
           const std::map<std::string, std::vector<std::string>>& links) {
  Json scene;
  for (const auto& [name, at] : points) {
    scene["points"][name] = {at.real(), at.imag()};
  }
  for (const auto& [name, of] : links) {
    scene["links"][name] = of;
  }
  return scene;
}

// Two of Roberts' cognates, pinned at the tracing point, share the coupler curve. At each of its
// three double points the four-bars may stand in two ways that differ: six configurations are
// single, and those at real double points are real. The complex ones are found by chance.
TEST(SpecialGroups, OfRobertsCognatesMoveAndHaveSingleConfigurationsBeside) {
  const Complex o = 0;
  const Complex ratio(0.5, 0.5);  // of the coupler triangles: exact in doubles, as all points are
  const std::vector<std::array<Complex, 3>> four_bars = {
      {Complex(1, 2), Complex(5, 3), Complex(6, 0)},
      {Complex(3, 4), Complex(15, 9), Complex(21, 0)}};
  const std::vector<std::size_t> at_real_double_points = {4, 2};
  for (std::size_t place = 0; place < four_bars.size(); ++place) {
    const auto& [a, b, q] = four_bars[place];
    const Complex p = a + ratio * (b - a);
    const mechanism::Solution solution = solved(drawn({{"O", o},
                                                       {"A", a},
                                                       {"B", b},
                                                       {"Q", q},
                                                       {"P", p},
                                                       {"D", p - a},
                                                       {"C", ratio * b},
                                                       {"R", ratio * q}},
                                                      {{"ground", {"O", "Q", "R"}},
                                                       {"crank", {"O", "A"}},
                                                       {"coupler", {"A", "B", "P"}},
                                                       {"rocker", {"Q", "B"}},
                                                       {"crank 2", {"O", "D"}},
                                                       {"coupler 2", {"D", "C", "P"}},
                                                       {"rocker 2", {"R", "C"}}}),
                                                true);
    EXPECT_NE(solution.incomplete, "");
    ASSERT_EQ(solution.families.size(), 1U);
    EXPECT_EQ(solution.families[0].mobility, 1);
    EXPECT_EQ(solution.configurations.size(), at_real_double_points[place]);
    for (const mechanism::Configuration& configuration : solution.configurations) {
      for (const mechanism::GroupProof& proof : configuration.proofs) {
        EXPECT_LE(proof.boxes, 6);
        EXPECT_EQ(proof.of, 18);
      }
    }
  }
}

/// A crank and three bars of its length turn alike, and three links between them keep their angles.
/// Two of the bars with the link on both are flat where the crank lies along the x-axis: there this
/// motion crosses another one.
class SweptParallelCranks {
 public:
  SweptParallelCranks(double from, double to) {
    const Complex crank = std::polar(1.0, 0.7);
    scene_ = drawn({{"O", 0},
                    {"A", crank},
                    {"B", crank + Complex(0.8, 2.1)},
                    {"C", crank + Complex(3, 3)},
                    {"P", {-2, -1.5}},
                    {"E", crank + Complex(-2, -1.5)},
                    {"Q", 4},
                    {"F", crank + 4.0},
                    {"R", 7},
                    {"G", crank + 7.0}},
                   {{"ground", {"O", "P", "Q", "R"}},
                    {"crank", {"O", "A"}},
                    {"d", {"A", "B"}},
                    {"b", {"B", "E", "C"}},
                    {"c", {"C", "F", "G"}},
                    {"e", {"P", "E"}},
                    {"f", {"Q", "F"}},
                    {"g", {"R", "G"}}});
    scene_["parameters"]["phi"] = {{"value", 0.7}};
    scene_["drivers"]["O"] = {{"position", "phi"}, {"velocity", 1}};
    scene_["sweep"] = {{"parameter", "phi"}, {"from", from}, {"to", to}, {"count", steps}};
    const mechanism::Plan plan(mechanism::parse_scene(scene_.dump(), "parallel cranks"));
    (void)mechanism::sweep(
        plan, {[this](const mechanism::SweepRecord& record) { keep(record); }, {}, {}, {}});
  }

  static constexpr int steps = 3;
  std::set<int> kept;          ///< the steps at which the three links keep their angles
  std::vector<double> events;  ///< the parameter at each

 private:
  void keep(const mechanism::SweepRecord& record) {
    if (!record.event.empty()) {
      events.push_back(record.parameter);
      return;
    }
    double turned = 0;
    for (const auto& [link, angle] : {std::pair{"d", std::arg(Complex(0.8, 2.1))},
                                      {"b", std::arg(Complex(-2.8, -3.6))},
                                      {"c", std::arg(Complex(1, -3))}}) {
      const Direction<double>& by = record.state->link(link).pose.direction;
      turned = std::max(turned, std::abs(Complex(by.cos, by.sin) - std::polar(1.0, angle)));
    }
    if (turned < 1e-6) {
      kept.insert(record.step);
    }
  }

  Json scene_;
};

// Nearer than a millionth of a radian to the change point the two motions are not told apart: there
// is one configuration for both, and a branch of each may begin or end.
TEST(SpecialGroups, AreSweptFromOverAndToChangePoints) {
  const double turn = 2 * std::acos(-1);
  const std::vector<std::array<double, 3>> ranges = {
      {0, 0.15, 0}, {turn / 2 - 0.1, turn / 2 + 0.1, turn / 2}, {turn - 0.15, turn, turn}};
  for (const auto& [from, to, change_point] : share_of(ranges, ranges.size())) {
    SCOPED_TRACE(change_point);
    const SweptParallelCranks swept(from, to);
    EXPECT_EQ(std::ssize(swept.kept), SweptParallelCranks::steps);
    EXPECT_LE(swept.events.size(), 2U);
    for (const double event : swept.events) {
      EXPECT_NEAR(event, change_point, 1e-6);
    }
  }
}

}  // namespace
}  // namespace assur::test::special_groups_test
