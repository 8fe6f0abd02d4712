// Access to the parts of an emitted solver for its search and tracking, and the types of its
// results.
#pragma once

#include <algorithm>
#include <array>
#include <assur/assembly.hpp>
#include <assur/numeric/precision.hpp>
#include <assur/support/configuration_order.hpp>
#include <assur/support/placed_group.hpp>
#include <assur/support/power_derivative.hpp>
#include <assur/support/scene_columns.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

namespace assur::support {

/// The result of an emitted solver, apart from the configurations.
struct Solution {
  /// ok, also if the links cannot be assembled; degenerate if there is no configuration, but a
  /// group moves freely or is inconsistent; not_finite; unsound_arithmetic; unresolved in float, if
  /// the program chose not to use double, and if redundant constraints may lock a group that moves
  /// freely without them.
  AssemblyStatus status = AssemblyStatus::ok;
  int count = 0;  ///< the number of configurations
  /// The number of families: a group that moves freely or is inconsistent counts once for each
  /// combination of configurations of the groups that hold it, directly or through others, if all
  /// groups that do not depend on it can be assembled.
  int families = 0;
  int mobility = 0;  ///< the greatest mobility of these families
  /// False if a configuration of a group with more than four links may be missing.
  bool complete = true;
};

/// The result of the solver of a scene with limits.
struct LimitedSolution : Solution {
  int left_out = 0;  ///< configurations beyond the limits of joints
};

/// Whether a solver has parameters as arguments.
template <typename Solver, typename = void>
inline constexpr bool has_parameters = false;
template <typename Solver>
inline constexpr bool
    has_parameters<Solver, std::void_t<typename Solver::template Parameters<double>>> = true;

/// The arguments of a solver: its drivers.
template <typename Solver, typename Scalar, bool HasParameters = has_parameters<Solver>>
struct GivenTo {
  using Type = typename Solver::template Drivers<Scalar>;
};
/// The arguments of a solver with parameters.
template <typename Solver, typename Scalar>
struct GivenTo<Solver, Scalar, true> {
  struct Type {
    typename Solver::template Drivers<Scalar> drivers;
    typename Solver::template Parameters<Scalar> parameters;

    /// The positions of all arguments that change along a path; drivers that turn come first.
    [[nodiscard]] auto positions() {
      const auto of_drivers = drivers.positions();
      const auto values = parameters.values();
      std::array<Scalar*, of_drivers.size() + values.size()> all;
      std::copy(values.begin(), values.end(),
                std::copy(of_drivers.begin(), of_drivers.end(), all.begin()));
      return all;
    }
  };
};

/// Arguments below this, and their products, are far from the end of the range of the scalar.
template <typename Scalar>
inline constexpr Scalar moderate =
    numeric::power_of_two<Scalar>(std::numeric_limits<Scalar>::max_exponent / 8);

/// The private parts of a solver that its search and its tracking use.
template <typename Solver, typename Scalar>
struct Access {
  using Given = typename GivenTo<Solver, Scalar>::Type;
  using Groups = typename Solver::Groups;
  using Parts = typename Solver::template Parts<Scalar>;
  using Placed = typename Parts::Placed;
  static constexpr std::size_t lengths_from = turning_key_size(Solver::keyed_links);
  static constexpr std::size_t turning_drivers = Solver::turning_drivers;  ///< they come first
  static constexpr std::size_t first_key = Solver::first_key;  ///< the first entry that may differ
  using Key = std::array<Scalar, lengths_from + Solver::keyed_slides>;
  static constexpr bool in_packs = Solver::in_packs;  ///< whether a pack may be the scalar
  /// Whether the search has to check that arguments are finite; groups check positions themselves.
  static constexpr bool is_looked_at = has_parameters<Solver> || Solver::order > 0;
  static constexpr bool has_limits = std::is_same_v<typename Solver::Solution, LimitedSolution>;
  template <typename Those>
  static auto gaps_of(int)
      -> decltype(Those::redundant_gap(std::declval<const Placed&>()), std::true_type());
  template <typename Those>
  static std::false_type gaps_of(...);
  /// Whether the solver computes the residual of redundant constraints.
  static constexpr bool has_gaps = decltype(gaps_of<Parts>(0))::value;
  template <typename Those>
  static auto settles_of(int) -> decltype(Those::settle(std::declval<Placed&>()), std::true_type());
  template <typename Those>
  static std::false_type settles_of(...);
  /// Whether it closes all constraints together if it is nearly singular without the redundant
  /// ones.
  static constexpr bool settles = decltype(settles_of<Parts>(0))::value;
  template <typename Those>
  static auto followed_of(int) -> std::integral_constant<std::size_t, Those::followed_angles>;
  template <typename Those>
  static auto followed_of(...) -> std::integral_constant<std::size_t, 0>;
  /// The number of angles that loads and springs read and that tracking continues.
  static constexpr std::size_t followed_angles = decltype(followed_of<Solver>(0))::value;
  using Followed = std::array<Scalar, followed_angles>;
  template <typename Those>
  static auto redundant_of(int) -> decltype(Those::has_redundant, std::true_type());
  template <typename Those>
  static std::false_type redundant_of(...);
  /// Whether the solver leaves out redundant constraints and tests them.
  static constexpr bool has_redundant = decltype(redundant_of<Solver>(0))::value;
  template <typename Those>
  static auto laws_of(int) -> decltype(Those::has_laws, std::true_type());
  template <typename Those>
  static std::false_type laws_of(...);
  /// Whether the solver has drivers whose laws read joints.
  static constexpr bool has_laws = decltype(laws_of<Solver>(0))::value;
  template <typename Those>
  static auto own_rates_of(int) -> decltype(Those::has_own_rates, std::true_type());
  template <typename Those>
  static std::false_type own_rates_of(...);
  /// Whether there are rates that are not arguments of the solver.
  static constexpr bool has_own_rates = decltype(own_rates_of<Solver>(0))::value;
  /// For each group, the set of the groups that hold it, directly or through others.
  static constexpr auto holders = [] {
    constexpr std::size_t groups = std::tuple_size_v<Groups>;
    if constexpr (groups > 1) {
      return Solver::holders;
    } else {
      return std::array<std::uint64_t, groups>{};
    }
  }();

  [[nodiscard]] static auto& drivers_of(Given& given) {
    if constexpr (has_parameters<Solver>) {
      return given.drivers;
    } else {
      return given;
    }
  }
  /// The arguments at a fraction of a straight path.
  [[nodiscard]] static Given between(Given from, const Given& to, Scalar part) {
    Given result = to;
    const auto starts = from.positions();
    const auto positions = result.positions();
    for (std::size_t index = 0; index < positions.size(); ++index) {
      *positions[index] = *starts[index] + part * (*positions[index] - *starts[index]);
    }
    return result;
  }
  /// Places the links that drivers move.
  static void drive(const Given& given, Placed& placed) {
    if constexpr (has_parameters<Solver>) {
      Parts::drive(given.drivers, given.parameters, placed);
    } else {
      Parts::drive(given, placed);
    }
  }
  /// Whether no position, and no rate, is NaN or infinite.
  [[nodiscard]] static bool is_finite(const Given& given) {
    return are_below(given, std::numeric_limits<Scalar>::infinity());
  }
  /// Whether no position, and no rate, reaches a limit.
  [[nodiscard]] static bool are_below(Given given, Scalar limit) {
    const auto below = [limit](const auto*... value) {
      return ((std::abs(*value) < limit) && ...);
    };
    if constexpr (Solver::order > 0) {
      if (!std::apply(below, drivers_of(given).rates())) {
        return false;
      }
    }
    return std::apply(below, given.positions());
  }
  [[nodiscard]] static bool parameters_differ(Given from, Given to) {
    if constexpr (has_parameters<Solver>) {
      return std::apply(
          [&to](const auto*... start) {
            return std::apply([=](const auto*... end) { return ((*start != *end) || ...); },
                              to.parameters.values());
          },
          from.parameters.values());
    } else {
      return false;
    }
  }
  /// Sets the positions of a group's external joints.
  template <typename Held>
  static void hold(const Placed& placed, Held& held) {
    Parts::hold(placed, held);
  }
  /// Places a group's links.
  template <typename Group>
  static void place(const Group& group, Placed& placed) {
    Parts::place(group, placed);
  }
  /// Fills a state from the placed links; rates that are not finite are marked as unknown.
  static void list(const Placed& placed, typename Solver::template State<Scalar>& state) {
    list_moderate(placed, state);
    if constexpr (Solver::order > 0) {
      mark_infinite_rates(state);
    }
  }
  /// The same if arguments are below `moderate` and there are no other rates.
  static void list_moderate(const Placed& placed, typename Solver::template State<Scalar>& state) {
    Parts::list(placed, state);
  }
  /// Whether all joints keep their limits.
  [[nodiscard]] static auto keeps_limits(const Placed& placed) {
    return Parts::keeps_limits(placed);
  }
  /// The residual of the redundant constraints, divided by the largest coordinate.
  [[nodiscard]] static Scalar gap(const Placed& placed) { return Parts::redundant_gap(placed); }
  /// The direction of the first link of the key, in the ground's frame.
  [[nodiscard]] static Direction<Scalar> first_direction(const Placed& placed) {
    return Parts::first_direction(placed);
  }
  /// The angles that loads and springs read, continued from those of `placed`.
  [[nodiscard]] static Followed followed(const Placed& placed) { return Parts::followed(placed); }
  /// Closes all constraints together. Returns whether they hold, and agree in the rates that are
  /// known.
  [[nodiscard]] static bool settle(Placed& placed) { return Parts::settle(placed); }
  /// The key by which states are distinguished and sorted.
  static void key(const Placed& placed, Key& key) { Parts::key(placed, key); }
};

}  // namespace assur::support
