// Law: the covariance of a scene's points follows from their sensitivities and the mean shift from
// means over whole solutions, and every report has the same numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

#include "largest.hpp"
#include "mechanism/scene_solutions.hpp"

namespace assur::test::tolerance_test {
namespace {

/// The worked mechanism with two parameters that vary together, their deviations scaled.
Json correlated(double scale) {
  Json scene = worked();
  const double length = 2 * scale;
  const double angle = 0.02 * scale;
  const double both = 0.6 * length * angle;
  scene["covariance"] = {{"parameters", {"phi", "AG"}},
                         {"matrix", {{angle * angle, both}, {both, length * length}}}};
  return scene;
}

TEST(Covariance, OfAPointIsTheSensitivityTwiceAppliedToThatOfTheParameters) {
  const Json scene = correlated(1);
  const Json& matrix = scene["covariance"]["matrix"];
  const std::vector<std::string> varying = {"phi", "AG"};
  double worst = 0;
  const Json report = report_of(scene);
  ASSERT_EQ(report["configurations"].size(), 2U);
  for (const Json& configuration : report["configurations"]) {
    for (const Json& point : configuration["outputs"]) {
      for (std::size_t one = 0; one < 2; ++one) {
        for (std::size_t other = 0; other < 2; ++other) {
          double sum = 0;
          for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) {
              sum += point["sensitivity"][varying[i]][one].get<double>() *
                     matrix[i][j].get<double>() *
                     point["sensitivity"][varying[j]][other].get<double>();
            }
          }
          const double reported = point["covariance"][one][other].get<double>();
          worst = largest(worst, std::abs(reported - sum) / (1e-9 + std::abs(sum)));
        }
      }
    }
  }
  std::cout << "largest relative difference " << worst << '\n';
  EXPECT_LT(worst, 1e-12);
}

TEST(Covariance, OfIndependentParametersIsTheSquareOfTheRootSumSquare) {
  Json scene = with_unit_covariance(worked());
  std::size_t row = 0;
  for (const auto& [name, value] : scene["parameters"].items()) {
    const double tolerance = value.is_object() ? value["tolerance"].get<double>() : 0;
    scene["covariance"]["matrix"][row][row] = tolerance * tolerance;
    ++row;
  }
  const Json report = report_of(scene);
  ASSERT_EQ(report["configurations"].size(), 2U);
  for (const Json& configuration : report["configurations"]) {
    for (const Json& point : configuration["outputs"]) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double rss = point["rss"][axis].get<double>();
        EXPECT_NEAR(point["covariance"][axis][axis].get<double>(), rss * rss, 1e-14 * rss * rss);
      }
    }
  }
}

/// What normal deviations add to the mean position of each point of the first configuration, by the
/// three-point rule in both parameters, less the mean shift that the report gives.
Eigen::VectorXd unexplained_shift(double scale) {
  const Json scene = correlated(scale);
  const Json& matrix = scene["covariance"]["matrix"];
  Json plain = worked();
  plain["want"] = {"position"};
  const auto points = [](const Json& root, const char* key) {
    std::vector<double> values;
    for (const Json& point : root["configurations"][0]["outputs"]) {
      values.insert(values.end(), {point[key][0].get<double>(), point[key][1].get<double>()});
    }
    return Eigen::VectorXd(
        Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
  };
  // The matrix is L L^T: deviations are L z with independent z.
  const double l11 = std::sqrt(matrix[0][0].get<double>());
  const double l21 = matrix[1][0].get<double>() / l11;
  const double l22 = std::sqrt(matrix[1][1].get<double>() - l21 * l21);
  Eigen::VectorXd mean = -points(report_of(plain), "position");
  for (const int one : {-1, 0, 1}) {
    for (const int other : {-1, 0, 1}) {
      const double weight = (one == 0 ? 4.0 : 1.0) * (other == 0 ? 4.0 : 1.0) / 36;
      const double z1 = one * std::sqrt(3.0);
      const double z2 = other * std::sqrt(3.0);
      mean += weight * points(report_of(plain, {setting(scene, "phi", l11 * z1),
                                                setting(scene, "AG", l21 * z1 + l22 * z2)}),
                              "position");
    }
  }
  return mean - points(report_of(scene), "mean_shift");
}

TEST(MeanShift, IsTheMeanOverNormalDeviationsToFourthOrder) {
  const Eigen::VectorXd wide = unexplained_shift(1);
  const Eigen::VectorXd narrow = unexplained_shift(0.5);
  const Json outputs = report_of(correlated(1))["configurations"][0]["outputs"];
  Eigen::Index row = 0;
  for (const Json& point : outputs) {
    for (std::size_t axis = 0; axis < 2; ++axis, ++row) {
      const double shift = point["mean_shift"][axis].get<double>();
      std::cout << "shift " << shift << ", unexplained " << wide(row) << ", at half the deviations "
                << narrow(row) << '\n';
      EXPECT_LT(std::abs(wide(row)), 0.05 * std::abs(shift));
      EXPECT_NEAR(wide(row) / narrow(row), 16, 1);
    }
  }
}

TEST(Covariance, IsLeftOutWhereTheSceneDoesNotAskForIt) {
  Json unwanted = correlated(1);
  unwanted["want"] = {"position"};
  for (const Json& json : {worked(), unwanted}) {
    const Solved made = solved(json);
    for (const Configuration& configuration : made.configurations()) {
      for (const Coordinate& number : coordinates(configuration)) {
        EXPECT_FALSE(number.has_hessian());
      }
    }
    for (const std::string& text :
         {mechanism::report_json(made.report()), mechanism::report_text(made.report()),
          mechanism::csv_header(made.plan)}) {
      EXPECT_EQ(text.find("covariance"), std::string::npos);
      EXPECT_EQ(text.find("mean"), std::string::npos);
    }
  }
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream stream(line.substr(0, line.find('\n')));
  for (std::string cell; std::getline(stream, cell, ',');) {
    result.push_back(cell);
  }
  return result;
}

TEST(Covariance, StandsInTheTableAndInTheTextAsInTheJson) {
  Json json = correlated(1);
  json.erase("sweep");  // the table of a sweep has other columns
  const Solved made = solved(json);
  const Json point = report_of(json)["configurations"][0]["outputs"]["F"];
  const std::vector<std::string> titles = cells(mechanism::csv_header(made.plan));
  const std::vector<std::string> row = cells(mechanism::csv_rows(made.report()));
  ASSERT_EQ(titles.size(), row.size());
  const auto cell = [&](const std::string& title) {
    const auto found = std::find(titles.begin(), titles.end(), title);
    return found == titles.end() ? std::nan("")
                                 : std::stod(row[static_cast<std::size_t>(found - titles.begin())]);
  };
  EXPECT_EQ(cell("F.variance_x"), point["covariance"][0][0].get<double>());
  EXPECT_EQ(cell("F.variance_y"), point["covariance"][1][1].get<double>());
  EXPECT_EQ(cell("F.covariance_xy"), point["covariance"][0][1].get<double>());
  EXPECT_EQ(point["covariance"][1][0], point["covariance"][0][1]);
  EXPECT_EQ(cell("F.mean_shift_x"), point["mean_shift"][0].get<double>());
  EXPECT_EQ(cell("F.mean_shift_y"), point["mean_shift"][1].get<double>());

  const std::string text = mechanism::report_text(made.report());
  const std::string part = text.substr(text.find("point F"));
  const auto row_of = [&](const std::string& title) {
    std::istringstream stream(part.substr(part.find(title) + title.size()));
    std::array<double, 2> numbers{};
    stream >> numbers[0] >> numbers[1];
    return numbers;
  };
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto near = [](double printed, const Json& number) {
      EXPECT_NEAR(printed, number.get<double>(), 1e-9 * std::abs(number.get<double>()));
    };
    near(row_of("covariance x")[axis], point["covariance"][0][axis]);
    near(row_of("covariance y")[axis], point["covariance"][1][axis]);
    near(row_of("mean shift")[axis], point["mean_shift"][axis]);
  }
}

/// Three parameters that vary as one: a matrix of rank one is on the border of what is allowed.
TEST(Covariance, MayBeOfRankOneWithTheRoundingsOfExpressions) {
  Json scene = worked();
  const std::vector<std::string> deviations = {"0.1", "(BE/1700)", "sqrt(0.03)"};
  Json matrix = Json::array();
  for (const std::string& one : deviations) {
    matrix.push_back(Json::array());
    for (const std::string& other : deviations) {
      matrix.back().push_back(one + "*" + other);
    }
  }
  scene["covariance"] = {{"parameters", {"AB", "GD", "FG"}}, {"matrix", matrix}};
  EXPECT_EQ(report_of(scene)["status"], "ok");
}

}  // namespace
}  // namespace assur::test::tolerance_test
