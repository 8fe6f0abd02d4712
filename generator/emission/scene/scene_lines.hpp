// Turns places on links, with their derivatives to the modelled parameters, into C++.
#pragma once

#include <Eigen/Core>
#include <assur/mechanism/dual.hpp>
#include <assur/model.hpp>
#include <iterator>
#include <string>
#include <vector>

namespace assur::generator::emission::scene {

/// The parameters of a scene to which derivatives are modelled.
class ModelledParameters {
 public:
  /// By their columns among the derivatives of the scene's values.
  ModelledParameters(std::vector<Eigen::Index> columns, std::vector<std::string> names)
      : columns_(std::move(columns)), names_(std::move(names)) {}

  [[nodiscard]] Eigen::Index count() const { return std::ssize(columns_); }
  [[nodiscard]] const std::vector<Eigen::Index>& columns() const { return columns_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// The derivatives of a quantity to these parameters.
  [[nodiscard]] Eigen::VectorXd gradient(const mechanism::Dual& quantity) const;

 private:
  std::vector<Eigen::Index> columns_;
  std::vector<std::string> names_;
};

/// The statements of one function, with constants declared as they are needed.
class SceneLines {
 public:
  explicit SceneLines(const ModelledParameters& parameters) : parameters_(parameters) {}

  void add(const std::string& line) { lines_.push_back(line); }
  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }

  /// A point of a link, as an expression; `name` is for the case that it needs a declaration.
  [[nodiscard]] std::string point(const std::string& name, const mechanism::Dual& x,
                                  const mechanism::Dual& y);
  /// A frame of a link, likewise; empty for the link's own.
  [[nodiscard]] std::string frame(const std::string& name, const Pose<mechanism::Dual>& pose);
  /// The derivatives of a number, likewise; empty where there are none.
  [[nodiscard]] std::string gradient(const std::string& name, const mechanism::Dual& number);
  /// A name of the function's own, like `name`.
  [[nodiscard]] std::string declared(const std::string& name);

 private:
  /// Assigns the derivatives that are not zero to an entry each; `target` is `row(` of `row(0)`.
  void add_gradient(const std::string& target, const mechanism::Dual& quantity);
  void add_gradients(const std::string& target, const std::vector<mechanism::Dual>& rows);
  [[nodiscard]] bool varies(const std::vector<mechanism::Dual>& quantities) const;

  const ModelledParameters& parameters_;
  std::vector<std::string> lines_;
  std::vector<std::string> taken_;
};

/// Frames one in the other, from the outermost; empty texts are skipped.
[[nodiscard]] std::string nested_frames(const std::vector<std::string>& frames);

}  // namespace assur::generator::emission::scene
