// Turns lengths in any unit into lengths near one, exactly, in any scalar.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/index.hpp>
#include <assur/detail/numbers.hpp>
#include <assur/model.hpp>
#include <assur/numeric/precision.hpp>
#include <assur/support/displaced_frame.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace assur::support {

using detail::ScalarOf;

/// Whether each of a model's variables is an angle, in their order; the others are lengths.
template <typename Variables>
inline constexpr auto& are_angles = detail::SortsOf<Variables>::angles;

/// Numbers in another scalar, lengths multiplied by `scale`.
template <typename Scalar, typename Number, std::size_t Count>
void scale_numbers(const void* from, const std::array<bool, Count>& is_length, Number scale,
                   void* to) {
  for (std::size_t place = 0; place < Count; ++place) {
    const auto number = detail::number_at<Number>(from, place);
    detail::put_number(to, place, Scalar(is_length[place] ? number * scale : number));
  }
}

/// The variables in another scalar, lengths multiplied by `scale`, a power of two.
template <typename To, typename From>
[[nodiscard]] To scaled_to(const From& from, typename ScalarOf<From>::Type scale) {
  To result;
  scale_numbers<typename ScalarOf<To>::Type>(&from, detail::SortsOf<From>::lengths, scale, &result);
  return result;
}

/// The variables in another scalar, member by member: faster, but compiled anew for every model.
template <typename To, typename From>
[[nodiscard]] To converted_to(const From& from) {
  To result;
  for_each_pair(result, from, [](auto& target, const auto& source) {
    if constexpr (detail::is_direction<std::decay_t<decltype(source)>>) {
      target = {source.cos, source.sin};
    } else {
      target = source;
    }
  });
  return result;
}

/// 2^-e of a length of 2^e m, 1 <= m < 2, by the bits of a normal number; of any other, at most the
/// largest power that there is.
template <typename Scalar>
[[nodiscard]] Scalar inverse_power_of_two(Scalar length) {
  using Limits = std::numeric_limits<Scalar>;
  using Bits = std::conditional_t<Limits::digits == 24, std::uint32_t, std::uint64_t>;
  static_assert(sizeof(Bits) == sizeof(Scalar), "a power is made of bits of double or float");
  constexpr auto largest = numeric::power_of_two<Scalar>(Limits::max_exponent - 1);
  if (!(length >= (Limits::min)() && length < largest)) {
    return std::ldexp(Scalar(1), (std::min)(-std::ilogb(length), Limits::max_exponent - 1));
  }
  Bits bits = 0;
  std::memcpy(&bits, &length, sizeof(bits));
  constexpr Bits exponent_of_one = Limits::max_exponent - 1;
  constexpr Bits below_exponent = Limits::digits - 1;
  bits = (2 * exponent_of_one - (bits >> below_exponent)) << below_exponent;
  Scalar power = 0;
  std::memcpy(&power, &bits, sizeof(power));
  return power;
}

/// A few roundings of a length of one.
template <typename Scalar>
inline constexpr Scalar rounding_of_one = 2 * std::numeric_limits<Scalar>::epsilon();

/// In a chain of groups the bound of a displacement grows much faster than the displacement itself.
/// A bound beyond some part of the longest length would merge two configurations that are close
/// together, so a larger bound counts as that part.
template <typename Scalar>
[[nodiscard]] Scalar counted_displacement(Scalar displaced, Scalar longest) {
  return (std::min)(displaced, 64 * std::numeric_limits<Scalar>::epsilon() * longest);
}

/// How far rounding may have moved the inputs of a group whose neighbours it has `displaced`. The
/// rounding of a coordinate grows with the coordinate.
template <typename Inputs, typename Scalar = typename ScalarOf<Inputs>::Type>
[[nodiscard]] Scalar rounding_of_inputs(const Inputs& u, Scalar displaced) {
  return rounding_of_one<Scalar> * (std::max)(Scalar(1), longest_length(u)) + displaced;
}

/// Numbers with bounds, lengths known to `within` and directions to a `turn`.
template <typename Scalar, typename Number, std::size_t Count>
void bound_numbers(const void* from, const std::array<bool, Count>& is_length, Number within,
                   Number turn, void* to) {
  for (std::size_t place = 0; place < Count; ++place) {
    detail::put_number(
        to, place,
        Scalar{detail::number_at<Number>(from, place), is_length[place] ? within : turn});
  }
}

/// The variables with bounds, lengths known to `within` and directions to a `turn`: where a root of
/// their final polynomial is certain, it is so however the variables were rounded.
template <typename To, typename From, typename Scalar = typename ScalarOf<From>::Type>
[[nodiscard]] To rounded(const From& from, Scalar within, Scalar turn) {
  To result;
  bound_numbers<typename ScalarOf<To>::Type>(&from, detail::SortsOf<From>::lengths, within, turn,
                                             &result);
  return result;
}

/// How far rounding of the dimensions may have moved a coefficient of a specialised group, whose
/// functions hold them as numbers: lengths are at most one there, and few of them meet in a term.
inline constexpr double rounding_of_named_numbers = 32 * std::numeric_limits<double>::epsilon();
template <typename Model, typename Scalar>
[[nodiscard]] constexpr Scalar rounding_of_numbers() {
  constexpr Scalar rounding =
      static_cast<Scalar>(rounding_of_named_numbers) * numeric::roundings_of_double<Scalar>;
  return Model::dimension_count == 0 ? rounding : Scalar(0);
}

/// The longest length of a group. Only differences of the external joints' places count, not where
/// the group is.
template <typename Model, typename Scalar = double>
[[nodiscard]] Scalar size_of(const typename Model::template Dimensions<Scalar>& d,
                             const typename Model::template Inputs<Scalar>& u) {
  typename Model::template Configuration<Scalar> q;
  Vector<Scalar, Model::equation_count> f;
  Model::residual(typename Model::template Dimensions<Scalar>{}, u, q, f);
  return (std::max)(longest_length(d), f.cwiseAbs().maxCoeff());
}

/// The longest length of a group in the unit of its inputs; a specialised group states it, because
/// its lengths are in its functions.
template <typename Model, typename Scalar = double>
[[nodiscard]] Scalar own_size(const typename Model::template Dimensions<Scalar>& d,
                              const typename Model::template Inputs<Scalar>& u) {
  if constexpr (Model::dimension_count == 0) {
    return static_cast<Scalar>(Model::own_length);
  } else {
    return size_of<Model, Scalar>(d, u);
  }
}

/// The amount by which the loop Jacobian of a group may be off, in parts of the group's length: a
/// coordinate far from the origin is rounded in proportion to itself, and what rounding has
/// `displaced` is not known better. Where nothing turns, J depends on directions alone. In float a
/// displacement counts no more than in `counted_displacement`: the full bound would leave no digit
/// behind three groups.
template <typename Model, typename Scalar = double>
[[nodiscard]] Scalar unsure_jacobian(const typename Model::template Dimensions<Scalar>& d,
                                     const typename Model::template Inputs<Scalar>& u,
                                     const DisplacementOf<Scalar>& displaced) {
  constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  const DisplacementOf<Scalar> by = displaced.bounded();
  if constexpr (detail::has_angles<Model>) {
    const Scalar places = longest_length(u);
    const Scalar moved = (std::max)(by.moved, epsilon * places);
    if constexpr (std::is_same_v<Scalar, float>) {
      const Scalar own = own_size<Model, Scalar>(d, u);
      const Scalar longest = (std::max)({own, places, by.reach});
      const Scalar turned = counted_displacement(by.turned, Scalar(1));
      return own > 0 ? (std::max)(counted_displacement(moved, longest) / own, turned) : turned;
    }
    return moved > 0 ? (std::max)(moved / own_size<Model, Scalar>(d, u), by.turned) : by.turned;
  } else {
    return (std::max)(epsilon, by.turned);
  }
}

/// The length by which a group is measured: its longest one, unless that is no longer than the
/// rounding of the external joints' places, or than they are `displaced`; then the length of which
/// that is a rounding.
template <typename Model, typename Scalar = double>
[[nodiscard]] Scalar size_among(const typename Model::template Dimensions<Scalar>& d,
                                const typename Model::template Inputs<Scalar>& u,
                                const DisplacementOf<Scalar>& displaced = {}) {
  if constexpr (Model::dimension_count == 0) {  // specialised: lengths are in such a unit already
    return 1;
  }
  constexpr Scalar rounding = 4 * std::numeric_limits<Scalar>::epsilon();
  const Scalar own = size_of<Model, Scalar>(d, u);
  const Scalar places = longest_length(u);
  const Scalar moved =
      counted_displacement(displaced.moved, (std::max)({own, places, displaced.reach}));
  const bool tells = own > rounding * places + moved;
  const Scalar untold = (std::max)(places, moved / std::numeric_limits<Scalar>::epsilon());
  return (std::max)(own, tells ? 256 * std::numeric_limits<Scalar>::epsilon() * places : untold);
}

/// In a group that is smaller than this, lengths count that are too small to have all their digits:
/// 2^-960 in double, 2^-93 in float.
template <typename Scalar>
inline constexpr Scalar least_size =
    (std::numeric_limits<Scalar>::min)() * numeric::power_of_two<Scalar>(
                                               std::numeric_limits<Scalar>::digits + 9);

/// The power of two that brings a size near one.
template <typename Scalar>
[[nodiscard]] Scalar scale_of(Scalar size) {
  return size > 0 && std::isfinite(size) ? inverse_power_of_two(size) : Scalar(1);
}

/// The power of two that brings the longest length of a group near one.
template <typename Model, typename Scalar = double>
[[nodiscard]] Scalar unit_scale(const typename Model::template Dimensions<Scalar>& d,
                                const typename Model::template Inputs<Scalar>& u,
                                const DisplacementOf<Scalar>& displaced = {}) {
  return scale_of(size_among<Model, Scalar>(d, u, displaced));
}

}  // namespace assur::support
