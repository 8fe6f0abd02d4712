// Turns a seed and a counter into random numbers, each without those before it.
#pragma once

#include <array>
#include <cstdint>

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

/// Returns the uniform random number of one parameter in one sample. It lies in (-1, 1) and is
/// never one of the ends.
[[nodiscard]] inline double uniform(std::uint64_t seed, std::uint64_t sample,
                                    std::uint32_t parameter) {
  const std::array<std::uint32_t, 4> bits = philox(
      {static_cast<std::uint32_t>(sample), static_cast<std::uint32_t>(sample >> 32U), parameter, 0},
      {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U)});
  const std::uint64_t whole = (std::uint64_t{bits[0]} << 32U | bits[1]) >> 12U;  // 52 bits
  return (static_cast<double>(whole) + 0.5) * 0x1p-51 - 1;
}

}  // namespace assur::mechanism::campaign
