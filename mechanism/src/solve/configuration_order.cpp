#include "configuration_order.hpp"

#include <algorithm>
#include <assur/support/configuration_order.hpp>
#include <numeric>

namespace assur::mechanism::solve {

namespace {

/// Up to this number of configurations the rough sort is omitted.
constexpr std::size_t few = 64;

/// The directions of some links.
struct LinkDirections {
  const std::vector<LinkIndex>& links;
  const Table<LinkIndex, Frame>& placed;

  [[nodiscard]] std::size_t size() const { return links.size(); }
  [[nodiscard]] const Direction<double>& operator[](std::size_t place) const {
    return placed[links[place]].pose.direction;
  }
};

}  // namespace

void set_order_key(const NamedParts& parts, const Table<LinkIndex, Frame>& links,
                   const std::vector<SlideState>& slides, std::vector<double>& key) {
  std::size_t place = support::turning_key_size(parts.links.size());
  key.assign(place + parts.slides.size(), 0);
  support::turning_key(LinkDirections{parts.links, links}, key);
  for (const NamedSlide& named : parts.slides) {
    for (const SlideState& slide : slides) {
      if (slide.joint == named.joint) {
        key[place] = named.sense * slide.displacement;
      }
    }
    ++place;
  }
}

/// Sorts by the plain keys without regard to rounding: the sort that follows exchanges neighbours
/// only, and its time grows as the square of the remaining exchanges.
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
    set_order_key(parts_, configurations[index].links, configurations[index].slides, keys_[index]);
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
