// Continuation of a branch of an emitted solver across a point at which branches cross.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/branch_step.hpp>
#include <assur/local/crossing.hpp>
#include <assur/local/singular_point.hpp>
#include <assur/numeric/precision.hpp>
#include <assur/support/closures_on_way.hpp>
#include <assur/support/scene_branch.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>

namespace assur::support {

/// The result of a step across a crossing.
template <typename Scalar>
struct Landing {
  bool is_refused = true;  ///< the point may lie on another branch
  Scalar part = 0;         ///< of the whole way
};

/// The next crossing of a branch on a straight path of the arguments, if there is one.
template <typename Solver, typename Scalar>
class CrossingAhead {
  using Branch = support::Branch<Solver, Scalar>;
  using Own = Access<Solver, Scalar>;
  using Given = typename Own::Given;
  using Groups = typename Own::Groups;
  using Placed = typename Own::Placed;
  using Closures = ClosuresOnWay<Solver, Scalar>;
  using Step = typename Closures::Step;
  using OfGroups = BranchGroups<Solver, Scalar>;

 public:
  /// Whether the branch has reached the point from which it steps across the crossing.
  [[nodiscard]] bool is_reached(Scalar part) const { return !(part < before_); }
  /// The fraction of the path at which this point lies; infinite if no crossing is known.
  [[nodiscard]] Scalar before() const { return before_; }
  void leave_behind() { before_ = std::numeric_limits<Scalar>::infinity(); }
  /// Moves this point closer to the crossing, after a refused step. False if the crossing is not
  /// known accurately enough.
  [[nodiscard]] bool comes_closer(Scalar reached) {
    const Scalar distance = (at_.part - reached) / 4;
    before_ = at_.part - distance;
    return distance * speed_ > std::cbrt(std::numeric_limits<Scalar>::epsilon());
  }

  /// Looks for a crossing where linear extrapolation predicts a vanishing pivot, once from each
  /// point. `next` is the point at which a step was refused.
  [[gnu::noinline, gnu::cold]] void seek(const Given& from, const Given& to, const Branch& start,
                                         Scalar reached, Scalar next) {
    if (reached == sought_from_) {
      return;
    }
    sought_from_ = reached;
    const Beside aside = beside(from, to, start, reached);
    const Scalar farthest = 2 * (std::max)(next - reached, widest_landing / aside.speed);
    std::array<Scalar, detail::size(Closures::pivots)> zeros;
    const Scalar nearest = find_zeros(start, aside, zeros);
    if (!(nearest <= farthest)) {
      return;
    }
    // A group loses at least one rank, and at most one for every two unknowns, as a tetrad does if
    // all of its joints are collinear.
    PivotSets<Groups> vanishing{};
    int corank = 0;
    int most_corank = 0;
    std::size_t pivot = 0;
    Closures::each_group([&](auto place) {
      using Group = std::tuple_element_t<place, Groups>;
      for (int index = 0; index < Group::pivot_count; ++index) {
        const Scalar zero = zeros[pivot++];
        if (zero > 0 && zero < local::CrossingLimits<Scalar>().together * nearest) {
          vanishing[place] |= 1U << index;
        }
      }
      corank += vanishing[place] != 0 ? 1 : 0;
      most_corank += vanishing[place] != 0 ? Group::unknown_count / 2 : 0;
    });
    typename Closures::Point point{Closures::configurations_of(start.groups), reached + nearest};
    const Step way = nearest / aside.part * Closures::step_between(point.q, aside.there.q);
    if (!(way.cwiseAbs().maxCoeff() < 1)) {
      return;
    }
    Closures::move_groups(way, point.q);
    const Closures closures(from, to, aside.speed);
    for (bool is_found = false; corank <= most_corank && !is_found; ++corank) {
      const auto singular = local::singular_point(closures, point, corank);
      is_found = singular.is_found && singular.opening <= closures.rounding(singular.at) &&
                 singular.at.part > reached && singular.at.part <= reached + farthest;
      if (is_found) {
        at_ = singular.at;
        vanishing_ = vanishing;
        corank_ = corank;
        speed_ = aside.speed;
        before_ = at_.part - widest_landing / speed_;
      }
    }
  }

  /// Steps as far beyond the crossing as the branch is before it, or to the end of the path.
  [[nodiscard, gnu::noinline, gnu::cold]] Landing<Scalar> land(const Given& from, const Given& to,
                                                               const Branch& start, Scalar reached,
                                                               Branch& end, Placed& placed) const {
    const Beside aside = beside(from, to, start, reached);
    const Scalar distance = at_.part - reached;
    const bool is_on_it = std::abs(1 - at_.part) * aside.speed <= on_crossing;
    Landing<Scalar> landing;
    landing.part = is_on_it ? Scalar(1) : (std::min)(at_.part + distance, Scalar(1));
    const Scalar ratio = (landing.part - at_.part) / distance;
    const auto q = Closures::configurations_of(start.groups);
    const Step straight = distance / aside.part * Closures::step_between(q, aside.there.q);
    Step on;
    if (!local::goes_on_behind<Step>(Closures::step_between(q, at_.q), straight, ratio,
                                     distance * aside.speed, on)) {
      return landing;
    }
    auto predicted = at_.q;
    Closures::move_groups(on, predicted);
    end.given = landing.part < 1 ? Own::between(from, to, landing.part) : to;
    end.is_kept_before = false;
    end.status = Status::ok;
    Own::drive(end.given, placed);
    bool is_known = true;
    detail::PivotSet reversed = 0;
    if (land_groups<0>(predicted, &vanishing_, start, is_known, reversed, end, placed)) {
      // Each lost rank reverses the sign of det J once. If velocities are unknown, so are signs.
      const auto expected = ratio > 0 ? static_cast<detail::PivotSet>(corank_) % 2 : 0;
      landing.is_refused = is_known ? reversed != expected : landing.part < 1;
    } else if (is_on_it) {
      Own::drive(end.given, placed);
      landing.is_refused =
          !land_groups<0>(predicted, nullptr, start, is_known, reversed, end, placed);
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

 private:
  template <typename Group>
  using Held = HeldJoints<Group, Scalar, Solver::order, Solver::parameter_count>;

  /// The largest distance from a crossing at which a branch steps across it, in the groups' inputs:
  /// the prediction then has three eighths of the digits.
  static constexpr Scalar widest_landing =
      numeric::power_of_two<Scalar>(-(std::numeric_limits<Scalar>::digits / 8));
  /// Points closer to a crossing than this, in the groups' inputs, count as on it: a few times the
  /// error of its position.
  static constexpr Scalar on_crossing = 16 * numeric::half_of_digits<Scalar>;

  /// A point just beyond the start of a step, and the speed of the groups' inputs there.
  struct Beside {
    Scalar speed = 0;
    Scalar part = numeric::half_of_digits<Scalar>;  ///< of the whole way
    typename Closures::Place there;
  };
  [[nodiscard, gnu::noinline]] static Beside beside(const Given& from, const Given& to,
                                                    const Branch& start, Scalar reached) {
    Beside result;
    for (int time = 0; time < 2;
         ++time) {  // the second pass resolves half of the digits in all units
      Closures(from, to, 1)
          .place(reached + result.part, Closures::configurations_of(start.groups), &start.groups,
                 result.there);
      result.speed = Closures::largest_difference(start.groups, result.there.u) / result.part;
      if (time == 0) {
        result.part = (std::min)(numeric::half_of_digits<Scalar> / result.speed, Scalar(0.5));
      }
    }
    return result;
  }

  /// Finds the fraction of the path after which each pivot vanishes, and returns the least.
  template <typename Zeros>
  [[nodiscard]] static Scalar find_zeros(const Branch& start, const Beside& aside, Zeros& zeros) {
    Scalar nearest = std::numeric_limits<Scalar>::infinity();
    std::size_t pivot = 0;
    Closures::each_group([&](auto place) {
      using Group = std::tuple_element_t<place, Groups>;
      const auto& pivots = std::get<place>(start.groups).pivots;
      const auto others = OfGroups::template pivots_of<Group>(std::get<place>(aside.there.u),
                                                              std::get<place>(aside.there.q));
      for (int index = 0; index < Group::pivot_count; ++index) {
        const Scalar zero = aside.part * pivots(index) / (pivots(index) - others(index));
        zeros[pivot++] = zero;
        nearest = zero > 0 ? (std::min)(nearest, zero) : nearest;
      }
    });
    return nearest;
  }

  /// Corrects and places the groups from `Place` on; false if one may lie on another branch.
  /// `is_known` becomes false if velocities are unknown. On the crossing itself, `vanishing` being
  /// null, nothing is corrected.
  template <std::size_t Place, typename Configurations>
  [[nodiscard]] static bool land_groups(const Configurations& predicted,
                                        const PivotSets<Groups>* vanishing, const Branch& start,
                                        bool& is_known, detail::PivotSet& reversed, Branch& end,
                                        Placed& placed) {
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
      if (vanishing != nullptr &&
          !is_led_to((*vanishing)[Place], std::get<Place>(start.groups), reversed, point, status)) {
        return false;
      }
      if (!is_solvable(status) || !OfGroups::place(held, point, status, end, placed)) {
        is_known = false;
        Own::place(place_group(held, point.q, Status::near_singular), placed);
      }
      return land_groups<Place + 1>(predicted, vanishing, start, is_known, reversed, end, placed);
    }
  }
  /// Corrects a group's configuration; false if it may lie on another branch. `reversed` is whether
  /// the signs of the groups' determinants are reversed an odd number of times.
  template <typename Group>
  [[nodiscard]] static bool is_led_to(detail::PivotSet vanishing,
                                      const GroupPoint<Group, Scalar>& start,
                                      detail::PivotSet& reversed, GroupPoint<Group, Scalar>& point,
                                      Status& status) {
    using Model = Specialised<Group>;
    using Unknowns = Vector<Scalar, Group::unknown_count>;
    const typename Model::template Dimensions<Scalar> d;
    const Unknowns none = Unknowns::Zero();
    Unknowns way;
    if (!detail::predict_and_correct<Model, Scalar>(d, point.u, 1, none, point.q, way,
                                                    point.inverse)) {
      return false;
    }
    // Another branch is no nearer than 1 / |J^-1|, since the curvature of closures is about one.
    const Scalar correction = way.cwiseAbs().maxCoeff() * point.inverse.cwiseAbs().sum();
    const auto pivots = detail::pivots_at<Model, Scalar>(d, point.u, point.q);
    point.pivots = pivots.values;
    status = OfGroups::look(point, pivots);
    const detail::PivotSet changed = detail::changed_pivots(start.pivots, point.pivots);
    for (detail::PivotSet left = changed; left != 0; left &= left - 1) {
      reversed ^= 1U;
    }
    return correction < local::CrossingLimits<Scalar>().correction && (changed & ~vanishing) == 0;
  }

  typename Closures::Point at_;
  PivotSets<Groups> vanishing_{};  ///< at the crossing
  int corank_ = 0;                 ///< the number of ranks lost there
  Scalar speed_ = 0;               ///< change of the groups' inputs along the whole path
  Scalar before_ = std::numeric_limits<Scalar>::infinity();
  Scalar sought_from_ = -1;  ///< the fraction of the path from which the last search started
};

}  // namespace assur::support
