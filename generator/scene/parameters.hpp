// Turns a scene's parameters and expressions into values with derivatives to every parameter.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "scene/dual.hpp"
#include "scene/scene.hpp"

namespace assur::generator {

/// The values of a scene's parameters. A parameter may be an expression in others; its own
/// gradient entry is one, and what it depends on enters by the chain rule.
class ParameterValues {
 public:
  /// `replaced` puts a value in place of one parameter's expression, for sweeps. Throws InputError
  /// for a cycle, a value or a derivative that is not finite, a negative tolerance, or a covariance
  /// that is none.
  explicit ParameterValues(const Scene& scene,
                           std::optional<std::pair<int, double>> replaced = std::nullopt);

  [[nodiscard]] Dual value(const SceneNumber& number) const;
  [[nodiscard]] const std::vector<Dual>& parameters() const { return values_; }
  /// Half-widths; zero where a parameter has no tolerance.
  [[nodiscard]] const Eigen::VectorXd& tolerances() const { return tolerances_; }
  /// Covariance of the parameters, zero for those that the scene's `covariance` does not name;
  /// empty where the scene has none.
  [[nodiscard]] const Eigen::MatrixXd& covariance() const { return covariance_; }
  /// Whether values carry Hessians: the scene has a covariance and wants sensitivity.
  [[nodiscard]] bool second_order() const { return second_order_; }
  [[nodiscard]] int count() const { return static_cast<int>(values_.size()); }
  [[nodiscard]] Dual constant(double value) const;

 private:
  /// The deviation of one parameter: zero, with its own gradient entry one.
  [[nodiscard]] Dual deviation(std::size_t index) const;
  [[nodiscard]] Dual evaluated(const SceneNumber& number, const std::vector<bool>& known) const;

  const Scene* scene_;
  std::vector<Dual> values_;
  Eigen::VectorXd tolerances_;
  Eigen::MatrixXd covariance_;
  bool second_order_;
};

}  // namespace assur::generator
