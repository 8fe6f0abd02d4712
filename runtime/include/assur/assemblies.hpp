// Result types of the position analysis of a group: configurations and their status.
#pragma once

#include <array>
#include <assur/status.hpp>
#include <cstddef>

namespace assur {

enum class [[nodiscard]] AssemblyStatus : unsigned char{
    ok,          ///< the list is complete; it is empty if the links cannot reach
    degenerate,  ///< no configuration is isolated: the group moves freely
    not_finite,  ///< an input is NaN or infinite, or the lengths differ by too many powers of ten
    /// Rounding errors have no bound: the program was compiled with parts of -ffast-math that the
    /// compiler does not report, the processor's rounding mode is not the default, or it flushes
    /// such short lengths to zero. Nothing is listed.
    unsound_arithmetic,
    /// The precision does not determine the number of configurations, and the program chose not to
    /// use double. Nothing is listed.
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

/// What to do if float does not determine the number of configurations. In double this does not
/// happen, because the search in special position settles the list.
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
  /// ok or near_singular. near_singular: the derivatives may have fewer correct digits than
  /// `regularity` promises (six in double, three in float), or configurations are so close together
  /// that rounding of the inputs decides whether there are two, one or none.
  std::array<Status, capacity> regularity{};
  /// The greatest mobility of a family of configurations that is not listed; zero if there is none.
  int mobility = 0;
  /// False if a configuration of a group with more than four links may be missing: fewer complex
  /// configurations were enclosed than exist in general position.
  bool complete = true;
};

}  // namespace assur
