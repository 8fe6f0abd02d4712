// Turns places on links, with their derivatives to the modelled parameters, into C++.
#pragma once

#include <Eigen/Core>
#include <assur/mechanism/dual.hpp>
#include <assur/model.hpp>
#include <iterator>
#include <string>
#include <vector>

#include "emission/scene/scene_numbers.hpp"

namespace assur::generator::emission::scene {

/// The parameters of a scene to which derivatives are modelled.
class ModelledParameters {
 public:
  /// The parameters are given by their columns among the derivatives of the scene's values.
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
  /// `order`: the highest order of the time derivatives that are wanted.
  SceneLines(const ModelledParameters& parameters, const SceneNumbers& numbers, int order)
      : parameters_(parameters), numbers_(numbers), order_(order) {}

  void add(const std::string& line) { lines_.push_back(line); }
  /// Whether a statement begins like this.
  [[nodiscard]] bool declares(const std::string& beginning) const;
  /// All lines, after declarations of what they read: the variable parameters as `p`, and the
  /// drivers, unless the function has these already.
  [[nodiscard]] std::vector<std::string> lines(bool has_drivers = false) const;

  /// A number, or its formula in variable parameters.
  [[nodiscard]] std::string number(const SceneNumber& number);
  /// `{cos, sin}`.
  [[nodiscard]] std::string direction(const Direction<SceneNumber>& direction);

  /// An expression for the point at (x, y) of a frame, or of the ground's if `frame` is empty;
  /// `name` is for a declaration, if it needs one.
  [[nodiscard]] std::string point(const std::string& name, const std::string& frame,
                                  const SceneNumber& x, const SceneNumber& y);
  /// An expression for a frame on a link, in the same way; empty for the link's own frame.
  [[nodiscard]] std::string frame(const std::string& name, const Pose<SceneNumber>& pose);
  /// The derivatives of a number or of a direction's angle, as a declared row; empty if all are 0.
  template <typename Quantity>
  [[nodiscard]] std::string gradient(const std::string& name, const Quantity& quantity) {
    return declared_gradient(name, gradient_of(quantity));
  }
  /// The rates of a number or of a direction's angle that moves with drivers, as a row; empty where
  /// it does not, or none are wanted.
  template <typename Quantity>
  [[nodiscard]] std::string rates(const Quantity& quantity) const {
    return moves(quantity) && order_ > 0 ? row_of(numbers_.rates(quantity, order_)) : "";
  }
  /// A name like `name` that no other declaration of the function has.
  [[nodiscard]] std::string declared(const std::string& name);

 private:
  /// A text for each modelled parameter; empty where the derivative is zero.
  using Gradient = std::vector<std::string>;
  [[nodiscard]] Gradient gradient_of(const SceneNumber& number);
  [[nodiscard]] Gradient gradient_of(const Direction<SceneNumber>& direction);
  [[nodiscard]] Gradient constant_gradient(const mechanism::Dual& number) const;
  [[nodiscard]] static bool is_zero(const Gradient& gradient);
  [[nodiscard]] std::string declared_gradient(const std::string& name, const Gradient& gradient);
  /// Assigns the derivatives that are not zero to an entry each; `target` is `row(` of `row(0)`.
  void add_gradient(const std::string& target, const Gradient& gradient);
  void add_gradients(const std::string& target, const std::vector<Gradient>& rows);

  [[nodiscard]] bool moves(const SceneNumber& number) const { return numbers_.moves(number); }
  [[nodiscard]] bool moves(const Direction<SceneNumber>& direction) const {
    return numbers_.moves(direction.cos) || numbers_.moves(direction.sin);
  }
  [[nodiscard]] static std::string row_of(const std::vector<std::string>& rates);
  /// Assigns the rates of a coordinate that moves to a row of `target`.
  template <typename Quantity>
  void add_rates(const std::string& target, int row, const Quantity& quantity) {
    if (const std::string text = rates(quantity); !text.empty()) {
      add(target + ".rates.row(" + std::to_string(row) + ") = " + text + ";");
    }
  }

  const ModelledParameters& parameters_;
  const SceneNumbers& numbers_;
  int order_;
  std::vector<std::string> lines_;
  std::vector<std::string> taken_;
};

/// Frames, each in the one before it, from the outermost; empty texts are skipped.
[[nodiscard]] std::string nested_frames(const std::vector<std::string>& frames);

}  // namespace assur::generator::emission::scene
