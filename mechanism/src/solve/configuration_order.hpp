// Order of assembly configurations, a property of the mechanism alone.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <vector>

namespace assur::mechanism::solve {

/// Sets the key by which a configuration is sorted: the turning key of its links, then the
/// displacements of its slides.
void set_order_key(const NamedParts& parts, const Table<LinkIndex, Frame>& links,
                   const std::vector<SlideState>& slides, std::vector<double>& key);

/// Sorts configurations by a key that depends neither on the mechanism's place and size nor on the
/// order in which its parts are listed: the sum of the cosines of the angles between all pairs of
/// links that groups place, which does not depend on reflection either. Where these sums are equal,
/// sines decide, then the links' angles by name, and then displacements.
class ConfigurationOrder {
 public:
  /// The parts must outlive the order.
  explicit ConfigurationOrder(const NamedParts& parts) : parts_(parts) {}

  void sort(std::vector<Configuration>& configurations);

 private:
  void sort_roughly(std::vector<Configuration>& configurations);

  const NamedParts& parts_;
  std::vector<std::vector<double>> keys_;  ///< kept for their memory
};

}  // namespace assur::mechanism::solve
