#include "scene/configuration_order.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace assur::generator {

namespace {

std::vector<double> order_key(const AssemblyConfiguration& configuration,
                              const std::vector<bool>& moving) {
  std::vector<double> key(4, 0.0);
  for (std::size_t one = 0; one < configuration.links.size(); ++one) {
    for (std::size_t other = one + 1; other < configuration.links.size(); ++other) {
      if (!moving[one] || !moving[other]) {
        continue;
      }
      const Direction<Dual>& first = configuration.links[one].direction;
      const Direction<Dual>& second = configuration.links[other].direction;
      const Direction<double> between =
          turned(Direction<double>{second.cos.value(), second.sin.value()},
                 Direction<double>{first.cos.value(), -first.sin.value()});
      key[0] += between.cos;
      key[1] += between.cos * between.cos;
      key[2] += between.cos * between.cos * between.cos;
      key[3] += between.sin;
    }
  }
  for (const JointState& slide : configuration.joints) {
    key.push_back(slide.displacement.value());
  }
  return key;
}

bool comes_before(const std::vector<double>& left, const std::vector<double>& right) {
  for (std::size_t place = 0; place < left.size(); ++place) {
    const double difference = left[place] - right[place];
    if (std::abs(difference) > 1e-9 * (1 + std::abs(left[place]))) {
      return difference < 0;
    }
  }
  return false;
}

}  // namespace

void put_in_order(std::vector<AssemblyConfiguration>& configurations,
                  const std::vector<bool>& moving) {
  std::vector<std::pair<std::vector<double>, std::size_t>> keyed;
  for (std::size_t index = 0; index < configurations.size(); ++index) {
    keyed.emplace_back(order_key(configurations[index], moving), index);
  }
  std::stable_sort(keyed.begin(), keyed.end(), [](const auto& left, const auto& right) {
    return comes_before(left.first, right.first);
  });
  std::vector<AssemblyConfiguration> ordered;
  for (const auto& [key, index] : keyed) {
    ordered.push_back(std::move(configurations[index]));
  }
  configurations = std::move(ordered);
}

}  // namespace assur::generator
