// Joint limits of several mechanisms at once: which are kept, and which certainly.
#pragma once

#include <assur/numeric/pack.hpp>
#include <assur/support/displaced_frame.hpp>
#include <cstddef>

namespace assur::support {

/// The lanes in which limits are kept, and those in which that is certain despite rounding, six
/// digits being correct in regular configurations.
template <typename Truth>
struct KeptLimits {
  Truth kept;
  Truth certain;

  /// Whether both are kept. This is also certain if one of them is certainly not kept.
  friend KeptLimits operator&&(const KeptLimits& one, const KeptLimits& other) {
    return {one.kept & other.kept, (one.certain & other.certain) | (one.certain & !one.kept) |
                                       (other.certain & !other.kept)};
  }
};

template <typename Scalar, std::size_t Lanes>
[[nodiscard]] numeric::PackOf<Scalar, Lanes> pack_limit_slack(
    const numeric::PackOf<Scalar, Lanes>& lowest, const numeric::PackOf<Scalar, Lanes>& highest) {
  using Pack = numeric::PackOf<Scalar, Lanes>;
  return Pack(1e-6) * larger(Pack(1), larger(abs(lowest), abs(highest)));
}

/// `is_between`, lane by lane.
template <typename Scalar, std::size_t Lanes>
[[nodiscard]] auto is_between(const numeric::PackOf<Scalar, Lanes>& lowest,
                              const numeric::PackOf<Scalar, Lanes>& displacement,
                              const numeric::PackOf<Scalar, Lanes>& highest) {
  const auto slack = pack_limit_slack(lowest, highest);
  const auto inside = (lowest + slack < displacement) & (displacement < highest - slack);
  const auto outside = (displacement < lowest - slack) | (highest + slack < displacement);
  return KeptLimits<numeric::PackTruth<Scalar, Lanes>>{inside, inside | outside};
}

/// `is_turned_between`, lane by lane.
template <typename Scalar, std::size_t Lanes>
[[nodiscard]] auto is_turned_between(const numeric::PackOf<Scalar, Lanes>& lowest,
                                     const numeric::PackOf<Scalar, Lanes>& angle,
                                     const numeric::PackOf<Scalar, Lanes>& highest) {
  using Pack = numeric::PackOf<Scalar, Lanes>;
  const Pack turn(6.283185307179586);
  const Pack slack = pack_limit_slack(lowest, highest);
  const Pack first = angle + turn * ceil((lowest - slack - angle) / turn);
  const auto inside = (lowest + slack < first) & (first < highest - slack);
  const auto outside = highest + slack < first;
  return KeptLimits<numeric::PackTruth<Scalar, Lanes>>{inside, inside | outside};
}

}  // namespace assur::support
