// Turns the answer to "where can this group stand?" into types: configurations, each with its
// status.
#pragma once

#include <array>
#include <assur/status.hpp>
#include <cstddef>

namespace assur {

enum class AssemblyStatus : unsigned char {
  ok,          ///< all configurations are listed; none if the links cannot reach
  degenerate,  ///< the final polynomial vanishes: no configurations, or infinitely many
  not_finite   ///< an input is NaN or infinite, or the lengths differ by too many powers of ten
};

/// The assembly configurations of a model, in an order that rigid motion, reflection and change of
/// units keep.
template <typename Model>
struct Assemblies {
  static constexpr auto capacity = static_cast<std::size_t>(Model::max_configurations);

  AssemblyStatus status = AssemblyStatus::ok;
  int count = 0;
  std::array<typename Model::template Configuration<double>, capacity> configurations;
  /// ok, or near_singular: the derivatives may keep fewer than six digits, or two configurations
  /// meet so closely that double-double arithmetic cannot tell whether they are two, one or none.
  std::array<Status, capacity> regularity{};
  /// Nearly multiple roots of the final polynomial that double-double could not exclude and from
  /// which no closed configuration came: each may hide two that meet, or none.
  int undecided = 0;
  /// For a degenerate group: freedom where it was found assembled, or zero if it was not.
  int mobility = 0;
};

}  // namespace assur
