// Parts of a configuration that drivers do not place.
#pragma once

#include <algorithm>
#include <assur/mechanism/solution.hpp>

namespace assur::mechanism {

/// Calls `use` with every link, output and slide whose motion follows from loop closures. The
/// motion of other parts, placed by drivers, is known in singular configurations too.
template <typename Use>
void for_each_followed(const Mechanism& mechanism, const Structure& structure,
                       Configuration& configuration, const Use& use) {
  const Table<LinkIndex, bool> is_driven = structure.placed_by_drivers();
  for (const LinkIndex link : configuration.links.keys()) {
    if (!is_driven[link]) {
      use(configuration.links[link]);
    }
  }
  for (const OutputIndex output : configuration.outputs.keys()) {
    if (!is_driven[mechanism.features()[mechanism.outputs()[output].point].link]) {
      use(configuration.outputs[output]);
    }
  }
  const auto& drivers = mechanism.drivers();
  for (SlideState& slide : configuration.slides) {
    if (std::none_of(drivers.begin(), drivers.end(),
                     [&](const Driver& driver) { return driver.joint == slide.joint; })) {
      use(slide);
    }
  }
}

}  // namespace assur::mechanism
