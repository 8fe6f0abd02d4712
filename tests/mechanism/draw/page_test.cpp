// Law: the frames of a page are the solutions at the values of the sweep, and no name in a scene
// ends the script or the template that contains it.
#include <gtest/gtest.h>

#include <algorithm>
#include <assur/mechanism/drawing.hpp>
#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "largest.hpp"

namespace assur::test::page_test {
namespace {

using mechanism::JointType;
using mechanism::Mechanism;
using mechanism::Plan;
using mechanism::Scene;
using Json = nlohmann::ordered_json;

Json data_of(const std::string& page) {
  const std::string begin = R"(<script type="application/json" id="film">)";
  const std::size_t at = page.find(begin) + begin.size();
  return Json::parse(page.substr(at, page.find("</script>", at) - at));
}

/// The numbers of 32 bits that the page holds in base 64.
std::vector<float> numbers_of(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t held = 0;
  unsigned bits = 0;
  for (const char letter : text) {
    if (letter != '=') {
      held = held << 6U | static_cast<std::uint32_t>(digits.find(letter));
      bits += 6;
      if (bits >= 8) {
        bits -= 8;
        bytes.push_back(static_cast<std::uint8_t>(held >> bits & 0xFFU));
      }
    }
  }
  std::vector<float> numbers;
  for (std::size_t at = 0; at + 3 < bytes.size(); at += 4) {
    numbers.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(bytes[at]) |
                                           static_cast<std::uint32_t>(bytes[at + 1]) << 8U |
                                           static_cast<std::uint32_t>(bytes[at + 2]) << 16U |
                                           static_cast<std::uint32_t>(bytes[at + 3]) << 24U));
  }
  return numbers;
}

/// The same numbers in the scene's own coordinates; each row begins with x and y.
std::vector<double> placed(const std::string& text, std::size_t width, const Json& origin) {
  const std::vector<float> numbers = numbers_of(text);
  std::vector<double> there(numbers.begin(), numbers.end());
  for (std::size_t at = 0; at < there.size(); at += width) {
    there[at] += origin[0].get<double>();
    there[at + 1] += origin[1].get<double>();
  }
  return there;
}

/// The platform is swept along a length, so that its links change their shapes from step to step.
TEST(PageOfASweptLength, HasOutputsAndPinsWhereTheyAreSolved) {
  const Scene scene = mechanism::read_scene(ASSUR_EXAMPLES "/platform_3rpr.json");
  const std::string page = drawing_page(scene.mechanism, scene.request);
  EXPECT_LT(page.size(), 1'000'000U);
  const Json data = data_of(page);
  const auto count = data["count"].get<std::size_t>();
  ASSERT_EQ((count - 1) % 120, 0U);
  const auto pin = std::find_if(data["shapes"].begin(), data["shapes"].end(), [](const Json& one) {
    return one["symbol"] == "pin" && one["name"] == "B1";
  });
  ASSERT_NE(pin, data["shapes"].end());
  const auto point = (*pin)["points"][0].get<std::size_t>();
  const Plan plan(scene);
  double worst = 0;
  int compared = 0;
  for (const std::size_t step : {std::size_t{0}, count / 3, count - 1}) {
    const double leg = 12 + 6 * static_cast<double>(step) / static_cast<double>(count - 1);
    const mechanism::Solution solution = plan.solve(plan.values({{"leg1", leg}}));
    std::vector<bool> found(solution.configurations.size(), false);
    for (const Json& branch : data["branches"]) {
      const std::vector<double> points = placed(branch["points"], 2, data["origin"]);
      const std::vector<double> outputs = placed(branch["outputs"], 6, data["origin"]);
      ASSERT_EQ(points.size(), 2 * count * data["points"].get<std::size_t>());
      ASSERT_EQ(outputs.size(), 12 * count);
      const std::size_t at = 2 * (step * data["points"].get<std::size_t>() + point);
      if (std::isnan(points[at])) {
        continue;
      }
      double nearest = INFINITY;
      for (std::size_t place = 0; place < found.size(); ++place) {
        const Eigen::Vector2d solved = solution.configurations[place].output("B1").position;
        const double distance =
            std::max({std::abs(points[at] - solved.x()), std::abs(points[at + 1] - solved.y()),
                      std::abs(outputs[12 * step] - solved.x()),
                      std::abs(outputs[12 * step + 1] - solved.y())});
        found[place] = found[place] || distance < 1e-5;
        nearest = std::min(nearest, distance);
      }
      worst = largest(worst, nearest);
      ++compared;
    }
    EXPECT_TRUE(std::all_of(found.begin(), found.end(), [](bool one) { return one; }));
  }
  EXPECT_GT(compared, 9);
  EXPECT_LT(worst, 2e-6);
}

/// A crank alone, with names that end scripts and templates.
struct Odd {
  Mechanism mechanism{"</script><script>alert(1)</script>{{film}}{{style}}"};
  mechanism::Request request;
};
Odd odd_names() {
  Odd odd;
  Mechanism& m = odd.mechanism;
  m.set_unit("</script>");
  m.add_parameter("phi", 1);
  m.add_link("ground");
  m.add_point("ground.A", 0, 0);
  m.add_link("<!--<script>");
  m.add_point("<!--<script>.A", 0, 0);
  m.add_point("<!--<script>.B", 2, 0);
  m.add_joint("A", JointType::revolute, {"ground.A", "<!--<script>.A"});
  m.add_driver("A", "phi", 1);
  m.add_output("{{title}}", "<!--<script>.B");
  return odd;
}

TEST(PageOfOddNames, IsOnePage) {
  const Odd odd = odd_names();
  const std::string page = drawing_page(odd.mechanism, odd.request);
  const auto count = [&](const std::string& text) {
    int found = 0;
    for (std::size_t at = page.find(text); at != std::string::npos; at = page.find(text, at + 1)) {
      ++found;
    }
    return found;
  };
  EXPECT_EQ(count("<script"), 2);
  EXPECT_EQ(count("</script>"), 2);
  EXPECT_EQ(count("<!--"), 0);
  EXPECT_EQ(
      count("<title>&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;{{film}}{{style}}</title>"),
      1);
  const Json data = data_of(page);
  EXPECT_EQ(data["title"], odd.mechanism.name());
  EXPECT_EQ(data["outputs"][0], "{{title}}");
}

TEST(PageWithoutASweep, HasTheConfigurationsAtOneStep) {
  const Odd odd = odd_names();
  const Json data = data_of(drawing_page(odd.mechanism, odd.request));
  EXPECT_EQ(data["count"], 1);
  ASSERT_EQ(data["branches"].size(), 1U);
  const std::vector<double> output = placed(data["branches"][0]["outputs"], 6, data["origin"]);
  ASSERT_EQ(output.size(), 6U);
  EXPECT_NEAR(output[0], 2 * std::cos(1), 1e-6);
  EXPECT_NEAR(output[3], 2 * std::cos(1), 1e-6);  // the speed upwards at angular velocity 1
}

/// A crank of length 2 stands millions of units from the origin, where single precision has steps
/// of half a unit.
TEST(PageOfAFarPlace, HasPlacesToAPartOfTheMechanism) {
  Mechanism m("A far crank");
  m.add_parameter("phi", 1);
  m.add_link("ground");
  m.add_point("ground.A", 4.5e5, 5.4e6);
  m.add_link("crank");
  m.add_point("crank.A", 0, 0);
  m.add_point("crank.B", 2, 0);
  m.add_joint("A", JointType::revolute, {"ground.A", "crank.A"});
  m.add_driver("A", "phi", 1);
  m.add_output("B", "crank.B");
  const Json data = data_of(drawing_page(m, {}));
  const std::vector<double> output = placed(data["branches"][0]["outputs"], 6, data["origin"]);
  EXPECT_NEAR(output[0], 4.5e5 + 2 * std::cos(1), 1e-6);
  EXPECT_NEAR(output[1], 5.4e6 + 2 * std::sin(1), 1e-6);
}

/// The crank with a swept angle: `length` has a value of its own, `twice` is a formula.
constexpr const char* crank = R"({"name": "A crank",
  "parameters": {"length": "1+1", "twice": "2*length", "phi": 0},
  "links": {"ground": {"A": [0, 0]}, "crank": {"A": [0, 0], "B": ["twice", 0]}},
  "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]}},
  "drivers": {"A": {"position": "phi"}}, "outputs": {"B": "crank.B"},
  "sweep": {"parameter": "phi", "from": 0, "to": 1, "count": 5}})";

TEST(PageOfASceneText, HasSlidersForWhatHasAValueOfItsOwn) {
  const mechanism::SceneText source = {crank, {"length=3"}};
  const Scene scene = mechanism::parse_scene(source.text, "crank", source.settings);
  const std::string page = drawing_page(scene.mechanism, scene.request, source);
  EXPECT_LE(page.size(), mechanism::most_page_bytes);
  const Json data = data_of(page);
  EXPECT_EQ(data["parameters"], Json::parse(R"([{"name": "length", "value": 3.0, "own": true},
    {"name": "twice", "value": 6.0, "own": false}, {"name": "phi", "value": 0.0, "own": true}])"));
  const Json& solved = data["scene"];
  EXPECT_EQ(solved["text"], crank);
  EXPECT_EQ(solved["settings"], Json::parse(R"(["length=3"])"));
  EXPECT_GT(solved["module"].get<std::string>().size(), 100'000U);
  EXPECT_TRUE(data_of(drawing_page(scene.mechanism, scene.request))["scene"].is_null());
}

TEST(PageOfASceneText, HasNoModuleWhereItWouldBeLargerThanTheBound) {
  const mechanism::SceneText source = {crank + std::string(700'000, ' '), {}};
  const Scene scene = mechanism::parse_scene(source.text, "crank");
  const std::string page = drawing_page(scene.mechanism, scene.request, source);
  EXPECT_LE(page.size(), mechanism::most_page_bytes);
  const Json data = data_of(page);
  EXPECT_TRUE(data["scene"].is_null());
  EXPECT_EQ(data["count"], 181);
}

TEST(PageOfASceneText, HasTheModuleWhereNothingButTheSweptAngleHasAValue) {
  const std::string own = R"("length": "1+1", "twice": "2*length", )";
  std::string text = crank;
  text.erase(text.find(own), own.size());
  text.replace(text.find(R"("twice")"), 7, "4");
  const Scene scene = mechanism::parse_scene(text, "crank");
  const mechanism::SceneText source = {text, {}};
  EXPECT_EQ(data_of(drawing_page(scene.mechanism, scene.request, source))["scene"]["text"], text);
}

TEST(PageOfAProgram, HasTheAnglesOfLinksAndTheirRates) {
  std::string text = crank;
  const std::string driver = R"({"position": "phi"})";
  text.replace(text.find(driver), driver.size(), R"({"position": "phi", "velocity": 3})");
  const Scene scene = mechanism::parse_scene(text, "crank");
  const Json data = data_of(drawing_page(scene.mechanism, scene.request));
  EXPECT_EQ(data["links"], Json::parse(R"(["crank"])"));
  const std::vector<float> angles = numbers_of(data["branches"][0]["angles"]);
  const auto count = data["count"].get<std::size_t>();
  ASSERT_EQ(angles.size(), 3 * count);
  for (std::size_t step = 0; step < count; ++step) {
    EXPECT_NEAR(angles[3 * step], static_cast<double>(step) / static_cast<double>(count - 1), 1e-6);
    EXPECT_NEAR(angles[3 * step + 1], 3, 1e-6);
    EXPECT_NEAR(angles[3 * step + 2], 0, 1e-6);
  }
}

TEST(PageOfASweep, OpensOnTheBranchThatIsAskedFor) {
  const Scene scene = mechanism::read_scene(ASSUR_EXAMPLES "/four_bar_coupler_curve.json");
  EXPECT_EQ(data_of(drawing_page(scene.mechanism, scene.request, std::nullopt, 2))["chosen"], 2);
  EXPECT_THROW((void)drawing_page(scene.mechanism, scene.request, std::nullopt, 3),
               mechanism::NoSuchConfiguration);
}

/// B = 2 length (cos phi, sin phi).
Eigen::Matrix2d covariance_of_crank(double phi, const Eigen::Matrix2d& of_length_and_phi) {
  constexpr double length = 2;
  Eigen::Matrix2d derivatives;
  derivatives << 2 * std::cos(phi), -2 * length * std::sin(phi), 2 * std::sin(phi),
      2 * length * std::cos(phi);
  return derivatives * of_length_and_phi * derivatives.transpose();
}

void expect_spreads(const std::string& text, const Eigen::Matrix2d& of_length_and_phi) {
  const Scene scene = mechanism::parse_scene(text, "crank");
  const Json data = data_of(drawing_page(scene.mechanism, scene.request));
  const std::vector<float> spreads = numbers_of(data["branches"][0]["spreads"]);
  const auto count = data["count"].get<std::size_t>();
  ASSERT_EQ(spreads.size(), 3 * count);
  for (std::size_t step = 0; step < count; ++step) {
    const double phi = static_cast<double>(step) / static_cast<double>(count - 1);
    const Eigen::Matrix2d expected = covariance_of_crank(phi, of_length_and_phi);
    EXPECT_NEAR(spreads[3 * step], expected(0, 0), 1e-7);
    EXPECT_NEAR(spreads[3 * step + 1], expected(0, 1), 1e-7);
    EXPECT_NEAR(spreads[3 * step + 2], expected(1, 1), 1e-7);
  }
}

TEST(PageOfWhatVaries, HasTheCovarianceOfItsOutputs) {
  std::string text = crank;
  text.insert(text.rfind('}'), R"(, "covariance": {"parameters": ["length", "phi"],
    "matrix": [[0.01, 0.001], [0.001, 0.0004]]})");
  Eigen::Matrix2d matrix;
  matrix << 0.01, 0.001, 0.001, 0.0004;
  expect_spreads(text, matrix);
}

TEST(PageOfWhatVaries, TakesTolerancesForDeviations) {
  std::string text = crank;
  const std::string own = R"("1+1")";
  text.replace(text.find(own), own.size(), R"({"value": 2, "tolerance": "0.1"})");
  Eigen::Matrix2d matrix;
  matrix << 0.01, 0, 0, 0;
  expect_spreads(text, matrix);
}

TEST(PageOfNothing, IsRefused) {
  Scene scene = mechanism::read_scene(ASSUR_EXAMPLES "/four_bar_coupler_curve.json",
                                      {"coupler=1", "rocker=1"});
  EXPECT_THROW((void)drawing_page(scene.mechanism, scene.request), mechanism::MechanismError);
  scene.request.sweep.reset();
  EXPECT_THROW((void)drawing_page(scene.mechanism, scene.request), mechanism::MechanismError);
  Mechanism ground("The ground alone");
  ground.add_link("ground");
  ground.add_point("ground.A", 0, 0);
  EXPECT_THROW((void)drawing_page(ground, {}), mechanism::MechanismError);
}

}  // namespace
}  // namespace assur::test::page_test
