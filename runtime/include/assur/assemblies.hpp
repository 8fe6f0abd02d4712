// Turns the answer to "where can this group stand?" into types: configurations, each with its
// status.
#pragma once

#include <array>
#include <assur/status.hpp>
#include <cstddef>

namespace assur {

enum class [[nodiscard]] AssemblyStatus : unsigned char{
    ok,          ///< the list is complete; it is empty if the links cannot reach
    degenerate,  ///< no configuration is isolated: the group moves freely
    not_finite,  ///< an input is NaN or infinite, or the lengths differ by too many powers of ten
    /// Rounding has no bound, because of how the program was compiled, without the compiler telling
    /// (parts of -ffast-math), or how the processor is set, or the processor flushes such short
    /// lengths to zero: nothing is listed.
    unsound_arithmetic,
    /// The precision does not decide how many configurations there are, and the program chose not
    /// to use double: nothing is listed.
    unresolved};

[[nodiscard]] constexpr const char* to_string(AssemblyStatus status) {
  switch (status) {
    case AssemblyStatus::ok:
      return "ok";
    case AssemblyStatus::degenerate:
      return "degenerate";
    case AssemblyStatus::not_finite:
      return "not finite";
    case AssemblyStatus::unsound_arithmetic:
      return "unsound arithmetic";
    case AssemblyStatus::unresolved:
      return "unresolved";
  }
  return "unknown";
}

/// What is done where float does not decide how many configurations there are. In double this does
/// not happen, because a search in special position settles the list.
enum class Unresolved : unsigned char {
  ask_double,  ///< the same group is solved in double, and its configurations are rounded
  refuse       ///< the status is `unresolved`, and no code in double is compiled
};

/// The assembly configurations of a model, in an order that rigid motion, reflection and change of
/// units keep.
template <typename Model, typename Scalar = double>
struct Assemblies {
  static constexpr auto capacity = static_cast<std::size_t>(Model::max_configurations);

  AssemblyStatus status = AssemblyStatus::ok;
  int count = 0;
  std::array<typename Model::template Configuration<Scalar>, capacity> configurations;
  /// ok, or near_singular: the derivatives may keep fewer digits than `regularity` promises, six in
  /// double and three in float, or configurations meet so closely that rounding of the inputs
  /// decides whether they are two, one or none.
  std::array<Status, capacity> regularity{};
  /// The greatest mobility of a family beside the listed configurations; zero without a family.
  int mobility = 0;
  /// False where a configuration of a group with more than four links may be missing: fewer complex
  /// configurations are enclosed than there are in general position.
  bool complete = true;
};

}  // namespace assur
