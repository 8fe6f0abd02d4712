// Loop-closure equations of a kinematic model, by walking the loops of its graph.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "equations/implicit_equations.hpp"
#include "equations/link_frame.hpp"

namespace assur::generator::equations {

/// One vector loop-closure equation: both walks to the chord joint reach the same point.
struct LoopClosure {
  std::string name;             ///< `BCDEB`
  structure::JointIndex chord;  ///< the joint that closes the loop
  std::string equation;         ///< `B + BC + CD - ED - E = 0`, as text
  Vector2 residual;             ///< in the names of the vocabulary
};

/// The frame of a link: its origin, and its angle as a sum of angles.
struct LinkPose {
  Vector2 origin;
  AngleSum angle;
  Vector2 direction;  ///< (cos, sin) of `angle` in the names of the vocabulary
};

/// The link of an unknown angle, or the joint of an unknown displacement.
using Owner = std::variant<structure::LinkIndex, structure::JointIndex>;

/// A prismatic joint by which a link's angle follows from that of another one, or of the base.
struct AngleTie {
  structure::JointIndex joint;
  structure::LinkIndex link;  ///< the link whose angle follows
};

/// The loop-closure equations of a model. Angles that prismatic joints tie together are merged, so
/// the unknowns are one angle for each set of links that turn together and one displacement for
/// each prismatic joint. The residuals are x and y of each loop.
struct ClosureEquations : ImplicitEquations {
  explicit ClosureEquations(const structure::Model& of_model);

  const structure::Model* model;
  std::vector<Owner> owners;  ///< for each unknown
  structure::LinkTable<LinkFrame> frames;
  structure::LinkTable<LinkPose> poses;
  /// One for each prismatic joint of a rigid model, in the order in which links were tied.
  std::vector<AngleTie> ties;
  /// The unit vector along each slide, in the names of the vocabulary; zero at revolute joints.
  structure::JointTable<Vector2> slide_directions;
  std::vector<LoopClosure> loops;
  /// Sums of angles that must vanish because prismatic joints alone close a loop. They contain no
  /// unknown, so a model with such a sum has over-determined angles.
  std::vector<AngleSum> compatibility;
};

/// `moves`: for each dimension, in order, whether it varies in time. One that does is an input,
/// after the model's own inputs. Dimensions beyond the end of the list are constant.
[[nodiscard]] ClosureEquations closure_equations(const structure::Model& model,
                                                 const std::vector<bool>& moves = {});

}  // namespace assur::generator::equations
