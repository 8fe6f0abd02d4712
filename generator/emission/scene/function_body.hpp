// Builds the statements of a solver's function: points and frames with derivatives and rates.
#pragma once

#include <Eigen/Core>
#include <assur/mechanism/dual.hpp>
#include <assur/model.hpp>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "emission/scene/scene_numbers.hpp"

namespace assur::generator::emission::scene {

/// The modelled parameters of a scene, by which derivatives are emitted.
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

/// An expression; empty for a frame that is that of its parent, or a zero row.
using OptionalExpression = std::optional<cpp::Expression>;

/// The statements of one function, with constants declared as they are needed.
class FunctionBody {
 public:
  /// `order`: the highest order of the time derivatives that are wanted.
  FunctionBody(const ModelledParameters& parameters, const SceneNumbers& numbers, int order)
      : parameters_(parameters), numbers_(numbers), order_(order) {}

  void add(cpp::Statement statement) { statements_.push_back(std::move(statement)); }
  void add(const cpp::Block& block) {
    statements_.insert(statements_.end(), block.begin(), block.end());
  }
  [[nodiscard]] bool declares(const std::string& variable) const {
    return cpp::declares(statements_, variable);
  }
  [[nodiscard]] std::size_t size() const { return statements_.size(); }
  /// Removes and returns the statements from the given index on.
  [[nodiscard]] cpp::Block take_from(std::size_t first);
  /// The variables that statements read, and those that the roots in them read.
  [[nodiscard]] std::set<std::string> variables_read(const cpp::Block& statements) const;
  /// All statements, after declarations of what they read: the variable parameters as `p`, and the
  /// drivers, unless the function has these already.
  [[nodiscard]] cpp::Block block(bool has_drivers = false) const;

  /// A number, or its formula in variable parameters.
  [[nodiscard]] cpp::Expression number(const SceneNumber& number) const;
  /// `{cos, sin}`.
  [[nodiscard]] cpp::Expression direction(const Direction<SceneNumber>& direction) const;

  /// An expression for the point at (x, y) of a frame, or of the ground if there is none; `name` is
  /// used if it needs a declaration.
  [[nodiscard]] cpp::Expression point(const std::string& name, const OptionalExpression& frame,
                                      const SceneNumber& x, const SceneNumber& y);
  /// An expression for a frame on a link, likewise; empty for the link's own frame.
  [[nodiscard]] OptionalExpression frame(const std::string& name, const Pose<SceneNumber>& pose);
  /// The derivatives of a number or of a direction's angle, as a declared row; empty if all are 0.
  template <typename Quantity>
  [[nodiscard]] OptionalExpression gradient(const std::string& name, const Quantity& quantity) {
    return declared_gradient(name, gradient_of(quantity));
  }
  /// The rates of a number or of a direction's angle that moves with drivers, as a row; empty if it
  /// does not move or no rates are wanted.
  template <typename Quantity>
  [[nodiscard]] OptionalExpression rates(const Quantity& quantity) const {
    return moves(quantity) && order_ > 0
               ? OptionalExpression(rates_of(numbers_.rates(quantity, order_)))
               : std::nullopt;
  }
  /// A local variable with this name, made unique within the function.
  [[nodiscard]] cpp::Expression local(const std::string& name);

 private:
  [[nodiscard]] Gradient gradient_of(const SceneNumber& number) const;
  [[nodiscard]] Gradient gradient_of(const Direction<SceneNumber>& direction) const;
  [[nodiscard]] Gradient constant_gradient(const mechanism::Dual& number) const;
  [[nodiscard]] static bool is_zero(const Gradient& gradient);
  [[nodiscard]] OptionalExpression declared_gradient(const std::string& name,
                                                     const Gradient& gradient);
  /// Assigns each derivative that is not zero to its entry of the target after these indices.
  void add_gradient(const cpp::Expression& target, const std::vector<cpp::Expression>& places,
                    const Gradient& gradient);
  void add_gradients(const cpp::Expression& target, const std::vector<Gradient>& rows);

  [[nodiscard]] bool moves(const SceneNumber& number) const { return numbers_.moves(number); }
  [[nodiscard]] bool moves(const Direction<SceneNumber>& direction) const {
    return numbers_.moves(direction.cos) || numbers_.moves(direction.sin);
  }
  [[nodiscard]] static cpp::Expression rates_of(std::vector<cpp::Expression> rates) {
    return cpp::call(cpp::alias("Rates"), std::move(rates));
  }
  /// Assigns the rates of a coordinate that moves to a row of `target`.
  template <typename Quantity>
  void add_rates(const cpp::Expression& target, std::size_t row, const Quantity& quantity) {
    if (const OptionalExpression value = rates(quantity)) {
      add(cpp::assigned(target.member("rates").member("row").at({cpp::word(row)}), *value));
    }
  }

  const ModelledParameters& parameters_;
  const SceneNumbers& numbers_;
  int order_;
  cpp::Block statements_;
  int locals_ = 0;
};

/// Frames, each in the one before it, from the outermost; empty ones are skipped.
[[nodiscard]] cpp::Expression nested_frames(const std::vector<OptionalExpression>& frames);

}  // namespace assur::generator::emission::scene
