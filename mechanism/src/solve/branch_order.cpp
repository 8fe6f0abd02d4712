#include "branch_order.hpp"

#include <algorithm>
#include <array>
#include <assur/numeric/order.hpp>
#include <cmath>

namespace assur::mechanism::solve {

namespace {

/// The rates by which branches are sorted: angular velocities, velocities of slides, and then their
/// accelerations. They stand in the order of the names of links and slides, so that the order in
/// which a scene lists them does not matter.
using Rates = std::array<std::vector<double>, 4>;

Rates rates_of(const Configuration& configuration, const NamedParts& parts) {
  Rates rates;
  for (const LinkIndex link : parts.links) {
    rates[0].push_back(configuration.links[link].velocity(2));
    rates[2].push_back(configuration.links[link].acceleration(2));
  }
  for (const NamedSlide& named : parts.slides) {
    for (const SlideState& slide : configuration.slides) {
      if (slide.joint == named.joint) {
        rates[1].push_back(named.sense * slide.velocity);
        rates[3].push_back(named.sense * slide.acceleration);
      }
    }
  }
  return rates;
}

/// Compares the first rates that differ by more than the rounding of the largest.
bool goes_before(const Rates& one, const Rates& other) {
  constexpr double rounding = 1e-4;
  for (std::size_t kind = 0; kind < one.size(); ++kind) {
    double largest = 0;
    for (const std::vector<double>* of : {&one[kind], &other[kind]}) {
      for (const double rate : *of) {
        largest = std::max(largest, std::abs(rate));
      }
    }
    for (std::size_t place = 0; place < one[kind].size(); ++place) {
      const double difference = one[kind][place] - other[kind][place];
      if (std::abs(difference) > rounding * largest) {
        return difference < 0;
      }
    }
  }
  return false;
}

}  // namespace

void put_in_order(const NamedParts& parts, std::vector<Configuration>& branches) {
  std::vector<Rates> rates;
  rates.reserve(branches.size());
  for (const Configuration& branch : branches) {
    rates.push_back(rates_of(branch, parts));
  }
  // Comparison up to rounding is not transitive, so a faster sort cannot rely on it.
  numeric::insertion_sort(
      branches.size(),
      [&](std::size_t one, std::size_t other) { return goes_before(rates[one], rates[other]); },
      [&](std::size_t one, std::size_t other) {
        std::swap(branches[one], branches[other]);
        std::swap(rates[one], rates[other]);
      });
}

}  // namespace assur::mechanism::solve
