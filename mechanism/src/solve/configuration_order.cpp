#include "configuration_order.hpp"

#include <algorithm>
#include <assur/support/configuration_order.hpp>
#include <numeric>

namespace assur::mechanism::solve {

namespace {

/// So many are put in order as they are.
constexpr std::size_t few = 64;

}  // namespace

void ConfigurationOrder::set_key(const Configuration& configuration, std::vector<double>& key) {
  directions_.clear();
  for (const LinkIndex link : parts_.links) {
    directions_.push_back(configuration.links[link].pose.direction);
  }
  std::size_t place = support::turning_key_size(directions_.size());
  key.assign(place + parts_.slides.size(), 0);
  support::turning_key(directions_, key);
  for (const NamedSlide& named : parts_.slides) {
    for (const SlideState& slide : configuration.slides) {
      if (slide.joint == named.joint) {
        key[place] = named.sense * slide.displacement;
      }
    }
    ++place;
  }
}

/// By their keys as they are, with their rounding: what comes after exchanges neighbours alone, and
/// takes time as the square of how many it has to exchange.
void ConfigurationOrder::sort_roughly(std::vector<Configuration>& configurations) {
  keys_.resize(configurations.size());
  std::vector<std::size_t> order(configurations.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(
      order, [this](std::size_t one, std::size_t other) { return keys_[one] < keys_[other]; });
  std::vector<Configuration> sorted;
  std::vector<std::vector<double>> keys;
  sorted.reserve(order.size());
  for (const std::size_t place : order) {
    sorted.push_back(std::move(configurations[place]));
    keys.push_back(std::move(keys_[place]));
  }
  configurations = std::move(sorted);
  keys_ = std::move(keys);
}

void ConfigurationOrder::sort(std::vector<Configuration>& configurations) {
  if (configurations.size() < 2) {
    return;
  }
  keys_.resize(configurations.size());
  for (std::size_t index = 0; index < configurations.size(); ++index) {
    set_key(configurations[index], keys_[index]);
  }
  if (configurations.size() > few) {
    sort_roughly(configurations);
  }
  support::put_in_order(keys_, static_cast<int>(configurations.size()),
                        support::turning_key_size(parts_.links.size()),
                        [&configurations](std::size_t one, std::size_t other) {
                          std::swap(configurations[one], configurations[other]);
                        });
}

}  // namespace assur::mechanism::solve
