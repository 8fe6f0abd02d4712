// Turns a scene file (JSON) into a checked description of one planar mechanism.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/expression.hpp"

namespace assur::generator {

/// A number of the scene: an expression, and where it stands, for messages.
struct SceneNumber {
  Expression expression;
  std::string where;
};

struct SceneParameter {
  std::string name;
  SceneNumber value;
  std::optional<SceneNumber> tolerance;  ///< half-width
};

/// A named feature of a link in its local frame: a point, or a line through it.
struct SceneFeature {
  std::string name;
  bool line = false;
  SceneNumber x, y;              ///< of the point, or of the line's `through`
  SceneNumber along_x, along_y;  ///< of a line; not necessarily a unit vector
  std::string where;
};

struct SceneLink {
  std::string name;
  std::vector<SceneFeature> features;
};

/// A feature of a link by index.
struct FeatureReference {
  int link = 0;
  int feature = 0;
};

enum class SceneJointType : unsigned char { revolute, prismatic, pin_in_slot };

struct SceneJoint {
  std::string name;
  SceneJointType type = SceneJointType::revolute;
  std::vector<FeatureReference> between;
};

struct SceneDriver {
  int joint = 0;
  SceneNumber position;
  SceneNumber velocity;
  SceneNumber acceleration;
};

struct SceneOutput {
  std::string name;
  FeatureReference point;
};

struct SceneWant {
  bool position = true;
  bool velocity = true;
  bool acceleration = true;
  bool sensitivity = true;
};

struct SceneSweep {
  int parameter = 0;
  SceneNumber from, to;
  int count = 0;
};

/// Variances and covariances of some parameters; the others do not vary.
struct SceneCovariance {
  std::vector<int> parameters;
  std::vector<std::vector<SceneNumber>> matrix;  ///< square, in the order of `parameters`
};

/// One planar mechanism. The link named `ground`, if there is any, is the fixed frame.
struct Scene {
  std::string file;  ///< for messages
  std::string name;
  std::vector<SceneParameter> parameters;
  std::vector<SceneLink> links;
  std::vector<SceneJoint> joints;
  std::vector<SceneDriver> drivers;
  std::vector<SceneOutput> outputs;
  SceneWant want;
  std::optional<SceneSweep> sweep;
  std::optional<SceneCovariance> covariance;

  [[nodiscard]] const SceneFeature& feature(const FeatureReference& reference) const {
    return links[static_cast<std::size_t>(reference.link)]
        .features[static_cast<std::size_t>(reference.feature)];
  }
};

/// Reads a scene. `settings` replace parameters' values: `NAME=EXPR`. Throws InputError with one
/// line: file, place, what is wrong, and the mend where there is one.
[[nodiscard]] Scene read_scene(const std::string& file, const std::vector<std::string>& settings);
/// The same from text; `file` is its name in messages.
[[nodiscard]] Scene parse_scene(const std::string& text, const std::string& file,
                                const std::vector<std::string>& settings);

}  // namespace assur::generator
