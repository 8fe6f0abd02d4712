#include "configuration_order.hpp"

#include <assur/support/configuration_order.hpp>

namespace assur::mechanism::solve {

namespace {

std::vector<double> order_key(const Configuration& configuration, const NamedParts& parts,
                              std::vector<Direction<double>>& directions) {
  directions.clear();
  for (const LinkIndex link : parts.links) {
    directions.push_back(configuration.links[link].pose.direction);
  }
  std::vector<double> key(support::turning_key_size(directions.size()) + parts.slides.size());
  support::turning_key(directions, key);
  std::size_t place = support::turning_key_size(directions.size());
  for (const NamedSlide& named : parts.slides) {
    for (const SlideState& slide : configuration.slides) {
      if (slide.joint == named.joint) {
        key[place] = named.sense * slide.displacement;
      }
    }
    ++place;
  }
  return key;
}

}  // namespace

void put_in_order(std::vector<Configuration>& configurations, const NamedParts& parts) {
  if (configurations.size() < 2) {
    return;
  }
  std::vector<Direction<double>> directions;
  std::vector<std::vector<double>> keys;
  keys.reserve(configurations.size());
  for (const Configuration& configuration : configurations) {
    keys.push_back(order_key(configuration, parts, directions));
  }
  support::put_in_order(keys, static_cast<int>(configurations.size()),
                        support::turning_key_size(parts.links.size()),
                        [&configurations](std::size_t one, std::size_t other) {
                          std::swap(configurations[one], configurations[other]);
                        });
}

}  // namespace assur::mechanism::solve
