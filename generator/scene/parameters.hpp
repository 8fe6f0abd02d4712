// Turns a scene's parameters and expressions into values with gradients to every parameter.
#pragma once

#include <Eigen/Core>
#include <assur/variables.hpp>
#include <optional>
#include <unsupported/Eigen/AutoDiff>
#include <vector>

#include "scene/scene.hpp"

namespace assur::generator {

/// A value and its gradient with respect to the scene's parameters.
using Dual = Eigen::AutoDiffScalar<Eigen::VectorXd>;

/// d(angle)/d(parameters) of a direction.
[[nodiscard]] Eigen::VectorXd angle_gradient(const Direction<Dual>& direction);

/// The values of a scene's parameters. A parameter may be an expression in others; its own
/// gradient entry is one, and what it depends on enters by the chain rule.
class ParameterValues {
 public:
  /// `replaced` puts a value in place of one parameter's expression, for sweeps. Throws InputError
  /// for a cycle, a value or a derivative that is not finite, or a negative tolerance.
  explicit ParameterValues(const Scene& scene,
                           std::optional<std::pair<int, double>> replaced = std::nullopt);

  [[nodiscard]] Dual value(const SceneNumber& number) const;
  [[nodiscard]] const std::vector<Dual>& parameters() const { return values_; }
  /// Half-widths; zero where a parameter has no tolerance.
  [[nodiscard]] const Eigen::VectorXd& tolerances() const { return tolerances_; }
  [[nodiscard]] int count() const { return static_cast<int>(values_.size()); }
  [[nodiscard]] Dual constant(double value) const;

 private:
  [[nodiscard]] Dual evaluated(const SceneNumber& number, const std::vector<bool>& known) const;

  const Scene* scene_;
  std::vector<Dual> values_;
  Eigen::VectorXd tolerances_;
};

}  // namespace assur::generator
