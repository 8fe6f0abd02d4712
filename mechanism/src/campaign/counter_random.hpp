// Random numbers as functions of a seed and a counter, independent of earlier ones.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace assur::mechanism::campaign {

/// Philox4x32-10 of Salmon, Moraes, Dror and Shaw, "Parallel random numbers: as easy as 1, 2, 3"
/// (SC11): ten rounds of products that are keyed by the seed.
[[nodiscard]] inline std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                                         std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t first = std::uint64_t{0xD2511F53U} * counter[0];
    const std::uint64_t second = std::uint64_t{0xCD9E8D57U} * counter[2];
    counter = {static_cast<std::uint32_t>(second >> 32U) ^ counter[1] ^ key[0],
               static_cast<std::uint32_t>(second),
               static_cast<std::uint32_t>(first >> 32U) ^ counter[3] ^ key[1],
               static_cast<std::uint32_t>(first)};
    key[0] += 0x9E3779B9U;
    key[1] += 0xBB67AE85U;
  }
  return counter;
}

/// Two random numbers of one parameter in one sample, each a whole number of 52 bits.
[[nodiscard]] inline std::array<std::uint64_t, 2> random_wholes(std::uint64_t seed,
                                                                std::uint64_t sample,
                                                                std::uint32_t parameter) {
  const std::array<std::uint32_t, 4> bits = philox(
      {static_cast<std::uint32_t>(sample), static_cast<std::uint32_t>(sample >> 32U), parameter, 0},
      {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U)});
  return {(std::uint64_t{bits[0]} << 32U | bits[1]) >> 12U,
          (std::uint64_t{bits[2]} << 32U | bits[3]) >> 12U};
}

/// Returns the uniform random number of one parameter in one sample. It lies in (-1, 1) and is
/// never one of the ends.
[[nodiscard]] inline double uniform(std::uint64_t seed, std::uint64_t sample,
                                    std::uint32_t parameter) {
  const std::uint64_t whole = random_wholes(seed, sample, parameter)[0];
  return (static_cast<double>(whole) + 0.5) * 0x1p-51 - 1;
}

/// Returns the normal random number of one parameter in one sample, with the mean 0 and the
/// standard deviation 1, by the transform of Box and Muller.
[[nodiscard]] inline double normal(std::uint64_t seed, std::uint64_t sample,
                                   std::uint32_t parameter) {
  const auto [radius, turn] = random_wholes(seed, sample, parameter);
  return std::sqrt(-2 * std::log((static_cast<double>(radius) + 0.5) * 0x1p-52)) *
         std::cos(2 * std::numbers::pi * static_cast<double>(turn) * 0x1p-52);
}

}  // namespace assur::mechanism::campaign
