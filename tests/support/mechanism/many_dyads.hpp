// Scenes of dyads in a row, each of which can be assembled for any configuration of the previous
// ones.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace assur::test {

/// A crank, and `count` dyads: each hangs on the ground and on a point near the last one's pivot,
/// so there are 2^count configurations. The angle of bar i in the reference is near `angle(i)`.
template <typename Angle>
nlohmann::ordered_json many_dyads(int count, const Angle& angle) {
  const auto joint = [](const std::string& one, const std::string& other) {
    return nlohmann::ordered_json{{"type", "revolute"},
                                  {"between", nlohmann::ordered_json::array({one, other})}};
  };
  nlohmann::ordered_json scene;
  scene["links"]["ground"] = {{"A", {0, 0}}};
  scene["links"]["bar0"] = {{"A", {0, 0}}, {"P", {0.01, 0}}};
  scene["joints"]["A"] = joint("ground.A", "bar0.A");
  scene["drivers"]["A"]["position"] = 0.3;
  scene["want"] = {"position"};
  for (int number = 1; number <= count; ++number) {
    const std::string own = std::to_string(number);
    scene["links"]["ground"]["G" + own] = {1 + 0.003 * number, 0.1};
    scene["links"]["bar" + own] = {{"A", {0, 0}}, {"P", {0.01, 0}}, {"C", {2, 0}}};
    scene["links"]["rocker" + own] = {{"G", {0, 0}}, {"C", {2.1, 0}}};
    scene["joints"]["A" + own] =
        joint("bar" + std::to_string(number - 1) + ".P", "bar" + own + ".A");
    scene["joints"]["C" + own] = joint("bar" + own + ".C", "rocker" + own + ".C");
    scene["joints"]["G" + own] = joint("ground.G" + own, "rocker" + own + ".G");
    scene["reference"]["bar" + own] = angle(number);
  }
  return scene;
}

}  // namespace assur::test
