// The closures of all groups of an emitted solver while its arguments go along a straight way.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/branch_step.hpp>
#include <assur/detail/pivots.hpp>
#include <assur/detail/products.hpp>
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
  static constexpr int pivots = (0 + ... + Group::pivot_count);
};

/// A group on a branch: where it is held and stands, and J^-1 there.
template <typename Group, typename Scalar>
struct GroupPoint {
  typename Group::template Inputs<Scalar> u;
  typename Group::template Configuration<Scalar> q;
  Matrix<Scalar, Group::unknown_count, Group::equation_count> inverse;
  Vector<Scalar, Group::pivot_count> pivots;  ///< J is singular where one vanishes
};

template <typename Groups, typename Scalar>
struct GroupPoints;
template <typename... Group, typename Scalar>
struct GroupPoints<std::tuple<Group...>, Scalar> {
  using Type = std::tuple<GroupPoint<Group, Scalar>...>;
};

/// What holds each group.
template <typename Groups, typename Scalar>
struct GroupInputs;
template <typename... Group, typename Scalar>
struct GroupInputs<std::tuple<Group...>, Scalar> {
  using Type = std::tuple<typename Group::template Inputs<Scalar>...>;
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
  static constexpr int pivots = GroupSizes<Groups>::pivots;
  static constexpr int most_corank = static_cast<int>(std::tuple_size_v<Groups>);
  using Open = Vector<Scalar, rows>;
  using Step = Vector<Scalar, unknowns + 1>;
  /// The configurations of the groups, and the part of the way that the arguments have gone.
  struct Point {
    Configurations q;
    Scalar part = 0;
  };

  /// `speed` is how much of what holds the groups changes along the whole way.
  ClosuresOnWay(const Given& from, const Given& to, Scalar speed)
      : from_(from), to_(to), speed_(speed) {}

  /// Where the groups are held where the arguments have gone a part of the way, by how much they
  /// miss there, and where they are.
  struct Place {
    typename GroupInputs<Groups, Scalar>::Type u;
    Configurations q;
    Open misses;
  };
  using Points = typename GroupPoints<Groups, Scalar>::Type;

  /// Places the groups in given configurations, or, if there are points that have these, as far
  /// from them as their J^-1 tells.
  [[gnu::noinline]] void place(Scalar part, const Configurations& q, const Points* points,
                               Place& place) const {
    Placed placed;
    Own::drive(Own::between(from_, to_, part), placed);
    place.q = q;
    place_from<0>(points, placed, place);
  }
  [[nodiscard]] Open misses(const Point& point) const {
    Place there;
    place(point.part, point.q, nullptr, there);
    return there.misses;
  }
  void move(const Step& step, Point& point) const {
    move_groups(step, point.q);
    point.part += step(unknowns) / speed_;
  }
  [[nodiscard]] Scalar rounding(const Point& point) const {
    Place there;
    place(point.part, point.q, nullptr, there);
    Scalar longest = 1;
    each_group([&](auto group) {
      longest = (std::max)(longest, longest_length(std::get<group>(there.u)));
    });
    return 4 * std::numeric_limits<Scalar>::epsilon() * longest;
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
  template <std::size_t Index>
  static void place_from(const Points* points, Placed& placed, Place& place) {
    if constexpr (Index < std::tuple_size_v<Groups>) {
      using Group = std::tuple_element_t<Index, Groups>;
      Held<Group> held;
      Own::hold(placed, held);
      std::get<Index>(place.u) = held.u;
      PlacedGroup<Group, Scalar, Solver::order, Solver::parameter_count> group;
      group.q = std::get<Index>(place.q);
      Vector<Scalar, Group::equation_count> f;
      Group::residual(held.u, group.q, f);
      place.misses.template segment<Group::equation_count>(first_equation<Index>()) = f;
      if (points != nullptr) {
        detail::move_slightly<Specialised<Group>, Scalar>(
            group.q, -detail::product(std::get<Index>(*points).inverse, f));
        std::get<Index>(place.q) = group.q;
      }
      place_links(held, group);
      Own::place(group, placed);
      place_from<Index + 1>(points, placed, place);
    }
  }

  const Given& from_;
  const Given& to_;
  Scalar speed_;
};

}  // namespace assur::support
