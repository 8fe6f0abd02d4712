// All configurations of a mechanism, by depth-first search over the groups of an emitted solver.
#pragma once

#include <algorithm>
#include <array>
#include <assur/assembly.hpp>
#include <assur/support/configuration_order.hpp>
#include <assur/support/placed_group.hpp>
#include <assur/support/redundant.hpp>
#include <assur/support/scene_access.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

namespace assur::support {

/// One configuration of every group of a solver.
template <typename Groups, typename Scalar>
struct GroupConfigurations;
template <typename... Group, typename Scalar>
struct GroupConfigurations<std::tuple<Group...>, Scalar> {
  using Type = std::tuple<typename Group::template Configuration<Scalar>...>;
};

/// The depth-first search of an emitted solver: once the preceding groups are placed, each
/// configuration of a group in turn places its links, overwriting the previous one. If `Keeps`, the
/// search stores the configurations of the groups.
template <typename Solver, typename Scalar, bool Keeps = false>
class Search {
  using State = typename Solver::template State<Scalar>;
  using Own = Access<Solver, Scalar>;
  using Groups = typename Own::Groups;
  using Placed = typename Own::Placed;
  using Solution = typename Solver::Solution;
  static constexpr auto capacity = static_cast<std::size_t>(Solver::max_configurations);
  static constexpr std::size_t group_count = std::tuple_size_v<Groups>;
  /// A set of groups has a bit for each.
  using Set = std::uint64_t;
  static_assert(group_count <= 64, "a set of groups fits into a word of 64 bits");

 public:
  using States = std::array<State, capacity>;
  using Configurations = typename GroupConfigurations<Groups, Scalar>::Type;

  explicit Search(States& states) : states_(states) {}

  /// All configurations within the joint limits, in the order of `assur solve`.
  [[nodiscard, gnu::flatten]] Solution run(const typename Own::Given& given) {
    is_moderate_ = Own::is_looked_at && Own::are_below(given, moderate<Scalar>);
    if (Own::is_looked_at && !is_moderate_ && !Own::is_finite(given)) {
      solution_.status = AssemblyStatus::not_finite;
      return solution_;
    }
    Placed placed;
    Own::drive(given, placed);
    proceed<0>(placed, {});
    const bool is_lost = is_unsure_ && solution_.count == 0;
    const bool is_doubtful =
        (Own::has_gaps && solution_.families > 0) || (Own::has_redundant && is_lost);
    if (is_doubtful && solution_.status == AssemblyStatus::ok) {
      // It is unknown whether the redundant constraints let the families move, or where groups are
      // whose neighbours rounding has displaced far.
      solution_.status = AssemblyStatus::unresolved;
      solution_.families = solution_.mobility = 0;
    }
    if (solution_.status != AssemblyStatus::ok) {
      solution_.count = 0;
    } else if (solution_.count == 0 && solution_.families > 0) {
      solution_.status = AssemblyStatus::degenerate;
    }
    if constexpr (capacity > 1) {
      if constexpr (Own::has_gaps) {
        leave_out_almost_closed();
      }
      put_found_in_order();
    }
    return solution_;
  }

  /// The configurations of the groups in a configuration of the mechanism, by its index from 0.
  [[nodiscard]] const Configurations& kept(int configuration) const {
    return detail::entry(kept_, configuration);
  }

 private:
  void put_found_in_order() {
    if (solution_.count > 1) {
      put_in_order(
          keys_, solution_.count, Own::lengths_from,
          [this](std::size_t one, std::size_t other) {
            std::swap(states_[one], states_[other]);
            if constexpr (Keeps) {
              std::swap(kept_[one], kept_[other]);
            }
          },
          Own::first_key);
    }
  }

  /// If a mechanism without its redundant constraints is singular, these constraints nearly hold in
  /// a neighbourhood of each true configuration: a configuration with a much larger residual than a
  /// near one is left out.
  void leave_out_almost_closed() {
    constexpr Scalar near = std::is_same_v<Scalar, float> ? Scalar(0.1) : Scalar(0.01);
    constexpr Scalar much_more = 16;
    constexpr Scalar rounding = 64 * std::numeric_limits<Scalar>::epsilon();
    // Turning all links together changes no key, but the direction of the first link.
    const auto are_near = [&](std::size_t one, std::size_t other, Scalar away) {
      const Direction<Scalar> turn =
          turned(first_directions_[one], reversed(first_directions_[other]));
      if (!(turn.cos > 0 && std::abs(turn.sin) < away)) {
        return false;
      }
      for (std::size_t place = Own::first_key; place < Own::lengths_from; ++place) {
        if (!(std::abs(keys_[one][place] - keys_[other][place]) < away)) {
          return false;
        }
      }
      return true;
    };
    const auto is_none_beside = [&](std::size_t one, std::size_t other) {
      // Two configurations that only rounding separates coincide when all constraints are closed
      // together: halfway between them the residual is the squared distance over 8, at most 32 eps.
      constexpr Scalar equal = 16 * numeric::half_of_digits<Scalar>;
      return gaps_[one] > (std::max)(much_more * gaps_[other], rounding)
                 ? are_near(one, other, near)
                 : Own::settles && other < one && are_near(one, other, equal);
    };
    for (std::size_t one = 0; one < static_cast<std::size_t>(solution_.count); ++one) {
      bool is_none = false;
      for (std::size_t other = 0; other < static_cast<std::size_t>(solution_.count); ++other) {
        is_none = is_none || is_none_beside(one, other);
      }
      if (is_none) {
        const auto last = static_cast<std::size_t>(--solution_.count);
        states_[one] = states_[last];
        keys_[one] = keys_[last];
        gaps_[one] = gaps_[last];
        first_directions_[one] = first_directions_[last];
        if constexpr (Keeps) {
          kept_[one] = kept_[last];
        }
        ++solution_.left_out;
        --one;
      }
    }
  }

  /// Groups that have no configuration on the present path of the search.
  struct Loose {
    Set moving = 0;  ///< those that move freely, or are inconsistent
    Set all = 0;     ///< these and the groups that they hold
  };

  /// Searches the groups from `Place` on; beyond the last, the configuration is listed. Every group
  /// but the first has a separate function: inlined into each other, at each call of the next, they
  /// would grow beyond what compilers can handle.
  template <std::size_t Place>
  void proceed(Placed& placed, Loose loose) {
    if constexpr (Place < group_count) {
      if constexpr (Place == 0) {
        descend<Place>(placed, loose);
      } else {
        descend_apart<Place>(placed, loose);
      }
    } else if (loose.moving != 0) {
      count_families(loose.moving);
    } else if constexpr (Own::settles) {
      // Nearly singular groups may be placed far from the closure of all constraints together. At
      // that closure the constraints may lock the mechanism: then their rates contradict each
      // other.
      const bool is_regular = placed.regularity == Status::ok;
      const Scalar gap = Own::gap(placed);
      const bool holds = is_regular && gap <= redundancy_slack(Scalar(1), Status::ok);
      const bool may_hold =
          !is_regular || gap <= redundancy_slack(Scalar(1), Status::near_singular);
      Placed settled = placed;
      if (may_hold && ((holds && Solver::order == 0) || Own::settle(settled)) &&
          Own::keeps_limits(settled)) {
        keep(holds ? placed : settled, placed);
      } else {
        ++solution_.left_out;
      }
    } else {
      if constexpr (Own::has_limits) {
        if (!Own::keeps_limits(placed)) {
          ++solution_.left_out;
          // Nearly singular groups may be placed far from where the redundant constraints hold.
          is_unsure_ = is_unsure_ || (Own::has_redundant && placed.regularity != Status::ok);
          return;
        }
      }
      keep(placed, placed);
    }
  }
  /// Lists a configuration. The residual of redundant constraints is that of the placement by the
  /// groups alone.
  void keep(const Placed& placed, const Placed& by_groups) {
    const auto slot = static_cast<std::size_t>(solution_.count++);
    if (is_moderate_ && !Own::has_own_rates) {
      Own::list_moderate(placed, states_[slot]);
    } else {
      Own::list(placed, states_[slot]);
    }
    if constexpr (has_parameters<Solver>) {
      if (!are_places_finite(states_[slot])) {
        solution_.status = AssemblyStatus::not_finite;
      }
    }
    Own::key(placed, keys_[slot]);
    if constexpr (Own::has_gaps) {
      gaps_[slot] = Own::gap(by_groups);
      first_directions_[slot] = Own::first_direction(placed);
    }
    if constexpr (Keeps) {
      kept_[slot] = current_;
    }
  }
  template <std::size_t Place>
  [[gnu::noinline, gnu::flatten]] void descend_apart(Placed& placed, Loose loose) {
    descend<Place>(placed, loose);
  }

  /// Searches each configuration of a group, and the groups after it.
  template <std::size_t Place>
  void descend(Placed& placed, Loose loose) {
    using Group = std::tuple_element_t<Place, Groups>;
    constexpr Set itself = Set{1} << Place;
    if ((Own::holders[Place] & loose.all) != 0) {
      loose.all |= itself;
      proceed<Place + 1>(placed, loose);
      return;
    }
    HeldJoints<Group, Scalar, Solver::order, Solver::parameter_count> held;
    Own::hold(placed, held);
    // If float does not determine a group's configurations, the caller of the whole search decides
    // what to do: after rounded groups double would not determine them either.
    const auto found =
        assemblies<Specialised<Group>, Scalar, Unresolved::refuse>({}, held.u, held.displaced);
    if (found.status != AssemblyStatus::ok && found.status != AssemblyStatus::degenerate) {
      solution_.status = found.status;
      return;
    }
    solution_.complete = solution_.complete && found.complete;
    const Status before = placed.regularity;
    is_unsure_ = is_unsure_ || (Own::has_redundant && found.count == 0 && before != Status::ok);
    if (found.mobility > 0) {
      mobilities_[Place] = found.mobility;
      proceed<Place + 1>(placed, {loose.moving | itself, loose.all | itself});
    }
    for (int index = 0; index < found.count; ++index) {
      const auto group = place_group(held, detail::entry(found.configurations, index),
                                     detail::entry(found.regularity, index));
      placed.regularity = group.regularity == Status::ok ? before : Status::near_singular;
      Own::place(group, placed);
      if constexpr (Keeps) {
        std::get<Place>(current_) = group.q;
      }
      choices_[Place] = static_cast<std::size_t>(index);
      proceed<Place + 1>(placed, loose);
      if (solution_.status != AssemblyStatus::ok) {
        return;
      }
    }
  }

  /// Counts the families of moving groups while all others are assembled, each once for each
  /// combination of configurations of the groups that hold it.
  void count_families(Set moving) {
    for (std::size_t group = 0; group < group_count; ++group) {
      if ((moving >> group & 1U) == 0) {
        continue;
      }
      const std::size_t choice = choice_of_holders(Own::holders[group]);
      Set& counted = counted_[group][choice / 64];
      const Set bit = Set{1} << choice % 64;
      if ((counted & bit) == 0) {
        counted |= bit;
        ++solution_.families;
        solution_.mobility = (std::max)(solution_.mobility, mobilities_[group]);
      }
    }
  }
  /// An index for the combination of configurations of the groups in a set.
  [[nodiscard]] std::size_t choice_of_holders(Set holders) const {
    std::size_t choice = 0;
    for (std::size_t group = 0; group < group_count; ++group) {
      choice = choice * most_choices[group] + ((holders >> group & 1U) != 0 ? choices_[group] : 0);
    }
    return choice;
  }
  template <typename Tuple>
  struct MostChoices;
  template <typename... Group>
  struct MostChoices<std::tuple<Group...>> {
    static constexpr std::array<std::size_t, group_count> value = {
        static_cast<std::size_t>(Group::max_configurations)...};
  };
  static constexpr std::array<std::size_t, group_count> most_choices = MostChoices<Groups>::value;

  States& states_;
  std::array<typename Own::Key, capacity> keys_;
  Solution solution_;
  /// Whether nearly singular groups were followed by one without a configuration, or by redundant
  /// constraints that do not hold.
  bool is_unsure_ = false;
  bool is_moderate_ = false;  ///< whether all arguments are below `moderate`
  Configurations current_;
  std::array<std::size_t, group_count> choices_{};  ///< the indices of the groups' configurations
  std::array<int, group_count> mobilities_{};       ///< of groups that move
  std::array<std::array<Set, capacity / 64 + 1>, group_count> counted_{};  ///< families
  std::array<Configurations, Keeps ? capacity : 0> kept_;
  std::array<Scalar, Own::has_gaps ? capacity : 0> gaps_;
  std::array<Direction<Scalar>, Own::has_gaps ? capacity : 0> first_directions_;
};

}  // namespace assur::support
