// A branch of an emitted solver, and how its groups are judged and placed.
#pragma once

#include <assur/detail/pivots.hpp>
#include <assur/kinematics.hpp>
#include <assur/status.hpp>
#include <assur/support/placed_group.hpp>
#include <assur/support/scene_access.hpp>
#include <assur/support/specialised.hpp>
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
  /// Where the branch has been followed to a place at which others cross it, or so close to it that
  /// velocities are not known, it is kept as it was a little before: that tells how it goes on.
  bool is_kept_before = false;
  typename Access<Solver, Scalar>::Given followed_to;  ///< what was given there
  /// ok or near_singular; with any other status nothing can be followed from here. singular also
  /// where a branch begins and velocities are not known: it may be any of those that meet there.
  Status status = Status::singular;
};

/// Judges and places the groups of a branch.
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
