// Turns lengths in any unit into lengths near one, exactly, in any scalar.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/index.hpp>
#include <assur/detail/numbers.hpp>
#include <assur/model.hpp>
#include <assur/support/displaced_frame.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace assur::support {

/// The scalar of a model's variables.
template <typename Variables>
struct ScalarOf;
template <template <typename> class Variables, typename Scalar>
struct ScalarOf<Variables<Scalar>> {
  using Type = Scalar;
};

/// Numbers in another scalar, lengths multiplied by `scale`.
template <typename Scalar, std::size_t Count>
void scale_numbers(const void* from, const std::array<bool, Count>& is_length, double scale,
                   void* to) {
  for (std::size_t place = 0; place < Count; ++place) {
    const double number = detail::number_at<double>(from, place);
    detail::put_number(to, place, Scalar(is_length[place] ? number * scale : number));
  }
}

/// The same variables in another scalar, lengths multiplied by `scale`, a power of two.
template <typename To, typename From>
[[nodiscard]] To scaled_to(const From& from, double scale) {
  To result;
  scale_numbers<typename ScalarOf<To>::Type>(&from, detail::SortsOf<From>::lengths, scale, &result);
  return result;
}

/// The same variables in another scalar, member by member: faster, but compiled anew for every
/// model.
template <typename To, typename From>
[[nodiscard]] To converted_to(const From& from) {
  To result;
  for_each_pair(result, from, [](auto& target, const auto& source) {
    if constexpr (std::is_same_v<std::decay_t<decltype(source)>, double>) {
      target = source;
    } else {
      target = {source.cos, source.sin};
    }
  });
  return result;
}

/// 2^-e of a length of 2^e m, 1 <= m < 2, by the bits of a number that has them all; where it has
/// not, at most the largest power that there is.
[[nodiscard]] inline double inverse_power_of_two(double length) {
  if (!(length >= (std::numeric_limits<double>::min)() && length < 0x1p1023)) {
    constexpr int most = std::numeric_limits<double>::max_exponent - 1;
    return std::ldexp(1.0, (std::min)(-std::ilogb(length), most));
  }
  std::uint64_t bits = 0;
  std::memcpy(&bits, &length, sizeof(bits));
  constexpr std::uint64_t exponent_of_one = 1023;
  bits = (2 * exponent_of_one - (bits >> 52U)) << 52U;
  double power = 0;
  std::memcpy(&power, &bits, sizeof(power));
  return power;
}

/// A few roundings of a length of one.
inline constexpr double rounding_of_one = 2 * std::numeric_limits<double>::epsilon();

/// In a chain of groups the bound of a displacement grows much faster than the displacement itself.
/// A bound beyond some part of the longest length would make one of two configurations that are
/// close together, so it counts as this much.
[[nodiscard]] inline double counted_displacement(double displaced, double longest) {
  return (std::min)(displaced, 0x1p-46 * longest);
}

/// How far rounding may have moved the inputs of a group whose neighbours it has `displaced`. The
/// rounding of a coordinate grows with the coordinate.
template <typename Inputs>
[[nodiscard]] double rounding_of_inputs(const Inputs& u, double displaced) {
  return rounding_of_one * (std::max)(1.0, longest_length(u)) + displaced;
}

/// Numbers with bounds, lengths known to `within` and directions to a `turn`.
template <typename Scalar, std::size_t Count>
void bound_numbers(const void* from, const std::array<bool, Count>& is_length, double within,
                   double turn, void* to) {
  for (std::size_t place = 0; place < Count; ++place) {
    detail::put_number(
        to, place,
        Scalar{detail::number_at<double>(from, place), is_length[place] ? within : turn});
  }
}

/// The same variables with bounds, lengths known to `within` and directions to a `turn`: where a
/// root of their final polynomial is certain, it is so however the variables were rounded.
template <typename To, typename From>
[[nodiscard]] To rounded(const From& from, double within, double turn) {
  To result;
  bound_numbers<typename ScalarOf<To>::Type>(&from, detail::SortsOf<From>::lengths, within, turn,
                                             &result);
  return result;
}

/// What rounding of its dimensions may have done to a coefficient of a specialised group, whose
/// functions hold them as numbers: lengths are at most one there, and few of them meet in a term.
inline constexpr double rounding_of_named_numbers = 32 * std::numeric_limits<double>::epsilon();
template <typename Model>
[[nodiscard]] constexpr double rounding_of_numbers() {
  return Model::dimension_count == 0 ? rounding_of_named_numbers : 0.0;
}

/// The longest length of a group. Only differences of the external joints' places count, not where
/// the group is.
template <typename Model>
[[nodiscard]] double size_of(const typename Model::template Dimensions<double>& d,
                             const typename Model::template Inputs<double>& u) {
  typename Model::template Configuration<double> q;
  Vector<double, Model::equation_count> f;
  Model::residual(typename Model::template Dimensions<double>{}, u, q, f);
  return (std::max)(longest_length(d), f.cwiseAbs().maxCoeff());
}

/// The longest length of a group in the unit of its inputs; a specialised one tells it, as it has
/// its lengths in its functions.
template <typename Model>
[[nodiscard]] double own_size(const typename Model::template Dimensions<double>& d,
                              const typename Model::template Inputs<double>& u) {
  if constexpr (Model::dimension_count == 0) {
    return Model::own_length;
  } else {
    return size_of<Model>(d, u);
  }
}

/// By how much the loop Jacobian of a group may be off, in parts of what it is made of: a place far
/// away is rounded as it is long, and what rounding has `displaced` is not known better. Where
/// nothing turns J depends on directions alone.
template <typename Model>
[[nodiscard]] double unsure_jacobian(const typename Model::template Dimensions<double>& d,
                                     const typename Model::template Inputs<double>& u,
                                     const Displacement& displaced) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const Displacement by = displaced.bounded();
  if constexpr (detail::has_angles<Model>) {
    const double moved = (std::max)(by.moved, epsilon * longest_length(u));
    return moved > 0 ? (std::max)(moved / own_size<Model>(d, u), by.turned) : by.turned;
  } else {
    return (std::max)(epsilon, by.turned);
  }
}

/// The longest length of a group that counts. A length that is no longer than the rounding of the
/// external joints' places, or than these are `displaced`, does not: then the group is measured by
/// the length of which that is a rounding.
template <typename Model>
[[nodiscard]] double size_among(const typename Model::template Dimensions<double>& d,
                                const typename Model::template Inputs<double>& u,
                                const Displacement& displaced = {}) {
  if constexpr (Model::dimension_count == 0) {  // folded, and in units of the longest already
    return 1;
  }
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  const double own = size_of<Model>(d, u);
  const double places = longest_length(u);
  const double moved =
      counted_displacement(displaced.moved, (std::max)({own, places, displaced.reach}));
  const bool tells = own > rounding * places + moved;
  const double untold = (std::max)(places, moved / std::numeric_limits<double>::epsilon());
  return (std::max)(own, tells ? 0x1p-44 * places : untold);
}

/// In a group of a smaller size, lengths that are too small to have all their digits count.
inline constexpr double least_size = 0x1p-960;

/// The power of two that brings a size near one.
[[nodiscard]] inline double scale_of(double size) {
  return size > 0 && std::isfinite(size) ? inverse_power_of_two(size) : 1.0;
}

/// The power of two that brings the longest length of a group near one.
template <typename Model>
[[nodiscard]] double unit_scale(const typename Model::template Dimensions<double>& d,
                                const typename Model::template Inputs<double>& u,
                                const Displacement& displaced = {}) {
  return scale_of(size_among<Model>(d, u, displaced));
}

}  // namespace assur::support
