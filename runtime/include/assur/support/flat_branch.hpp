// A branch of an emitted solver as an array of numbers, for languages without templates.
#pragma once

#include <assur/support/flat_variables.hpp>
#include <assur/support/scene_track.hpp>
#include <cstddef>
#include <cstring>
#include <tuple>
#include <utility>

namespace assur::support {

/// Copies between a branch and an array, in this order: whether the stored point lies before the
/// point to which the branch was followed, the positions of drivers and parameters at the stored
/// point and at that point, the angles that are followed, then for each group u, q, J^-1 and the
/// pivots.
template <typename Solver, typename Scalar>
class FlatBranch {
  using Branch = support::Branch<Solver, Scalar>;

  template <typename Group>
  static constexpr std::size_t inverse_size =
      static_cast<std::size_t>(Group::unknown_count* Group::equation_count);
  template <typename Group>
  static constexpr auto pivot_count = static_cast<std::size_t>(Group::pivot_count);
  template <typename Variables>
  static constexpr std::size_t count_of = number_count<Variables, Scalar>;

  template <typename Points>
  struct NumbersOf;
  template <typename... Group>
  struct NumbersOf<std::tuple<GroupPoint<Group, Scalar>...>> {
    static constexpr std::size_t value =
        (std::size_t{0} + ... +
         (count_of<typename Group::template Inputs<Scalar>> +
          count_of<typename Group::template Configuration<Scalar>> + inverse_size<Group> +
          pivot_count<Group>));
  };

 public:
  /// The number of numbers in a branch, without its status.
  static constexpr std::size_t size =
      1 + Access<Solver, Scalar>::followed_angles +
      2 * std::tuple_size_v<
              decltype(std::declval<typename Access<Solver, Scalar>::Given>().positions())> +
      NumbersOf<decltype(Branch::groups)>::value;

  /// `numbers` has `size` entries.
  static void flatten(Branch branch, Scalar* numbers) {
    visit(branch, [&numbers](void* part, std::size_t count) {
      std::memcpy(numbers, part, count * sizeof(Scalar));
      numbers += count;
    });
  }
  [[nodiscard]] static Branch unflattened(const Scalar* numbers, Status status) {
    Branch branch;
    visit(branch, [&numbers](void* part, std::size_t count) {
      std::memcpy(part, numbers, count * sizeof(Scalar));
      numbers += count;
    });
    branch.status = status;
    return branch;
  }

 private:
  template <typename Visitor>
  static void visit(Branch& branch, const Visitor& visitor) {
    auto is_kept_before = static_cast<Scalar>(branch.is_kept_before);
    visitor(&is_kept_before, std::size_t{1});
    branch.is_kept_before = is_kept_before != 0;
    for (Scalar* position : branch.given.positions()) {
      visitor(position, std::size_t{1});
    }
    for (Scalar* position : branch.followed_to.positions()) {
      visitor(position, std::size_t{1});
    }
    for (Scalar& angle : branch.followed) {
      visitor(&angle, std::size_t{1});
    }
    std::apply([&visitor](auto&... point) { (visit_point(point, visitor), ...); }, branch.groups);
  }
  template <typename Group, typename Visitor>
  static void visit_point(GroupPoint<Group, Scalar>& point, const Visitor& visitor) {
    visitor(static_cast<void*>(&point.u), count_of<decltype(point.u)>);
    visitor(static_cast<void*>(&point.q), count_of<decltype(point.q)>);
    visitor(point.inverse.data(), inverse_size<Group>);
    visitor(point.pivots.data(), pivot_count<Group>);
  }
};

}  // namespace assur::support
