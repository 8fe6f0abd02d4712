// Law: over all rigid kinds of the tetrad and all functions of expressions, the second derivatives
// of a scene are the differences of the gradients of its whole solutions.
#include <gtest/gtest.h>

#include <algorithm>
#include <assur/tetrad/models.hpp>
#include <cmath>
#include <iostream>

#include "largest.hpp"
#include "mechanism/kind_scene.hpp"
#include "mechanism/scene_solutions.hpp"
#include "richardson.hpp"

namespace assur::test::second_derivatives_test {
namespace {

double distance(const Configuration& one, const Configuration& other) {
  double sum = 0;
  for (const mechanism::LinkIndex link : one.links.keys()) {
    const Direction<double>& a = one.links[link].pose.direction;
    const Direction<double>& b = other.links[link].pose.direction;
    sum += std::hypot(a.cos - b.cos, a.sin - b.sin);
  }
  return sum;
}

/// The gradients of all coordinates in the configuration nearest to a given one, one row each.
Eigen::MatrixXd gradients_near(const Configuration& reference, const Solution& solution) {
  const auto nearest =
      std::min_element(solution.configurations.begin(), solution.configurations.end(),
                       [&](const auto& one, const auto& other) {
                         return distance(one, reference) < distance(other, reference);
                       });
  const std::vector<Coordinate> values = coordinates(
      nearest == solution.configurations.end() ? reference : *nearest);  // none: no agreement
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(values.size()), values[0].gradient.size());
  for (std::size_t row = 0; row < values.size(); ++row) {
    rows.row(static_cast<Eigen::Index>(row)) = values[row].gradient.transpose();
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
  const Solved made = solved(scene);
  Json plain = scene;
  plain.erase("covariance");  // the differences are of first derivatives alone
  for (const Configuration& configuration : made.configurations()) {
    if (configuration.regularity != Status::ok) {
      continue;
    }
    ++agreement.compared;
    const std::vector<Coordinate> derived = coordinates(configuration);
    for (std::size_t parameter = 0; parameter < names.size(); ++parameter) {
      ++agreement.columns;
      const double value = made.values.parameter(mechanism::ParameterIndex(parameter));
      const auto at = [&](double offset) -> Eigen::MatrixXd {
        return gradients_near(configuration,
                              solved(plain, {setting(scene, names[parameter], offset)}).solution);
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
        const Eigen::RowVectorXd apart = derived[row].hessian.col(column).transpose() -
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
  const Solved made = solved(GetParam().scene);
  for (const Configuration& configuration : made.configurations()) {
    std::vector<double> accelerations;
    for (const auto& link : configuration.links) {
      accelerations.insert(accelerations.end(),
                           {link.acceleration(0), link.acceleration(1), link.acceleration(2)});
    }
    for (const auto& slide : configuration.slides) {
      accelerations.push_back(slide.acceleration);
    }
    for (const auto& point : configuration.outputs) {
      accelerations.insert(accelerations.end(), {point.acceleration(0), point.acceleration(1)});
    }
    const double scale = std::abs(*std::max_element(
        accelerations.begin(), accelerations.end(),
        [](double one, double other) { return std::abs(one) < std::abs(other); }));
    const std::vector<Coordinate> derived = coordinates(configuration);
    ASSERT_EQ(derived.size(), accelerations.size());
    for (std::size_t row = 0; row < derived.size(); ++row) {
      const double apart = derived[row].hessian(index, index) - accelerations[row];
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
  std::cout << kinds << " kinds, seeds 7100 + model, " << agreement.compared << " configurations, "
            << agreement.unsure << " columns unsure, largest relative difference "
            << agreement.worst << '\n';
  EXPECT_GT(kinds, 40);
  EXPECT_EQ(agreement.unsure, 0);
}

}  // namespace
}  // namespace assur::test::second_derivatives_test
