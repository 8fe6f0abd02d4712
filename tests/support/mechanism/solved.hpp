// Plan, values and solution of a scene, and coordinates of states.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/report.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <string>
#include <utility>
#include <vector>

namespace assur::test {

using mechanism::Configuration;
using mechanism::Plan;
using mechanism::Scene;
using mechanism::Solution;
using mechanism::SolutionStatus;
using mechanism::Values;

/// A scene at the values of its file, solved.
struct Solved {
  Scene scene;
  Plan plan;
  Values values;
  Solution solution;

  explicit Solved(Scene given)
      : scene(std::move(given)), plan(scene), values(plan.values()), solution(plan.solve(values)) {}

  [[nodiscard]] const std::vector<Configuration>& configurations() const {
    return solution.configurations;
  }
  [[nodiscard]] mechanism::Report report() const { return {plan, values, solution, "", 0}; }
};

/// A number of a configuration and its derivatives with respect to the parameters, in the order of
/// the columns.
struct Coordinate {
  double value;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;  ///< empty if not computed

  [[nodiscard]] bool has_hessian() const { return hessian.size() != 0; }
};

template <int Coordinates>
Coordinate coordinate(double value, const mechanism::Derivatives<Coordinates>& follows, int row) {
  return {value, follows.first.row(row).transpose(),
          follows.has_second() ? follows.second[static_cast<std::size_t>(row)] : Eigen::MatrixXd()};
}

/// All position coordinates of a configuration: x, y, theta of links, slides, x, y of outputs.
inline std::vector<Coordinate> coordinates(const Configuration& configuration) {
  std::vector<Coordinate> result;
  for (const mechanism::Frame& link : configuration.links) {
    result.push_back(coordinate(link.pose.x, link.follows, 0));
    result.push_back(coordinate(link.pose.y, link.follows, 1));
    result.push_back(coordinate(angle_of(link.pose.direction), link.follows, 2));
  }
  for (const mechanism::SlideState& slide : configuration.slides) {
    result.push_back(coordinate(slide.displacement, slide.follows, 0));
  }
  for (const mechanism::Point& point : configuration.outputs) {
    result.push_back(coordinate(point.position.x(), point.follows, 0));
    result.push_back(coordinate(point.position.y(), point.follows, 1));
  }
  return result;
}

}  // namespace assur::test
