// libFuzzer's entry point: passes its bytes to the parser ASSUR_READER.
#include <cstddef>
#include <cstdint>

#include "readers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  assur::test::fuzz::ASSUR_READER({reinterpret_cast<const char*>(data), size});
  return 0;
}
