// Tracking of a branch of an emitted solver to other positions of the drivers. Solvers include this
// for all that they call, batches too.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/branch_step.hpp>
#include <assur/detail/products.hpp>
#include <assur/support/closures_on_way.hpp>
#include <assur/support/scene_batch.hpp>
#include <assur/support/scene_branch.hpp>
#include <assur/support/scene_crossing.hpp>
#include <assur/support/scene_solve.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>

namespace assur::support {

/// The result of following a branch.
struct Track {
  /// ok or near_singular: the end of the path is reached. no_convergence: within 0.2% of the path
  /// beyond `reached` the branch ends or comes too close to another without crossing it, or a
  /// driver turns by more than 2000 radians. singular: the path changes direction at a crossing of
  /// branches. not_finite: a driver is not finite. Otherwise the status of a branch that cannot be
  /// followed.
  Status status = Status::singular;
  double reached = 0;  ///< the fraction of the path to the last point certain to lie on the branch
};

/// The same for the solver of a scene with limits: a branch is followed through them and back.
struct LimitedTrack : Track {
  bool within_limits = false;  ///< whether the state, if it was filled, keeps them
};

/// Follows branches of an emitted solver without rates. A step is accepted as one on the same
/// branch if Newton's steps contract, no pivot changes its sign or tends to zero from both ends,
/// and the linear predictions from both ends agree with the path; otherwise it is halved. At a
/// crossing a branch is continued with its tangent and curvature.
template <typename Solver, typename Scalar>
class Tracker {
  using Branch = support::Branch<Solver, Scalar>;
  using State = typename Solver::template State<Scalar>;
  using Own = Access<Solver, Scalar>;
  using Given = typename Own::Given;
  using Groups = typename Own::Groups;
  using Placed = typename Own::Placed;
  using Track = typename Solver::Track;
  using OfGroups = BranchGroups<Solver, Scalar>;

 public:
  /// The branch of a configuration, by its index in the solver's list, from 0; no_convergence if
  /// there is no such configuration, or if float does not determine the configurations.
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
      if (is_solvable(branch.status)) {
        follow(branch, branch, placed);
      }
    }
    return branch;
  }

  /// Follows a branch to where the drivers stand at `to`, and fills the state there. The state is
  /// unchanged if the branch is not followed to the end.
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
    Scalar passed = 0;
    if (branch.is_kept_before && !goes_straight_on(branch, to, passed)) {
      way.status = Status::singular;
      return way;
    }
    const Scalar turn = largest_turn(branch.given, to);
    const bool moves_by_formulas = Own::has_laws || Own::parameters_differ(branch.given, to);
    // No driver turns by more than a radian a step: after a full turn the groups' inputs are the
    // same as before.
    const Scalar widest = 1 / (std::max)(turn, Scalar(1));
    std::array<Branch, 2> ends;
    CrossingAhead<Solver, Scalar> crossing;
    const Branch* start = &branch;
    Scalar reached = 0;
    for (Scalar width = widest; reached < 1;) {
      Branch& end = start == ends.data() ? ends[1] : ends[0];
      Placed placed;
      if constexpr (has_groups) {
        if (crossing.is_reached(reached)) {
          const auto landing = crossing.land(branch.given, to, *start, reached, end, placed);
          if (!landing.is_refused) {
            width = (std::min)(2 * (landing.part - reached), widest);
            follow(*start, end, placed);
            arrive(end, landing.part, passed, placed, state, way);
            reached = landing.part;
            start = &end;
            crossing.leave_behind();
          } else if (!crossing.comes_closer(reached)) {
            way.status = Status::no_convergence;
            return way;
          }
          continue;
        }
      }
      if (!(width > detail::StepLimits<Scalar>().shortest)) {
        way.status = Status::no_convergence;
        return way;
      }
      const Scalar next = (std::min)({reached + width, crossing.before(), Scalar(1)});
      end.given = next < 1 ? Own::between(branch.given, to, next) : to;
      end.is_kept_before = false;
      Own::drive(end.given, placed);
      end.status = Status::ok;
      StepSize size{turn * (next - reached), !moves_by_formulas};
      if (!step<0>(*start, end, placed, size) ||
          (!size.is_small && may_pass_singularity(*start, end))) {
        width = (next - reached) / 2;
        if constexpr (has_groups) {
          crossing.seek(branch.given, to, *start, reached, next);
        }
        continue;
      }
      follow(*start, end, placed);
      start = &end;
      width = (std::min)(2 * (next - reached), widest);
      reached = next;
      arrive(end, reached, passed, placed, state, way);
    }
    branch = *start;
    way.status = branch.status;
    return way;
  }

 private:
  /// Continues the angles that loads and springs read from one point of a branch to the next, which
  /// is placed.
  static void follow(const Branch& start, Branch& end, Placed& placed) {
    if constexpr (Own::followed_angles > 0) {
      placed.followed = start.followed;
      end.followed = Own::followed(placed);
    }
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
      const Status status = OfGroups::look(point, pivots);
      if (!is_solvable(status)) {
        branch.status = status;
        return;
      }
      if (!OfGroups::place(held, point, status, branch, placed)) {
        branch.status = Status::singular;
        return;
      }
      settle<Place + 1>(found, branch, placed);
    }
  }

  /// The size of a step.
  struct StepSize {
    Scalar turn;    ///< the largest turn of a driver or of a placed group, radians
    bool is_small;  ///< no pivot can vanish within twice the step; unknown for formulas
  };

  /// Steps the groups from `Place` on; false if one refuses the step.
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
      return is_solvable(status) && OfGroups::place(held, point, status, end, placed) &&
             step<Place + 1>(start, end, placed, size);
    }
  }

  using Closures = ClosuresOnWay<Solver, Scalar>;
  static constexpr bool has_groups = std::tuple_size_v<Groups> > 0;
  using PivotSets = support::PivotSets<Groups>;

  /// Whether extrapolation from both ends of a step predicts that a pivot vanishes: then the step
  /// may have passed a crossing onto the branch whose pivots have the same signs, or a gap in which
  /// nothing can be assembled.
  [[nodiscard, gnu::noinline]] static bool may_pass_singularity(const Branch& start,
                                                                const Branch& end) {
    Scalar largest = 0;
    Closures::each_group([&](auto place) {
      largest =
          (std::max)(largest, detail::largest_difference<Scalar>(std::get<place>(start.groups).u,
                                                                 std::get<place>(end.groups).u));
    });
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
  /// For each group, the pivots that may vanish within twice a step. They are extrapolated from a
  /// small `part` of the path, which changes the groups' inputs by half of their digits.
  [[nodiscard]] static PivotSets vanishing(const Branch& from, const Branch& to, Scalar part) {
    PivotSets sets{};
    typename Closures::Place there;
    Closures(from.given, to.given, 1)
        .place(part, Closures::configurations_of(from.groups), &from.groups, there);
    Closures::each_group([&](auto place) {
      using Group = std::tuple_element_t<place, Groups>;
      const auto& point = std::get<place>(from.groups);
      const auto& u = std::get<place>(there.u);
      sets[place] = detail::pivots_that_may_vanish<Scalar>(
          point.u, u, std::get<place>(to.groups).u, point.pivots,
          OfGroups::template pivots_of<Group>(u, std::get<place>(there.q)), part);
    });
    return sets;
  }
  /// Whether a path to `to` continues straight through the crossing on which a branch is, or
  /// straight back. `passed` is the fraction of the path, measured from the stored point, that is
  /// already covered.
  [[nodiscard]] static bool goes_straight_on(Branch& branch, Given to, Scalar& passed) {
    const auto starts = branch.given.positions();
    const auto middles = branch.followed_to.positions();
    const auto ends = to.positions();
    Scalar along = 0;
    Scalar square = 0;
    Scalar largest = 0;
    for (std::size_t index = 0; index < starts.size(); ++index) {
      const Scalar way = *ends[index] - *starts[index];
      const Scalar gone = *middles[index] - *starts[index];
      along += way * gone;
      square += way * way;
      largest = (std::max)(largest, std::abs(gone));
    }
    if (square == 0) {
      return true;
    }
    passed = along / square;
    bool is_straight = true;
    for (std::size_t index = 0; index < starts.size(); ++index) {
      const Scalar way = *ends[index] - *starts[index];
      const Scalar gone = *middles[index] - *starts[index];
      is_straight =
          is_straight && std::abs(gone - passed * way) <= numeric::half_of_digits<Scalar> * largest;
    }
    return is_straight;
  }
  /// Updates the fraction reached, measured from the stored point, of which `passed` had been
  /// covered before; fills the state at the end.
  static void arrive(const Branch& branch, Scalar part, Scalar passed, Placed& placed, State& state,
                     Track& way) {
    if (part < 1) {
      // Back from a crossing, no point is certain before the end.
      way.reached = passed < 1 ? (std::max)(Scalar(0), (part - passed) / (1 - passed)) : Scalar(0);
      return;
    }
    way.reached = 1;
    placed.regularity = branch.status;
    Own::list(placed, state);
    if constexpr (Own::has_limits) {
      way.within_limits = Own::keeps_limits(placed);
    }
  }

  /// Newton's steps from the linear prediction of the start. Returns the regularity of the result,
  /// or no_convergence if it may lie on another branch.
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
    // The group's inputs move on arcs, which the prediction replaces by chords: an arc starts at an
    // angle of up to half the turn to its chord.
    const Scalar turn = detail::turn_of<Model, Scalar>(predicted, inverse_size);
    const Scalar held =
        size.turn * (std::max)(detail::largest_difference<Scalar>(start.u, end.u), size.turn);
    const Scalar bend = start.inverse.cwiseAbs().sum() * (held + turn * turn);
    size.is_small = size.is_small && detail::keep_their_signs<Model, Scalar>(start.pivots, pivots,
                                                                             turn + bend, bend);
    size.turn = (std::max)(size.turn, turn);
    const Status status = OfGroups::look(end, pivots);
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
