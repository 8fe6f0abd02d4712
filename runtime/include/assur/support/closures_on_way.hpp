// The closures of all groups of an emitted solver while its arguments go along a straight way.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/pivots.hpp>
#include <assur/local/singular_point.hpp>
#include <assur/support/placed_group.hpp>
#include <assur/support/scene_access.hpp>
#include <assur/support/scene_search.hpp>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <type_traits>

namespace assur::support {

template <typename Groups>
struct GroupSizes;
template <typename... Group>
struct GroupSizes<std::tuple<Group...>> {
  static constexpr int unknowns = (0 + ... + Group::unknown_count);
  static constexpr int equations = (0 + ... + Group::equation_count);
};

/// For each group a set of pivots.
template <typename Groups>
using PivotSets = std::array<detail::PivotSet, std::tuple_size_v<Groups>>;

/// A `local::System`: each group's closures, in its unit, in the order in which groups are placed.
/// They hold what is placed by the groups before them, closed or not.
template <typename Solver, typename Scalar_>
class ClosuresOnWay {
  using Own = Access<Solver, Scalar_>;
  using Given = typename Own::Given;
  using Placed = typename Own::Placed;
  template <typename Group>
  using Held = HeldJoints<Group, Scalar_, Solver::order, Solver::parameter_count>;

 public:
  using Scalar = Scalar_;
  using Groups = typename Own::Groups;
  using Configurations = typename GroupConfigurations<Groups, Scalar>::Type;
  static constexpr int rows = GroupSizes<Groups>::equations;
  static constexpr int unknowns = GroupSizes<Groups>::unknowns;
  static constexpr int most_corank = static_cast<int>(std::tuple_size_v<Groups>);
  using Open = Vector<Scalar, rows>;
  using Step = Vector<Scalar, unknowns + 1>;
  /// The configurations of the groups, and the part of the way that the arguments have gone.
  struct Point {
    Configurations q;
    Scalar part;
  };

  /// `speed` is how much of what holds the groups changes along the whole way.
  ClosuresOnWay(const Given& from, const Given& to, Scalar speed)
      : from_(from), to_(to), speed_(speed) {}

  [[nodiscard]] Open misses(const Point& point) const {
    Open all;
    walk(point.part, [&](auto place, const auto& held) {
      using Group = std::tuple_element_t<place, Groups>;
      const auto& q = std::get<place>(point.q);
      Vector<Scalar, Group::equation_count> f;
      Group::residual(held.u, q, f);
      all.template segment<Group::equation_count>(first_equation<place>()) = f;
      return q;
    });
    return all;
  }
  void move(const Step& step, Point& point) const {
    move_groups(step, point.q);
    point.part += step(unknowns) / speed_;
  }
  [[nodiscard]] Scalar rounding(const Point& point) const {
    Scalar longest = 1;
    walk(point.part, [&](auto place, const auto& held) {
      longest = (std::max)(longest, longest_length(held.u));
      return std::get<place>(point.q);
    });
    return 4 * std::numeric_limits<Scalar>::epsilon() * longest;
  }

  /// Places the groups where the arguments have gone a part of the way: each one in the
  /// configuration that `configure(place, held)` returns, by its place and what holds it.
  template <typename Configure>
  void walk(Scalar part, const Configure& configure) const {
    Placed placed;
    Own::drive(Own::between(from_, to_, part), placed);
    walk_from<0>(placed, configure);
  }
  /// Turns and shifts the unknowns of all groups, by the first entries of a step.
  static void move_groups(const Step& step, Configurations& q) {
    each_group([&](auto place) {
      using Group = std::tuple_element_t<place, Groups>;
      advance(std::get<place>(q),
              Vector<Scalar, Group::unknown_count>(
                  step.template segment<Group::unknown_count>(first_unknown<place>())));
    });
  }
  /// The step from some configurations to others. Its last entry is zero.
  [[nodiscard]] static Step step_between(const Configurations& from, const Configurations& to) {
    Step step = Step::Zero();
    int index = 0;
    each_group([&](auto place) {
      for_each_pair(std::get<place>(from), std::get<place>(to),
                    [&](const auto& one, const auto& other) {
                      step(index++) = detail::step_between(one, other);
                    });
    });
    return step;
  }
  template <typename Use>
  static void each_group(const Use& use) {
    each_group_from<0>(use);
  }

 private:
  template <std::size_t Place, typename Use>
  static void each_group_from(const Use& use) {
    if constexpr (Place < std::tuple_size_v<Groups>) {
      use(std::integral_constant<std::size_t, Place>());
      each_group_from<Place + 1>(use);
    }
  }
  template <std::size_t Place>
  static constexpr int first_unknown() {
    if constexpr (Place == 0) {
      return 0;
    } else {
      return first_unknown<Place - 1>() + std::tuple_element_t<Place - 1, Groups>::unknown_count;
    }
  }
  template <std::size_t Place>
  static constexpr int first_equation() {
    if constexpr (Place == 0) {
      return 0;
    } else {
      return first_equation<Place - 1>() + std::tuple_element_t<Place - 1, Groups>::equation_count;
    }
  }
  template <std::size_t Place, typename Configure>
  static void walk_from(Placed& placed, const Configure& configure) {
    if constexpr (Place < std::tuple_size_v<Groups>) {
      using Group = std::tuple_element_t<Place, Groups>;
      Held<Group> held;
      Own::hold(placed, held);
      PlacedGroup<Group, Scalar, Solver::order, Solver::parameter_count> group;
      group.q = configure(std::integral_constant<std::size_t, Place>(), held);
      place_links(held, group);
      Own::place(group, placed);
      walk_from<Place + 1>(placed, configure);
    }
  }

  const Given& from_;
  const Given& to_;
  Scalar speed_;
};

}  // namespace assur::support
