// Law: every link and slide of every example has the same results alone, with only the parts
// modelled that hold it, as in the whole mechanism.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "command/command.hpp"
#include "largest.hpp"
#include "mechanism/solved.hpp"
#include "scenes_of.hpp"

namespace assur::test::reported_part_test {
namespace {

namespace fs = std::filesystem;
using mechanism::JointIndex;
using mechanism::LinkIndex;
using mechanism::Reported;

/// The numbers of one part in every configuration. Equal ones are kept once, since configurations
/// may differ in other parts alone.
using Numbers = std::vector<std::vector<double>>;

bool are_close(const std::vector<double>& one, const std::vector<double>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](double a, double b) { return std::abs(a - b) <= 1e-9 * (1 + std::abs(a)); });
}

void add_once(Numbers& numbers, const std::vector<double>& entry) {
  if (std::none_of(numbers.begin(), numbers.end(),
                   [&](const std::vector<double>& known) { return are_close(known, entry); })) {
    numbers.push_back(entry);
  }
}

Numbers of_link(const Solved& solved, const std::string& name) {
  Numbers numbers;
  for (const Configuration& configuration : solved.configurations()) {
    const mechanism::Frame& link = configuration.link(name);
    std::vector<double> entry = {link.pose.x, link.pose.y, link.pose.direction.cos,
                                 link.pose.direction.sin};
    entry.insert(entry.end(), link.velocity.begin(), link.velocity.end());
    entry.insert(entry.end(), link.acceleration.begin(), link.acceleration.end());
    const auto derivatives = link.follows.first.reshaped();
    entry.insert(entry.end(), derivatives.begin(), derivatives.end());
    add_once(numbers, entry);
  }
  return numbers;
}

Numbers of_slide(const Solved& solved, const std::string& name) {
  Numbers numbers;
  const JointIndex joint = index_of(solved.plan.mechanism().joints(), name);
  for (const Configuration& configuration : solved.configurations()) {
    for (const mechanism::SlideState& slide : configuration.slides) {
      if (slide.joint == joint) {
        add_once(numbers, {slide.displacement, slide.velocity, slide.acceleration});
      }
    }
  }
  return numbers;
}

/// The part may have more: configurations that the rest of the mechanism cannot reach.
void expect_included(const Numbers& whole, const Numbers& part, const std::string& what) {
  EXPECT_GE(part.size(), whole.size()) << what;
  for (const std::vector<double>& entry : whole) {
    EXPECT_TRUE(std::any_of(part.begin(), part.end(), [&](const std::vector<double>& other) {
      return are_close(entry, other);
    })) << what;
  }
}

/// The scene with one part reported and no outputs, solved; the rest of its text stays.
Solved reporting(const std::string& text, const std::string& list, const std::string& name) {
  auto scene = nlohmann::ordered_json::parse(text);
  scene["report"] = {{"links", nlohmann::ordered_json::array()},
                     {"joints", nlohmann::ordered_json::array()}};
  scene["report"][list].push_back(name);
  scene.erase("outputs");
  return Solved(mechanism::parse_scene(scene.dump(), "scene"));
}

TEST(ReportedPart, HasWhatTheWholeMechanismSaysOfIt) {
  int links = 0;
  int slides = 0;
  int smaller = 0;
  for (const std::string& scene : scenes_of(ASSUR_EXAMPLES)) {
    SCOPED_TRACE(scene);
    const std::string text = read_file(fs::path(ASSUR_EXAMPLES) / (scene + ".json"));
    const Solved whole(mechanism::parse_scene(text, "scene"));
    const mechanism::Mechanism& all = whole.plan.mechanism();
    for (const mechanism::Link& link : all.links()) {
      const Solved part = reporting(text, "links", link.name);
      expect_included(of_link(whole, link.name), of_link(part, link.name), link.name);
      smaller += part.plan.structure().groups.size() < whole.plan.structure().groups.size() ? 1 : 0;
      ++links;
    }
    for (const mechanism::Joint& joint : all.joints()) {
      if (joint.type != mechanism::JointType::revolute) {
        const Solved part = reporting(text, "joints", joint.name);
        expect_included(of_slide(whole, joint.name), of_slide(part, joint.name), joint.name);
        ++slides;
      }
    }
  }
  EXPECT_GE(links, 40);
  EXPECT_GE(slides, 4);
  EXPECT_GE(smaller, 20);
}

TEST(ReportedPart, IsTheGroundWhereNothingIsReported) {
  const std::string text = read_file(fs::path(ASSUR_EXAMPLES) / "jansen_leg.json");
  const Solved solved = reporting(text, "links", "ground");
  EXPECT_EQ(solved.plan.mechanism().links().size(), 1U);
  ASSERT_EQ(solved.configurations().size(), 1U);
  EXPECT_EQ(solved.plan.structure().groups.size(), 0U);
}

TEST(ReportedPart, HasTheSameSweep) {
  // Jansen's leg has eight branches; its coupler j alone has two.
  auto scene =
      nlohmann::ordered_json::parse(read_file(fs::path(ASSUR_EXAMPLES) / "jansen_leg.json"));
  scene["report"] = {{"links", {"j"}}, {"joints", nlohmann::ordered_json::array()}};
  scene.erase("outputs");
  scene["sweep"]["count"] = 37;
  const TemporaryDirectory directory;
  const auto file = directory.write("leg.json", scene.dump());
  const CommandResult swept = run_assur("solve '" + file.string() + "' --format csv");
  EXPECT_EQ(swept.status, 0) << swept.messages;
  EXPECT_EQ(std::count(swept.output.begin(), swept.output.end(), '\n'), 1 + 2 * 37);
  EXPECT_EQ(swept.output.substr(0, swept.output.find(".theta")),
            "step,configuration,branch,phi,j.x,j.y,j");
}

TEST(ReportedPart, IsRefusedInALine) {
  const std::string text = read_file(fs::path(ASSUR_EXAMPLES) / "slider_crank.json");
  const auto expect = [&](const std::string& report, const std::string& words) {
    auto scene = nlohmann::ordered_json::parse(text);
    scene["report"] = nlohmann::ordered_json::parse(report);
    try {
      const Plan plan(mechanism::parse_scene(scene.dump(), "scene"));
      ADD_FAILURE() << report << " was accepted";
    } catch (const mechanism::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  expect("[]", "report");
  expect(R"({"link": []})", "did you mean 'links'");
  expect(R"({"links": "rod"})", "expected a list of the names of links");
  expect(R"({"links": ["rodd"]})", "no link named 'rodd'");
  expect(R"({"links": ["crank", "crank"]})", "'crank' occurs twice");
  expect(R"({"joints": ["A"]})", "revolute");
}

}  // namespace
}  // namespace assur::test::reported_part_test
