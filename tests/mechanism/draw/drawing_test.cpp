// Law: in a drawing, pins and outputs are at their solved positions and dead centres where sweeps
// find them, in any unit and with any names.
#include <gtest/gtest.h>

#include <algorithm>
#include <assur/mechanism/drawing.hpp>
#include <assur/mechanism/forces.hpp>
#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <iostream>
#include <map>
#include <regex>
#include <set>

#include "largest.hpp"
#include "mechanism/drawn_scene.hpp"
#include "mechanism/picture.hpp"
#include "mechanism/swept_slider_crank.hpp"
#include "scenes_of.hpp"

namespace assur::test::drawing_test {
namespace {

using mechanism::Drawing;
using mechanism::JointType;
using mechanism::Mechanism;
using mechanism::Plan;
using mechanism::Shape;
using mechanism::Symbol;

class ExampleDrawing : public testing::TestWithParam<std::string> {
 protected:
  ExampleDrawing() : drawn_(drawn_scene(GetParam())), drawing_(drawn_.drawing) {}

  const DrawnScene& drawn_;
  const Drawing& drawing_;
};

TEST_P(ExampleDrawing, HasEveryConfigurationOnce) {
  ASSERT_EQ(drawing_.stances.size(), drawn_.solution.configurations.size());
  for (std::size_t place = 0; place < drawing_.stances.size(); ++place) {
    EXPECT_EQ(drawing_.stances[place].configuration, static_cast<int>(place) + 1);
  }
  EXPECT_FALSE(drawing_.traces.empty());
}

/// The picture's own coordinates have two decimals.
TEST_P(ExampleDrawing, PinsOfThePictureStandWhereTheyAreSolved) {
  const Picture picture(drawing_);
  const auto pins =
      pins_of(drawn_.plan, drawn_.values, drawn_.solution.configurations[drawing_.emphasised]);
  std::set<std::string> seen;
  double worst = 0;
  for (const XmlElement* element : picture.elements) {
    if (element->attribute("class") == "pin") {
      ASSERT_EQ(element->children.size(), 1U);
      const std::string name = element->children[0].text;
      ASSERT_TRUE(pins.contains(name)) << name;
      const Eigen::Vector2d at = picture.in_scene(std::stod(element->attribute("cx")),
                                                  std::stod(element->attribute("cy")));
      worst = largest(worst, (at - pins.at(name)).norm() * picture.number("data-scale"));
      seen.insert(name);
    }
  }
  EXPECT_EQ(seen.size(), pins.size());
  EXPECT_LT(worst, 0.0072);
}

TEST_P(ExampleDrawing, NumbersOfThePictureAreFiniteAndInsideIt) {
  const Picture picture(drawing_);
  const double height =
      picture.number("data-scale") > 0 ? std::stod(picture.root.attribute("viewBox").substr(8)) : 0;
  const std::regex number(R"(-?[0-9]+(\.[0-9]+)?)");
  int count = 0;
  for (const XmlElement* element : picture.elements) {
    for (const std::string key : {"d", "cx", "cy", "x", "y"}) {
      const std::string value = element->attribute(key);
      EXPECT_EQ(std::regex_replace(value, number, "").find_first_not_of("M ,Z"), std::string::npos)
          << value;
      for (std::sregex_iterator at(value.begin(), value.end(), number), end; at != end; ++at) {
        EXPECT_GE(std::stod(at->str()), 0);
        EXPECT_LE(std::stod(at->str()), std::max(height, 320.0));
        ++count;
      }
    }
  }
  EXPECT_GT(count, 50);
}

/// The widths that are assumed for letters are not less than those of common plain fonts.
TEST_P(ExampleDrawing, TextsDoNotOverlap) {
  const Picture picture(drawing_);
  struct Extent {
    double left, right, top, bottom;
  };
  std::vector<Extent> extents;
  for (const XmlElement* element : picture.elements) {
    if (element->name == "text") {
      const double width = 6.1 * static_cast<double>(element->text.size());
      const double x = std::stod(element->attribute("x"));
      const double y = std::stod(element->attribute("y"));
      const bool centred = element->attribute("class") == "label";
      const double left = centred ? x - width / 2 : x;
      extents.push_back({left, left + width, y - 7.2, y});
    }
  }
  for (std::size_t one = 0; one < extents.size(); ++one) {
    for (std::size_t other = 0; other < one; ++other) {
      const Extent& a = extents[one];
      const Extent& b = extents[other];
      EXPECT_FALSE(a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
          << one << " and " << other;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExampleDrawing, testing::ValuesIn(scenes_of(ASSUR_EXAMPLES)),
                         [](const auto& name) { return std::string(name.param); });

/// Every dead centre that is drawn is an event of the sweep in the scene's own steps.
TEST(DrawingOfTheWorkedMechanism, HasTheDeadCentresOfItsSweep) {
  const DrawnScene& drawn = drawn_scene("quintero_2011_rrp_rrr");
  std::set<long> swept;
  sweep(drawn.plan, {[&](const mechanism::SweepRecord& row) {
                       if (row.event.starts_with("fold") || row.event.starts_with("birth")) {
                         swept.insert(std::lround(row.parameter * 1e7));
                       }
                     },
                     nullptr, nullptr});
  int count = 0;
  for (const mechanism::Mark& mark : drawn.drawing.marks) {
    if (mark.event == "fold" || mark.event == "birth") {
      EXPECT_TRUE(swept.contains(std::lround(mark.parameter * 1e7))) << mark.parameter;
      ++count;
    }
  }
  std::cout << count << " dead centres drawn of " << swept.size() << '\n';
  EXPECT_GT(count, 0);
}

/// What a picture shows of the mechanism, without its scale.
std::string shown(const Made& made) {
  const std::string text = drawing_svg(drawing_of(made.mechanism, made.request));
  const std::size_t legend = text.find("<g class=\"scale\">");
  EXPECT_NE(legend, std::string::npos);
  return std::regex_replace(text.substr(0, legend), std::regex(R"( data-[a-z]+="[^"]*")"), "");
}

/// A factor that is a power of two changes no digit of a number.
TEST(DrawingOfAnyUnit, IsTheSamePicture) {
  EXPECT_EQ(shown(slider_crank(1)), shown(slider_crank(1024)));
  EXPECT_EQ(shown(slider_crank(1)), shown(slider_crank(std::ldexp(1, -30))));
}

TEST(DrawingOfOddNames, IsWellFormed) {
  const Made made = slider_crank(1, " <&\"'>\xc3\xa9 ]]>");
  const Drawing drawing = drawing_of(made.mechanism, made.request);
  const Picture picture(drawing);
  EXPECT_EQ(picture.root.children[0].text, "one & <two> \"three\" ? <&\"'>\xc3\xa9 ]]>");
  const std::string dxf = drawing_dxf(drawing);
  EXPECT_TRUE(std::all_of(dxf.begin(), dxf.end(),
                          [](char byte) { return byte == '\n' || (byte >= 0x20 && byte < 0x7f); }));
  EXPECT_NE(dxf.find("\\U+00E9"), std::string::npos);
}

/// A link has the name of the layer of pins.
TEST(DrawingOfOddNames, HasALayerForEachLink) {
  Mechanism mechanism("a link called pins");
  mechanism.add_link("ground");
  mechanism.add_point("ground.A", 0, 0);
  mechanism.add_link("pins");
  mechanism.add_point("pins.A", 0, 0);
  mechanism.add_point("pins.B", 1, 0);
  mechanism.add_joint("A", JointType::revolute, {"ground.A", "pins.A"});
  mechanism.add_driver("A", 1);
  mechanism.add_link("free");
  mechanism.add_point("free.B", 0, 0);
  mechanism.add_joint("B", JointType::revolute, {"pins.B", "free.B"});
  mechanism.add_driver("B", 1);
  const std::string dxf = drawing_dxf(drawing_of(mechanism, {}));
  EXPECT_NE(dxf.find("\n8\nC1_PINS\n"), std::string::npos);
  EXPECT_NE(dxf.find("\n8\nC1_PINS_2\n"), std::string::npos);
}

std::map<Symbol, int> symbols_of(const std::string& scene) {
  std::map<Symbol, int> counts;
  for (const Shape& shape : drawn_scene(scene).drawing.shapes) {
    ++counts[shape.symbol];
  }
  return counts;
}

TEST(DrawingSymbols, AreThoseOfTheJoints) {
  auto excavator = symbols_of("excavator_arm");
  EXPECT_EQ(excavator[Symbol::tube], 3);
  EXPECT_EQ(excavator[Symbol::rod], 3);
  EXPECT_EQ(excavator[Symbol::plate], 3);  // boom, stick, bucket
  EXPECT_EQ(excavator[Symbol::bar], 2);    // rocker, link
  auto shaper = symbols_of("shaper_quick_return");
  EXPECT_EQ(shaper[Symbol::slot], 1);
  EXPECT_EQ(shaper[Symbol::guide], 1);
  EXPECT_EQ(shaper[Symbol::block], 1);
  auto lift = symbols_of("scissor_lift");
  EXPECT_EQ(lift[Symbol::slot], 2);
  EXPECT_EQ(lift[Symbol::tube], 1);
}

TEST(DrawingChoices, AreOneConfigurationOrRefused) {
  const Made made = slider_crank(1);
  const Drawing second = drawing_of(made.mechanism, made.request, {2, false});
  ASSERT_EQ(second.stances.size(), 1U);
  EXPECT_EQ(second.stances[0].configuration, 2);
  EXPECT_TRUE(std::all_of(second.traces.begin(), second.traces.end(),
                          [](const mechanism::Trace& trace) { return trace.configuration == 2; }));
  EXPECT_THROW((void)drawing_of(made.mechanism, made.request, {3, false}),
               mechanism::MechanismError);
  EXPECT_THROW((void)drawing_of(made.mechanism, made.request, {0, true}),
               mechanism::MechanismError);
  EXPECT_THROW((void)drawing_of(Mechanism("nothing"), {}), mechanism::MechanismError);
  Mechanism ground("ground alone");
  ground.add_link("ground");
  EXPECT_THROW((void)drawing_of(ground, {}), mechanism::MechanismError);
}

/// If the scene's own value is no value of the sweep, the traces belong to no configuration.
TEST(DrawingBesideItsSweep, HasWaysWithoutConfigurations) {
  Made made = slider_crank(1);
  made.request.sweep->from = made.mechanism.add_number(1, "sweep.from");
  const Drawing drawing = drawing_of(made.mechanism, made.request);
  ASSERT_EQ(drawing.traces.size(), 2U);
  for (const mechanism::Trace& trace : drawing.traces) {
    EXPECT_EQ(trace.configuration, 0);
  }
  EXPECT_NO_THROW(Picture{drawing});
}

/// Arrows begin in the pins and are as long as the forces say, by the arrow of the legend.
TEST(DrawingOfForces, IsToScale) {
  const mechanism::Scene scene = mechanism::read_scene(ASSUR_EXAMPLES "/four_bar_torque.json");
  const Drawing all = drawing_of(scene.mechanism, scene.request);
  EXPECT_TRUE(all.forces.empty());
  const Drawing drawing = drawing_of(scene.mechanism, scene.request, {0, true});
  const Picture picture(drawing);
  const Plan plan(scene);
  const auto values = plan.values();
  const mechanism::Solution solution = plan.solve(values);
  const auto& configuration =
      solution.configurations[plan.nearest(values, solution)->configuration];
  const auto pins = pins_of(plan, values, configuration);
  const std::regex numbers("M(.+),(.+) (.+),(.+)M.*");
  std::vector<Eigen::Vector2d> foot, arrow;
  std::vector<std::string> titles;
  for (const XmlElement* element : picture.elements) {
    std::smatch found;
    const std::string path = element->attribute("class") == "force" ? element->attribute("d") : "";
    if (std::regex_match(path, found, numbers)) {
      const auto number = [&](std::size_t place) { return std::stod(found[place].str()); };
      foot.push_back(picture.in_scene(number(1), number(2)));
      arrow.push_back(picture.in_scene(number(3), number(4)) - foot.back());
      titles.push_back(element->children.empty() ? "" : element->children[0].text);
    }
  }
  const mechanism::Forces forces = forces_of(values, configuration);
  ASSERT_EQ(arrow.size(), forces.joints.size() + 1);
  ASSERT_NE(picture.text.find(">force 20<"), std::string::npos);
  const double scale = arrow.back().x() / 20;
  double worst = 0;
  for (std::size_t place = 0; place < forces.joints.size(); ++place) {
    const mechanism::JointForce& force = forces.joints[place];
    EXPECT_EQ(titles[place].find(force.joint + " on "), 0U) << titles[place];
    worst = largest(worst, (arrow[place] / scale - force.on.back().second).norm());
    EXPECT_LT((foot[place] - pins.at(force.joint)).norm(), 0.01 / picture.number("data-scale"));
  }
  std::cout << "forces read off the picture are wrong by " << worst << " of 31\n";
  EXPECT_LT(worst, 0.02);  // the picture has two decimals, the longest arrow 60 units
}

}  // namespace
}  // namespace assur::test::drawing_test
