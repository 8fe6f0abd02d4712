// Console, file reading and exit without an operating system, by requests to the debugger or QEMU.
#pragma once

#include <cstddef>
#include <cstdint>

namespace semihosting {

/// Operations of ARM semihosting, which RISC-V shares.
enum class Operation : std::uintptr_t { open = 0x01, write = 0x05, read = 0x06, exit = 0x18 };

inline std::uintptr_t call(Operation operation, const void* block) {
#ifdef __arm__
  register std::uintptr_t r0 asm("r0") = static_cast<std::uintptr_t>(operation);
  register const void* r1 asm("r1") = block;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
#else
  register std::uintptr_t a0 asm("a0") = static_cast<std::uintptr_t>(operation);
  register const void* a1 asm("a1") = block;
  // Three uncompressed instructions in one page mark the call.
  asm volatile(
      ".balign 16\n.option push\n.option norvc\n"
      "slli zero, zero, 0x1f\nebreak\nsrai zero, zero, 0x7\n.option pop"
      : "+r"(a0)
      : "r"(a1)
      : "memory");
  return a0;
#endif
}

/// Opens the console for reading or for writing.
inline std::uintptr_t console(bool writes) {
  static constexpr char name[] = ":tt";
  const std::uintptr_t block[] = {reinterpret_cast<std::uintptr_t>(name), writes ? 4U : 0U,
                                  sizeof(name) - 1};
  return call(Operation::open, block);
}

inline void write(std::uintptr_t file, const void* bytes, std::size_t size) {
  const std::uintptr_t block[] = {file, reinterpret_cast<std::uintptr_t>(bytes), size};
  (void)call(Operation::write, block);
}

/// The number of bytes read.
inline std::size_t read(std::uintptr_t file, void* bytes, std::size_t size) {
  const std::uintptr_t block[] = {file, reinterpret_cast<std::uintptr_t>(bytes), size};
  return size - call(Operation::read, block);
}

/// Ends the program; a `status` other than zero is reported as failure.
[[noreturn]] inline void exit(int status) {
  constexpr std::uintptr_t application_exit = 0x20026, run_time_error = 0x20023;
  for (;;) {
    // On 32 bits the argument is the reason itself, not a block that holds it.
    (void)call(Operation::exit,
               reinterpret_cast<const void*>(status == 0 ? application_exit : run_time_error));
  }
}

}  // namespace semihosting
