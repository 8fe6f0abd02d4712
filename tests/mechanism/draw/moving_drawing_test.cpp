// Law: in a moving drawing, every pin is at each moment at its solved position, and the requested
// branch is shown, however many others there are.
#include <gtest/gtest.h>

#include <assur/mechanism/drawing.hpp>
#include <assur/mechanism/plan.hpp>
#include <cmath>
#include <set>
#include <sstream>

#include "largest.hpp"
#include "mechanism/picture.hpp"
#include "mechanism/swept_slider_crank.hpp"

namespace assur::test::moving_drawing_test {
namespace {

using mechanism::Drawing;
using mechanism::JointType;
using mechanism::Mechanism;
using mechanism::Plan;

std::vector<double> values_of(const XmlElement& pin, const std::string& attribute) {
  std::vector<double> values;
  for (const XmlElement& child : pin.children) {
    if (child.name == "animate" && child.attribute("attributeName") == attribute) {
      std::istringstream in(child.attribute("values"));
      for (std::string value; std::getline(in, value, ';');) {
        values.push_back(std::stod(value));
      }
    }
  }
  return values;
}

/// A full turn is a closed motion; its every moment is a solved position.
TEST(MovingDrawing, HasPinsWhereTheyAreSolved) {
  const Made made = slider_crank(1);
  const Picture picture(moving_drawing_of(made.mechanism, made.request, 1));
  const Plan plan(made.mechanism, made.request);
  std::set<std::string> moving;
  double worst = 0;
  for (const XmlElement* element : picture.elements) {
    if (element->attribute("class") != "pin" || element->children.size() < 2) {
      continue;
    }
    const std::vector<double> u = values_of(*element, "cx");
    const std::vector<double> v = values_of(*element, "cy");
    ASSERT_EQ(u.size(), v.size());
    ASSERT_EQ(60 % (u.size() - 1), 0U);
    EXPECT_EQ(u.front(), u.back());
    for (std::size_t moment = 0; moment < u.size(); ++moment) {
      const double part = static_cast<double>(moment) / static_cast<double>(u.size() - 1);
      const mechanism::Values values = plan.values({{"phi", 2 * std::acos(-1) * part}});
      const auto pins = pins_of(plan, values, plan.solve(values).configurations[0]);
      const Eigen::Vector2d at = picture.in_scene(u[moment], v[moment]);
      worst = largest(
          worst, (at - pins.at(element->children[0].text)).norm() * picture.number("data-scale"));
    }
    moving.insert(element->children[0].text);
  }
  EXPECT_EQ(moving, (std::set<std::string>{"B", "C"}));
  EXPECT_LT(worst, 0.0072);
}

/// A sweep of half a turn ends elsewhere than it begins.
TEST(MovingDrawing, GoesToAndFroWhereItIsNotClosed) {
  Made made = slider_crank(1);
  made.request.sweep->to = made.mechanism.add_number("pi", "sweep.to");
  const Drawing drawing = moving_drawing_of(made.mechanism, made.request);
  const std::size_t count = drawing.motion.size();
  ASSERT_GT(count, 20U);
  for (std::size_t moment = 0; moment < count; ++moment) {
    EXPECT_EQ(drawing.motion[moment].points, drawing.motion[count - 1 - moment].points);
  }
}

/// A crank that holds dyads which are independent of one another: 2^dyads configurations.
Made star(int dyads) {
  Made made{Mechanism("a star"), {}};
  Mechanism& m = made.mechanism;
  m.add_parameter("phi", 1);
  m.add_link("ground");
  m.add_point("ground.A", 0, 0);
  m.add_link("crank");
  m.add_point("crank.A", 0, 0);
  m.add_point("crank.B", 1, 0);
  m.add_joint("A", JointType::revolute, {"ground.A", "crank.A"});
  m.add_driver("A", "phi");
  for (int dyad = 0; dyad < dyads; ++dyad) {
    const std::string name = std::to_string(dyad);
    const double angle = 0.3 + 2 * std::acos(-1) * dyad / dyads;
    m.add_point("ground.G" + name, 4 * std::cos(angle), 4 * std::sin(angle));
    m.add_point("crank.P" + name, 1 - 0.05 * dyad, 0);
    m.add_link("inner" + name);
    m.add_point("inner" + name + ".P", 0, 0);
    m.add_point("inner" + name + ".Q", 3, 0);
    m.add_link("outer" + name);
    m.add_point("outer" + name + ".Q", 3, 0);
    m.add_point("outer" + name + ".G", 0, 0);
    m.add_joint("P" + name, JointType::revolute, {"crank.P" + name, "inner" + name + ".P"});
    m.add_joint("Q" + name, JointType::revolute, {"inner" + name + ".Q", "outer" + name + ".Q"});
    m.add_joint("G" + name, JointType::revolute, {"outer" + name + ".G", "ground.G" + name});
  }
  m.add_output("B", "crank.B");
  made.request.sweep = mechanism::Sweep{m.parameter_named("phi"), m.add_number(1, "sweep.from"),
                                        m.add_number(1.1, "sweep.to"), 5};
  return made;
}

TEST(DrawingOfMany, HasTheOneThatIsAskedFor) {
  Made made = star(5);
  const Plan plan(made.mechanism, made.request);
  const mechanism::Configuration last = plan.solve(plan.values()).configurations.back();
  for (const mechanism::LinkIndex link : made.mechanism.links().keys()) {
    if (link != made.mechanism.ground()) {
      const auto& [c, s] = last.links[link].pose.direction;
      made.request.reference.push_back(
          {link, made.mechanism.add_number(std::atan2(s, c), "reference")});
    }
  }
  const Drawing drawing = drawing_of(made.mechanism, made.request);
  EXPECT_EQ(drawing.stances.size(), mechanism::most_drawn);
  EXPECT_EQ(drawing.left_out, 32 - mechanism::most_drawn);
  EXPECT_EQ(drawing.stances[drawing.emphasised].configuration, 32);
  EXPECT_NE(drawing_svg(drawing).find("and 8 more"), std::string::npos);
  EXPECT_EQ(moving_drawing_of(made.mechanism, made.request, 30).motion.front().configuration, 30);
  EXPECT_THROW((void)moving_drawing_of(made.mechanism, made.request, 33),
               mechanism::MechanismError);
  const std::string page = drawing_page(made.mechanism, made.request);
  EXPECT_NE(page.find(R"("chosen":32)"), std::string::npos);
  EXPECT_NE(page.find(R"("number":32)"), std::string::npos);
}

TEST(MovingDrawing, NeedsASweepAndItsBranch) {
  Made made = slider_crank(1);
  EXPECT_THROW((void)moving_drawing_of(made.mechanism, made.request, 3), mechanism::MechanismError);
  made.request.sweep.reset();
  EXPECT_THROW((void)moving_drawing_of(made.mechanism, made.request), mechanism::MechanismError);
}

}  // namespace
}  // namespace assur::test::moving_drawing_test
