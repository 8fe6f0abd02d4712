// Turns masses, gravity, loads, springs and dampers into statements that add them to what acts on
// links.
#pragma once

#include <map>
#include <string>

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// What acts on each link of a solver, as variables of one function.
class LinkLoads {
 public:
  /// Declares a variable for each link. Both must outlive it.
  LinkLoads(const SolverScene& solver, FunctionBody& body);

  /// Adds all that is there before the forces of joints are known.
  void add_all();

  /// The variable of a link.
  [[nodiscard]] const cpp::Expression& on(mechanism::LinkIndex link) const { return on_[link]; }
  /// The sum over links that count as one.
  [[nodiscard]] cpp::Expression together(const std::vector<mechanism::LinkIndex>& links) const;
  /// A variable for the place of a point, or of a line's `through`.
  [[nodiscard]] cpp::Expression place(mechanism::FeatureIndex feature);
  /// A variable for a point of a link; `name` is what it is called.
  [[nodiscard]] cpp::Expression place(const std::string& name, mechanism::LinkIndex link,
                                      const SceneNumber& x, const SceneNumber& y);
  /// The direction of a line.
  [[nodiscard]] cpp::Expression direction(mechanism::FeatureIndex line) const;
  /// Adds an effort along the coordinate between two features, and against it on the other link.
  void push(const std::vector<mechanism::FeatureIndex>& between, const cpp::Expression& effort);

 private:
  [[nodiscard]] mechanism::LinkIndex link_of(mechanism::FeatureIndex feature) const {
    return solver_.mechanism().features()[feature].link;
  }
  [[nodiscard]] cpp::Expression place(const std::string& name, const mechanism::PlaceOnLink& on);
  /// A number that need not exist.
  [[nodiscard]] SceneNumber number(mechanism::NumberIndex number) const;
  /// Whether the number is there, and not always zero.
  [[nodiscard]] bool counts(mechanism::NumberIndex number) const;
  void add(mechanism::LinkIndex link, const std::string& function,
           std::vector<cpp::Expression> arguments);
  void add_masses();
  void add_load(const mechanism::Load& load);
  void add_spring(const mechanism::Spring& spring);
  void add_joint_spring(const mechanism::Spring& spring);

  const SolverScene& solver_;
  FunctionBody& body_;
  mechanism::Table<mechanism::LinkIndex, cpp::Expression> on_;
  std::map<mechanism::FeatureIndex, cpp::Expression> places_;
};

}  // namespace assur::generator::emission::scene
