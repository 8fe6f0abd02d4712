// Law: among more configurations than can be listed, one is found by its number and followed alone
// through a sweep; where all can be listed or swept, they give the same answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "mechanism/many_dyads.hpp"
#include "mechanism/sweep_runs.hpp"

namespace assur::test::numbered_test {
namespace {

using Json = nlohmann::ordered_json;
using mechanism::Configuration;
using mechanism::Plan;
using mechanism::Solution;

Plan plan_of(const Json& scene) { return Plan(mechanism::parse_scene(scene.dump(), "scene")); }

double upright(int /*number*/) { return 1.4; }

/// Fifteen dyads, 2^15 configurations, of which limits leave 2^6.
Json limited_row() {
  Json scene = many_dyads(15, upright);
  for (int number = 1; number <= 15; ++number) {
    if (number % 5 > 1) {
      scene["joints"]["G" + std::to_string(number)]["limits"] = {0, 3.1};
    }
  }
  return scene;
}

/// The angle of each link, by its name.
std::map<std::string, double> angles_of(const Plan& plan, const Configuration& configuration) {
  std::map<std::string, double> angles;
  for (const mechanism::LinkIndex link : configuration.links.keys()) {
    angles[plan.mechanism().links()[link].name] =
        angle_of(configuration.links[link].pose.direction);
  }
  return angles;
}

TEST(Numbered, AreFoundAloneInTheOrderOfTheList) {
  const Plan plan = plan_of(limited_row());
  ASSERT_GT(plan.most_configurations(), static_cast<double>(Plan::most_listed));
  const mechanism::Values values = plan.values();
  const Solution all = plan.solve(values);
  const std::size_t count = all.configurations.size();
  ASSERT_EQ(count, 64U);
  Solution one;
  for (std::size_t number = 1; number <= count; ++number) {
    ASSERT_EQ(plan.solve_one(values, number, one), number);
    ASSERT_EQ(one.configurations.size(), 1U);
    EXPECT_EQ(angles_of(plan, one.configurations[0]),
              angles_of(plan, all.configurations[number - 1]));
  }
  EXPECT_EQ(plan.solve_one(values, count + 1, one), count);
  EXPECT_EQ(one.configurations.size(), 0U);
  std::map<std::string, double> first = angles_of(plan, all.configurations[0]);
  for (std::size_t number = 1; number < count / 2; ++number) {
    EXPECT_EQ(angles_of(plan, all.configurations[number]).at("bar1"), first.at("bar1"));
  }
  EXPECT_NE(angles_of(plan, all.configurations[count / 2]).at("bar1"), first.at("bar1"));
}

TEST(Numbered, AreThoseOfAListThatCanBeHad) {
  const Plan plan = plan_of(many_dyads(5, upright));
  const mechanism::Values values = plan.values();
  const Solution all = plan.solve(values);
  Solution one;
  for (std::size_t number = 1; number <= all.configurations.size(); ++number) {
    ASSERT_EQ(plan.solve_one(values, number, one), number);
    ASSERT_EQ(one.configurations.size(), 1U);
    EXPECT_EQ(angles_of(plan, one.configurations[0]),
              angles_of(plan, all.configurations[number - 1]));
  }
  EXPECT_EQ(plan.solve_one(values, 33, one), 32U);
  EXPECT_EQ(one.configurations.size(), 0U);
}

/// Two rows of dyads on one crank, neither of which depends on the other.
Json two_rows() {
  Json scene = limited_row();
  const Json other = limited_row();
  for (const auto& [name, link] : other["links"].items()) {
    if (name != "ground" && name != "bar0") {
      scene["links"]["other_" + name] = link;
    }
  }
  for (const auto& [name, joint] : other["joints"].items()) {
    if (name == "A") {
      continue;
    }
    Json moved = joint;
    for (auto& end : moved["between"]) {
      const std::string text = end;
      if (!text.starts_with("ground") && !text.starts_with("bar0")) {
        end = "other_" + text;
      }
    }
    scene["joints"]["other_" + name] = moved;
  }
  return scene;
}

/// The scene in another order; where a joint's links are exchanged, its limits change their signs.
Json listed_anew(const Json& scene, unsigned seed) {
  std::mt19937 random(seed);
  Json result = scene;
  for (const char* part : {"links", "joints"}) {
    std::vector<std::string> names;
    for (const auto& [name, item] : scene[part].items()) {
      names.push_back(name);
    }
    std::shuffle(names.begin(), names.end(), random);
    result[part] = Json::object();
    for (const std::string& name : names) {
      result[part][name] = scene[part][name];
      if (std::string(part) == "joints" && !scene["drivers"].contains(name) && random() % 2 == 0) {
        Json& joint = result[part][name];
        std::swap(joint["between"][0], joint["between"][1]);
        if (joint.contains("limits")) {
          joint["limits"] = {-joint["limits"][1].get<double>(), -joint["limits"][0].get<double>()};
        }
      }
    }
  }
  return result;
}

TEST(Numbered, DoNotDependOnHowAllIsListed) {
  const Json scene = two_rows();
  const auto found = [](const Json& described) {
    const Plan plan = plan_of(described);
    std::vector<std::map<std::string, double>> all;
    Solution one;
    for (const std::size_t number : {1U, 2U, 63U, 64U, 65U, 777U, 4096U}) {
      EXPECT_EQ(plan.solve_one(plan.values(), number, one), number);
      all.push_back(angles_of(plan, one.configurations.at(0)));
    }
    EXPECT_EQ(plan.solve_one(plan.values(), 4097, one), 4096U);
    return all;
  };
  const auto expected = found(scene);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const auto anew = found(listed_anew(scene, seed));
    for (std::size_t place = 0; place < expected.size(); ++place) {
      for (const auto& [link, angle] : expected[place]) {
        EXPECT_NEAR(std::remainder(anew[place].at(link) - angle, 2 * std::numbers::pi), 0, 1e-9)
            << link << " in number " << place;
      }
    }
  }
}

/// The rows of one branch, followed alone, and where it ends.
struct FollowedAlone {
  std::vector<std::pair<int, Configuration>> rows;
  std::optional<double> end;
};

FollowedAlone followed(const Plan& plan, std::size_t number) {
  FollowedAlone result;
  const auto record = [&](const mechanism::SweepRecord& row) {
    result.rows.emplace_back(row.step, *row.state);
  };
  result.end = mechanism::sweep_branch(plan, number, {record, nullptr, nullptr});
  return result;
}

/// Every branch that begins at the first step of an example's sweep has the same rows if it is
/// followed alone. In none of these sweeps do branches cross.
TEST(OneBranch, HasTheRowsThatItHasAmongAll) {
  int rows = 0;
  int whole = 0;
  int ended = 0;
  for (const std::string name :
       {"four_bar_coupler_curve", "jansen_leg", "platform_3rpr", "quintero_2011_rrp_rrr",
        "excavator_arm", "shaper_quick_return", "zhauyt_2017_six_bar"}) {
    const mechanism::Scene scene =
        mechanism::read_scene(std::string(ASSUR_EXAMPLES) + "/" + name + ".json");
    const Plan plan(scene);
    const SweepKept all = run_sweep(scene);
    const auto crosses = [&](const SweepEventKept& event) { return event.kind() == "crossing"; };
    ASSERT_TRUE(std::ranges::none_of(all.events, crosses)) << name;
    const auto first = std::ranges::count(all.rows, 0, &SweepRowKept::step);
    for (int branch = 1; branch <= first; ++branch) {
      const FollowedAlone alone = followed(plan, static_cast<std::size_t>(branch));
      std::size_t place = 0;
      for (const SweepRowKept& row : all.rows) {
        if (row.branch != branch) {
          continue;
        }
        ASSERT_LT(place, alone.rows.size()) << name << ", branch " << branch << ", " << row.step;
        EXPECT_EQ(alone.rows[place].first, row.step);
        Eigen::Index link = 0;
        for (const mechanism::Frame& frame : alone.rows[place].second.links) {
          EXPECT_EQ(frame.pose.x, row.pose(4 * link));
          EXPECT_EQ(frame.pose.direction.sin, row.pose(4 * link + 3));
          ++link;
        }
        ++place;
        ++rows;
      }
      EXPECT_EQ(place, alone.rows.size()) << name << ", branch " << branch;
      (alone.end ? ended : whole) += 1;
    }
  }
  std::printf("%d rows of %d whole branches and %d that end\n", rows, whole, ended);
  EXPECT_GT(rows, 3000);
  EXPECT_GT(whole, 20);
  EXPECT_GT(ended, 3);
}

/// 2^29 branches: each bar's pin stays on its side of the line from its pivot to its rocker's.
TEST(OneBranch, IsFollowedAmongMoreThanCanBeListed) {
  constexpr int count = 29;
  Json scene = many_dyads(count, [](int number) { return number % 3 != 1 ? 1.4 : -1.3; });
  scene["parameters"]["phi"] = 0.3;
  scene["drivers"]["A"]["position"] = "phi";
  scene["sweep"] = {{"parameter", "phi"}, {"from", 0}, {"to", 6.2}, {"count", 12}};
  const Plan plan = plan_of(scene);
  for (const std::size_t number : {0U, 1U, 2U, 1000U}) {
    const FollowedAlone alone = followed(plan, number);
    EXPECT_FALSE(alone.end.has_value());
    ASSERT_EQ(alone.rows.size(), 12U);
    std::array<double, count> sides{};
    for (const auto& [step, row] : alone.rows) {
      const long double phi = 6.2L * step / 11;
      long double x = 0.01L * std::cos(phi);
      long double y = 0.01L * std::sin(phi);
      for (int bar = 1; bar <= count; ++bar) {
        const auto& pose = row.link("bar" + std::to_string(bar)).pose;
        double& side = sides[static_cast<std::size_t>(bar - 1)];
        // The circles of radius 2 about (x, y) and 2.1 about G.
        const long double dx = 1 + 0.003L * bar - x;
        const long double dy = 0.1L - y;
        const long double square = dx * dx + dy * dy;
        const long double along = (square + 4 - 2.1L * 2.1L) / (2 * square);
        const long double across = std::sqrt(4 / square - along * along);
        if (side == 0) {
          side = dx * pose.direction.sin - dy * pose.direction.cos > 0 ? 1 : -1;
        }
        const long double cos = (along * dx - side * across * dy) / 2;
        const long double sin = (along * dy + side * across * dx) / 2;
        ASSERT_NEAR(pose.direction.cos, static_cast<double>(cos), 1e-12) << bar << " at " << step;
        ASSERT_NEAR(pose.direction.sin, static_cast<double>(sin), 1e-12) << bar << " at " << step;
        x += 0.01L * cos;
        y += 0.01L * sin;
      }
    }
    if (number == 0) {
      for (int bar = 1; bar <= count; ++bar) {
        EXPECT_EQ(sides[static_cast<std::size_t>(bar - 1)] > 0, bar % 3 != 1);
      }
    }
  }
}

}  // namespace
}  // namespace assur::test::numbered_test
