#include <array>
#include <assur/text/numbers.hpp>
#include <charconv>

namespace assur::text {

std::string short_number(double number, int digits) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number + 0.0,
                                 std::chars_format::general, digits);
  return {text.data(), end.ptr};
}

}  // namespace assur::text
