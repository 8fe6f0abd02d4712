// Statements that sum the loads on each link: gravity, inertia, loads, springs and dampers.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// The opposite of a force.
[[nodiscard]] inline cpp::Expression opposite(const cpp::Expression& force) {
  return cpp::call("support::opposite", {force});
}

/// The pull of a spring that has no direction where its ends coincide, as variables.
struct DirectedPull {
  cpp::Expression pull, at;            ///< on the first link
  mechanism::LinkIndex first, second;  ///< the spring pulls the first toward the second
};

/// The loads on each link of a solver, as variables of one function.
class LinkLoads {
 public:
  /// Declares a variable for each link. Both must outlive it.
  LinkLoads(const SolverScene& solver, FunctionBody& body);

  /// Adds all loads except joint forces.
  void add_all();
  /// Adds the same without pulls of unknown direction, and returns those.
  [[nodiscard]] std::vector<DirectedPull> add_all_known();
  /// Adds the same without inertia.
  void add_applied();

  /// The variable of a link.
  [[nodiscard]] const cpp::Expression& on(mechanism::LinkIndex link) const { return on_[link]; }
  /// Whether any force or moment was added to a link.
  [[nodiscard]] bool bears(mechanism::LinkIndex link) const { return bears_[link]; }
  /// The sum over links that count as one.
  [[nodiscard]] cpp::Expression together(const std::vector<mechanism::LinkIndex>& links) const;
  /// A variable for the position of a point, or of a line's `through`.
  [[nodiscard]] cpp::Expression place(mechanism::FeatureIndex feature);
  /// A variable for a point of a link; `name` is the name of the point.
  [[nodiscard]] cpp::Expression place(const std::string& name, mechanism::LinkIndex link,
                                      const SceneNumber& x, const SceneNumber& y);
  /// The direction of a line.
  [[nodiscard]] cpp::Expression direction(mechanism::FeatureIndex line) const;
  /// Adds an effort along the coordinate between two features, and its opposite on the other link.
  void push(const std::vector<mechanism::FeatureIndex>& between, const cpp::Expression& effort);
  /// A variable for the centre of a mass.
  [[nodiscard]] cpp::Expression centre(const mechanism::Mass& mass);
  /// Whether the number exists and is not always zero.
  [[nodiscard]] bool counts(mechanism::NumberIndex number) const;
  /// The expression of a number that may be absent.
  [[nodiscard]] cpp::Expression value(mechanism::NumberIndex number) const {
    return body_.number(this->number(number));
  }

 private:
  [[nodiscard]] mechanism::LinkIndex link_of(mechanism::FeatureIndex feature) const {
    return solver_.mechanism().features()[feature].link;
  }
  [[nodiscard]] cpp::Expression place(const std::string& name, const mechanism::PlaceOnLink& on);
  /// A number that may be absent.
  [[nodiscard]] SceneNumber number(mechanism::NumberIndex number) const;
  void add(mechanism::LinkIndex link, const std::string& function,
           std::vector<cpp::Expression> arguments);
  /// A variable for the acceleration of gravity.
  [[nodiscard]] cpp::Expression gravity();
  void add_masses();
  void add_weights();
  void add_weight(const mechanism::Mass& mass, const cpp::Expression& gravity);
  void add_loads_and_springs();
  void add_load(const mechanism::Load& load);
  void add_spring(const mechanism::Spring& spring);
  void add_joint_spring(const mechanism::Spring& spring);

  const SolverScene& solver_;
  FunctionBody& body_;
  mechanism::Table<mechanism::LinkIndex, cpp::Expression> on_;
  mechanism::Table<mechanism::LinkIndex, bool> bears_;
  std::map<mechanism::FeatureIndex, cpp::Expression> places_;
  std::map<mechanism::LinkIndex, cpp::Expression> centres_;
  std::vector<DirectedPull> pulls_;
  bool leaves_out_unknown_ = false;  ///< pulls of unknown direction
};

/// Whether statements compute the pull of a spring that has no direction where its ends coincide.
[[nodiscard]] bool has_directed_springs(const cpp::Block& statements);

/// Fills the member for the resultant on the ground: by the equilibrium of all links together, it
/// is the sum of the loads on all of them.
void add_ground_resultant(const cpp::Expression& on_all_links, FunctionBody& body);

}  // namespace assur::generator::emission::scene
