#include "command/scene_warnings.hpp"

#include <algorithm>
#include <array>
#include <assur/text/quoted.hpp>

#include "command/output.hpp"

namespace assur::generator::command {

namespace {

using mechanism::Formula;
using mechanism::Mechanism;
using mechanism::NumberIndex;
using mechanism::ParameterIndex;

/// Whether a number depends on a parameter, directly or by the formulas of others. Formulas of
/// parameters have no cycles.
bool follows(const Mechanism& mechanism, NumberIndex number, ParameterIndex parameter) {
  if (!number.exists()) {
    return false;
  }
  return std::ranges::any_of(
      mechanism.numbers()[number].formula.parameters(), [&](ParameterIndex read) {
        return read == parameter ||
               follows(mechanism, mechanism.parameters()[read].value, parameter);
      });
}

}  // namespace

void warn_of_idle_links(const mechanism::Scene& scene) {
  for (const mechanism::Link& link : scene.mechanism.links()) {
    if (link.is_idle) {
      remarks() << "warning: " << scene.file << ": the link " << text::in_quotes(link.name)
                << " turns freely on its one pin, and is left at rest; drive that joint, or add "
                   "another, if it should move\n";
    }
  }
}

void warn_of_idle_sweep(const mechanism::Scene& scene) {
  if (!scene.request.sweep) {
    return;
  }
  const Mechanism& mechanism = scene.mechanism;
  const ParameterIndex swept = scene.request.sweep->parameter;
  const auto moves_with = [&](NumberIndex number) { return follows(mechanism, number, swept); };
  for (const mechanism::Feature& feature : mechanism.features()) {
    const std::array numbers = {feature.x, feature.y, feature.along_x, feature.along_y};
    if (std::ranges::any_of(numbers, moves_with)) {
      return;
    }
  }
  for (const mechanism::Driver& driver : mechanism.drivers()) {
    if (moves_with(driver.position)) {
      return;
    }
  }
  const std::string name = text::in_quotes(mechanism.parameters()[swept].name);
  remarks() << "warning: " << scene.file << ": sweep: no link and no driver reads the parameter "
            << name << ", so nothing moves; sweep another, or let a driver's position read it\n";
}

}  // namespace assur::generator::command
