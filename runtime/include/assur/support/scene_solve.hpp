// Configurations of an emitted solver from its arguments, in double if float does not determine
// them.
#pragma once

#include <array>
#include <assur/detail/second_look.hpp>
#include <assur/detail/wider.hpp>
#include <assur/support/scene_search.hpp>
#include <cstddef>
#include <tuple>
#include <type_traits>

namespace assur::support {

/// Whether double is used if a scalar does not determine the configurations.
template <Unresolved unresolved, typename Scalar>
inline constexpr bool asks_double =
    unresolved == Unresolved::ask_double && !std::is_same_v<Scalar, double>;

/// Solves in double for arguments in another scalar: the scene's own numbers have all their digits,
/// and the arguments count as exact.
template <typename Solver, typename Scalar>
class InDouble {
  using Own = Access<Solver, Scalar>;
  using Groups = typename Own::Groups;
  using Wide = Search<Solver, double, true>;

 public:
  using Configurations = typename GroupConfigurations<Groups, Scalar>::Type;

  explicit InDouble(const typename Own::Given& given) : search_(states_) {
    solution_ = search_.run(widened(given));
  }

  [[nodiscard]] const typename Solver::Solution& solution() const { return solution_; }
  /// The rounded configurations of the groups in a configuration of the mechanism, by its index
  /// from 0.
  [[nodiscard]] Configurations rounded(int configuration) const {
    Configurations result;
    round<0>(search_.kept(configuration), result);
    return result;
  }

 private:
  [[nodiscard]] static typename Access<Solver, double>::Given widened(typename Own::Given given) {
    typename Access<Solver, double>::Given result;
    const auto copy = [](const auto& to, const auto& from) {
      for (std::size_t index = 0; index < to.size(); ++index) {
        *to[index] = static_cast<double>(*from[index]);
      }
    };
    copy(result.positions(), given.positions());
    if constexpr (Solver::order > 0) {
      copy(Access<Solver, double>::drivers_of(result).rates(), Own::drivers_of(given).rates());
    }
    return result;
  }
  template <std::size_t Place, typename From>
  static void round(const From& from, Configurations& to) {
    if constexpr (Place < std::tuple_size_v<Groups>) {
      auto& q = std::get<Place>(to);
      q = detail::narrowed<std::decay_t<decltype(q)>>(std::get<Place>(from));
      round<Place + 1>(from, to);
    }
  }

  typename Wide::States states_;
  Wide search_;
  typename Solver::Solution solution_;
};

/// The regularity of a group in its present configuration, by its pivots.
template <typename Group, typename Scalar>
[[nodiscard]] Status regularity_of_group(const typename Group::template Inputs<Scalar>& u,
                                         const typename Group::template Configuration<Scalar>& q) {
  using Model = Specialised<Group>;
  const typename Model::template Dimensions<Scalar> d;
  return detail::regularity_at<Model, Scalar>(detail::pivots_at<Model, Scalar>(d, u, q), d, u, q)
      .status;
}

/// Places the groups from `Place` on in known configurations.
template <typename Solver, typename Scalar, std::size_t Place, typename Configurations,
          typename Placed>
void place_known(const Configurations& known, Placed& placed) {
  using Own = Access<Solver, Scalar>;
  using Groups = typename Own::Groups;
  if constexpr (Place < std::tuple_size_v<Groups>) {
    using Group = std::tuple_element_t<Place, Groups>;
    HeldJoints<Group, Scalar, Solver::order, Solver::parameter_count> held;
    Own::hold(placed, held);
    const auto& q = std::get<Place>(known);
    const Status status = regularity_of_group<Group, Scalar>(held.u, q);
    const auto group =
        place_group(held, q, status == Status::ok ? Status::ok : Status::near_singular);
    if (group.regularity != Status::ok) {
      placed.regularity = Status::near_singular;
    }
    Own::place(group, placed);
    place_known<Solver, Scalar, Place + 1>(known, placed);
  }
}

/// Fills the states of another scalar with all configurations found in double: those of the groups
/// are rounded, and everything else is computed in that scalar, including the verdicts.
template <typename Solver, typename Scalar>
[[nodiscard, gnu::noinline, gnu::cold]] typename Solver::Solution solve_in_double(
    const typename Access<Solver, Scalar>::Given& given,
    typename Search<Solver, Scalar>::States& states) {
  using Own = Access<Solver, Scalar>;
  const InDouble<Solver, Scalar> wide(given);
  for (int index = 0; index < wide.solution().count; ++index) {
    typename Own::Placed placed;
    Own::drive(given, placed);
    place_known<Solver, Scalar, 0>(wide.rounded(index), placed);
    if constexpr (Own::settles) {
      if (placed.regularity != Status::ok) {
        (void)Own::settle(placed);  // it has already settled in double
      }
    }
    Own::list(placed, detail::entry(states, index));
  }
  return wide.solution();
}

/// All configurations within the joint limits, in the order of `assur solve`.
template <typename Solver, Unresolved unresolved, typename Scalar>
[[nodiscard]] typename Solver::Solution solve(
    const typename Access<Solver, Scalar>::Given& given,
    std::array<typename Solver::template State<Scalar>,
               static_cast<std::size_t>(Solver::max_configurations)>& states) {
  auto solution = Search<Solver, Scalar>(states).run(given);
  if constexpr (asks_double<unresolved, Scalar>) {
    if (solution.status == AssemblyStatus::unresolved) {
      solution = solve_in_double<Solver, Scalar>(given, states);
    }
  }
  return solution;
}

/// Finds the configurations of the groups in one configuration of the mechanism, by its index from
/// 0; they are set if that configuration exists.
template <Unresolved unresolved, typename Solver, typename Scalar>
[[nodiscard]] typename Solver::Solution choose(
    const typename Access<Solver, Scalar>::Given& given, int configuration,
    typename GroupConfigurations<typename Access<Solver, Scalar>::Groups, Scalar>::Type& chosen) {
  typename Search<Solver, Scalar>::States states;
  Search<Solver, Scalar, true> search(states);
  const auto solution = search.run(given);
  if constexpr (asks_double<unresolved, Scalar>) {
    if (solution.status == AssemblyStatus::unresolved) {
      const InDouble<Solver, Scalar> wide(given);
      if (configuration >= 0 && configuration < wide.solution().count) {
        chosen = wide.rounded(configuration);
      }
      return wide.solution();
    }
  }
  if (configuration >= 0 && configuration < solution.count) {
    chosen = search.kept(configuration);
  }
  return solution;
}

}  // namespace assur::support
