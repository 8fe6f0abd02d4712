// A random mechanism of a crank and a tetrad, as a scene with a sweep and as rigid bodies.
#pragma once

#include <assur/mechanism/scene_file.hpp>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "rigid_body.hpp"

namespace assur::test {

/// The crank turns about the origin by the parameter p; joint B is on it. The links BCG, EDF, CD
/// and GF are bodies 0 to 3, joints B C G E D F have indices 0 to 5.
struct RandomSweep {
  enum class Swept : unsigned char { crank, displacement, length };

  std::string kind;  ///< R or P for B C G E D F
  Swept swept = Swept::crank;
  RigidBodies bodies;
  BodyFeature crank_feature;  ///< joint B on the crank
  BodyPose crank;             ///< as made, at p = 0
  mechanism::Scene scene;

  /// Moves joint B on the ground, or changes the bar's length, to a value of the parameter.
  void set_parameter(Real p) {
    BodyPose pose = crank;
    if (swept == Swept::crank) {
      pose.theta += p;
    } else if (swept == Swept::displacement) {
      pose.x += std::cos(crank.theta) * p;
      pose.y += std::sin(crank.theta) * p;
    } else {
      bodies.joints[4].on_second.x = bar_x + p;
    }
    bodies.joints[0].on_first = pose.world(crank_feature);
  }
  Real bar_x = 0;  ///< of joint D on the bar CD, at p = 0
};

namespace random_sweep_detail {

using Json = nlohmann::ordered_json;

struct Ends {
  int first, second;
};
inline constexpr std::array<Ends, 6> graph{{{-1, 0}, {0, 2}, {0, 3}, {-1, 1}, {1, 2}, {1, 3}}};
inline constexpr std::array<const char*, 6> joint_names{"B", "C", "G", "E", "D", "F"};
inline constexpr std::array<const char*, 4> link_names{"BCG", "EDF", "CD", "GF"};

inline Json feature_json(const BodyFeature& feature, bool line) {
  const auto x = static_cast<double>(feature.x);
  const auto y = static_cast<double>(feature.y);
  if (!line) {
    return {x, y};
  }
  const auto angle = static_cast<double>(feature.angle);
  return {{"through", {x, y}}, {"along", {std::cos(angle), std::sin(angle)}}};
}

/// A feature with the digits that a scene file keeps.
inline BodyFeature rounded(const BodyFeature& feature) {
  return {static_cast<double>(feature.x), static_cast<double>(feature.y),
          static_cast<double>(feature.angle)};
}

}  // namespace random_sweep_detail

/// A random scene, assembled at p = 0, lengths in a unit. `count` steps over -pi..pi for a crank,
/// -1.5..1.5 otherwise.
inline RandomSweep random_sweep(const std::string& kind, RandomSweep::Swept swept, unsigned seed,
                                int count, double unit = 1) {
  using namespace random_sweep_detail;
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> length(-1.5 * unit, 1.5 * unit);
  std::uniform_real_distribution<double> angle(-3.1, 3.1);
  RandomSweep made;
  made.kind = kind;
  made.swept = swept;
  made.crank = {0, 0, angle(engine)};
  for (int link = 0; link < 4; ++link) {
    made.bodies.poses.push_back({length(engine), length(engine), angle(engine)});
  }
  for (std::size_t joint = 0; joint < 6; ++joint) {
    BodyJoint at;
    at.prismatic = kind[joint] == 'P';
    at.first = graph[joint].first;
    at.second = graph[joint].second;
    const BodyFeature place{length(engine), length(engine), angle(engine)};
    BodyFeature other = place;
    if (at.prismatic) {
      const Real displacement = length(engine);
      other.x += displacement * std::cos(place.angle);
      other.y += displacement * std::sin(place.angle);
    }
    const bool held = at.first < 0;
    at.on_first =
        held ? place : rounded(made.bodies.poses[static_cast<std::size_t>(at.first)].local(place));
    at.on_second = rounded(made.bodies.poses[static_cast<std::size_t>(at.second)].local(other));
    made.bodies.joints.push_back(at);
  }
  made.crank_feature = rounded(made.crank.local(made.bodies.joints[0].on_first));
  made.bar_x = made.bodies.joints[4].on_second.x;

  Json scene;
  scene["parameters"] = {{"p", 0}};
  Json links;
  const bool turning = swept != RandomSweep::Swept::displacement;
  const BodyFeature base{0, 0, made.crank.theta};
  links["ground"]["A"] = feature_json(base, !turning);
  links["crank"]["A"] = feature_json({0, 0, 0}, !turning);
  for (const char* name : link_names) {
    links[name] = Json::object();
  }
  for (std::size_t joint = 0; joint < 6; ++joint) {
    const BodyJoint& at = made.bodies.joints[joint];
    const std::string name = joint_names[joint];
    const auto owner = [&](int link) -> std::string {
      return link >= 0    ? link_names[static_cast<std::size_t>(link)]
             : joint == 0 ? "crank"
                          : "ground";
    };
    links[owner(at.first)][name] =
        feature_json(joint == 0 ? made.crank_feature : at.on_first, at.prismatic);
    links[owner(at.second)][name] = feature_json(at.on_second, at.prismatic);
    scene["joints"][name] = {
        {"type", at.prismatic ? "prismatic" : "revolute"},
        {"between", {owner(at.first) + "." + name, owner(at.second) + "." + name}}};
  }
  std::ostringstream precise;
  precise.precision(17);
  if (swept == RandomSweep::Swept::length) {
    precise << static_cast<double>(made.bar_x) << " + p";
    Json& bar = links["CD"]["D"];
    (bar.is_array() ? bar : bar["through"])[0] = precise.str();
    precise.str("");
  }
  precise << static_cast<double>(made.crank.theta)
          << (swept == RandomSweep::Swept::crank ? " + p" : "");
  scene["joints"]["A"] = {{"type", turning ? "revolute" : "prismatic"},
                          {"between", {"ground.A", "crank.A"}}};
  scene["drivers"]["A"]["position"] = turning ? precise.str() : "p";
  const Json from = swept == RandomSweep::Swept::crank ? Json("-pi") : Json(-1.5 * unit);
  const Json to = swept == RandomSweep::Swept::crank ? Json("pi") : Json(1.5 * unit);
  scene["sweep"] = {{"parameter", "p"}, {"from", from}, {"to", to}, {"count", count}};
  scene["links"] = links;
  made.scene = mechanism::parse_scene(scene.dump(), "random");
  return made;
}

}  // namespace assur::test
