// Keys of the scene format, shared by its reader and its JSON Schema.
#pragma once

#include <array>

namespace assur::mechanism::file {

/// A key of an object of a scene.
struct SceneKey {
  const char* name;
  bool required;
  const char* form;     ///< the JSON Schema of its value
  const char* meaning;  ///< with its unit and its sign
};

inline constexpr std::array scene_keys = {
    SceneKey{"name", false, R"({"type": "string"})",
             "The name of the scene in messages and reports."},
    SceneKey{"unit", false, R"({"type": "string"})",
             "The name of the unit of length, such as mm or in, shown in drawings."},
    SceneKey{"parameters", false, R"({"$ref": "#/$defs/parameters"})",
             "Numbers with names, which expressions may use."},
    SceneKey{"points", false, R"({"$ref": "#/$defs/points"})",
             "The points of a drawing, in the frame of the ground, which links may list."},
    SceneKey{"links", true, R"({"$ref": "#/$defs/links"})",
             "The rigid bodies, each with the drawn points that belong to it, or with its named "
             "features in its own frame. The link 'ground' is the fixed frame; it may be left out "
             "where all links list points."},
    SceneKey{"joints", false, R"({"$ref": "#/$defs/joints"})",
             "Connections of links. Every drawn point that two links or more list is a revolute "
             "joint of its name, unless joints join them there. Required if no link lists points."},
    SceneKey{"drivers", false, R"({"$ref": "#/$defs/drivers"})",
             "The joints whose coordinates are given."},
    SceneKey{"outputs", false, R"({"$ref": "#/$defs/outputs"})",
             "Points to report, each with a name; or a list of drawn points."},
    SceneKey{"masses", false, R"({"$ref": "#/$defs/masses"})",
             "Masses of links, each by the link's name."},
    SceneKey{"gravity", false, R"({"$ref": "#/$defs/point"})",
             "The acceleration of free fall [x, y], in the ground's frame; by default none."},
    SceneKey{"loads", false, R"({"$ref": "#/$defs/loads"})",
             "Forces at points and couples on links, each with a name."},
    SceneKey{"springs", false, R"({"$ref": "#/$defs/springs"})",
             "Springs with dampers, each with a name."},
    SceneKey{"want", false,
             R"({"type": "array", "items": {"enum": ["position", "velocity", "acceleration",
                 "sensitivity", "forces", "dynamics", "coefficients"]}, "uniqueItems": true})",
             "What is computed; by default the first four."},
    SceneKey{"report", false, R"({"$ref": "#/$defs/report"})",
             "Which links and slides are reported beside the outputs."},
    SceneKey{"reference", false,
             R"({"type": "object", "additionalProperties": {"$ref": "#/$defs/number"}})",
             "Approximate angles of some links against the ground, in radians, for --nearest; by "
             "default those of the drawing."},
    SceneKey{"redundancy", false, R"({"$ref": "#/$defs/redundancy"})",
             "By how much redundant constraints may fail to hold."},
    SceneKey{"sweep", false, R"({"$ref": "#/$defs/sweep"})", "A range of one parameter."},
    SceneKey{"covariance", false, R"({"$ref": "#/$defs/covariance"})",
             "How some parameters vary together."},
};

inline constexpr std::array parameter_keys = {
    SceneKey{"value", false, R"({"$ref": "#/$defs/number"})",
             "A length in the scene's unit, an angle in radians, or any other number. Required "
             "without 'drawn'."},
    SceneKey{"drawn", false, R"({"$ref": "#/$defs/drawn"})",
             "Two drawn points: the parameter is their distance in every link that lists both, as "
             "drawn unless 'value' is given. A list of such pairs: the distance of each, and "
             "'value' is required. The name of a joint: its coordinate as drawn."},
    SceneKey{"tolerance", false, R"({"$ref": "#/$defs/number"})",
             "A half-width, in the parameter's unit; not negative."},
    SceneKey{"velocity", false, R"({"$ref": "#/$defs/number"})",
             "The rate in time, in the parameter's unit; by default that of the parameters in its "
             "value."},
    SceneKey{"acceleration", false, R"({"$ref": "#/$defs/number"})",
             "The second rate in time; by default that of the parameters in its value."},
    SceneKey{"variable", false, R"({"type": "boolean"})",
             "Whether the parameter stays an argument of the emitted solver."},
};

/// The two forms of a line: by a point and a direction, or by two points of the same link.
inline constexpr std::array line_keys = {
    SceneKey{"through", true, R"({"$ref": "#/$defs/point"})",
             "A point of the line, from which displacements are measured."},
    SceneKey{"along", true, R"({"$ref": "#/$defs/point"})",
             "The direction of the line, of any length but zero; its sense is that of positive "
             "displacements."},
};

inline constexpr std::array line_through_points_keys = {
    SceneKey{"from", true, R"({"type": "string"})",
             "A point of the same link, from which displacements are measured."},
    SceneKey{"to", true, R"({"type": "string"})", "The point of that link toward which it runs."},
};

inline constexpr std::array joint_keys = {
    SceneKey{"type", true, R"({"enum": ["revolute", "prismatic", "pin-in-slot"]})",
             "Revolute: points coincide. Prismatic: two lines coincide, with the same direction. "
             "Pin-in-slot: a point lies on a line."},
    SceneKey{
        "between", false,
        R"({"type": "array", "minItems": 2, "items": {"$ref": "#/$defs/feature_name"}})",
        "Features of different links. A prismatic joint may name two points of links that list "
        "drawn points: the line from the first to the second. The coordinate is measured from the "
        "first to the second: "
        "the angle theta_second - theta_first, counter-clockwise, or the displacement of the "
        "second line's 'through' from the first's, along the line."},
    SceneKey{"links", false, R"({"type": "array", "minItems": 2, "items": {"type": "string"}})",
             "In place of 'between': links that list drawn points. The coordinate is measured from "
             "the first to the second; the pin of a pin-in-slot is on the first, the slot on the "
             "second."},
    SceneKey{"at", false, R"({"type": "string"})",
             "With 'links': the drawn point of the pin; by default the one with the joint's name."},
    SceneKey{
        "along", false,
        R"({"type": "array", "minItems": 2, "maxItems": 2, "items": {"type": "string"}})",
        "With 'links': two drawn points; a slide or a slot runs from the first to the second. The "
        "displacement of a slide is zero as drawn; that of a pin in its slot is measured from "
        "the first point."},
    SceneKey{"direction", false, R"({"$ref": "#/$defs/point"})",
             "In place of 'along': the direction [dx, dy] in the drawing of a line through 'at'."},
    SceneKey{"limits", false, R"({"$ref": "#/$defs/pair"})",
             "Lowest and highest coordinate, both included, in radians or the scene's unit; an "
             "angle may differ by whole turns."},
};

inline constexpr std::array driver_keys = {
    SceneKey{"position", false, R"({"$ref": "#/$defs/number"})",
             "The joint's coordinate: an angle in radians or a displacement. It may contain "
             "joint(K), the coordinate of another joint of two links. By default as drawn."},
    SceneKey{"velocity", false, R"({"$ref": "#/$defs/number"})",
             "Its rate in time; by default it follows from the position."},
    SceneKey{"acceleration", false, R"({"$ref": "#/$defs/number"})",
             "Its second rate in time; by default likewise."},
};

inline constexpr std::array report_keys = {
    SceneKey{"links", false,
             R"({"type": "array", "items": {"type": "string"}, "uniqueItems": true})",
             "Names of links; by default all."},
    SceneKey{
        "joints", false, R"({"type": "array", "items": {"type": "string"}, "uniqueItems": true})",
        "Names of joints; by default all. Revolute ones are listed where forces or coefficients "
        "are wanted."},
};

inline constexpr std::array sweep_keys = {
    SceneKey{"parameter", true, R"({"type": "string"})", "The parameter that is swept."},
    SceneKey{"from", true, R"({"$ref": "#/$defs/number"})", "Its first value."},
    SceneKey{"to", true, R"({"$ref": "#/$defs/number"})", "Its last value."},
    SceneKey{"count", true, R"({"type": "integer", "minimum": 1, "maximum": 10000000})",
             "The number of equally spaced values, both ends included."},
};

inline constexpr std::array redundancy_keys = {
    SceneKey{"tolerance", true, R"({"$ref": "#/$defs/number"})",
             "A length in the scene's unit; by default constraints must hold to within rounding."},
};

inline constexpr std::array covariance_keys = {
    SceneKey{
        "parameters", true,
        R"({"type": "array", "items": {"type": "string"}, "minItems": 1, "uniqueItems": true})",
        "The parameters that vary."},
    SceneKey{
        "matrix", true,
        R"({"type": "array", "items": {"type": "array", "items": {"$ref": "#/$defs/number"}}})",
        "Variances and covariances, in the order of the parameters."},
};

}  // namespace assur::mechanism::file
