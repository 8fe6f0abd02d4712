// Follows a branch of an emitted solver to where the drivers stand elsewhere. Solvers include this
// for all that they call, batches too.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/branch_step.hpp>
#include <assur/detail/products.hpp>
#include <assur/local/singular_point.hpp>
#include <assur/support/closures_on_way.hpp>
#include <assur/support/scene_batch.hpp>
#include <assur/support/scene_solve.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>

namespace assur::support {

/// The place to which a branch of an emitted solver has been followed.
template <typename Solver, typename Scalar = double>
struct Branch {
  typename Access<Solver, Scalar>::Given given;
  typename GroupPoints<typename Access<Solver, Scalar>::Groups, Scalar>::Type groups;
  /// Where the branch has been followed to a place at which others cross it, or so close to it that
  /// velocities are not known, it is kept as it was a little before: that tells how it goes on.
  bool is_kept_before = false;
  typename Access<Solver, Scalar>::Given followed_to;  ///< what was given there
  /// ok or near_singular; with any other status nothing can be followed from here. singular also
  /// where a branch begins and velocities are not known: it may be any of those that meet there.
  Status status = Status::singular;
};

/// How far a branch was followed.
struct Track {
  /// ok, or near_singular: at the end of the way. no_convergence: within 0.2% of the way from
  /// `reached` the branch ends or comes too close to another without crossing it, or a driver turns
  /// by more than 2000 radians. singular: the way turns off where branches cross. not_finite: a
  /// driver is. Or the status of a branch that cannot be followed.
  Status status = Status::singular;
  double reached = 0;  ///< the part of the way to the last point that is certainly of the branch
};

/// The same for the solver of a scene with limits: a branch is followed through them and back.
struct LimitedTrack : Track {
  bool within_limits = false;  ///< whether the state, where it was filled, keeps them
};

/// Follows branches of an emitted solver without rates. A step is taken for one of the same branch
/// where Newton's steps contract, no pivot changes its sign or goes to zero from both ends, and the
/// linear predictions from both ends agree with the way; otherwise it is halved. Where branches
/// cross, a branch goes on along the tangent and the bend with which it comes.
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
    Scalar passed = 0;
    if (branch.is_kept_before && !goes_straight_on(branch, to, passed)) {
      way.status = Status::singular;
      return way;
    }
    const Scalar turn = largest_turn(branch.given, to);
    const bool moves_by_formulas = Own::has_laws || Own::parameters_differ(branch.given, to);
    // No driver turns by more than a radian: after a full turn the groups are held as before.
    const Scalar widest = 1 / (std::max)(turn, Scalar(1));
    std::array<Branch, 2> ends;
    Crossing crossing;
    const Branch* start = &branch;
    Scalar reached = 0;
    for (Scalar width = widest; reached < 1;) {
      Branch& end = start == ends.data() ? ends[1] : ends[0];
      Placed placed;
      if constexpr (has_groups) {
        if (!(reached < crossing.before)) {
          const Landing landing = land(branch.given, to, *start, reached, crossing, end, placed);
          if (landing.is_refused) {
            if (!crossing.comes_closer(reached)) {
              way.status = Status::no_convergence;
              return way;
            }
            continue;
          }
          if (landing.part == 1) {
            list(end.status, placed, state, way);
          }
          width = (std::min)(2 * (landing.part - reached), widest);
          reached = landing.part;
          start = &end;
          crossing.before = std::numeric_limits<Scalar>::infinity();
          continue;
        }
      }
      if (!(width > detail::StepLimits<Scalar>().shortest)) {
        way.status = Status::no_convergence;
        return way;
      }
      const Scalar next = (std::min)({reached + width, crossing.before, Scalar(1)});
      end.given = next < 1 ? Own::between(branch.given, to, next) : to;
      end.is_kept_before = false;
      Own::drive(end.given, placed);
      end.status = Status::ok;
      StepSize size{turn * (next - reached), !moves_by_formulas};
      if (!step<0>(*start, end, placed, size) ||
          (!size.is_small && may_pass_singularity(*start, end))) {
        width = (next - reached) / 2;
        if constexpr (has_groups) {
          if (!(reached == crossing.sought_from)) {
            crossing.sought_from = reached;
            find_crossing(branch.given, to, *start, reached, next, crossing);
          }
        }
        continue;
      }
      start = &end;
      width = (std::min)(2 * (next - reached), widest);
      reached = next;
      way.reached = (std::max)(Scalar(0), (next - passed) / (1 - passed));
      if (next == 1) {
        list(end.status, placed, state, way);
      }
    }
    branch = *start;
    way.status = branch.status;
    way.reached = 1;
    return way;
  }

 private:
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

  using Closures = ClosuresOnWay<Solver, Scalar>;
  static constexpr bool has_groups = std::tuple_size_v<Groups> > 0;
  using PivotSets = support::PivotSets<Groups>;

  /// Whether a pivot may vanish as seen from both ends of a step: then the step may have passed
  /// over a crossing of branches to the one whose pivots have the same signs, or over a gap in
  /// which nothing can be assembled.
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
  /// For each group the pivots that may vanish within twice a step. The drivers go by a part of the
  /// way, which moves what holds the groups by half of its digits.
  [[nodiscard]] static PivotSets vanishing(const Branch& from, const Branch& to, Scalar part) {
    PivotSets sets{};
    typename Closures::Place there;
    Closures(from.given, to.given, 1).place(part, configurations_of(from), &from.groups, there);
    Closures::each_group([&](auto place) {
      using Group = std::tuple_element_t<place, Groups>;
      const auto& point = std::get<place>(from.groups);
      const auto& u = std::get<place>(there.u);
      sets[place] = detail::pivots_that_may_vanish<Scalar>(
          point.u, u, std::get<place>(to.groups).u, point.pivots,
          pivots_of<Group>(u, std::get<place>(there.q)), part);
    });
    return sets;
  }
  template <typename Group, typename Inputs, typename Configuration>
  [[nodiscard, gnu::noinline]] static Vector<Scalar, Group::pivot_count> pivots_of(
      const Inputs& u, const Configuration& q) {
    using Model = Specialised<Group>;
    return detail::pivots_at<Model, Scalar>(typename Model::template Dimensions<Scalar>(), u, q)
        .values;
  }

  /// A place on the way at which branches cross.
  struct Crossing {
    typename Closures::Point at;
    PivotSets vanishing{};
    Scalar speed = 0;  ///< how much of what holds the groups changes along the whole way
    /// The part of the way from which it is crossed; infinite where no crossing is ahead.
    Scalar before = std::numeric_limits<Scalar>::infinity();

    Scalar sought_from = -1;  ///< the part of the way from which it was looked for last

    /// Whether the crossing may be known well enough from a nearer place.
    [[nodiscard]] bool comes_closer(Scalar reached) {
      const Scalar distance = (at.part - reached) / 4;
      before = at.part - distance;
      return distance * speed > std::cbrt(std::numeric_limits<Scalar>::epsilon());
    }
  };
  /// Where a branch begins to move, and how fast.
  struct Beside {
    Scalar speed = 0;
    Scalar part = numeric::half_of_digits<Scalar>;  ///< of the whole way
    typename Closures::Place there;
  };
  [[nodiscard, gnu::noinline]] static Beside beside(const Given& from, const Given& to,
                                                    const Branch& start, Scalar reached) {
    Beside result;
    for (int time = 0; time < 2; ++time) {  // the second time with half of the digits in all units
      Closures(from, to, 1)
          .place(reached + result.part, configurations_of(start), &start.groups, result.there);
      Scalar largest = 0;
      Closures::each_group([&](auto place) {
        largest = (std::max)(largest,
                             detail::largest_difference<Scalar>(std::get<place>(start.groups).u,
                                                                std::get<place>(result.there.u)));
      });
      result.speed = largest / result.part;
      if (time == 0) {
        result.part = (std::min)(numeric::half_of_digits<Scalar> / result.speed, Scalar(0.5));
      }
    }
    return result;
  }
  [[nodiscard]] static typename Closures::Configurations configurations_of(const Branch& branch) {
    typename Closures::Configurations q;
    Closures::each_group(
        [&](auto place) { std::get<place>(q) = std::get<place>(branch.groups).q; });
    return q;
  }

  /// Looks for a crossing of branches where a pivot will vanish if all goes on as it begins.
  [[gnu::noinline, gnu::cold]] static void find_crossing(const Given& from, const Given& to,
                                                         const Branch& start, Scalar reached,
                                                         Scalar next, Crossing& crossing) {
    const Beside aside = beside(from, to, start, reached);
    const Closures closures(from, to, aside.speed);
    std::array<Scalar, detail::size(Closures::pivots)> zeros;
    Scalar nearest = std::numeric_limits<Scalar>::infinity();
    std::size_t pivot = 0;
    Closures::each_group([&](auto place) {
      using Group = std::tuple_element_t<place, Groups>;
      const auto& pivots = std::get<place>(start.groups).pivots;
      const auto others =
          pivots_of<Group>(std::get<place>(aside.there.u), std::get<place>(aside.there.q));
      for (int index = 0; index < Group::pivot_count; ++index) {
        const Scalar zero = aside.part * pivots(index) / (pivots(index) - others(index));
        zeros[pivot++] = zero;
        nearest = zero > 0 ? (std::min)(nearest, zero) : nearest;
      }
    });
    const Scalar farthest = 2 * (std::max)(next - reached, widest_landing / aside.speed);
    if (!(nearest <= farthest)) {
      return;
    }
    constexpr auto together =
        static_cast<Scalar>(1.7);  // less apart than the bend of the first pivot tells
    crossing.vanishing = PivotSets{};
    int corank = 0;
    pivot = 0;
    Closures::each_group([&](auto place) {
      for (int index = 0; index < std::tuple_element_t<place, Groups>::pivot_count; ++index) {
        const Scalar zero = zeros[pivot++];
        if (zero > 0 && zero < together * nearest) {
          crossing.vanishing[place] |= 1U << index;
        }
      }
      corank += crossing.vanishing[place] != 0 ? 1 : 0;
    });
    typename Closures::Point point{configurations_of(start), reached + nearest};
    const typename Closures::Step way =
        nearest / aside.part * Closures::step_between(point.q, aside.there.q);
    if (!(way.cwiseAbs().maxCoeff() < 1)) {
      return;
    }
    Closures::move_groups(way, point.q);
    const auto singular = local::singular_point(closures, point, corank);
    if (singular.is_found && singular.opening <= closures.rounding(singular.at) &&
        singular.at.part > reached && singular.at.part <= reached + farthest) {
      crossing.at = singular.at;
      crossing.speed = aside.speed;
      crossing.before = crossing.at.part - widest_landing / aside.speed;
    }
  }
  /// How far from a crossing a branch goes over it at most, in what holds the groups: what is
  /// predicted there is known to three eighths of the digits.
  static constexpr Scalar widest_landing =
      numeric::power_of_two<Scalar>(-(std::numeric_limits<Scalar>::digits / 8));
  /// Nearer to a crossing than this, in what holds the groups, is on it.
  static constexpr Scalar on_crossing = 16 * numeric::half_of_digits<Scalar>;

  struct Landing {
    bool is_refused = true;
    Scalar part = 0;
  };
  /// Goes on behind a crossing, as the tangent and the bend with which a branch comes into it lead
  /// on. Refused where the corrected place may be of another branch.
  [[nodiscard, gnu::noinline, gnu::cold]] static Landing land(const Given& from, const Given& to,
                                                              const Branch& start, Scalar reached,
                                                              const Crossing& crossing, Branch& end,
                                                              Placed& placed) {
    using Step = typename Closures::Step;
    const Beside aside = beside(from, to, start, reached);
    const Scalar distance = crossing.at.part - reached;
    const auto q = configurations_of(start);
    const Step straight = distance / aside.part * Closures::step_between(q, aside.there.q);
    const Step way = Closures::step_between(q, crossing.at.q);
    const Step bend = way - straight;
    constexpr auto most_bend = static_cast<Scalar>(0.1);
    Landing landing;
    if (!(bend.cwiseAbs().maxCoeff() <=
          most_bend * (std::max)(way.cwiseAbs().maxCoeff(), distance * aside.speed))) {
      return landing;
    }
    const bool is_on_it = std::abs(1 - crossing.at.part) * aside.speed <= on_crossing;
    landing.part = is_on_it ? Scalar(1) : (std::min)(crossing.at.part + distance, Scalar(1));
    const Scalar ratio = (landing.part - crossing.at.part) / distance;
    auto predicted = crossing.at.q;
    Closures::move_groups(ratio * (way + bend) + ratio * ratio * bend, predicted);
    end.given = landing.part < 1 ? Own::between(from, to, landing.part) : to;
    end.is_kept_before = false;
    end.status = Status::ok;
    Own::drive(end.given, placed);
    bool is_known = true;
    if (land_groups<0>(predicted, &crossing.vanishing, ratio > 0, start, is_known, end, placed) &&
        (is_known || landing.part == 1)) {
      landing.is_refused = false;
    } else if (is_on_it) {
      Own::drive(end.given, placed);
      landing.is_refused =
          !land_groups<0>(predicted, nullptr, ratio > 0, start, is_known, end, placed);
    }
    if (!is_known) {
      const Given given = end.given;
      end = start;
      end.is_kept_before = true;
      end.followed_to = given;
      end.status = Status::near_singular;
    }
    return landing;
  }
  /// Corrects and places the groups from `Place` on; false where one may be of another branch.
  /// `is_known` becomes false where velocities are not. On the crossing itself, where no pivots
  /// `vanish` nearby, nothing is corrected.
  template <std::size_t Place, typename Configurations>
  [[nodiscard]] static bool land_groups(const Configurations& predicted, const PivotSets* vanishing,
                                        bool is_behind, const Branch& start, bool& is_known,
                                        Branch& end, Placed& placed) {
    if constexpr (Place == std::tuple_size_v<Groups>) {
      return true;
    } else {
      using Group = std::tuple_element_t<Place, Groups>;
      GroupPoint<Group, Scalar>& point = std::get<Place>(end.groups);
      Held<Group> held;
      Own::hold(placed, held);
      point.u = held.u;
      point.q = std::get<Place>(predicted);
      Status status = Status::singular;
      if (vanishing != nullptr && !is_led_to((*vanishing)[Place], is_behind,
                                             std::get<Place>(start.groups), point, status)) {
        return false;
      }
      if (!is_solvable(status) || !place(held, point, status, end, placed)) {
        is_known = false;
        Own::place(place_group(held, point.q, Status::near_singular), placed);
      }
      return land_groups<Place + 1>(predicted, vanishing, is_behind, start, is_known, end, placed);
    }
  }
  /// Corrects a group's configuration, behind the crossing or before it; false where it may be of
  /// another branch.
  template <typename Group>
  [[nodiscard]] static bool is_led_to(detail::PivotSet vanishing, bool is_behind,
                                      const GroupPoint<Group, Scalar>& start,
                                      GroupPoint<Group, Scalar>& point, Status& status) {
    using Model = Specialised<Group>;
    using Unknowns = Vector<Scalar, Group::unknown_count>;
    const typename Model::template Dimensions<Scalar> d;
    const Unknowns none = Unknowns::Zero();
    Unknowns way;
    if (!detail::predict_and_correct<Model, Scalar>(d, point.u, 1, none, point.q, way,
                                                    point.inverse)) {
      return false;
    }
    // Another branch is no nearer than 1 / |J^-1|, for closures bend by about one.
    constexpr auto most_of_distance = static_cast<Scalar>(0.25);
    const Scalar correction = way.cwiseAbs().maxCoeff() * point.inverse.cwiseAbs().sum();
    const auto pivots = detail::pivots_at<Model, Scalar>(d, point.u, point.q);
    point.pivots = pivots.values;
    status = look(point, pivots);
    // The pivots that vanish at the crossing change their signs there, and behind a second one they
    // would do so again. Where velocities are not known, signs are not.
    const detail::PivotSet changed = detail::changed_pivots(start.pivots, point.pivots);
    const bool is_right =
        is_solvable(status) ? changed == (is_behind ? vanishing : 0) : (changed & ~vanishing) == 0;
    return correction < most_of_distance && is_right;
  }
  /// Whether a way to `to` goes through the crossing on which a branch is, straight on or back.
  /// `passed` is the part of that way, from where the branch is kept, that it has gone already.
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
  static void list(Status regularity, Placed& placed, State& state, Track& way) {
    placed.regularity = regularity;
    Own::list(placed, state);
    if constexpr (Own::has_limits) {
      way.within_limits = Own::keeps_limits(placed);
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
