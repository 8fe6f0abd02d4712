// Turns one configuration of an emitted solver into that of the same branch where the drivers stand
// elsewhere. Solvers include this for all that they call, batches too.
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
  int orientation = 0;  ///< the sign of det J: constant on a branch, opposite on those it may meet
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
  /// ok or near_singular; with any other status nothing can be followed from here.
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
/// where Newton's steps contract, det J keeps its sign, and the linear predictions from both ends
/// agree with the way; otherwise it is halved.
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
    const Scalar widest = widest_step(branch.given, to);
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
      if (!step<0>(*start, end, placed)) {
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
  /// The part of the way in which no driver turns by more than a radian: after a full turn the
  /// groups are held as before.
  [[nodiscard]] static Scalar widest_step(Given from, Given to) {
    const auto starts = from.positions();
    const auto ends = to.positions();
    Scalar turn = 1;
    for (std::size_t index = 0; index < Own::turning_drivers; ++index) {
      turn = (std::max)(turn, std::abs(*ends[index] - *starts[index]));
    }
    return 1 / turn;
  }

  template <typename Group>
  using Held = HeldJoints<Group, Scalar, Solver::order, Solver::parameter_count>;

  /// Sets the sign of det J where a group stands, and tells how regular the group is there.
  template <typename Group>
  [[nodiscard]] static Status look(GroupPoint<Group, Scalar>& point) {
    using Model = Specialised<Group>;
    const typename Model::template Dimensions<Scalar> d;
    const auto pivots = detail::pivots_at<Model, Scalar>(d, point.u, point.q);
    point.orientation = detail::orientation_of(pivots);
    return detail::regularity_at<Model, Scalar>(pivots, d, point.u, point.q).status;
  }

  /// Places a group on the way, and counts its regularity.
  template <typename Group>
  static void place(const Held<Group>& held, const GroupPoint<Group, Scalar>& point, Status status,
                    Branch& branch, Placed& placed) {
    const auto group = place_group(held, point.q, status);
    if (group.regularity != Status::ok) {
      branch.status = group.regularity;
    }
    Own::place(group, placed);
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
      const Status status = look(point);
      if (!is_solvable(status)) {
        branch.status = status;
        return;
      }
      Model::inverse_jacobian(typename Model::template Dimensions<Scalar>(), point.u, point.q,
                              point.inverse);
      place(held, point, status, branch, placed);
      settle<Place + 1>(found, branch, placed);
    }
  }

  /// Steps the groups from `Place` on; false where one refuses the step.
  template <std::size_t Place>
  [[nodiscard]] static bool step(const Branch& start, Branch& end, Placed& placed) {
    if constexpr (Place == std::tuple_size_v<Groups>) {
      return true;
    } else {
      using Group = std::tuple_element_t<Place, Groups>;
      GroupPoint<Group, Scalar>& point = std::get<Place>(end.groups);
      Held<Group> held;
      Own::hold(placed, held);
      point.u = held.u;
      if (!advance(std::get<Place>(start.groups), point)) {
        return false;
      }
      const Status status = look(point);
      if (!is_solvable(status) || point.orientation != std::get<Place>(start.groups).orientation) {
        return false;
      }
      place(held, point, status, end, placed);
      return step<Place + 1>(start, end, placed);
    }
  }

  /// Newton's steps from the linear prediction of the start.
  template <typename Group>
  [[nodiscard]] static bool advance(const GroupPoint<Group, Scalar>& start,
                                    GroupPoint<Group, Scalar>& end) {
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
      return false;
    }
    Group::residual(start.u, end.q, f);
    const Unknowns back = -detail::product(end.inverse, f);
    const Unknowns defect = way - (predicted - back) / 2;
    return detail::turn_of<Model, Scalar>(defect, inverse_size) <=
           detail::StepLimits<Scalar>().defect;
  }
};

}  // namespace assur::support
