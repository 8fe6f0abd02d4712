// The closures of all groups of an emitted solver on a straight path of its arguments.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/branch_step.hpp>
#include <assur/detail/pivots.hpp>
#include <assur/detail/products.hpp>
#include <assur/local/singular_point.hpp>
#include <assur/support/placed_group.hpp>
#include <assur/support/scene_access.hpp>
#include <assur/support/scene_branch.hpp>
#include <assur/support/scene_search.hpp>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <type_traits>

namespace assur::support {

/// The sizes of the groups, in the order in which they are solved.
template <typename Groups>
struct GroupSizes;
template <typename... Group>
struct GroupSizes<std::tuple<Group...>> {
  static constexpr std::array<int, sizeof...(Group)> unknowns{Group::unknown_count...};
  static constexpr std::array<int, sizeof...(Group)> equations{Group::equation_count...};
  static constexpr std::array<int, sizeof...(Group)> pivots{Group::pivot_count...};
  static constexpr std::size_t count = sizeof...(Group);

  /// The sum of the sizes of the groups before `place`.
  [[nodiscard]] static constexpr int before(const std::array<int, count>& sizes,
                                            std::size_t place) {
    int sum = 0;
    for (std::size_t group = 0; group < place; ++group) {
      sum += sizes[group];
    }
    return sum;
  }
  [[nodiscard]] static constexpr int all(const std::array<int, count>& sizes) {
    return before(sizes, count);
  }
};

/// The inputs of each group.
template <typename Groups, typename Scalar>
struct GroupInputs;
template <typename... Group, typename Scalar>
struct GroupInputs<std::tuple<Group...>, Scalar> {
  using Type = std::tuple<typename Group::template Inputs<Scalar>...>;
};

/// A set of pivots for each group.
template <typename Groups>
using PivotSets = std::array<detail::PivotSet, std::tuple_size_v<Groups>>;

/// A `local::System`: each group's closures, in its unit, in the order in which groups are placed.
/// A group's inputs follow from the groups before it, whether these are closed or not.
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
  using Sizes = GroupSizes<Groups>;
  static constexpr int rows = Sizes::all(Sizes::equations);
  static constexpr int unknowns = Sizes::all(Sizes::unknowns);
  static constexpr int pivots = Sizes::all(Sizes::pivots);
  static constexpr int most_corank = unknowns / 2;
  [[nodiscard]] static constexpr int row_count() { return rows; }
  [[nodiscard]] static constexpr int unknown_count() { return unknowns; }
  using Open = Vector<Scalar, rows>;
  using Step = Vector<Scalar, unknowns + 1>;
  /// The configurations of the groups, and the fraction of the path that the arguments have
  /// covered.
  struct Point {
    Configurations q;
    Scalar part = 0;
  };

  /// `speed` is the change of the groups' inputs along the whole path.
  ClosuresOnWay(const Given& from, const Given& to, Scalar speed)
      : from_(from), to_(to), speed_(speed) {}

  /// The groups' inputs at a fraction of the path, the residuals of their closures, and their
  /// configurations.
  using Inputs = typename GroupInputs<Groups, Scalar>::Type;
  struct Place {
    Inputs u;
    Configurations q;
    // Unaligned, for compilers keep Eigen's check of the alignment, which may end the program.
    Eigen::Matrix<Scalar, rows, 1, Eigen::DontAlign> misses;
  };
  using Points = typename GroupPoints<Groups, Scalar>::Type;

  /// Places the groups in given configurations, or, if points with these configurations are given,
  /// corrected linearly by their J^-1.
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
  /// The residual due to rounding: four roundings of the longest length.
  [[nodiscard]] Scalar rounding(const Point& point) const {
    Place there;
    place(point.part, point.q, nullptr, there);
    Scalar longest = 1;
    each_group([&](auto group) {
      longest = (std::max)(longest, longest_length(std::get<group>(there.u)));
    });
    return 4 * std::numeric_limits<Scalar>::epsilon() * longest;
  }
  /// Adds the first entries of a step to the unknowns of all groups.
  static void move_groups(const Step& step, Configurations& q) {
    each_group([&](auto place) {
      using Group = std::tuple_element_t<place, Groups>;
      advance(std::get<place>(q),
              Vector<Scalar, Group::unknown_count>(step.template segment<Group::unknown_count>(
                  Sizes::before(Sizes::unknowns, place))));
    });
  }
  /// The step between two sets of configurations. Its last entry is zero.
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
  [[nodiscard]] static Configurations configurations_of(const Points& points) {
    Configurations q;
    each_group([&](auto place) { std::get<place>(q) = std::get<place>(points).q; });
    return q;
  }
  /// The largest difference between the groups' inputs and those at given points.
  [[nodiscard]] static Scalar largest_difference(const Points& points, const Inputs& inputs) {
    Scalar largest = 0;
    each_group([&](auto place) {
      largest = (std::max)(largest, detail::largest_difference<Scalar>(std::get<place>(points).u,
                                                                       std::get<place>(inputs)));
    });
    return largest;
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
      place.misses.template segment<Group::equation_count>(Sizes::before(Sizes::equations, Index)) =
          f;
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
