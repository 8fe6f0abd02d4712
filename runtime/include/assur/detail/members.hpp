// Visitors of the members of a model's variables, one list at a time or two in parallel.
#pragma once

#include <algorithm>
#include <assur/directions.hpp>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace assur::detail {

// Members are visited by index, not by nested calls of std::apply, which would be instantiated for
// the variables of every model and dominate the compile time of its users.
template <typename Members, typename Use, std::size_t... Index>
[[gnu::always_inline]] constexpr void visit(Members&& members, Use&& use,
                                            std::index_sequence<Index...>) {
  (use(std::get<Index>(members), Index), ...);
}
template <typename Members, typename Use>
[[gnu::always_inline]] constexpr void visit(Members&& members, Use&& use) {
  visit(members, use, std::make_index_sequence<std::tuple_size_v<std::decay_t<Members>>>());
}

template <typename One, typename Other, typename Use, std::size_t... Index>
[[gnu::always_inline]] constexpr void visit_both(One&& one, Other&& other, Use& use,
                                                 std::index_sequence<Index...>) {
  (use(std::get<Index>(one), std::get<Index>(other)), ...);
}
template <typename One, typename Other, typename Use>
[[gnu::always_inline]] constexpr void visit_both(One&& one, Other&& other, Use& use) {
  visit_both(one, other, use, std::make_index_sequence<std::tuple_size_v<std::decay_t<One>>>());
}

template <typename Scalar>
void advance_member(Scalar& length, const Scalar& step) {
  length = length + step;
}
template <typename Scalar>
void advance_member(Direction<Scalar>& direction, const Scalar& step) {
  direction = normalised(turned(direction, direction_of(step)));
}

template <typename Scalar>
[[nodiscard]] bool is_finite_number(const Scalar& length) {
  using std::isfinite;
  return isfinite(length);
}
template <typename Scalar>
[[nodiscard]] bool is_finite_number(const Direction<Scalar>& direction) {
  return is_finite_number(direction.cos) && is_finite_number(direction.sin);
}

/// Whether a number is neither NaN nor infinite, also for scalars without isfinite.
template <typename Scalar>
[[nodiscard]] bool is_number(const Scalar& value) {
  return value - value == Scalar(0);  // NOLINT(misc-redundant-expression): it tells NaN
}

/// The largest difference of two variables, of a direction's cosine or sine.
template <typename Scalar>
[[nodiscard]] inline Scalar apart(Scalar one, Scalar other) {
  return std::abs(one - other);
}
template <typename Scalar>
[[nodiscard]] inline Scalar apart(const Direction<Scalar>& one, const Direction<Scalar>& other) {
  return (std::max)(std::abs(one.cos - other.cos), std::abs(one.sin - other.sin));
}

/// The step that leads from one variable to another; a direction turns by at most half a turn.
template <typename Scalar>
[[nodiscard]] inline Scalar step_between(Scalar from, Scalar to) {
  return to - from;
}
template <typename Scalar>
[[nodiscard]] inline Scalar step_between(const Direction<Scalar>& from,
                                         const Direction<Scalar>& to) {
  return std::atan2(from.cos * to.sin - from.sin * to.cos, from.cos * to.cos + from.sin * to.sin);
}

/// A variable extrapolated linearly from a part of a step to the whole step; so are a direction's
/// cosine and sine.
template <typename Scalar>
[[nodiscard]] inline Scalar extrapolated(Scalar from, Scalar beside, Scalar part) {
  return from + (beside - from) / part;
}
template <typename Scalar>
[[nodiscard]] inline Direction<Scalar> extrapolated(const Direction<Scalar>& from,
                                                    const Direction<Scalar>& beside, Scalar part) {
  return {extrapolated(from.cos, beside.cos, part), extrapolated(from.sin, beside.sin, part)};
}

}  // namespace assur::detail
