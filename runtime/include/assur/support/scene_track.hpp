// Follows a branch of an emitted solver to where the drivers stand elsewhere. Solvers include this
// for all that they call, batches too.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/branch_step.hpp>
#include <assur/detail/products.hpp>
#include <assur/support/scene_batch.hpp>
#include <assur/support/scene_solve.hpp>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace assur::support {

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

/// The place to which a branch of an emitted solver has been followed.
template <typename Solver, typename Scalar = double>
struct Branch {
  typename Access<Solver, Scalar>::Given given;
  typename GroupPoints<typename Access<Solver, Scalar>::Groups, Scalar>::Type groups;
  /// ok or near_singular; with any other status nothing can be followed from here. singular also
  /// where velocities are not known: the branch may be any of those that meet there.
  Status status = Status::singular;
};

/// How far a branch was followed.
struct Track {
  /// ok, or near_singular: at the end of the way. no_convergence: within 0.2% of the way from
  /// `reached` the branch ends or comes too close to another, or a driver turns by more than 2000
  /// radians. not_finite: a driver is. Or the status of a branch that cannot be followed.
  Status status = Status::singular;
  double reached = 0;  ///< the part of the way to the last point that is certainly of the branch
};

/// The same for the solver of a scene with limits: a branch is followed through them and back.
struct LimitedTrack : Track {
  bool within_limits = false;  ///< whether the state, where it was filled, keeps them
};

/// Follows branches of an emitted solver without rates. A step is taken for one of the same branch
/// where Newton's steps contract, no pivot changes its sign or goes to zero from both ends, and the
/// linear predictions from both ends agree with the way; otherwise it is halved.
template <typename Solver, typename Scalar>
class Tracker {
  using Branch = support::Branch<Solver, Scalar>;
  using State = typename Solver::template State<Scalar>;
  using Own = Access<Solver, Scalar>;
  using Given = typename Own::Given;
  using Groups = typename Own::Groups;
  using Placed = typename Own::Placed;
  using Track = typename Solver::Track;

 public:
  /// The branch of a configuration, by its number in the solver's list, from 0; no_convergence
  /// where no configuration has that number, or where float does not determine them.
  template <Unresolved unresolved>
  static Branch begin(const Given& given, int configuration) {
    Branch branch;
    branch.given = given;
    typename GroupConfigurations<Groups, Scalar>::Type chosen;
    const auto solution = choose<unresolved, Solver, Scalar>(given, configuration, chosen);
    if (solution.status == AssemblyStatus::not_finite) {
      branch.status = Status::not_finite;
    } else if (solution.status == AssemblyStatus::unsound_arithmetic) {
      branch.status = Status::unsound_arithmetic;
    } else if (configuration < 0 || configuration >= solution.count) {
      branch.status = Status::no_convergence;
    } else {
      Placed placed;
      Own::drive(given, placed);
      branch.status = Status::ok;
      settle<0>(chosen, branch, placed);
    }
    return branch;
  }

  /// Follows a branch to where the drivers stand at `to`, and fills the state there. The state is
  /// not changed where the branch is not followed to the end.
  [[nodiscard]] static Track run(const Given& to, Branch& branch, State& state) {
    Track way;
    way.status = branch.status;
    if (!is_solvable(branch.status)) {
      return way;
    }
    if (!Own::is_finite(to)) {
      way.status = Status::not_finite;
      return way;
    }
    const Scalar turn = largest_turn(branch.given, to);
    const bool moves_by_formulas = Own::has_laws || Own::parameters_differ(branch.given, to);
    // No driver turns by more than a radian: after a full turn the groups are held as before.
    const Scalar widest = 1 / (std::max)(turn, Scalar(1));
    std::array<Branch, 2> ends;
    const Branch* start = &branch;
    Scalar reached = 0;
    for (Scalar width = widest; reached < 1;) {
      if (!(width > detail::StepLimits<Scalar>().shortest)) {
        way.status = Status::no_convergence;
        return way;
      }
      const Scalar next = (std::min)(reached + width, Scalar(1));
      Branch& end = start == ends.data() ? ends[1] : ends[0];
      end.given = next < 1 ? between(branch.given, to, next) : to;
      Placed placed;
      Own::drive(end.given, placed);
      end.status = Status::ok;
      StepSize size{turn * (next - reached), !moves_by_formulas};
      if (!step<0>(*start, end, placed, size) ||
          (!size.is_small && may_pass_singularity(*start, end))) {
        width = (next - reached) / 2;
        continue;
      }
      start = &end;
      width = (std::min)(2 * (next - reached), widest);
      reached = next;
      way.reached = next;
      if (next == 1) {
        placed.regularity = end.status;
        Own::list(placed, state);
        if constexpr (Own::has_limits) {
          way.within_limits = Own::keeps_limits(placed);
        }
      }
    }
    branch = *start;
    way.status = branch.status;
    return way;
  }

 private:
  [[nodiscard]] static Given between(Given from, const Given& to, Scalar part) {
    Given result = to;
    const auto starts = from.positions();
    const auto positions = result.positions();
    for (std::size_t index = 0; index < positions.size(); ++index) {
      *positions[index] = *starts[index] + part * (*positions[index] - *starts[index]);
    }
    return result;
  }
  /// The largest turn of a driver.
  [[nodiscard]] static Scalar largest_turn(Given from, Given to) {
    const auto starts = from.positions();
    const auto ends = to.positions();
    Scalar turn = 0;
    for (std::size_t index = 0; index < Own::turning_drivers; ++index) {
      turn = (std::max)(turn, std::abs(*ends[index] - *starts[index]));
    }
    return turn;
  }

  template <typename Group>
  using Held = HeldJoints<Group, Scalar, Solver::order, Solver::parameter_count>;

  /// How regular a group is; singular where it is not known on which branch it is.
  template <typename Group>
  [[nodiscard]] static Status look(const GroupPoint<Group, Scalar>& point,
                                   const detail::Pivots<Specialised<Group>, Scalar>& pivots) {
    using Model = Specialised<Group>;
    const typename Model::template Dimensions<Scalar> d;
    const auto regularity = detail::regularity_at<Model, Scalar>(pivots, d, point.u, point.q);
    return regularity.knows_velocities() ? regularity.status : Status::singular;
  }

  /// Places a group on the way, and counts its regularity. False where the groups before it are so
  /// far displaced by rounding that it is not known on which branch the group is.
  template <typename Group>
  [[nodiscard]] static bool place(const Held<Group>& held, const GroupPoint<Group, Scalar>& point,
                                  Status status, Branch& branch, Placed& placed) {
    const auto group = place_group(held, point.q, status);
    if (group.regularity != Status::ok) {
      if (!are_derivatives_known(held, point.q)) {
        return false;
      }
      branch.status = group.regularity;
    }
    Own::place(group, placed);
    return true;
  }

  template <std::size_t Place, typename Configurations>
  static void settle(const Configurations& found, Branch& branch, Placed& placed) {
    if constexpr (Place < std::tuple_size_v<Groups>) {
      using Group = std::tuple_element_t<Place, Groups>;
      using Model = Specialised<Group>;
      GroupPoint<Group, Scalar>& point = std::get<Place>(branch.groups);
      Held<Group> held;
      Own::hold(placed, held);
      point.u = held.u;
      point.q = std::get<Place>(found);
      Model::inverse_jacobian(typename Model::template Dimensions<Scalar>(), point.u, point.q,
                              point.inverse);
      const auto pivots = detail::pivots_at<Model, Scalar>(
          typename Model::template Dimensions<Scalar>(), point.u, point.q);
      point.pivots = pivots.values;
      const Status status = look(point, pivots);
      if (!is_solvable(status)) {
        branch.status = status;
        return;
      }
      if (!place(held, point, status, branch, placed)) {
        branch.status = Status::singular;
        return;
      }
      settle<Place + 1>(found, branch, placed);
    }
  }

  /// How far a step goes.
  struct StepSize {
    Scalar turn;    ///< the largest of a driver or of a group that is placed, radians
    bool is_small;  ///< so that no pivot can vanish within twice the step; not known of formulas
  };

  /// Steps the groups from `Place` on; false where one refuses the step.
  template <std::size_t Place>
  [[nodiscard]] static bool step(const Branch& start, Branch& end, Placed& placed, StepSize& size) {
    if constexpr (Place == std::tuple_size_v<Groups>) {
      return true;
    } else {
      using Group = std::tuple_element_t<Place, Groups>;
      GroupPoint<Group, Scalar>& point = std::get<Place>(end.groups);
      Held<Group> held;
      Own::hold(placed, held);
      point.u = held.u;
      const Status status = advance(std::get<Place>(start.groups), point, size);
      return is_solvable(status) && place(held, point, status, end, placed) &&
             step<Place + 1>(start, end, placed, size);
    }
  }

  /// For each group the pivots that may vanish within twice a step.
  using PivotSets = std::array<detail::PivotSet, std::tuple_size_v<Groups>>;

  /// Whether a pivot may vanish as seen from both ends of a step: then the step may have passed
  /// over a crossing of branches to the one whose pivots have the same signs, or over a gap in
  /// which nothing can be assembled.
  [[nodiscard, gnu::noinline]] static bool may_pass_singularity(const Branch& start,
                                                                const Branch& end) {
    Scalar largest = 0;
    std::apply(
        [&](const auto&... one) {
          std::apply(
              [&](const auto&... other) {
                largest =
                    (std::max)({largest, detail::largest_difference<Scalar>(one.u, other.u)...});
              },
              end.groups);
        },
        start.groups);
    const Scalar part = (std::min)(numeric::half_of_digits<Scalar> / largest, Scalar(0.5));
    const PivotSets ahead = vanishing(start, end, part);
    if (ahead == PivotSets{}) {
      return false;
    }
    const PivotSets behind = vanishing(end, start, part);
    bool meet = false;
    for (std::size_t group = 0; group < ahead.size(); ++group) {
      meet = meet || (ahead[group] & behind[group]) != 0;
    }
    return meet;
  }
  /// The drivers go by a part of the way, which moves what holds the groups by half of its digits.
  [[nodiscard]] static PivotSets vanishing(const Branch& from, const Branch& to, Scalar part) {
    PivotSets sets{};
    Placed beside;
    Own::drive(between(from.given, to.given, part), beside);
    find_vanishing<0>(from, to, part, beside, sets);
    return sets;
  }
  template <std::size_t Place>
  static void find_vanishing(const Branch& from, const Branch& to, Scalar part, Placed& beside,
                             PivotSets& sets) {
    if constexpr (Place < std::tuple_size_v<Groups>) {
      using Group = std::tuple_element_t<Place, Groups>;
      using Model = Specialised<Group>;
      const GroupPoint<Group, Scalar>& point = std::get<Place>(from.groups);
      Held<Group> held;
      Own::hold(beside, held);
      Vector<Scalar, Group::equation_count> f;
      Group::residual(held.u, point.q, f);
      PlacedGroup<Group, Scalar, Solver::order, Solver::parameter_count> group;
      group.q = point.q;
      detail::move_slightly<Model, Scalar>(group.q, -detail::product(point.inverse, f));
      const typename Model::template Dimensions<Scalar> d;
      sets[Place] = detail::pivots_that_may_vanish<Scalar>(
          point.u, held.u, std::get<Place>(to.groups).u, point.pivots,
          detail::pivots_at<Model, Scalar>(d, held.u, group.q).values, part);
      place_links(held, group);
      Own::place(group, beside);
      find_vanishing<Place + 1>(from, to, part, beside, sets);
    }
  }

  /// Newton's steps from the linear prediction of the start. The regularity at their end, or
  /// no_convergence where that may lie on another branch.
  template <typename Group>
  [[nodiscard]] static Status advance(const GroupPoint<Group, Scalar>& start,
                                      GroupPoint<Group, Scalar>& end, StepSize& size) {
    using Model = Specialised<Group>;
    using Unknowns = Vector<Scalar, Group::unknown_count>;
    constexpr Scalar inverse_size = 1;  // the group's lengths are near one
    const typename Model::template Dimensions<Scalar> d;
    Vector<Scalar, Group::equation_count> f;
    Group::residual(end.u, start.q, f);
    const Unknowns predicted = -detail::product(start.inverse, f);
    Unknowns way;
    end.q = start.q;
    if (!detail::predict_and_correct<Model, Scalar>(d, end.u, inverse_size, predicted, end.q, way,
                                                    end.inverse)) {
      return Status::no_convergence;
    }
    const auto pivots = detail::pivots_at<Model, Scalar>(d, end.u, end.q);
    end.pivots = pivots.values;
    // What holds the group moves in arcs, of which the prediction knows the chord alone: the arc
    // begins up to half a turn off it.
    const Scalar turn = detail::turn_of<Model, Scalar>(predicted, inverse_size);
    const Scalar held =
        size.turn * (std::max)(detail::largest_difference<Scalar>(start.u, end.u), size.turn);
    const Scalar bend = start.inverse.cwiseAbs().sum() * (held + turn * turn);
    size.is_small = size.is_small && detail::keep_their_signs<Model, Scalar>(start.pivots, pivots,
                                                                             turn + bend, bend);
    size.turn = (std::max)(size.turn, turn);
    const Status status = look(end, pivots);
    Group::residual(start.u, end.q, f);
    const Unknowns back = -detail::product(end.inverse, f);
    const Unknowns defect = way - (predicted - back) / 2;
    if (!(detail::turn_of<Model, Scalar>(defect, inverse_size) <=
          detail::StepLimits<Scalar>().defect) ||
        detail::changed_pivots(start.pivots, end.pivots) != 0) {
      return Status::no_convergence;
    }
    return status;
  }
};

}  // namespace assur::support
