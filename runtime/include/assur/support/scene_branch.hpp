// A branch of an emitted solver, and the regularity and placement of its groups.
#pragma once

#include <assur/detail/pivots.hpp>
#include <assur/kinematics.hpp>
#include <assur/status.hpp>
#include <assur/support/placed_group.hpp>
#include <assur/support/scene_access.hpp>
#include <assur/support/specialised.hpp>
#include <tuple>

namespace assur::support {

/// A group on a branch: inputs, configuration and J^-1.
template <typename Group, typename Scalar>
struct GroupPoint {
  typename Group::template Inputs<Scalar> u;
  typename Group::template Configuration<Scalar> q;
  Matrix<Scalar, Group::unknown_count, Group::equation_count> inverse;
  Vector<Scalar, Group::pivot_count> pivots;  ///< J is singular if one vanishes
};

template <typename Groups, typename Scalar>
struct GroupPoints;
template <typename... Group, typename Scalar>
struct GroupPoints<std::tuple<Group...>, Scalar> {
  using Type = std::tuple<GroupPoint<Group, Scalar>...>;
};

/// A point of a branch of an emitted solver.
template <typename Solver, typename Scalar = double>
struct Branch {
  typename Access<Solver, Scalar>::Given given;
  typename GroupPoints<typename Access<Solver, Scalar>::Groups, Scalar>::Type groups;
  /// Whether the branch was followed to a crossing, or so close to one that velocities are unknown.
  /// The point stored is then one shortly before it, from which the branch can be continued.
  bool is_kept_before = false;
  typename Access<Solver, Scalar>::Given followed_to;  ///< the arguments at the crossing
  /// The angles that loads and springs read, with their whole turns since the branch began.
  typename Access<Solver, Scalar>::Followed followed{};
  /// ok or near_singular; with any other status the branch cannot be followed. singular also if
  /// velocities are unknown at the start: the branch may be any of those that meet there.
  Status status = Status::singular;
};

/// Regularity and placement of the groups of a branch.
template <typename Solver, typename Scalar>
struct BranchGroups {
  using Own = Access<Solver, Scalar>;
  using Placed = typename Own::Placed;
  template <typename Group>
  using Held = HeldJoints<Group, Scalar, Solver::order, Solver::parameter_count>;

  template <typename Group, typename Inputs, typename Configuration>
  [[nodiscard, gnu::noinline]] static Vector<Scalar, Group::pivot_count> pivots_of(
      const Inputs& u, const Configuration& q) {
    using Model = Specialised<Group>;
    return detail::pivots_at<Model, Scalar>(typename Model::template Dimensions<Scalar>(), u, q)
        .values;
  }
  /// The regularity of a group; singular if its branch is undetermined.
  template <typename Group>
  [[nodiscard]] static Status look(const GroupPoint<Group, Scalar>& point,
                                   const detail::Pivots<Specialised<Group>, Scalar>& pivots) {
    using Model = Specialised<Group>;
    const typename Model::template Dimensions<Scalar> d;
    const auto regularity = detail::regularity_at<Model, Scalar>(pivots, d, point.u, point.q);
    return regularity.knows_velocities() ? regularity.status : Status::singular;
  }

  /// Places a group, and updates the branch's status by its regularity. False if rounding displaces
  /// the preceding groups so far that the group's branch is undetermined.
  template <typename Group>
  [[nodiscard]] static bool place(const Held<Group>& held, const GroupPoint<Group, Scalar>& point,
                                  Status status, Branch<Solver, Scalar>& branch, Placed& placed) {
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
};

}  // namespace assur::support
