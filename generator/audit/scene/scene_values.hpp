// Values of one configuration of a scene, by name.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace assur::generator::audit::scene {

/// The values for every link L: L_x, L_y, L_theta, L_vx, L_vy, L_omega, L_ax, L_ay, L_alpha; for
/// every output P: P_x, P_y, P_vx, P_vy, P_ax, P_ay; for every slide S: S_displacement, S_velocity,
/// S_acceleration. Throws InputError if the scene has no such configuration. `settings` replace
/// parameters of the scene; others are ignored.
[[nodiscard]] std::map<std::string, double> scene_values(const std::string& file, int configuration,
                                                         const std::vector<std::string>& settings);

}  // namespace assur::generator::audit::scene
