// Parameters and derived numbers of a scene, with formulas in the parameters that vary.
#pragma once

#include <ginac/ginac.h>

#include <assur/mechanism/plan.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "emission/scene/formula_expression.hpp"
#include "emission/scene/scene_movers.hpp"

namespace assur::generator::emission::scene {

/// An expression for each modelled parameter; empty where the derivative is zero.
using Gradient = std::vector<std::optional<cpp::Expression>>;

/// The numbers of which a solver consists. Those that depend on parameters that vary at run time
/// have formulas.
class SceneNumbers {
 public:
  /// `variable`: the parameters that vary, each with its expression; `modelled`: the columns of the
  /// modelled parameters; `drivers` and `joints`: their members; `relative`: for each link whose
  /// group is solved relative to a moving link, the member for its frame. Throws MechanismError for
  /// a length that variable parameters change and that is zero at the scene's own numbers, and if
  /// groups are solved relative to moving links but the scene has no configuration at its own
  /// numbers.
  SceneNumbers(const mechanism::Plan& plan, const mechanism::Values& values,
               const std::vector<std::pair<mechanism::ParameterIndex, cpp::Expression>>& variable,
               const std::vector<Eigen::Index>& modelled,
               const mechanism::Table<mechanism::DriverIndex, std::string>& drivers,
               const mechanism::Table<mechanism::JointIndex, std::string>& joints,
               const mechanism::Table<mechanism::LinkIndex, std::string>& relative);
  SceneNumbers(const SceneNumbers&) = delete;
  SceneNumbers& operator=(const SceneNumbers&) = delete;

  [[nodiscard]] SceneNumber number(mechanism::NumberIndex number) const;
  /// The position to which a driver moves its joint: an argument of the solver, or the formula of a
  /// law that reads other joints.
  [[nodiscard]] const SceneNumber& position(mechanism::DriverIndex driver) const {
    return positions_[driver];
  }
  /// The law of a driver that is an argument, as a formula in variable parameters.
  [[nodiscard]] SceneNumber law(mechanism::DriverIndex driver) const;
  /// A number of a load, whose formula may read joints.
  [[nodiscard]] SceneNumber loading(mechanism::NumberIndex number) const;
  /// The derivative of a driver's law with respect to the coordinate of a joint that it reads.
  [[nodiscard]] SceneNumber slope(mechanism::DriverIndex driver, mechanism::JointIndex joint) const;
  [[nodiscard]] LinkFeature<SceneNumber> feature(mechanism::FeatureIndex index, bool is_line) const;
  /// A joint's feature in the frame of a link that has it, or that carries the link that has it.
  [[nodiscard]] LinkFeature<SceneNumber> feature(const mechanism::ElementaryJoint& at,
                                                 mechanism::LinkIndex link) const;
  [[nodiscard]] const mechanism::GroupGeometry<SceneNumber>& group(
      mechanism::GroupIndex group) const {
    return groups_[group];
  }
  [[nodiscard]] mechanism::SlideMeasure<SceneNumber> slide_measure(mechanism::GroupIndex group,
                                                                   int model_joint) const;

  /// Whether the number depends on something that moves, such as a driver.
  [[nodiscard]] bool moves(const SceneNumber& number) const;
  /// The formulas of its time derivatives, `order` in number.
  [[nodiscard]] std::vector<cpp::Expression> rates(const SceneNumber& number, int order) const;
  /// The same for the angle of a direction that moves: c s' - s c', c s'' - s c''.
  [[nodiscard]] std::vector<cpp::Expression> rates(const Direction<SceneNumber>& direction,
                                                   int order) const;

  /// Whether the number depends on a parameter that varies at run time, or on a driver.
  [[nodiscard]] bool varies(const SceneNumber& number) const;
  [[nodiscard]] bool varies(const Direction<SceneNumber>& direction) const {
    return varies(direction.cos) || varies(direction.sin);
  }
  /// A square root in formulas that vary, or one of its rates, computed by a function under a name.
  struct NamedStep {
    std::string name;
    cpp::Expression formula;
  };
  /// The steps in order of dependence, with `order` rates each.
  [[nodiscard]] const std::vector<NamedStep>& steps(int order) const;
  /// The formula of a number that varies.
  [[nodiscard]] cpp::Expression expression(const SceneNumber& number) const;
  /// The formulas of its derivatives with respect to the modelled parameters; empty for zero.
  [[nodiscard]] Gradient gradient(const SceneNumber& number) const;
  /// The same for the angle of a direction that varies: c ds - s dc.
  [[nodiscard]] Gradient gradient(const Direction<SceneNumber>& direction) const;

 private:
  /// Evaluates a parameter after those on which it depends.
  void evaluate(mechanism::ParameterIndex parameter);
  [[nodiscard]] mechanism::Dual deviation(mechanism::ParameterIndex parameter) const;
  [[nodiscard]] bool varies(const GiNaC::ex& formula) const;
  /// Replaces the rates that follow from a parameter's formula by the given ones.
  void set_rates(const Mover& mover);
  void set_rates(const Mover& mover, const GiNaC::ex& formula, mechanism::NumberIndex velocity,
                 mechanism::NumberIndex acceleration);
  /// The same for a driver whose law reads joints.
  void set_rates(mechanism::DriverIndex driver);
  void add_positions(const mechanism::Table<mechanism::DriverIndex, std::string>& drivers,
                     const mechanism::Table<mechanism::JointIndex, std::string>& joints);
  void add_relative_frames(const mechanism::Table<mechanism::LinkIndex, std::string>& relative);
  SceneNumber add_mover(const Mover& mover, const mechanism::Dual& value);
  /// Declares the coordinate of a joint for formulas: that of its driver, or the one found by the
  /// groups.
  void add_coordinate(mechanism::JointIndex joint,
                      const mechanism::Table<mechanism::JointIndex, std::string>& joints);
  /// The formula at zero deviations, in the quantities that vary at run time.
  [[nodiscard]] GiNaC::ex at_run_time(const GiNaC::ex& formula) const;
  /// The expression of a formula that `at_run_time` returned.
  [[nodiscard]] cpp::Expression expression(const GiNaC::ex& formula) const;
  /// A symbol for an expression.
  [[nodiscard]] GiNaC::symbol symbol(const cpp::Expression& expression);
  /// A mover with the expressions of its position and its rates.
  [[nodiscard]] Mover mover(const cpp::Expression& position, const cpp::Expression& velocity,
                            const cpp::Expression& acceleration);
  /// A direction as (x, y) / r, with r^2. The derivatives of its angle are shorter without the
  /// roots in r.
  struct LongDirection {
    GiNaC::ex x, y, square;
  };
  [[nodiscard]] LongDirection lengthened(const Direction<SceneNumber>& direction) const;
  /// Returns the derivative with respect to a modelled parameter, on which laws of drivers may
  /// depend as well.
  [[nodiscard]] GiNaC::ex derivative(const GiNaC::ex& formula, const GiNaC::ex& symbol) const;

  const mechanism::Plan& plan_;
  const mechanism::Values& values_;
  /// A parameter that varies; the deviation of another that is modelled or has rates; else zero.
  mechanism::Table<mechanism::ParameterIndex, GiNaC::ex> symbol_of_;
  mechanism::Table<mechanism::ParameterIndex, bool> is_variable_;
  mutable SceneSymbols symbols_;  ///< formulas that are created later may add roots
  /// The steps of the first `roots_in_steps_` roots.
  mutable std::vector<NamedStep> steps_;
  mutable std::size_t roots_in_steps_ = 0;
  std::vector<GiNaC::symbol> variables_;
  GiNaC::exmap deviations_;  ///< their symbols to zero
  GiNaC::exmap own_rates_;   ///< symbols of rates that are given to their formulas
  /// The factor of given rates: 1, or an argument where motions along coordinates omit them.
  GiNaC::ex given_rates_ = 1;
  std::vector<GiNaC::ex> modelled_;
  mechanism::Table<mechanism::ParameterIndex, std::optional<SceneNumber>> parameters_;
  SceneMovers movers_;
  mechanism::Table<mechanism::DriverIndex, SceneNumber> positions_;
  /// The coordinates of the joints that laws and loads read.
  mechanism::Table<mechanism::JointIndex, std::optional<SceneNumber>> coordinates_;
  /// The frames of links whose groups are solved relative to a link, in the frame of that link.
  mechanism::Table<mechanism::LinkIndex, Pose<SceneNumber>> relative_;
  GiNaC::exmap directions_;  ///< cosines and sines of these frames' angles to symbols
  SymbolExpressions expressions_;
  mechanism::Table<mechanism::GroupIndex, mechanism::GroupGeometry<SceneNumber>> groups_;
};

}  // namespace assur::generator::emission::scene
