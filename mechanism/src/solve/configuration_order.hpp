// Turns assembly configurations into an order that depends on the mechanism alone.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <vector>

namespace assur::mechanism::solve {

/// What places a configuration among others: the turning key of its links, then the displacements
/// of its slides.
void set_order_key(const NamedParts& parts, const Table<LinkIndex, Frame>& links,
                   const std::vector<SlideState>& slides, std::vector<double>& key);

/// Orders configurations by what depends neither on where the mechanism stands, nor on its size,
/// nor on the order in which its parts are listed: sums over all pairs of links that groups place
/// of the cosines of the angles between them, which do not depend on reflection either. Equal sums
/// fall back on sines, on the links' angles by name, and on displacements.
class ConfigurationOrder {
 public:
  /// The parts must outlive the order.
  explicit ConfigurationOrder(const NamedParts& parts) : parts_(parts) {}

  void sort(std::vector<Configuration>& configurations);

 private:
  void sort_roughly(std::vector<Configuration>& configurations);

  const NamedParts& parts_;
  std::vector<std::vector<double>> keys_;  ///< room for them
};

}  // namespace assur::mechanism::solve
