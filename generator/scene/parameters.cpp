#include "scene/parameters.hpp"

#include <cmath>
#include <functional>

#include "error.hpp"
#include "scene/covariance.hpp"

namespace assur::generator {

ParameterValues::ParameterValues(const Scene& scene, std::optional<std::pair<int, double>> replaced)
    : scene_(&scene), second_order_(scene.covariance && scene.want.sensitivity) {
  const auto count = static_cast<Eigen::Index>(scene.parameters.size());
  values_.resize(scene.parameters.size());
  tolerances_ = Eigen::VectorXd::Zero(count);
  enum class Mark : unsigned char { untouched, open, known };
  std::vector<Mark> marks(scene.parameters.size(), Mark::untouched);
  std::vector<bool> known(scene.parameters.size(), false);

  const std::function<void(std::size_t)> settle = [&](std::size_t index) {
    const SceneParameter& parameter = scene.parameters[index];
    if (marks[index] == Mark::known) {
      return;
    }
    if (marks[index] == Mark::open) {
      throw InputError(scene.file + ": " + parameter.value.where +
                       ": the parameter depends on itself");
    }
    marks[index] = Mark::open;
    Dual value;
    if (replaced && replaced->first == static_cast<int>(index)) {
      value = constant(replaced->second);
    } else {
      const std::function<void(const Expression&)> settle_names = [&](const Expression& part) {
        if (part.kind == Expression::Kind::name) {
          for (std::size_t other = 0; other < scene.parameters.size(); ++other) {
            if (scene.parameters[other].name == part.name) {
              settle(other);
            }
          }
        }
        for (const Expression& argument : part.arguments) {
          settle_names(argument);
        }
      };
      settle_names(parameter.value.expression);
      value = evaluated(parameter.value, known);
    }
    values_[index] = value + deviation(index);
    known[index] = true;
    marks[index] = Mark::known;
  };
  for (std::size_t index = 0; index < scene.parameters.size(); ++index) {
    settle(index);
  }
  for (std::size_t index = 0; index < scene.parameters.size(); ++index) {
    const auto& tolerance = scene.parameters[index].tolerance;
    if (tolerance) {
      const double half_width = value(*tolerance).value();
      if (half_width < 0) {
        throw InputError(scene.file + ": " + tolerance->where +
                         ": a tolerance is a half-width and cannot be negative");
      }
      tolerances_(static_cast<Eigen::Index>(index)) = half_width;
    }
  }
  if (scene.covariance) {
    covariance_ = covariance_matrix(scene, *this);
  }
}

Dual ParameterValues::constant(double value) const {
  const auto count = static_cast<Eigen::Index>(values_.size());
  const Eigen::Index order = second_order_ ? count : 0;
  return {value, Eigen::VectorXd::Zero(count), Eigen::MatrixXd::Zero(order, order)};
}

Dual ParameterValues::deviation(std::size_t index) const {
  const Dual zero = constant(0.0);
  return {0.0, Eigen::VectorXd::Unit(zero.derivatives().size(), static_cast<Eigen::Index>(index)),
          zero.hessian()};
}

Dual ParameterValues::value(const SceneNumber& number) const {
  return evaluated(number, std::vector<bool>(values_.size(), true));
}

Dual ParameterValues::evaluated(const SceneNumber& number, const std::vector<bool>& known) const {
  const Dual raw = evaluate<Dual>(number.expression, [&](const std::string& name) -> Dual {
    for (std::size_t index = 0; index < values_.size(); ++index) {
      if (scene_->parameters[index].name == name && known[index]) {
        return values_[index];
      }
    }
    throw InputError(scene_->file + ": " + number.where + ": no value for '" + name + "'");
  });
  // A bare number has no gradient.
  Dual result = raw.derivatives().size() == 0 ? constant(raw.value()) : raw;
  if (!std::isfinite(result.value())) {
    throw InputError(scene_->file + ": " + number.where + ": the value is not a finite number");
  }
  if (!result.derivatives().allFinite()) {
    throw InputError(scene_->file + ": " + number.where +
                     ": the derivative with respect to the parameters is not finite here");
  }
  if (!result.hessian().allFinite()) {
    throw InputError(scene_->file + ": " + number.where +
                     ": the second derivative with respect to the parameters is not finite here, "
                     "and a covariance needs it");
  }
  return result;
}

}  // namespace assur::generator
