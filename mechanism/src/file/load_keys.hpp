// Keys of loads in a scene, for the reader and the JSON Schema.
#pragma once

#include <array>

#include "scene_keys.hpp"

namespace assur::mechanism::file {

inline constexpr std::array mass_keys = {
    SceneKey{"mass", true, R"({"$ref": "#/$defs/number"})", "The mass; not negative."},
    SceneKey{"at", false,
             R"({"anyOf": [{"type": "string", "minLength": 1}, {"$ref": "#/$defs/point"}]})",
             "The centre of mass: a point of the link by its name, or [x, y] in the link's frame; "
             "by default the origin of that frame."},
    SceneKey{"inertia", false, R"({"$ref": "#/$defs/number"})",
             "The moment of inertia about the centre of mass; not negative, by default 0."},
};

inline constexpr std::array force_keys = {
    SceneKey{"at", true, R"({"$ref": "#/$defs/feature_name"})",
             "The point at which the force acts; at a pin, it acts on the link that is named."},
    SceneKey{"force", true, R"({"$ref": "#/$defs/pair_of_loads"})",
             "The components [Fx, Fy]. They may contain joint(K)."},
    SceneKey{"frame", false, R"({"type": "string"})",
             "The link in whose frame the components are given; by default the ground."},
};

inline constexpr std::array moment_keys = {
    SceneKey{"on", true, R"({"type": "string"})", "The link on which the couple acts."},
    SceneKey{"moment", true, R"({"$ref": "#/$defs/number"})",
             "The couple, positive counter-clockwise. It may contain joint(K)."},
};

inline constexpr std::array spring_keys = {
    SceneKey{"between", true,
             R"({"type": "array", "items": {"$ref": "#/$defs/feature_name"}, "minItems": 2,
                 "maxItems": 2})",
             "The points that the spring joins, of two links."},
    SceneKey{"stiffness", false, R"({"$ref": "#/$defs/number"})",
             "Force per change of length; not negative, by default 0."},
    SceneKey{"length", false, R"({"$ref": "#/$defs/number"})",
             "The length without force; not negative, by default 0."},
    SceneKey{"damping", false, R"({"$ref": "#/$defs/number"})",
             "Force per rate of the length; not negative, by default 0."},
};

inline constexpr std::array joint_spring_keys = {
    SceneKey{"joint", true, R"({"type": "string"})",
             "The joint of two links along whose coordinate the spring acts."},
    SceneKey{"stiffness", false, R"({"$ref": "#/$defs/number"})",
             "Torque or force per change of the coordinate; not negative, by default 0."},
    SceneKey{"rest", false, R"({"$ref": "#/$defs/number"})",
             "The coordinate without force, by default 0. At a revolute joint without a driver the "
             "deflection is taken within half a turn of it."},
    SceneKey{"damping", false, R"({"$ref": "#/$defs/number"})",
             "Torque or force per rate of the coordinate; not negative, by default 0."},
};

}  // namespace assur::mechanism::file
