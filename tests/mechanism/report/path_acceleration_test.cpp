// Law: in every report, the tangential part of a point's acceleration is the rate of its speed, and
// the normal part is its speed times the rate of its heading.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <sstream>

#include "largest.hpp"
#include "mechanism/scene_solutions.hpp"

namespace assur::test::path_acceleration_test {
namespace {

/// A point on a circle of radius 2; the crank has the angular acceleration 5.
Json circling(double omega) {
  Json scene;
  scene["parameters"] = {{"phi", 0.7}};
  scene["links"] = {{"ground", {{"A", {1, 0}}}}, {"crank", {{"A", {0, 0}}, {"P", {2, 0}}}}};
  scene["joints"]["A"] = {{"type", "revolute"}, {"between", {"ground.A", "crank.A"}}};
  scene["drivers"]["A"] = {{"position", "phi"}, {"velocity", omega}, {"acceleration", 5}};
  scene["outputs"]["P"] = "crank.P";
  return scene;
}

/// The rest of that line of a table in `text` that begins with a title.
std::string line_of(const std::string& text, const std::string& title) {
  const std::size_t at = text.find(title);
  return at == std::string::npos ? "" : text.substr(at + title.size(), text.find('\n', at) - at);
}

/// Both parts as they stand in the CSV table.
std::vector<std::string> csv_parts(const Solved& solved) {
  const auto cells = [](const std::string& line) {
    std::vector<std::string> list;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) {
      list.push_back(cell);
    }
    return list;
  };
  const std::vector<std::string> titles = cells(mechanism::csv_header(solved.plan));
  const std::vector<std::string> row = cells(mechanism::csv_rows(solved.report()));
  std::vector<std::string> parts;
  for (std::size_t index = 0; index < titles.size(); ++index) {
    if (titles[index] == "P.a_tangential" || titles[index] == "P.a_normal") {
      parts.push_back(row.at(index));
    }
  }
  return parts;
}

/// In either sense of rotation a_n is omega^2 r, positive to the left of the motion, and a_t is
/// alpha r, positive if the point speeds up.
TEST(PathAcceleration, OnACircleIsKnownInEveryReport) {
  for (const double omega : {3.0, -3.0}) {
    const Json json = circling(omega);
    const double sense = omega > 0 ? 1 : -1;
    const double tangential = sense * 10;
    const double normal = sense * 18;
    const Json point = report_of(json)["configurations"][0]["outputs"]["P"];
    EXPECT_NEAR(point["tangential"].get<double>(), tangential, 1e-14);
    EXPECT_NEAR(point["normal"].get<double>(), normal, 1e-14);

    const Solved circle = solved(json);
    const std::vector<std::string> parts = csv_parts(circle);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_NEAR(std::stod(parts[0]), tangential, 1e-14);
    EXPECT_NEAR(std::stod(parts[1]), normal, 1e-14);
    std::istringstream text(line_of(mechanism::report_text(circle.report()), "a_t, a_n"));
    double first = 0;
    double second = 0;
    text >> first >> second;
    EXPECT_NEAR(first, tangential, 1e-8);
    EXPECT_NEAR(second, normal, 1e-8);
  }
}

TEST(PathAcceleration, HasNoPartsAtRest) {
  const Json json = circling(0);
  const Json point = report_of(json)["configurations"][0]["outputs"]["P"];
  EXPECT_TRUE(point["tangential"].is_null());
  EXPECT_TRUE(point["normal"].is_null());
  EXPECT_EQ(csv_parts(solved(json)), (std::vector<std::string>{"", ""}));
}

TEST(PathAcceleration, NeedsVelocityAndAccelerationWanted) {
  for (const char* wanted : {"velocity", "acceleration"}) {
    Json json = circling(3);
    json["want"] = {wanted};
    const Json point = report_of(json)["configurations"][0]["outputs"]["P"];
    EXPECT_TRUE(point.contains(wanted));
    EXPECT_FALSE(point.contains("tangential"));
    EXPECT_FALSE(point.contains("normal"));
    const std::string header = mechanism::csv_header(solved(json).plan);
    EXPECT_EQ(header.find("a_tangential"), std::string::npos);
    EXPECT_EQ(header.find("a_normal"), std::string::npos);
  }
}

/// The six-bar's crank turns at 1, so that its angle is the time.
TEST(PathAcceleration, AlongACouplerCurveIsSpeedingUpAndTurning) {
  Json json = example("zhauyt_2017_six_bar.json");
  constexpr double step = 1e-4;
  const auto points = [&](double phi) {
    json["parameters"]["phi"] = phi;
    const Json root = report_of(json);
    std::vector<Json> found;
    for (const Json& configuration : root["configurations"]) {
      found.push_back(configuration["outputs"]["M"]);
    }
    return found;
  };
  const auto speed = [](const Json& point) {
    return std::hypot(point["velocity"][0].get<double>(), point["velocity"][1].get<double>());
  };
  const auto heading = [](const Json& point) {
    return std::atan2(point["velocity"][1].get<double>(), point["velocity"][0].get<double>());
  };
  double sum = 0;
  double tangential = 0;
  double normal = 0;
  for (int degree = 0; degree < 360; degree += 7) {
    const double phi = degree * 3.14159265358979323846 / 180;
    const std::vector<Json> at = points(phi);
    const std::vector<Json> above = points(phi + step);
    const std::vector<Json> below = points(phi - step);
    ASSERT_EQ(at.size(), 2U);
    ASSERT_EQ(above.size(), 2U);
    ASSERT_EQ(below.size(), 2U);
    for (std::size_t index = 0; index < at.size(); ++index) {
      const double a_t = at[index]["tangential"].get<double>();
      const double a_n = at[index]["normal"].get<double>();
      const double a = std::hypot(at[index]["acceleration"][0].get<double>(),
                                  at[index]["acceleration"][1].get<double>());
      sum = largest(sum, std::abs(std::hypot(a_t, a_n) - a) / a);
      const double growth = (speed(above[index]) - speed(below[index])) / (2 * step);
      const double turned = std::remainder(heading(above[index]) - heading(below[index]),
                                           2 * 3.14159265358979323846) /
                            (2 * step);
      tangential = largest(tangential, std::abs(a_t - growth) / a);
      normal = largest(normal, std::abs(a_n - speed(at[index]) * turned) / a);
    }
  }
  std::cout << "largest relative difference: of |a| " << sum << ", of the tangential part "
            << tangential << ", of the normal part " << normal << '\n';
  EXPECT_LT(sum, 1e-14);
  EXPECT_LT(tangential, 1e-6);
  EXPECT_LT(normal, 1e-6);
}

}  // namespace
}  // namespace assur::test::path_acceleration_test
