// Start-up code of a 32-bit RISC-V: from reset to main.
#include <cstdint>

#include "semihosting.hpp"

extern "C" {
extern std::uint32_t bss_begin, bss_end;
int main();

[[noreturn, gnu::used]] void prepared() {
  for (std::uint32_t* to = &bss_begin; to < &bss_end; ++to) {
    *to = 0;
  }
  semihosting::exit(main());
}

[[gnu::aligned(4), noreturn, gnu::used]] void fault() { semihosting::exit(1); }

/// The C library keeps errno where the thread pointer tp points, so this sets it.
[[gnu::naked, gnu::section(".vectors"), gnu::used]] void reset() {
  asm volatile(
      ".option push\n.option arch, +zicsr\nla sp, stack_top\nla tp, thread_begin\nla t0, fault\n"
      "csrw mtvec, t0\nj prepared\n.option pop");
}
}
