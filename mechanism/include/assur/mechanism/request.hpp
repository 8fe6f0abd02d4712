// Request of results for a mechanism: quantities, reported parts, a sweep, a covariance.
#pragma once

#include <algorithm>
#include <assur/mechanism/mechanism.hpp>
#include <optional>
#include <string>
#include <vector>

namespace assur::mechanism {

/// The requested results; others are not computed.
struct Want {
  bool position = true;
  bool velocity = true;
  bool acceleration = true;
  bool sensitivity = true;
  bool forces = false;        ///< efforts of drivers, forces in joints, the ground's resultant
  bool dynamics = false;      ///< mass matrix, bias and load of the free drivers
  bool coefficients = false;  ///< derivatives with respect to the coordinates of the free drivers

  /// Whether any requested result depends on loads.
  [[nodiscard]] bool loaded() const { return forces || dynamics; }
};

/// `count` equally spaced values of one parameter, both ends included.
struct Sweep {
  ParameterIndex parameter;
  NumberIndex from, to;
  int count = 0;
};

/// Variances and covariances of some parameters; the others do not vary.
struct Covariance {
  std::vector<ParameterIndex> parameters;
  std::vector<std::vector<NumberIndex>> matrix;  ///< square, in the order of `parameters`
};

/// The parts reported beside the outputs: links, and slides by their joints. An omitted list stands
/// for all. A group on which no reported part depends is not solved, and a plan's mechanism does
/// not contain it.
struct Reported {
  std::optional<std::vector<LinkIndex>> links;
  /// Prismatic joints and pins in slots; revolute joints if forces or coefficients are requested.
  std::optional<std::vector<JointIndex>> joints;

  [[nodiscard]] bool everything() const { return !links && !joints; }
  [[nodiscard]] bool has(LinkIndex link) const { return holds(links, link); }
  [[nodiscard]] bool has(JointIndex joint) const { return holds(joints, joint); }

 private:
  template <typename Key>
  [[nodiscard]] static bool holds(const std::optional<std::vector<Key>>& list, Key key) {
    return !list || std::find(list->begin(), list->end(), key) != list->end();
  }
};

/// The approximate angle of a link.
struct ReferenceAngle {
  LinkIndex link;
  NumberIndex theta;
};

/// The distance of a drawn pin from its slot, in the scene's unit.
struct DrawnGap {
  std::string joint;
  double length;
};

/// The pose in which a mechanism is drawn. Its angles are the request's reference.
struct DrawnPose {
  std::optional<DrawnGap> gap;  ///< the largest; nothing if all joints close in the drawing
};

/// The results requested of a mechanism.
struct Request {
  Want want;
  Reported reported;
  std::optional<Sweep> sweep;
  std::optional<Covariance> covariance;
  /// The length by which redundant constraints may fail to hold; if it does not exist, they must
  /// hold up to rounding.
  NumberIndex redundancy_tolerance;
  std::vector<ReferenceAngle> reference;  ///< by which one configuration is chosen
  /// Exists if the reference is that of a drawing, for want of an explicit one. It keeps no link in
  /// the solved part of the mechanism.
  std::optional<DrawnPose> drawn;
  bool prove = false;  ///< enclose every group of every configuration (`GroupProof`)
  /// The parameters that remain arguments of an emitted solver; the others become numbers there.
  std::vector<ParameterIndex> variable;
};

}  // namespace assur::mechanism
