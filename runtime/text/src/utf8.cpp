#include <algorithm>
#include <assur/text/error.hpp>
#include <assur/text/utf8.hpp>

namespace assur::text {

std::size_t first_byte_outside_utf8(const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = [&](std::size_t ahead) {
      return at + ahead < text.size() ? static_cast<unsigned char>(text[at + ahead]) : 0U;
    };
    const unsigned first = byte(0);
    const std::size_t length = first < 0x80   ? 1
                               : first < 0xC2 ? 0
                               : first < 0xE0 ? 2
                               : first < 0xF0 ? 3
                               : first < 0xF5 ? 4
                                              : 0;
    bool valid = length > 0;
    for (std::size_t ahead = 1; ahead < length; ++ahead) {
      valid = valid && (byte(ahead) & 0xC0U) == 0x80U;
    }
    // Overlong encodings, halves of surrogate pairs, and numbers beyond the last character are
    // invalid.
    valid = valid && !(first == 0xE0 && byte(1) < 0xA0) && !(first == 0xED && byte(1) > 0x9F) &&
            !(first == 0xF0 && byte(1) < 0x90) && !(first == 0xF4 && byte(1) > 0x8F);
    if (!valid) {
      return at;
    }
    at += length;
  }
  return text.size();
}

void expect_no_nul(const std::string& text, const std::string& name) {
  const std::size_t at = text.find('\0');
  if (at == std::string::npos) {
    return;
  }
  const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  const std::size_t column = at - (line == 0 ? 0 : text.rfind('\n', at) + 1) + 1;
  throw InputError(name + ":" + std::to_string(line + 1) + ":" + std::to_string(column) +
                   ": a NUL byte; remove it, or save the file as UTF-8");
}

}  // namespace assur::text
