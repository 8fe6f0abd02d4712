#include "configuration_order.hpp"

#include <array>
#include <assur/support/configuration_order.hpp>

namespace assur::mechanism {

namespace {

std::vector<double> order_key(const Configuration& configuration,
                              const std::vector<LinkIndex>& moving,
                              std::vector<Direction<double>>& directions) {
  directions.clear();
  for (const LinkIndex link : moving) {
    directions.push_back(configuration.links[link].pose.direction);
  }
  const std::array<double, 4> sums = support::turning_sums(directions);
  std::vector<double> key;
  key.reserve(sums.size() + configuration.slides.size());
  key.assign(sums.begin(), sums.end());
  for (const SlideState& slide : configuration.slides) {
    key.push_back(slide.displacement);
  }
  return key;
}

}  // namespace

void put_in_order(std::vector<Configuration>& configurations,
                  const std::vector<LinkIndex>& moving) {
  if (configurations.size() < 2) {
    return;
  }
  std::vector<Direction<double>> directions;
  std::vector<std::vector<double>> keys;
  keys.reserve(configurations.size());
  for (const Configuration& configuration : configurations) {
    keys.push_back(order_key(configuration, moving, directions));
  }
  support::put_in_order(configurations, keys, static_cast<int>(configurations.size()));
}

}  // namespace assur::mechanism
