// Law: each sample and each cell depends on its number alone and equals what solving it by itself
// gives, and those without a certain answer are counted.
#include <gtest/gtest.h>

#include <algorithm>
#include <assur/mechanism/campaign.hpp>
#include <assur/mechanism/forces.hpp>
#include <assur/mechanism/sample_statistics.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <cmath>
#include <numbers>
#include <regex>

#include "campaign/counter_random.hpp"

namespace assur::test::campaign_test {
namespace {

using namespace mechanism;

Scene example(const std::string& name, const std::vector<std::string>& settings = {}) {
  return read_scene(std::string(ASSUR_EXAMPLES) + "/" + name + ".json", settings);
}

using Rows = std::vector<double>;

Rows rows_of(const Campaign& campaign, ItemRange items, int threads) {
  Rows all;
  run_campaign(campaign, items, threads, nullptr, [&all](const RowBlock& block) {
    all.insert(all.end(), block.rows.begin(), block.rows.end());
  });
  return all;
}

Rows rows_of(const Campaign& campaign) { return rows_of(campaign, {0, campaign.items}, 1); }

/// Equal, or NaN in both.
bool are_same(const Rows& one, const Rows& other) {
  return std::ranges::equal(one, other, [](double first, double second) {
    return first == second || (std::isnan(first) && std::isnan(second));
  });
}

Outcome outcome_in(const Campaign& campaign, const Rows& rows, std::size_t sample) {
  return static_cast<Outcome>(rows[sample * campaign.columns.size() + 1]);
}

/// The known answers that the generator's authors publish.
TEST(CounterRandom, IsPhilox) {
  using mechanism::campaign::philox;
  using Numbers = std::array<std::uint32_t, 4>;
  constexpr std::uint32_t ones = 0xffffffff;
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}),
            (Numbers{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({ones, ones, ones, ones}, {ones, ones}),
            (Numbers{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Numbers{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(CounterRandom, LiesBetweenItsEnds) {
  double sum = 0;
  constexpr std::uint64_t count = 20000;
  for (std::uint64_t sample = 0; sample < count; ++sample) {
    const double number = mechanism::campaign::uniform(5, sample, 3);
    ASSERT_GT(number, -1);
    ASSERT_LT(number, 1);
    sum += number;
  }
  EXPECT_LT(std::abs(sum), 5 * std::sqrt(count / 3.0));
}

TEST(Campaign, PartsAreAllItemsOnce) {
  for (const std::uint64_t items : {0U, 1U, 7U, 1000U}) {
    for (const std::uint64_t parts : {1U, 3U, 8U, 64U}) {
      std::uint64_t next = 0;
      for (std::uint64_t number = 1; number <= parts; ++number) {
        const ItemRange range = part_of(items, number, parts);
        EXPECT_EQ(range.first, next);
        EXPECT_LE(range.last - range.first, items / parts + 1);
        next = range.last;
      }
      EXPECT_EQ(next, items);
    }
  }
}

TEST(Campaign, DoesNotDependOnThreadsOrParts) {
  const Scene scene = example("four_bar_coupler_curve");
  const Sampling sampling(scene.mechanism, scene.request, 2, 9, 3000);
  const Campaign campaign = sampling.campaign();
  const Rows all = rows_of(campaign);
  ASSERT_EQ(all.size(), 3000 * campaign.columns.size());
  for (const int threads : {2, 5}) {
    EXPECT_TRUE(are_same(rows_of(campaign, {0, 3000}, threads), all));
  }
  Rows parts;
  for (std::uint64_t number = 1; number <= 7; ++number) {
    const Rows part = rows_of(campaign, part_of(3000, number, 7), 2);
    parts.insert(parts.end(), part.begin(), part.end());
  }
  EXPECT_TRUE(are_same(parts, all));
}

TEST(Campaign, EndsWithWhatIsThrown) {
  const Campaign broken{{}, 100000, [] {
                          return [](std::uint64_t item, Rows&) {
                            if (item == 70000) {
                              throw MechanismError("", "seventy thousand");
                            }
                          };
                        }};
  for (const int threads : {1, 3}) {
    std::uint64_t done = 0;
    const auto use = [&done](const RowBlock& block) { done = block.items.last; };
    EXPECT_THROW(run_campaign(broken, {0, 100000}, threads, nullptr, use), MechanismError);
    EXPECT_GT(done, 60000U);
    EXPECT_LE(done, 70000U);
    const auto full = [](const RowBlock&) { throw std::runtime_error("the disk is full"); };
    EXPECT_THROW(run_campaign(broken, {0, 100000}, threads, nullptr, full), std::runtime_error);
  }
}

/// A slide that is driven to the sum of two parameters, one of them a formula of the other: the
/// output is linear in both.
const char* const linear = R"({
  "parameters": {
    "a": {"value": 3, "tolerance": 0.3},
    "b": {"value": "2*a", "tolerance": 0.1},
    "c": 1
  },
  "links": {
    "ground": {"S": {"through": [0, 0], "along": [1, 0]}},
    "block": {"S": {"through": [0, 0], "along": [1, 0]}, "P": [0, "c"]}
  },
  "joints": {"S": {"type": "prismatic", "between": ["ground.S", "block.S"]}},
  "drivers": {"S": {"position": "a + b"}},
  "outputs": {"P": "block.P"}
})";

TEST(Sampling, OfALinearOutputAgreesWithFirstOrder) {
  const Scene scene = parse_scene(linear, "linear");
  constexpr std::uint64_t count = 20000;
  const Sampling sampling(scene.mechanism, scene.request, 0, 1, count);
  const NominalPoint& nominal = sampling.nominal().front();
  EXPECT_DOUBLE_EQ(nominal.position.x(), 9);
  EXPECT_DOUBLE_EQ(nominal.worst_case->x(), 3 * 0.3 + 0.1);
  PointStatistics statistics(nominal.position);
  const Campaign campaign = sampling.campaign();
  const Rows rows = rows_of(campaign);
  for (std::size_t sample = 0; sample < count; ++sample) {
    ASSERT_EQ(outcome_in(campaign, rows, sample), Outcome::regular);
    const std::vector<double> parameters = sampling.parameters_of(sample % 100);
    EXPECT_LE(std::abs(parameters[1] - 2 * parameters[0]), 0.1);  // b follows a
    statistics.add({rows[4 * sample + 2], rows[4 * sample + 3]});
  }
  const double deviation = nominal.rss->x() / std::sqrt(3);
  EXPECT_NEAR(nominal.spread->covariance(0, 0), deviation * deviation, 1e-15);
  EXPECT_LE(statistics.greatest().x() - 9, nominal.worst_case->x());
  EXPECT_GE(statistics.least().x() - 9, -nominal.worst_case->x());
  EXPECT_GT(statistics.greatest().x() - 9, 0.97 * nominal.worst_case->x());
  // Five standard errors; the deviation has a smaller one than a normal distribution would give.
  EXPECT_LT(std::abs(statistics.mean_shift().x()), 5 * deviation / std::sqrt(count));
  EXPECT_LT(std::abs(std::sqrt(statistics.covariance()(0, 0)) - deviation),
            5 * deviation / std::sqrt(2.0 * count));
  EXPECT_EQ(statistics.covariance()(1, 1), 0);
}

/// Every sample has the forces of its own configuration. The crane's are linear in the payload, so
/// that none deviates by more than the worst case.
TEST(Sampling, HasTheForcesOfEachSample) {
  const Scene scene = example("crane");
  constexpr std::uint64_t count = 500;
  const Sampling sampling(scene.mechanism, scene.request, 0, 3, count);
  const Campaign campaign = sampling.campaign();
  const Rows rows = rows_of(campaign);
  const auto effort_at = static_cast<std::size_t>(
      std::ranges::find(campaign.columns, "cylinder.effort", &Column::name) -
      campaign.columns.begin());
  ASSERT_LT(effort_at, campaign.columns.size());
  const NominalForce& nominal = sampling.nominal_forces().front();
  EXPECT_EQ(nominal.column.name(), "cylinder.effort");
  double most = 0;
  for (std::size_t sample = 0; sample < count; ++sample) {
    const double effort = rows[sample * campaign.columns.size() + effort_at];
    most = std::max(most, std::abs(effort - nominal.number));
    if (sample % 50 == 0) {
      const Plan plan(scene);
      const Values values = plan.values({{"payload", sampling.parameters_of(sample)[0]}});
      const Solution solution = plan.solve(values);
      const auto& raised = solution.configurations[plan.nearest(values, solution)->configuration];
      EXPECT_DOUBLE_EQ(effort, forces_of(values, raised).efforts[DriverIndex(0)]);
    }
  }
  EXPECT_LE(most, nominal.worst_case * (1 + 1e-12));
  EXPECT_GT(most, 0.97 * nominal.worst_case);
  EXPECT_EQ(nominal.worst_case, nominal.rss);
}

/// The configuration that is turned least from the nominal one, by the sum of squares over links.
const Configuration& nearest_of(const Solution& solution, const Configuration& nominal,
                                LinkIndex ground, LinkIndex driven) {
  const auto square = [&](const Configuration& one) {
    double sum = 0;
    for (const LinkIndex link : one.links.keys()) {
      if (link != ground && link != driven) {
        const double turn = angle_of(
            turned(one.links[link].pose.direction, reversed(nominal.links[link].pose.direction)));
        sum += turn * turn;
      }
    }
    return sum;
  };
  return *std::ranges::min_element(solution.configurations, {}, square);
}

TEST(Sampling, IsWhatSolvingEachSampleGives) {
  for (const std::size_t branch : {1U, 2U}) {
    const Scene scene = example("four_bar_coupler_curve");
    const Sampling sampling(scene.mechanism, scene.request, branch, 7, 300);
    const Campaign campaign = sampling.campaign();
    const Rows rows = rows_of(campaign);
    Request request = scene.request;
    request.want = {true, false, false, false};
    request.sweep.reset();
    const Plan plan(scene.mechanism, request);
    const Solution nominal = plan.solve(plan.values());
    const LinkIndex crank = index_of(plan.mechanism().links(), std::string("crank"));
    for (std::size_t sample = 0; sample < 300; ++sample) {
      const std::vector<double> numbers = sampling.parameters_of(sample);
      std::vector<std::pair<std::string, double>> replaced;
      for (std::size_t place = 0; place < numbers.size(); ++place) {
        const Deviation& deviation = sampling.deviations()[place];
        const std::string& name = scene.mechanism.parameters()[deviation.parameter].name;
        replaced.emplace_back(name, numbers[place]);
        EXPECT_LT(std::abs(numbers[place] - plan.values().parameter(deviation.parameter)),
                  deviation.half_width);
      }
      const Solution solution = plan.solve(plan.values(replaced));
      const Configuration& expected = nearest_of(solution, nominal.configurations[branch - 1],
                                                 plan.mechanism().ground(), crank);
      const Eigen::Vector2d found(rows[6 * sample + 2], rows[6 * sample + 3]);
      EXPECT_LT((found - expected.output("P").position).norm(), 1e-12) << sample;
    }
  }
}

/// An almost stretched dyad: the samples that do not close are those without a triangle.
TEST(Sampling, CountsDyadsThatCannotClose) {
  const Scene scene = parse_scene(R"({
    "parameters": {"a": {"value": 1, "tolerance": 0.01}, "b": {"value": 1, "tolerance": 0.01},
                   "d": {"value": 1.995, "tolerance": 0.01}},
    "links": {"ground": {"A": [0, 0], "B": ["d", 0]}, "left": {"A": [0, 0], "C": ["a", 0]},
              "right": {"B": [0, 0], "C": ["b", 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "left.A"]},
               "B": {"type": "revolute", "between": ["ground.B", "right.B"]},
               "C": {"type": "revolute", "between": ["left.C", "right.C"]}},
    "outputs": {"C": "left.C"}})",
                                  "stretched");
  const Sampling sampling(scene.mechanism, scene.request, 1, 3, 2000);
  const Campaign campaign = sampling.campaign();
  const Rows rows = rows_of(campaign);
  std::size_t lost = 0;
  for (std::size_t sample = 0; sample < 2000; ++sample) {
    const std::vector<double> numbers = sampling.parameters_of(sample);
    const bool closes = numbers[0] + numbers[1] > numbers[2];
    EXPECT_EQ(outcome_in(campaign, rows, sample) == Outcome::no_assembly, !closes) << sample;
    EXPECT_EQ(std::isnan(rows[4 * sample + 2]), !closes);
    if (!closes && lost++ == 0) {
      EXPECT_NE(sampling.reason_of(sample), "");
    }
  }
  EXPECT_GT(lost, 300U);
  EXPECT_LT(lost, 1700U);
}

/// At a parallelogram's change point its two configurations meet, so that in no sample only one of
/// them is near the nominal configuration.
TEST(Sampling, TellsWhereTheConfigurationIsAmbiguous) {
  const std::string text = R"({
    "parameters": {"a": {"value": 1, "tolerance": 0.001}, "b": 1, "c": {"value": 2, "tolerance": 0.001},
                   "phi": 0},
    "links": {"ground": {"A": [0, 0], "D": [2, 0]}, "crank": {"A": [0, 0], "B": ["a", 0]},
              "coupler": {"B": [0, 0], "C": ["c", 0]}, "rocker": {"D": [0, 0], "C": ["b", 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
               "B": {"type": "revolute", "between": ["crank.B", "coupler.B"]},
               "C": {"type": "revolute", "between": ["coupler.C", "rocker.C"]},
               "D": {"type": "revolute", "between": ["ground.D", "rocker.D"]}},
    "drivers": {"A": {"position": "phi"}},
    "outputs": {"C": "rocker.C"}})";
  constexpr std::size_t count = 1000;
  const auto counts_at = [&](const std::string& phi) {
    const Scene scene = parse_scene(text, "parallelogram", {"phi=" + phi});
    const Sampling sampling(scene.mechanism, scene.request, 1, 4, count);
    EXPECT_EQ(sampling.nominal().front().worst_case.has_value(), phi != "0");
    const Campaign campaign = sampling.campaign();
    const Rows rows = rows_of(campaign);
    std::array<std::size_t, outcome_words.size()> counts{};
    for (std::size_t sample = 0; sample < count; ++sample) {
      ++counts[static_cast<std::size_t>(outcome_in(campaign, rows, sample))];
    }
    return counts;
  };
  const auto at_change_point = counts_at("0");
  const std::size_t lost = at_change_point[static_cast<std::size_t>(Outcome::no_assembly)];
  EXPECT_GT(lost, 200U);  // where crank and coupler do not reach
  EXPECT_EQ(lost + at_change_point[static_cast<std::size_t>(Outcome::ambiguous)] +
                at_change_point[static_cast<std::size_t>(Outcome::near_singular)],
            count);
  EXPECT_EQ(counts_at("1")[static_cast<std::size_t>(Outcome::regular)], count);
}

TEST(Sampling, RefusesWhatHasNothingToSample) {
  const auto refusal = [](const Mechanism& mechanism, std::size_t branch) -> std::string {
    try {
      const Sampling sampling(mechanism, {}, branch, 1, 10);
    } catch (const MechanismError& error) {
      return error.what();
    }
    return "";
  };
  Mechanism without_outputs("no outputs");
  EXPECT_EQ(refusal(without_outputs, 0).find("outputs: there is no point"), 0U);
  const Scene four_bar = example("four_bar_coupler_curve");
  EXPECT_EQ(refusal(four_bar.mechanism, 3), "there is no configuration 3; the highest number is 2");
  const Scene rigid =
      parse_scene(std::regex_replace(std::string(linear), std::regex("0\\.[13]"), "0"), "rigid");
  EXPECT_EQ(refusal(rigid.mechanism, 0).find("parameters: no parameter has a tolerance"), 0U);
}

TEST(Grid, HasTheConfigurationsOfTheTriangle) {
  const Scene scene = example("four_bar_coupler_curve");
  const std::vector<GridAxis> axes = {
      {scene.mechanism.parameter_named("phi"), 0, 2 * std::numbers::pi, 19},
      {scene.mechanism.parameter_named("ground"), 25.3, 290.1, 23}};
  const Campaign campaign = grid_campaign(scene.mechanism, scene.request, axes);
  EXPECT_EQ(campaign.items, 19U * 23U);
  const Rows rows = rows_of(campaign, {0, campaign.items}, 3);
  const std::size_t width = campaign.columns.size();
  std::size_t row = 0;
  for (std::uint64_t cell = 0; cell < campaign.items; ++cell) {
    const double phi = value_at(axes[0], cell / 23);
    const double ground = value_at(axes[1], cell % 23);
    const double diagonal = std::hypot(ground - 40 * std::cos(phi), 40 * std::sin(phi));
    const std::size_t expected = diagonal < 200 ? 2 : 0;  // coupler and rocker are 100 long
    for (std::size_t number = 0; number < std::max<std::size_t>(1, expected); ++number) {
      const double* const numbers = &rows[width * row++];
      EXPECT_EQ(numbers[0], static_cast<double>(cell));
      EXPECT_EQ(numbers[1], phi);
      EXPECT_EQ(numbers[2], ground);
      EXPECT_EQ(numbers[3], static_cast<double>(expected)) << phi << " " << ground;
      EXPECT_EQ(numbers[5], expected == 0 ? 0 : static_cast<double>(number + 1));
      EXPECT_EQ(std::isnan(numbers[7]), expected == 0);
    }
  }
  EXPECT_EQ(rows.size(), row * width);
}

TEST(Grid, RefusesTooManyCellsAndAParameterTwice) {
  const Scene scene = example("four_bar_coupler_curve");
  const ParameterIndex phi = scene.mechanism.parameter_named("phi");
  const ParameterIndex ground = scene.mechanism.parameter_named("ground");
  EXPECT_THROW((void)grid_campaign(scene.mechanism, scene.request,
                                   {{phi, 0, 1, 1000000}, {ground, 1, 2, 1000000}}),
               MechanismError);
  EXPECT_THROW(
      (void)grid_campaign(scene.mechanism, scene.request, {{phi, 0, 1, 2}, {phi, 0, 1, 2}}),
      MechanismError);
}

TEST(Histogram, DoesNotDependOnTheOrder) {
  std::vector<double> numbers;
  for (std::uint64_t sample = 0; sample < 5000; ++sample) {
    numbers.push_back(3 + std::pow(mechanism::campaign::uniform(2, sample, 0), 5));
  }
  Histogram forwards(3, 1e-9);
  Histogram backwards(3, 1e-9);
  std::ranges::for_each(numbers, [&](double number) { forwards.add(number); });
  std::for_each(numbers.rbegin(), numbers.rend(), [&](double number) { backwards.add(number); });
  const auto one = forwards.bars(50);
  const auto other = backwards.bars(50);
  ASSERT_EQ(one.size(), other.size());
  ASSERT_LE(one.size(), 50U);
  EXPECT_GT(one.size(), 25U);
  std::uint64_t total = 0;
  for (std::size_t bar = 0; bar < one.size(); ++bar) {
    EXPECT_EQ(one[bar].count, other[bar].count);
    EXPECT_EQ(one[bar].from, other[bar].from);
    const auto inside = std::ranges::count_if(
        numbers, [&](double number) { return number >= one[bar].from && number < one[bar].to; });
    EXPECT_EQ(one[bar].count, static_cast<std::uint64_t>(inside));
    total += one[bar].count;
  }
  EXPECT_EQ(total, numbers.size());
}

}  // namespace
}  // namespace assur::test::campaign_test
