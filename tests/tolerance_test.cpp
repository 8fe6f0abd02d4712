// Law: the second derivatives of a scene are those of its whole solutions, and the covariance and
// mean shift of its points follow from them.
#include <gtest/gtest.h>

#include <algorithm>
#include <assur/tetrad/models.hpp>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "command.hpp"
#include "kind_scene.hpp"
#include "largest.hpp"
#include "richardson.hpp"
#include "scene/covariance.hpp"
#include "scene/report.hpp"

namespace assur::test {
namespace {

using generator::AssemblyConfiguration;
using generator::Dual;
using generator::ParameterValues;
using generator::Scene;
using generator::Solution;
using Json = nlohmann::ordered_json;

Json worked() { return Json::parse(read_file(ASSUR_EXAMPLES "/quintero_2011_rrp_rrr.json")); }

std::vector<std::string> parameter_names(const Json& scene) {
  std::vector<std::string> names;
  for (const auto& [name, value] : scene["parameters"].items()) {
    names.push_back(name);
  }
  return names;
}

/// A covariance of all parameters, which makes values carry second derivatives.
Json with_unit_covariance(Json scene) {
  const std::vector<std::string> names = parameter_names(scene);
  Json matrix = Json::array();
  for (std::size_t row = 0; row < names.size(); ++row) {
    matrix.push_back(std::vector<double>(names.size(), 0.0));
    matrix[row][row] = 1.0;
  }
  scene["covariance"] = {{"parameters", names}, {"matrix", matrix}};
  return scene;
}

/// `NAME=EXPR` that moves a parameter off its own law.
std::string setting(const Json& scene, const std::string& name, double offset) {
  const Json& entry = scene["parameters"][name];
  const Json& value = entry.is_object() ? entry["value"] : entry;
  std::array<char, 40> text{};
  (void)std::snprintf(text.data(), text.size(), ") + (%.17g)", offset);
  return name + "=(" + (value.is_string() ? value.get<std::string>() : value.dump()) + text.data();
}

Solution solution_of(const Json& json, const std::vector<std::string>& settings = {}) {
  const Scene scene = generator::parse_scene(json.dump(), "scene", settings);
  return generator::solve(scene, ParameterValues(scene));
}

/// The report of a scene as a program reads it.
Json report_of(const Json& json, const std::vector<std::string>& settings = {}) {
  const Scene scene = generator::parse_scene(json.dump(), "scene", settings);
  const ParameterValues values(scene);
  const Solution solution = generator::solve(scene, values);
  return Json::parse(generator::report_json({&scene, &values, &solution}));
}

/// All that a configuration says of positions.
std::vector<Dual> coordinates(const AssemblyConfiguration& configuration) {
  std::vector<Dual> result;
  for (const auto& link : configuration.links) {
    result.insert(result.end(), {link.x, link.y, angle_of(link.direction)});
  }
  for (const auto& joint : configuration.joints) {
    result.push_back(joint.displacement);
  }
  for (const auto& point : configuration.outputs) {
    result.insert(result.end(), {point.x, point.y});
  }
  return result;
}

double distance(const AssemblyConfiguration& one, const AssemblyConfiguration& other) {
  double sum = 0;
  for (std::size_t link = 0; link < one.links.size(); ++link) {
    const auto& a = one.links[link].direction;
    const auto& b = other.links[link].direction;
    sum += std::hypot(a.cos.value() - b.cos.value(), a.sin.value() - b.sin.value());
  }
  return sum;
}

/// The gradients of all coordinates in the configuration nearest to a given one, one row each.
Eigen::MatrixXd gradients_near(const AssemblyConfiguration& reference, const Solution& solution) {
  const auto nearest =
      std::min_element(solution.configurations.begin(), solution.configurations.end(),
                       [&](const auto& one, const auto& other) {
                         return distance(one, reference) < distance(other, reference);
                       });
  const std::vector<Dual> values = coordinates(
      nearest == solution.configurations.end() ? reference : *nearest);  // none: no agreement
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(values.size()), values[0].derivatives().size());
  for (std::size_t row = 0; row < values.size(); ++row) {
    rows.row(static_cast<Eigen::Index>(row)) = values[row].derivatives().transpose();
  }
  return rows;
}

struct Agreement {
  double worst = 0;  ///< largest relative difference
  int compared = 0;  ///< configurations
  int columns = 0;   ///< pairs of a configuration and a parameter
  int unsure = 0;    ///< columns where the differences do not settle
};

/// Every second derivative of every regular configuration against differences of the gradients of
/// whole solutions, relative to the largest second derivative to the same parameter.
void compare_second_derivatives(const Json& scene, Agreement& agreement) {
  const std::vector<std::string> names = parameter_names(scene);
  const Scene parsed = generator::parse_scene(scene.dump(), "scene", {});
  const ParameterValues values(parsed);
  Json plain = scene;
  plain.erase("covariance");  // the differences are of first derivatives alone
  for (const AssemblyConfiguration& configuration :
       generator::solve(parsed, values).configurations) {
    if (configuration.regularity != Status::ok) {
      continue;
    }
    ++agreement.compared;
    const std::vector<Dual> derived = coordinates(configuration);
    for (std::size_t parameter = 0; parameter < names.size(); ++parameter) {
      ++agreement.columns;
      const double value = values.parameters()[parameter].value();
      const auto at = [&](double offset) -> Eigen::MatrixXd {
        return gradients_near(configuration,
                              solution_of(plain, {setting(scene, names[parameter], offset)}));
      };
      const auto difference =
          best_richardson<Eigen::MatrixXd>(at, 1e-2 * (value == 0 ? 1 : std::abs(value)), 8);
      const double scale = difference.derivative.cwiseAbs().maxCoeff();
      if (!(difference.uncertainty <= 1e-8 * scale)) {
        ++agreement.unsure;
        continue;
      }
      for (std::size_t row = 0; row < derived.size(); ++row) {
        const auto column = static_cast<Eigen::Index>(parameter);
        const Eigen::RowVectorXd apart = derived[row].hessian().col(column).transpose() -
                                         difference.derivative.row(static_cast<Eigen::Index>(row));
        agreement.worst = largest(agreement.worst, apart.cwiseAbs().maxCoeff() / scale);
      }
    }
  }
}

/// The worked mechanism with its parameters tied by every function that an expression may call.
Json tied_parameters() {
  Json scene = worked();
  scene["parameters"] = {{"AG", 275},
                         {"k", 0.8},
                         {"AB", "100*sqrt(1.25*k)"},
                         {"BE", "500*sin(k) + 500*(1 - sin(0.8)) + 20*(tan(k) - tan(4/5))"},
                         {"EF", "300*exponent^(k - 0.8)*k^2/0.64"},
                         {"exponent", "cos(k)/cos(0.8) + 0.25"},
                         {"GD", "300 + 30*(asin(k) - asin(0.8)) + AB - 100"},
                         {"FG", "150 - 10*(acos(k) - acos(0.8))/k"},
                         {"FD", "180 + 40*atan(AG/275 - 1) + 30*atan2(k - 0.5, -AG)/AG"},
                         {"phi", "70*deg"}};
  return with_unit_covariance(scene);
}

/// The worked mechanism with its crank replaced by a driven slide at an angle, and its slider by a
/// pin in a slot that is askew.
Json slotted() {
  Json scene = worked();
  scene["parameters"].erase("AB");
  scene["parameters"]["phi"] = "70*deg";
  scene["parameters"]["stroke"] = 100;
  scene["parameters"]["askew"] = 0.05;
  scene["links"].erase("slider");
  scene["links"]["ground"]["A"] = {{"through", {0, 0}}, {"along", {"cos(phi)", "sin(phi)"}}};
  scene["links"]["crank"] = {{"A", {{"through", {0, 0}}, {"along", {0, 1}}}}, {"B", {"askew", 0}}};
  scene["links"]["rod"]["slide"] = {{"through", {1, "10*askew"}}, {"along", {3, "askew"}}};
  scene["joints"]["A"]["type"] = "prismatic";
  scene["joints"].erase("D");
  scene["joints"]["S"] = {{"type", "pin-in-slot"}, {"between", {"lever.D", "rod.slide"}}};
  scene["drivers"]["A"] = {{"position", "stroke"}, {"velocity", 1}};
  return with_unit_covariance(scene);
}

struct NamedScene {
  const char* name;
  Json scene;
};

class SecondDerivatives : public testing::TestWithParam<NamedScene> {};

TEST_P(SecondDerivatives, AreTheDifferencesOfGradientsOfWholeSolutions) {
  Agreement agreement;
  compare_second_derivatives(GetParam().scene, agreement);
  std::cout << agreement.compared << " configurations, largest relative difference "
            << agreement.worst << '\n';
  EXPECT_GE(agreement.compared, 2);
  EXPECT_EQ(agreement.unsure, 0);
  EXPECT_LT(agreement.worst, 1e-9);
}

/// The driver moves at constant unit speed, so that accelerations are second derivatives.
TEST_P(SecondDerivatives, ToTheDriverAreTheAccelerations) {
  const std::string driver = GetParam().scene["parameters"].contains("stroke") ? "stroke" : "phi";
  const std::vector<std::string> names = parameter_names(GetParam().scene);
  const auto index =
      static_cast<Eigen::Index>(std::find(names.begin(), names.end(), driver) - names.begin());
  double worst = 0;
  for (const AssemblyConfiguration& configuration : solution_of(GetParam().scene).configurations) {
    std::vector<double> accelerations;
    for (const auto& link : configuration.links) {
      accelerations.insert(accelerations.end(),
                           {link.acceleration(0), link.acceleration(1), link.acceleration(2)});
    }
    for (const auto& joint : configuration.joints) {
      accelerations.push_back(joint.acceleration);
    }
    for (const auto& point : configuration.outputs) {
      accelerations.insert(accelerations.end(), {point.acceleration(0), point.acceleration(1)});
    }
    const double scale = std::abs(*std::max_element(
        accelerations.begin(), accelerations.end(),
        [](double one, double other) { return std::abs(one) < std::abs(other); }));
    const std::vector<Dual> derived = coordinates(configuration);
    ASSERT_EQ(derived.size(), accelerations.size());
    for (std::size_t row = 0; row < derived.size(); ++row) {
      const double apart = derived[row].hessian()(index, index) - accelerations[row];
      // Angles and lengths differ in unit; rounding scales with the largest.
      worst = largest(worst, std::abs(apart) / (std::abs(accelerations[row]) + 1e-4 * scale));
    }
  }
  std::cout << "largest relative difference " << worst << '\n';
  EXPECT_LT(worst, 1e-11);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SecondDerivatives,
                         testing::Values(NamedScene{"Worked", with_unit_covariance(worked())},
                                         NamedScene{"TiedParameters", tied_parameters()},
                                         NamedScene{"Slotted", slotted()}),
                         [](const auto& scene) { return std::string(scene.param.name); });

/// The scene of a group, with four parameters in all coordinates of all features.
Json with_parameters(Json scene) {
  scene["parameters"] = {{"p0", 0}, {"p1", 0}, {"p2", 0}, {"p3", 0}};
  int place = 0;
  const auto tie = [&](Json& pair) {
    for (Json& number : pair) {
      number = number.dump() + " + p" + std::to_string(place % 4) + "*" +
               (place % 3 == 0 ? "(1 - p" + std::to_string((place + 1) % 4) + ")" : "0.5");
      ++place;
    }
  };
  for (auto& link : scene["links"]) {
    for (auto& feature : link) {
      if (feature.is_object()) {
        tie(feature["through"]);
        tie(feature["along"]);
      } else {
        tie(feature);
      }
    }
  }
  return with_unit_covariance(scene);
}

template <typename Model>
void compare_kinds(int& kinds, Agreement& agreement) {
  if constexpr (Model::rigid) {
    for (const auto& roles : Model::kinds) {
      const unsigned seed = 7100 + static_cast<unsigned>(Model::number);
      SCOPED_TRACE(std::string(roles.kind) + ", seed " + std::to_string(seed));
      const KindInSpace<Model> space(roles, seed);
      Agreement found;
      compare_second_derivatives(
          with_parameters(Json::parse(scene_text(space, {0, 1, 2, 3}, {0, 1, 2, 3, 4, 5}))), found);
      EXPECT_GT(found.compared, 0);
      EXPECT_LT(found.worst, 1e-7);
      agreement.worst = largest(agreement.worst, found.worst);
      agreement.compared += found.compared;
      agreement.columns += found.columns;
      agreement.unsure += found.unsure;
      ++kinds;
    }
  }
}

TEST(SecondDerivativesOfAllKinds, AreTheDifferencesOfGradientsOfWholeSolutions) {
  int kinds = 0;
  Agreement agreement;
  std::apply([&](auto... model) { (compare_kinds<decltype(model)>(kinds, agreement), ...); },
             tetrad::Models());
  std::cout << kinds << " kinds, " << agreement.compared << " configurations, " << agreement.unsure
            << " columns unsure, largest relative difference " << agreement.worst << '\n';
  EXPECT_GT(kinds, 40);
  EXPECT_EQ(agreement.unsure, 0);
}

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

/// What the mean over normal deviations adds to each point of the first configuration, by the
/// three-point rule in both parameters, less what the report says.
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
    const Scene scene = generator::parse_scene(json.dump(), "scene", {});
    const ParameterValues values(scene);
    const Solution solution = generator::solve(scene, values);
    for (const AssemblyConfiguration& configuration : solution.configurations) {
      for (const Dual& coordinate : coordinates(configuration)) {
        EXPECT_FALSE(coordinate.has_hessian());
      }
    }
    for (const std::string& text :
         {generator::report_json({&scene, &values, &solution}),
          generator::report_text({&scene, &values, &solution}), generator::csv_header(scene)}) {
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
  const Json json = correlated(1);
  const Scene scene = generator::parse_scene(json.dump(), "scene", {});
  const ParameterValues values(scene);
  const Solution solution = generator::solve(scene, values);
  const Json point = report_of(json)["configurations"][0]["outputs"]["F"];
  const std::vector<std::string> titles = cells(generator::csv_header(scene));
  const std::vector<std::string> row = cells(generator::csv_rows({&scene, &values, &solution}, 0));
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

  const std::string text = generator::report_text({&scene, &values, &solution});
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

/// Every function of expressions, alone: gradients and Hessians against differences.
TEST(DualNumbers, FollowTheChainRuleToSecondOrder) {
  constexpr std::array<const char*, 22> functions = {"x + y",       "x - y",
                                                     "-x",          "x*y",
                                                     "x/y",         "2/x",
                                                     "x/2",         "sqrt(x)",
                                                     "sin(x)",      "cos(x)",
                                                     "tan(x)",      "asin(x)",
                                                     "acos(x)",     "atan(x)",
                                                     "atan2(x, y)", "atan2(-x, -y)",
                                                     "atan2(y, 2)", "x^3",
                                                     "x^(-0.5)",    "x^y",
                                                     "(x*y)^(x/y)", "sin(x*y)/(2 + cos(x))"};
  const Eigen::Vector2d place(0.37, 0.83);
  for (const char* text : functions) {
    const generator::Expression expression = generator::parse_expression(text);
    const auto at = [&](const Eigen::Vector2d& point) {
      return generator::evaluate<Dual>(expression, [&](const std::string& name) {
        const Eigen::Index index = name == "x" ? 0 : 1;
        return Dual(point(index), Eigen::Vector2d::Unit(index), Eigen::Matrix2d::Zero());
      });
    };
    const Dual derived = at(place);
    for (Eigen::Index index = 0; index < 2; ++index) {
      const auto difference = richardson<Eigen::Vector3d>(
          [&](double offset) {
            const Dual moved = at(place + offset * Eigen::Vector2d::Unit(index));
            return Eigen::Vector3d(moved.value(), moved.derivatives()(0), moved.derivatives()(1));
          },
          1e-2);
      Eigen::Vector3d expected;
      expected << derived.derivatives()(index), derived.hessian().col(index);
      EXPECT_LT((difference.derivative - expected).norm(), 1e-9 * (1 + expected.norm())) << text;
    }
  }
}

TEST(DualNumbers, PowersOfZeroHaveTheDerivativesOfPolynomials) {
  const Dual zero(0.0, Eigen::VectorXd::Ones(1), Eigen::MatrixXd::Zero(1, 1));
  const std::array<double, 4> second = {0, 0, 2, 0};
  for (int exponent = 0; exponent < 4; ++exponent) {
    const Dual power = pow(zero, exponent);
    EXPECT_EQ(power.derivatives()(0), exponent == 1 ? 1 : 0) << exponent;
    EXPECT_EQ(power.hessian()(0, 0), second[static_cast<std::size_t>(exponent)]) << exponent;
  }
}

}  // namespace
}  // namespace assur::test
