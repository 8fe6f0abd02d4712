// JSON Schema of scenes, from the tables of their keys.
#include <assur/mechanism/scene_file.hpp>
#include <span>

#include "json_values.hpp"
#include "load_keys.hpp"
#include "scene_keys.hpp"

namespace assur::mechanism::file {

namespace {

/// An object with these keys and no others.
SceneJson object_of(std::span<const SceneKey> keys, const std::string& description) {
  SceneJson schema = {{"description", description},
                      {"type", "object"},
                      {"properties", SceneJson::object()},
                      {"required", SceneJson::array()},
                      {"additionalProperties", false}};
  for (const SceneKey& key : keys) {
    SceneJson form = {{"description", key.meaning}};
    form.update(SceneJson::parse(key.form));
    schema["properties"][key.name] = form;
    if (key.required) {
      schema["required"].push_back(key.name);
    }
  }
  return schema;
}

/// An object whose keys are names chosen in the scene.
SceneJson names_of(const SceneJson& named, const char* pattern = nullptr) {
  SceneJson schema = {{"type", "object"}};
  schema["propertyNames"] =
      pattern == nullptr ? SceneJson{{"minLength", 1}} : SceneJson{{"pattern", pattern}};
  schema["additionalProperties"] = named;
  return schema;
}

SceneJson reference_to(const std::string& name) { return {{"$ref", "#/$defs/" + name}}; }

SceneJson definitions() {
  const SceneJson number = {
      {"description",
       "A number, or an expression in parameters: + - * / ^, parentheses, sqrt sin cos tan asin "
       "acos atan atan2, pi, and deg = pi/180"},
      {"anyOf", {{{"type", "number"}}, {{"type", "string"}, {"minLength", 1}}}}};
  const auto two = [](const std::string& description) {
    return SceneJson{{"description", description},
                     {"type", "array"},
                     {"items", reference_to("number")},
                     {"minItems", 2},
                     {"maxItems", 2}};
  };
  SceneJson joint = object_of(joint_keys, "A joint of two links; a revolute one may have more");
  joint["oneOf"] = {{{"required", {"between"}}}, {{"required", {"links"}}}};
  joint["if"] = {{"properties", {{"type", {{"enum", {"prismatic", "pin-in-slot"}}}}}}};
  joint["then"] = {{"properties", {{"between", {{"maxItems", 2}}}, {"links", {{"maxItems", 2}}}}}};
  const SceneJson line = object_of(line_keys, "A line in the frame of its link");
  const SceneJson line_through_points =
      object_of(line_through_points_keys, "A line through two points of its link");
  SceneJson parameter = object_of(parameter_keys, "A parameter: its value, tolerance and rates");
  parameter["anyOf"] = {{{"required", {"value"}}}, {{"required", {"drawn"}}}};
  const SceneJson name = {{"type", "string"}, {"minLength", 1}};
  const SceneJson two_points = {
      {"type", "array"}, {"items", name}, {"minItems", 2}, {"maxItems", 2}, {"uniqueItems", true}};
  const SceneJson listed_points = {{"description", "The drawn points of the link, each once"},
                                   {"type", "array"},
                                   {"items", name},
                                   {"uniqueItems", true}};
  const SceneJson features =
      names_of({{"anyOf", {reference_to("point"), line, line_through_points}}});
  return {{"number", number},
          {"pair", two("[lowest, highest]")},
          {"point", two("[x, y] in the frame of its link, in the scene's unit of length")},
          {"feature_name",
           {{"description", "link.feature"}, {"type", "string"}, {"pattern", "^[^.]+\\."}}},
          {"parameters",
           names_of({{"anyOf", {reference_to("number"), parameter}}}, "^[A-Za-z_][A-Za-z0-9_]*$")},
          {"points", names_of(reference_to("point"), "^[^.]+$")},
          {"drawn",
           {{"anyOf",
             {two_points, {{"type", "array"}, {"items", two_points}, {"minItems", 1}}, name}}}},
          {"links", names_of({{"anyOf", {features, listed_points}}}, "^[^.]+$")},
          {"joints", names_of(joint)},
          {"drivers", names_of(object_of(driver_keys, "The law of the joint of this name"))},
          {"outputs", {{"anyOf", {names_of(name), listed_points}}}},
          {"masses", names_of(object_of(mass_keys, "The mass of the link of this name"))},
          {"pair_of_loads", two("[Fx, Fy]")},
          {"loads", names_of({{"anyOf",
                               {object_of(force_keys, "A force at a point"),
                                object_of(moment_keys, "A couple on a link")}}})},
          {"springs", names_of({{"anyOf",
                                 {object_of(spring_keys, "Between points of two links"),
                                  object_of(joint_spring_keys, "At a joint")}}})},
          {"report", object_of(report_keys, "Lists of names")},
          {"sweep", object_of(sweep_keys, "Equally spaced values of a parameter")},
          {"redundancy",
           object_of(redundancy_keys, "By how much redundant constraints may fail to hold")},
          {"covariance", object_of(covariance_keys, "A symmetric matrix")}};
}

}  // namespace

}  // namespace assur::mechanism::file

namespace assur::mechanism {

std::string scene_schema() {
  file::SceneJson schema = {
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", "A scene: one planar mechanism, and the results requested of it"}};
  schema.update(file::object_of(
      file::scene_keys,
      "Lengths share one unit, and angles are in radians, counter-clockwise. A link's pose is the "
      "place of its frame's origin and the angle of its x-axis, in the frame of the ground."));
  schema["$defs"] = file::definitions();
  return schema.dump(2) + "\n";
}

}  // namespace assur::mechanism
