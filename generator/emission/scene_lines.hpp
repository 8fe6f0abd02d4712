// Turns places on links, with their derivatives to the modelled parameters, into C++.
#pragma once

#include <Eigen/Core>
#include <assur/model.hpp>
#include <string>
#include <vector>

#include "scene/dual.hpp"

namespace assur::generator {

/// The parameters of a scene to which derivatives are modelled.
class ModelledParameters {
 public:
  ModelledParameters(std::vector<int> indices, std::vector<std::string> names)
      : indices_(std::move(indices)), names_(std::move(names)) {}

  [[nodiscard]] int count() const { return static_cast<int>(indices_.size()); }
  [[nodiscard]] const std::vector<int>& indices() const { return indices_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// The derivatives of a quantity to these parameters.
  [[nodiscard]] Eigen::VectorXd gradient(const Dual& quantity) const;

 private:
  std::vector<int> indices_;
  std::vector<std::string> names_;
};

/// The statements of one function, with constants declared as they are needed.
class SceneLines {
 public:
  explicit SceneLines(const ModelledParameters& parameters) : parameters_(parameters) {}

  void add(const std::string& line) { lines_.push_back(line); }
  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }

  /// A point of a link, as an expression; `name` is for the case that it needs a declaration.
  [[nodiscard]] std::string point(const std::string& name, const Dual& x, const Dual& y);
  /// A frame of a link, likewise; empty for the link's own.
  [[nodiscard]] std::string frame(const std::string& name, const Pose<Dual>& pose);
  /// The derivatives of a number, likewise.
  [[nodiscard]] std::string gradient(const std::string& name, const Dual& number);

 private:
  [[nodiscard]] std::string declared(const std::string& name);
  void add_gradients(const std::string& target, const std::vector<Dual>& rows);
  [[nodiscard]] bool varies(const std::vector<Dual>& quantities) const;

  const ModelledParameters& parameters_;
  std::vector<std::string> lines_;
  std::vector<std::string> taken_;
};

/// Frames one in the other, from the outermost; empty texts are skipped.
[[nodiscard]] std::string nested_frames(const std::vector<std::string>& frames);

}  // namespace assur::generator
