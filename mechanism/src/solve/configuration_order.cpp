#include "configuration_order.hpp"

#include <assur/support/configuration_order.hpp>

namespace assur::mechanism::solve {

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

void ConfigurationOrder::sort(std::vector<Configuration>& configurations) {
  if (configurations.size() < 2) {
    return;
  }
  keys_.resize(configurations.size());
  for (std::size_t index = 0; index < configurations.size(); ++index) {
    set_key(configurations[index], keys_[index]);
  }
  support::put_in_order(keys_, static_cast<int>(configurations.size()),
                        support::turning_key_size(parts_.links.size()),
                        [&configurations](std::size_t one, std::size_t other) {
                          std::swap(configurations[one], configurations[other]);
                        });
}

}  // namespace assur::mechanism::solve
