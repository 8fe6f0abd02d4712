// Input, output, instruction counter and stack depth of a processor under QEMU, or of the build
// machine.
#pragma once

#include <cstddef>
#include <cstdint>

#ifdef __unix__
#include <cstdio>
#else
#include "semihosting.hpp"
#endif

namespace board {

#ifdef __unix__

inline std::size_t read(void* bytes, std::size_t size) { return std::fread(bytes, 1, size, stdin); }
inline void write(const void* bytes, std::size_t size) {
  (void)std::fwrite(bytes, 1, size, stdout);
}
inline void start_counting() {}
inline std::uint64_t instructions() { return 0; }
inline void paint_stack() {}
inline std::uint32_t painted_over() { return 0; }

#else

inline std::size_t read(void* bytes, std::size_t size) {
  static std::uintptr_t file = 0;
  file = file == 0 ? semihosting::console(false) : file;
  std::size_t got = 0;
  while (got < size) {
    const std::size_t more =
        semihosting::read(file, static_cast<unsigned char*>(bytes) + got, size - got);
    if (more == 0) {
      break;
    }
    got += more;
  }
  return got;
}
inline void write(const void* bytes, std::size_t size) {
  static std::uintptr_t file = 0;
  file = file == 0 ? semihosting::console(true) : file;
  semihosting::write(file, bytes, size);
}

/// QEMU counts instructions with -icount: on ARM one is 8 ns (shift=3), and the board's timer,
/// which counts down, ticks every 40 ns; on RISC-V one is 1 ns.
#ifdef __arm__
inline volatile std::uint32_t* timer() {
  return reinterpret_cast<volatile std::uint32_t*>(0x40000000);
}
inline void start_counting() {
  timer()[2] = 0xFFFFFFFF;  // from where it counts
  timer()[1] = 0xFFFFFFFF;
  timer()[0] = 1;
}
/// The instructions that have run since, in steps of five, to within a few; up to 2^32 ticks.
inline std::uint64_t instructions() { return std::uint64_t{0xFFFFFFFF - timer()[1]} * 5; }
#else
inline std::uint64_t all_instructions() {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::uint32_t again = 0;
  do {
    asm volatile(
        ".option push\n.option arch, +zicsr\n"
        "csrr %0, instreth\ncsrr %1, instret\ncsrr %2, instreth\n.option pop"
        : "=r"(high), "=r"(low), "=r"(again));
  } while (high != again);
  return std::uint64_t{high} << 32U | low;
}
inline std::uint64_t counted_from = 0;
inline void start_counting() { counted_from = all_instructions(); }
/// The instructions that have run since, to within a few.
inline std::uint64_t instructions() { return all_instructions() - counted_from; }
#endif

extern "C" std::uint32_t stack_bottom, stack_top;
constexpr std::uint32_t paint = 0xA5A5A5A5;

/// Marks the unused part of the stack, except what this function needs itself.
[[gnu::noinline]] inline void paint_stack() {
  auto* const here = static_cast<std::uint32_t*>(__builtin_frame_address(0));
  for (std::uint32_t* to = &stack_bottom; to < here - 32; ++to) {
    *to = paint;
  }
}

/// The bytes of the stack, from where it begins, that were used since it was painted.
[[gnu::noinline]] inline std::uint32_t painted_over() {
  const std::uint32_t* at = &stack_bottom;
  while (at < &stack_top && *at == paint) {
    ++at;
  }
  return static_cast<std::uint32_t>((&stack_top - at) * sizeof(*at));
}

#endif

}  // namespace board
