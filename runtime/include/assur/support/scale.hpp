// Exact scaling of lengths to a size near one, and the sizes and rounding bounds of groups.
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

/// 2^-e for a length of 2^e m, 1 <= m < 2, from the bits of a normal number; for any other number
/// at most the largest power of two.
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
/// Too large a bound would merge two configurations that are close together, so it is capped at a
/// fraction of the longest length.
template <typename Scalar>
[[nodiscard]] Scalar counted_displacement(Scalar displaced, Scalar longest) {
  return (std::min)(displaced, 64 * std::numeric_limits<Scalar>::epsilon() * longest);
}

/// Bound on the error of the inputs of a group whose neighbours are `displaced`. The rounding of a
/// coordinate grows with the coordinate.
template <typename Inputs, typename Scalar = typename ScalarOf<Inputs>::Type>
[[nodiscard]] Scalar rounding_of_inputs(const Inputs& u, Scalar displaced) {
  return rounding_of_one<Scalar> * (std::max)(Scalar(1), longest_length(u)) + displaced;
}

/// Numbers with error bounds: `within` for lengths, `turn` for directions.
template <typename Scalar, typename Number, std::size_t Count>
void bound_numbers(const void* from, const std::array<bool, Count>& is_length, Number within,
                   Number turn, void* to) {
  for (std::size_t place = 0; place < Count; ++place) {
    detail::put_number(
        to, place,
        Scalar{detail::number_at<Number>(from, place), is_length[place] ? within : turn});
  }
}

/// The variables with error bounds: `within` for lengths, `turn` for directions. A root of their
/// final polynomial that is certain is certain for any rounding of the variables.
template <typename To, typename From, typename Scalar = typename ScalarOf<From>::Type>
[[nodiscard]] To rounded(const From& from, Scalar within, Scalar turn) {
  To result;
  bound_numbers<typename ScalarOf<To>::Type>(&from, detail::SortsOf<From>::lengths, within, turn,
                                             &result);
  return result;
}

/// Bound on the error of a coefficient of a specialised group by rounding of the dimensions, which
/// are numbers in its functions: lengths are at most one, and few of them occur in a term.
inline constexpr double rounding_of_named_numbers = 32 * std::numeric_limits<double>::epsilon();
template <typename Model, typename Scalar>
[[nodiscard]] constexpr Scalar rounding_of_numbers() {
  constexpr Scalar rounding =
      static_cast<Scalar>(rounding_of_named_numbers) * numeric::roundings_of_double<Scalar>;
  return Model::dimension_count == 0 ? rounding : Scalar(0);
}

/// The longest length of a group. Only differences of the external joints' positions count, not the
/// position of the group.
template <typename Model, typename Scalar = double>
[[nodiscard]] Scalar size_of(const typename Model::template Dimensions<Scalar>& d,
                             const typename Model::template Inputs<Scalar>& u) {
  typename Model::template Configuration<Scalar> q;
  Vector<Scalar, Model::equation_count> f;
  Model::residual(typename Model::template Dimensions<Scalar>{}, u, q, f);
  return (std::max)(longest_length(d), f.cwiseAbs().maxCoeff());
}

/// The longest length of a group in the unit of its inputs; a specialised group states it, because
/// its lengths are numbers in its functions.
template <typename Model, typename Scalar = double>
[[nodiscard]] Scalar own_size(const typename Model::template Dimensions<Scalar>& d,
                              const typename Model::template Inputs<Scalar>& u) {
  if constexpr (Model::dimension_count == 0) {
    return static_cast<Scalar>(Model::own_length);
  } else {
    return size_of<Model, Scalar>(d, u);
  }
}

/// Bound on the error of the loop Jacobian of a group, relative to the group's length: a coordinate
/// far from the origin is rounded in proportion to itself, and neighbours are `displaced`. If no
/// link turns, J depends on directions alone. In float a displacement is capped as in
/// `counted_displacement`: the full bound would leave no correct digit after three groups.
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

/// The reference length of a group: its longest length; or, if the rounding or displacement of the
/// external joints is as large, that error divided by a rounding.
template <typename Model, typename Scalar = double>
[[nodiscard]] Scalar size_among(const typename Model::template Dimensions<Scalar>& d,
                                const typename Model::template Inputs<Scalar>& u,
                                const DisplacementOf<Scalar>& displaced = {}) {
  if constexpr (Model::dimension_count == 0) {  // specialised: lengths are already in such a unit
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

/// In a group smaller than this, significant lengths would be subnormal and lack digits: 2^-960 in
/// double, 2^-93 in float.
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
