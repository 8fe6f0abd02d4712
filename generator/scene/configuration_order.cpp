#include "scene/configuration_order.hpp"

#include <assur/configuration_order.hpp>

namespace assur::generator {

namespace {

std::vector<double> order_key(const AssemblyConfiguration& configuration,
                              const std::vector<bool>& moving) {
  std::vector<Direction<double>> directions;
  for (std::size_t link = 0; link < configuration.links.size(); ++link) {
    if (moving[link]) {
      const Direction<Dual>& direction = configuration.links[link].direction;
      directions.push_back({direction.cos.value(), direction.sin.value()});
    }
  }
  const std::array<double, 4> sums = turning_sums(directions);
  std::vector<double> key(sums.begin(), sums.end());
  for (const JointState& slide : configuration.joints) {
    key.push_back(slide.displacement.value());
  }
  return key;
}

}  // namespace

void put_in_order(std::vector<AssemblyConfiguration>& configurations,
                  const std::vector<bool>& moving) {
  std::vector<std::vector<double>> keys;
  keys.reserve(configurations.size());
  for (const AssemblyConfiguration& configuration : configurations) {
    keys.push_back(order_key(configuration, moving));
  }
  assur::put_in_order(configurations, keys, static_cast<int>(configurations.size()));
}

}  // namespace assur::generator
