// Start-up of a Cortex-M with a floating-point unit: from reset to main.
#include <array>
#include <cstdint>

#include "semihosting.hpp"

extern "C" {
extern std::uint32_t stack_top, data_in_flash, data_begin, data_end, bss_begin, bss_end;
int main();

[[noreturn]] void reset() {
  // Full access to the floating-point unit.
  auto* const access = reinterpret_cast<volatile std::uint32_t*>(0xE000ED88);
  *access = *access | 0xFU << 20U;
  asm volatile("dsb\nisb");
  const std::uint32_t* from = &data_in_flash;
  for (std::uint32_t* to = &data_begin; to < &data_end; ++to) {
    *to = *from++;
  }
  for (std::uint32_t* to = &bss_begin; to < &bss_end; ++to) {
    *to = 0;
  }
  semihosting::exit(main());
}

[[noreturn]] void fault() { semihosting::exit(1); }
}

namespace {

/// The initial stack pointer, and the handlers of reset and exceptions.
struct Vectors {
  std::uint32_t* stack;
  std::array<void (*)(), 15> handlers;
};

[[gnu::section(".vectors"), gnu::used]] const Vectors vectors = {
    &stack_top,
    {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
     fault, fault}};

}  // namespace
